import { computed } from '@preact/signals';
import { useEffect, useRef, useState } from 'preact/hooks';
import { NumberField } from '../../app/NumberField.tsx';
import { scaled } from '../../format/quantity.ts';
import { catalogue } from '../../state/engine.ts';
import { lesson } from '../../state/lesson.ts';
import { change, chooseBall, isOwnBall, settings } from '../../state/settings.ts';
import { text } from '../../text/language.ts';
import { ballName, UNSTATED } from '../../text/names.ts';

/** Radius of the picture of the largest ball. */
const LARGEST = 13;

const DOTS = 'M-.4-.45h0M.4-.45h0M0 0h0M-.45.4h0M.45.4h0';

/** What tells balls of a colour apart, on a disc of radius 1: seams, panels, dimples, holes. */
const MARKINGS: Readonly<Record<string, string>> = {
  tennis: 'M-.6-.8Q.1 0-.6.8M.6-.8Q-.1 0 .6.8',
  padel: 'M-.8-.6Q0 .1.8-.6M-.8.6Q0-.1.8.6',
  pickleball: DOTS,
  golf: DOTS,
  football:
    'M0-.4.38-.12.24.32h-.48L-.38-.12ZV-1M.38-.12.95-.3M.24.32.6.8M-.24.32-.6.8M-.38-.12-.95-.3',
  basketball: 'M-1 0H1M0-1V1M-.7-.7Q0 0-.7.7M.7-.7Q0 0 .7.7',
  squash: 'M-.3 0h0M.3 0h0',
  steel: 'M-.55-.35A.65.65 0 0 1-.1-.65',
  marble: 'M-.6.5Q-.1-.5.6-.5M-.4.7Q.1-.2.8-.2',
  other: 'M0-.5V.5M-.5 0H.5',
  unstated: 'M-.35-.3A.35.35 0 1 1 .2 0Q0 .1 0 .35M0 .65h0',
};

/** A ball by its size and weight. */
const OTHER = 'other';

/** The balls of a classroom, the most used first; the others follow as the engine lists them. */
const FIRST = ['table-tennis-40', 'tennis', 'rubber', 'marble', 'steel', 'basketball', 'football'];
const places = new Map(FIRST.map((name, place) => [name, place]));
const placeOf = ({ name }: { readonly name: string }): number => places.get(name) ?? FIRST.length;

/** Balls of one material that are sold in many sizes. */
const OF_MANY_SIZES = new Set(['rubber', 'marble', 'steel']);

/** Each choice by its name and diameter; what is no ball of a known size is drawn as large as a tennis ball. */
const choices = computed(() => {
  const balls = [...(catalogue.value?.balls ?? [])].sort((a, b) => placeOf(a) - placeOf(b));
  const ofLesson = balls.filter(({ name }) => lesson.value?.balls.includes(name));
  if (ofLesson.length > 0) return ofLesson;
  const choice = (name: string) => ({ name, diameter_m: 0.066 });
  return balls.length === 0 ? [] : [...balls, choice(OTHER), choice(UNSTATED)];
});

/** The balls in a row, one tap each: the ball decides drag, so it is asked for where one looks first. */
export function BallRow() {
  // Before its size and weight are there, it is no other ball yet.
  const [asking, setAsking] = useState(false);
  const { kind } = settings.value.ball ?? {};
  const isOther = isOwnBall(settings.value) || (asking && kind === undefined);
  const chosen = isOther ? OTHER : (kind ?? UNSTATED);
  const largest = Math.max(...choices.value.map(({ diameter_m }) => diameter_m));
  const row = useRef<HTMLDivElement>(null);
  // The ball that was chosen is in sight; until one is, those that are used most.
  useEffect(() => {
    const label = row.current?.querySelector(':checked')?.closest('label');
    if (!row.current || !label || chosen === UNSTATED) return;
    const [all, one] = [row.current.getBoundingClientRect(), label.getBoundingClientRect()];
    row.current.scrollLeft += one.left - all.left - (all.width - one.width) / 2;
  }, [chosen, choices.value]);
  return (
    <fieldset class="balls no-print">
      <legend class="small soft">{text('page-ball-row')}</legend>
      {/* Firefox would stop at what scrolls, before the balls themselves. */}
      <div ref={row} class="row" tabIndex={-1}>
        {choices.value.map(({ name, diameter_m }) => (
          <label key={name}>
            <input
              type="radio"
              name="ball"
              class="unseen"
              checked={name === chosen}
              onChange={() => {
                setAsking(name === OTHER);
                chooseBall(name === OTHER ? UNSTATED : name);
              }}
            />
            <svg viewBox="-14 -14 28 28" aria-hidden="true" class={`ball ${name}`}>
              {/* Areas as the diameters: small balls stay visible. */}
              <g transform={`scale(${LARGEST * Math.sqrt(diameter_m / largest)})`}>
                <circle r={1} />
                <path d={MARKINGS[name]} />
              </g>
            </svg>
            <span class="small">{name === OTHER ? text('page-ball-other') : ballName(name)}</span>
          </label>
        ))}
      </div>
      {isOther && <SizeAndWeight />}
      {kind !== undefined && OF_MANY_SIZES.has(kind) && <Size kind={kind} />}
    </fieldset>
  );
}

/** The size and weight of another ball; the two are stated together, because one alone says nothing of the air. */
function SizeAndWeight() {
  const { mass_kg, diameter_m } = settings.value.ball ?? {};
  const [typed, setTyped] = useState({ mass_kg, diameter_m });
  const take = (changes: typeof typed | object): void => {
    const now = { ...typed, ...changes };
    setTyped(now);
    if (now.mass_kg !== undefined && now.diameter_m !== undefined) change('ball', now);
  };
  return (
    <div class="measures">
      <NumberField
        label={text('page-settings-diameter')}
        unit="mm"
        value={scaled(typed.diameter_m, 1e3)}
        min={0.1}
        onChange={(mm) => take({ diameter_m: scaled(mm, 1e-3) })}
      />
      <NumberField
        label={text('page-settings-mass')}
        unit="g"
        value={scaled(typed.mass_kg, 1e3)}
        min={1e-3}
        onChange={(grams) => take({ mass_kg: scaled(grams, 1e-3) })}
      />
    </div>
  );
}

/** The size of a ball whose material is known, and with it its weight. */
function Size({ kind }: { readonly kind: string }) {
  const preset = catalogue.value?.balls.find(({ name }) => name === kind);
  return (
    <div class="measures">
      <NumberField
        label={text('page-settings-diameter')}
        unit="mm"
        value={scaled(settings.value.ball?.diameter_m, 1e3)}
        usual={scaled(preset?.diameter_m, 1e3)}
        min={0.1}
        onChange={(mm) => change('ball', { diameter_m: scaled(mm, 1e-3) })}
      />
    </div>
  );
}
