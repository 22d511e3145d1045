import { useRef, useState } from 'preact/hooks';
import { addressOf, hashOf } from '../../address/route.ts';
import { settingsToParameters } from '../../address/settings.ts';
import { FaultNotice } from '../../app/FaultNotice.tsx';
import { Lasting } from '../../app/Lasting.tsx';
import { fileName, saveText } from '../../app/save.ts';
import { saveCsv } from '../../app/saveCsv.ts';
import { CommaTick } from '../../app/Tick.tsx';
import type { Recording } from '../../lab/index.ts';
import { request } from '../../state/analysing.ts';
import { engine } from '../../state/engine.ts';
import { keepDrop } from '../../state/keeping.ts';
import { lesson, pupil } from '../../state/lesson.ts';
import { settings } from '../../state/settings.ts';
import { isWhole } from '../../state/sound.ts';
import { analysed, chosenDrop, drop, edits, workspace } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';
import { DropLink } from './DropLink.tsx';
import { SaveSound } from './SaveSound.tsx';

/** Keep the drop here, save its numbers, share the set-up, print a report. */
export function Keep() {
  const recording = workspace.value;
  const [named, setNamed] = useState<{ readonly of: unknown; readonly name: string }>();
  if (!recording) return null;
  const given = named?.of === recording.recording ? named.name.trim() : '';
  const name = given || pupil().name || recording.name;
  const stem = fileName(name);
  return (
    <section class="stack keep no-print" aria-label={text('page-keep-title')}>
      {drop.value && <KeepForm onName={(name) => setNamed({ of: recording.recording, name })} />}
      <div class="row">
        <SaveSound />
        {drop.value && (
          <>
            <button type="button" class="quiet" onClick={() => void saveTable(name)}>
              {text('page-keep-csv')}
            </button>
            <button type="button" class="quiet" onClick={() => saveJson(stem)}>
              {text('page-keep-json')}
            </button>
            <button type="button" class="quiet" onClick={() => void saveReport(name)}>
              {text('page-keep-report')}
            </button>
          </>
        )}
        <Share />
        {drop.value && !lesson.value && <DropLink name={name} label={text('page-keep-link')} />}
        {drop.value && <CommaTick />}
      </div>
    </section>
  );
}

async function saveTable(name: string): Promise<void> {
  const asked = request();
  if (asked) saveCsv(await engine().csv({ ...asked, name }), `${fileName(name)}.csv`);
}

/** One file to print, send or hand in: as the command line writes it, in the language of the page. */
async function saveReport(name: string): Promise<void> {
  const [asked, loaded] = [request(), workspace.peek()];
  if (!asked || !loaded) return;
  const html = await engine().report(loaded.recording, { ...asked, name }, new Date());
  saveText(html, 'text/html', `${fileName(name)}.html`);
}

/** The document of the command line, as it is. */
function saveJson(stem: string): void {
  const text = JSON.stringify(analysed.peek()?.document, null, 2);
  saveText(text, 'application/json', `${stem}.json`);
}

/** The result of keeping a drop. */
interface Attempt {
  readonly recording: Recording;
  readonly drop: number;
  /** Under which name it is kept; `null` if it could not be. */
  readonly name: string | null;
}

function KeepForm({ onName }: { readonly onName: (name: string) => void }) {
  const input = useRef<HTMLInputElement>(null);
  const [last, setLast] = useState<Attempt>();
  const loaded = workspace.value;
  if (!loaded) return null;
  const [index, count] = [chosenDrop.value, edits.value.length];
  const whose = pupil().name || loaded.name;
  const name =
    count > 1 ? `${whose}, ${text('page-lab-drop-of', { index: index + 1, count })}` : whose;
  const attempt = last?.recording === loaded.recording && last.drop === index ? last : undefined;
  return (
    <form
      class="stack"
      onSubmit={async (event) => {
        event.preventDefault();
        const given = input.current?.value.trim() || name;
        const isKept = await keepDrop(given);
        setLast({ recording: loaded.recording, drop: index, name: isKept ? given : null });
      }}
    >
      <div class="field">
        <label for="drop-name">{text('page-keep-name')}</label>
        <span class="pair">
          <input
            key={name}
            id="drop-name"
            ref={input}
            defaultValue={name}
            placeholder={text('page-keep-name-hint')}
            maxLength={120}
            onInput={(event) => onName(event.currentTarget.value)}
          />
          <button type="submit" class="button">
            {text('page-keep-keep')}
          </button>
        </span>
      </div>
      {!isWhole.value && <p class="small soft">{text('page-keep-long-sound')}</p>}
      <p role="status" class="small">
        {attempt && attempt.name !== null && (
          <>
            {text('page-keep-kept', { name: attempt.name })} <Lasting />{' '}
            <a href={hashOf('drops')}>{text('page-keep-see-all')}</a>
          </>
        )}
      </p>
      {attempt?.name === null && <FaultNotice fault={{ key: 'keep' }} />}
    </form>
  );
}

function Share() {
  const [shared, setShared] = useState<{ readonly address: string; readonly copied: boolean }>();
  const address = addressOf('lab', settingsToParameters(settings.value));
  const share = async (): Promise<void> => {
    const copied = await navigator.clipboard?.writeText(address).then(
      () => true,
      () => false,
    );
    setShared({ address, copied: copied ?? false });
  };
  return (
    <>
      <button type="button" class="quiet" onClick={() => void share()}>
        {text('page-keep-share')}
      </button>
      <p role="status" class="small shared">
        {shared?.address === address && (
          <>
            {shared.copied ? text('page-keep-shared') : text('page-keep-share-by-hand')}{' '}
            <code>{address}</code>
          </>
        )}
      </p>
    </>
  );
}
