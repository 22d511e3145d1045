import { computed } from '@preact/signals';
import { catalogue } from '../../state/engine.ts';
import { chooseBall, isOwnBall, settings } from '../../state/settings.ts';
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
  unstated: 'M-.35-.3A.35.35 0 1 1 .2 0Q0 .1 0 .35M0 .65h0',
};

/** Each ball by its name and diameter; one that is not stated is drawn as large as a tennis ball. */
const choices = computed(() => {
  const balls = catalogue.value?.balls ?? [];
  return balls.length === 0 ? [] : [{ name: UNSTATED, diameter_m: 0.066 }, ...balls];
});

/** The balls in a row, one tap each: the ball decides drag, so it is asked for where one looks first. */
export function BallRow() {
  const chosen = isOwnBall(settings.value) ? undefined : (settings.value.ball?.kind ?? UNSTATED);
  const largest = Math.max(...choices.value.map(({ diameter_m }) => diameter_m));
  return (
    <fieldset class="balls no-print">
      <legend class="small soft">{text('page-ball-row')}</legend>
      {/* Firefox would stop at what scrolls, before the balls themselves. */}
      <div class="row" tabIndex={-1}>
        {choices.value.map(({ name, diameter_m }) => (
          <label key={name}>
            <input
              type="radio"
              name="ball"
              class="unseen"
              checked={name === chosen}
              onChange={() => chooseBall(name)}
            />
            <svg viewBox="-14 -14 28 28" aria-hidden="true" class={`ball ${name}`}>
              {/* Areas as the diameters: small balls stay visible. */}
              <g transform={`scale(${LARGEST * Math.sqrt(diameter_m / largest)})`}>
                <circle r={1} />
                <path d={MARKINGS[name]} />
              </g>
            </svg>
            <span class="small">{ballName(name)}</span>
          </label>
        ))}
      </div>
    </fieldset>
  );
}
