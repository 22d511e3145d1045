import { Choice } from '../../app/Choice.tsx';
import { NumberField } from '../../app/NumberField.tsx';
import { ABSOLUTE_ZERO_C, scaled } from '../../format/quantity.ts';
import type { Inferred } from '../../lab/index.ts';
import { catalogue } from '../../state/engine.ts';
import { change, chooseBall, forgetSettings, isOwnBall, settings } from '../../state/settings.ts';
import { analysed } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';
import { ballName, lawChoices, nameIn, UNSTATED } from '../../text/names.ts';

const OWN = 'own';
/** The default last flight of the log-linear fit: the paper uses ten. */
const USUAL_LAST = 10;

/** Whether a quantity, as it is stated, looks like a mistake of units. */
function questionOf(quantity: string): string | undefined {
  const questions = analysed.value?.questions ?? [];
  const found = questions.find(({ code, arguments: of }) =>
    quantity === 'ball' ? code === 'implausible-ball' : of['quantity'] === quantity,
  );
  return found?.message;
}

/** Ball, air, gravity and drop: quantities that are not stated here are assumed. */
export function SettingsForm() {
  return (
    <>
      <p class="small soft">{text('page-settings-assumed-hint')}</p>
      <div class="form">
        <Ball />
        <Air />
        <Gravity />
        <Measured />
      </div>
      <button type="button" class="quiet" onClick={forgetSettings}>
        {text('page-settings-reset')}
      </button>
    </>
  );
}

function Ball() {
  const { kind, mass_kg, diameter_m, contact_time_s } = settings.value.ball ?? {};
  const balls = catalogue.value?.balls ?? [];
  const own = isOwnBall(settings.value);
  const preset = balls.find(({ name }) => name === kind);
  const known = preset || kind === undefined ? [] : [[kind, kind] as const];
  const choose = (name: string): void => {
    if (name === OWN) {
      const { mass_kg, diameter_m } = preset ?? balls[0] ?? {};
      change('ball', { kind: undefined, mass_kg, diameter_m });
    } else chooseBall(name);
  };
  return (
    <fieldset>
      <legend>{text('page-settings-ball')}</legend>
      <Choice
        label={text('page-settings-ball')}
        value={own ? OWN : (kind ?? UNSTATED)}
        options={[
          ...[UNSTATED, ...balls.map(({ name }) => name)].map(
            (name) => [name, ballName(name)] as const,
          ),
          ...known,
          [OWN, text('page-settings-own')],
        ]}
        onChange={choose}
      />
      <NumberField
        label={text('page-settings-mass')}
        unit="g"
        value={scaled(mass_kg, 1e3)}
        usual={scaled(preset?.mass_kg, 1e3)}
        min={1e-3}
        onChange={(grams) => change('ball', { mass_kg: scaled(grams, 1e-3) })}
      />
      <NumberField
        label={text('page-settings-diameter')}
        question={questionOf('ball')}
        unit="mm"
        value={scaled(diameter_m, 1e3)}
        usual={scaled(preset?.diameter_m, 1e3)}
        min={0.1}
        onChange={(mm) => change('ball', { diameter_m: scaled(mm, 1e-3) })}
      />
      <NumberField
        label={text('page-settings-contact')}
        question={questionOf('contact-time')}
        unit="ms"
        value={scaled(contact_time_s, 1e3)}
        usual={scaled(preset?.contact_time_s, 1e3)}
        min={0}
        onChange={(ms) => change('ball', { contact_time_s: scaled(ms, 1e-3) })}
      />
    </fieldset>
  );
}

function Air() {
  const { drag, temperature_k, pressure_pa, relative_humidity } = settings.value.air ?? {};
  const usual = catalogue.value?.usual_air;
  const usualLaw = catalogue.value?.drag_laws[0] ?? '';
  return (
    <fieldset>
      <legend>{text('page-settings-air')}</legend>
      <Choice
        label={text('page-settings-drag-law')}
        value={drag ?? usualLaw}
        options={lawChoices(drag ?? usualLaw)}
        onChange={(law) => change('air', { drag: law === usualLaw ? undefined : law })}
      />
      <NumberField
        label={text('page-settings-temperature')}
        question={questionOf('temperature')}
        unit="°C"
        value={temperature_k === undefined ? undefined : temperature_k + ABSOLUTE_ZERO_C}
        usual={usual && usual.temperature_k + ABSOLUTE_ZERO_C}
        min={-60}
        max={60}
        onChange={(celsius) =>
          change('air', {
            temperature_k: celsius === undefined ? undefined : celsius - ABSOLUTE_ZERO_C,
          })
        }
      />
      <NumberField
        label={text('page-settings-pressure')}
        question={questionOf('pressure')}
        unit="hPa"
        value={scaled(pressure_pa, 0.01)}
        usual={scaled(usual?.pressure_pa, 0.01)}
        min={0}
        onChange={(hpa) => change('air', { pressure_pa: scaled(hpa, 100) })}
      />
      <NumberField
        label={text('page-settings-humidity')}
        question={questionOf('humidity')}
        unit="%"
        value={scaled(relative_humidity, 100)}
        usual={scaled(usual?.relative_humidity, 100)}
        min={0}
        max={100}
        onChange={(percent) => change('air', { relative_humidity: scaled(percent, 0.01) })}
      />
    </fieldset>
  );
}

/** What is inferred, with gravity among it or not. */
function toggled(infer: readonly Inferred[]): Inferred[] | undefined {
  const others = infer.filter((name) => name !== 'gravity');
  const next: Inferred[] = others.length < infer.length ? others : [...infer, 'gravity'];
  return next.length > 0 ? next : undefined;
}

function Gravity() {
  const infer = settings.value.inference?.infer ?? [];
  const isMeasured = infer.includes('gravity');
  const { gravity_m_s2, latitude_deg, altitude_m } = settings.value.gravity ?? {};
  return (
    <fieldset>
      <legend>{text('page-settings-gravity-field')}</legend>
      <NumberField
        label={text('page-settings-gravity')}
        question={questionOf('gravity')}
        unit="m/s²"
        value={gravity_m_s2}
        usual={catalogue.value?.standard_gravity_m_s2}
        min={0.01}
        onChange={(g) =>
          change('gravity', { gravity_m_s2: g, latitude_deg: undefined, altitude_m: undefined })
        }
      />
      <NumberField
        label={text('page-settings-latitude')}
        unit="°"
        value={latitude_deg}
        min={-90}
        max={90}
        onChange={(degrees) =>
          change('gravity', {
            latitude_deg: degrees,
            gravity_m_s2: undefined,
            altitude_m: degrees === undefined ? undefined : altitude_m,
          })
        }
      />
      <label class="check">
        <input
          type="checkbox"
          checked={isMeasured}
          onChange={() => change('inference', { infer: toggled(infer) })}
        />
        {text('page-settings-measure-g')}
      </label>
      {latitude_deg !== undefined && (
        <NumberField
          label={text('page-settings-altitude')}
          question={questionOf('altitude')}
          unit="m"
          value={altitude_m}
          usual={0}
          onChange={(metres) => change('gravity', { altitude_m: metres })}
        />
      )}
    </fieldset>
  );
}

function Measured() {
  const { drop, inference, analysis } = settings.value;
  const { height_m, height_sd_m } = drop ?? {};
  const { restitution_laws } = inference ?? {};
  const { flights } = analysis ?? {};
  const laws = catalogue.value?.restitution_laws ?? [];
  const [first, last] = flights ?? [1, undefined];
  const setFlights = (from: number, to: number | undefined): void =>
    change('analysis', {
      flights: to === undefined ? undefined : [Math.round(from), Math.round(to)],
    });
  return (
    <fieldset>
      <legend>{text('page-settings-measured')}</legend>
      <NumberField
        label={text('page-settings-height')}
        question={questionOf('height')}
        unit="cm"
        value={scaled(height_m, 100)}
        min={0.1}
        onChange={(cm) =>
          change('drop', {
            height_m: scaled(cm, 0.01),
            height_sd_m: cm === undefined ? undefined : height_sd_m,
          })
        }
      />
      {height_m !== undefined && (
        <NumberField
          label={text('page-settings-height-sd')}
          question={questionOf('height-sd')}
          unit="mm"
          value={scaled(height_sd_m, 1e3)}
          usual={2}
          min={0.01}
          onChange={(mm) => change('drop', { height_sd_m: scaled(mm, 1e-3) })}
        />
      )}
      <Choice
        label={text('page-settings-restitution-law')}
        value={restitution_laws?.[0] ?? ''}
        options={[
          ['', text('page-settings-restitution-any')],
          ...laws.map(({ name }) => [name, nameIn(`restitution-law-${name}`, name)] as const),
        ]}
        onChange={(law) =>
          change('inference', { restitution_laws: law === '' ? undefined : [law] })
        }
      />
      <div class="twins">
        <NumberField
          label={`${text('page-settings-flights')}, ${text('page-settings-flights-from')}`}
          unit=""
          value={flights?.[0]}
          usual={1}
          min={1}
          max={last === undefined ? undefined : last - 1}
          onChange={(from = 1) => setFlights(from, last ?? Math.max(USUAL_LAST, from + 1))}
        />
        <NumberField
          label={text('page-settings-flights-to')}
          unit=""
          value={last}
          usual={USUAL_LAST}
          min={first + 1}
          onChange={(to) => setFlights(first, to)}
        />
      </div>
    </fieldset>
  );
}
