import { Choice } from '../../app/Choice.tsx';
import { fixed } from '../../format/quantity.ts';
import { leaveLesson, lesson, pupil, write } from '../../state/lesson.ts';
import { change, settings } from '../../state/settings.ts';
import { drop } from '../../state/workspace.ts';
import { language, text } from '../../text/language.ts';
import { BallRow } from './BallRow.tsx';
import { DropLink } from './DropLink.tsx';

/** What a lesson asks of its pupils: name, ball, surface and height. */
export function Pupil() {
  if (!lesson.value) return <BallRow />;
  const { surfaces, heightsM } = lesson.value;
  const { name, surface } = pupil();
  const height = settings.value.drop?.height_m;
  const inWords = (heightM: number): string => `${fixed(100 * heightM, 1, language.value)} cm`;
  return (
    <section class="stack pupil" aria-label={text('page-lesson-title')}>
      <div class="measures">
        <div class="field">
          <label for="pupil">{text('page-lesson-name')}</label>
          <input
            id="pupil"
            autocomplete="off"
            maxLength={60}
            value={name}
            onInput={(event) => write({ name: event.currentTarget.value })}
          />
        </div>
        {surfaces.length > 0 && (
          <Choice
            label={text('page-class-surface')}
            value={surface}
            options={['', ...surfaces].map((entry) => [entry, entry || '…'] as const)}
            onChange={(chosen) => write({ surface: chosen })}
          />
        )}
        {heightsM.length > 0 && (
          <Choice
            label={text('page-settings-height')}
            value={height === undefined ? '' : String(height)}
            options={[
              ['', '…'],
              ...heightsM.map((heightM) => [String(heightM), inWords(heightM)] as const),
            ]}
            onChange={(chosen) =>
              change('drop', { height_m: chosen === '' ? undefined : Number(chosen) })
            }
          />
        )}
      </div>
      <BallRow />
      {!drop.value && (
        <button type="button" class="quiet slim small" onClick={leaveLesson}>
          {text('page-lesson-leave')}
        </button>
      )}
    </section>
  );
}

/** Hands the drop in, as soon as it has a name. */
export function HandIn() {
  if (!lesson.value || !drop.value) return null;
  const name = pupil().name.trim();
  return (
    <section class="stack no-print" aria-label={text('page-hand-in')}>
      {name === '' ? (
        <p class="notice">{text('page-lesson-who')}</p>
      ) : (
        <DropLink name={name} label={text('page-hand-in')} primary />
      )}
    </section>
  );
}
