import { catalogue } from '../../state/engine.ts';
import { chooseBall, settings } from '../../state/settings.ts';
import { text } from '../../text/language.ts';
import { ballName } from '../../text/names.ts';

/** Radius of the picture of the largest ball. */
const LARGEST = 13;

/** The balls in a row, one tap each: the ball decides drag, so it is asked for where one looks first. */
export function BallRow() {
  const balls = catalogue.value?.balls ?? [];
  const { ball, mass_kg, diameter_m: own } = settings.value;
  const isOwn = mass_kg !== undefined || own !== undefined;
  const chosen = isOwn ? undefined : (ball ?? balls[0]?.name);
  const largest = Math.max(...balls.map(({ diameter_m }) => diameter_m));
  return (
    <fieldset class="balls no-print">
      <legend class="small soft">{text('page-ball-row')}</legend>
      <div class="row">
        {balls.map(({ name, diameter_m }) => (
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
              <circle r={LARGEST * Math.sqrt(diameter_m / largest)} />
            </svg>
            <span class="small">{ballName(name)}</span>
          </label>
        ))}
      </div>
    </fieldset>
  );
}
