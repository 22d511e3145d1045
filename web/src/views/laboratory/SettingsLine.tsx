import { fixed } from '../../format/quantity.ts';
import { catalogue } from '../../state/engine.ts';
import { isOwnBall, settings } from '../../state/settings.ts';
import { refusedSettings } from '../../state/workspace.ts';
import { language, text } from '../../text/language.ts';
import { ballName, UNSTATED } from '../../text/names.ts';
import { SettingsForm } from './SettingsForm.tsx';

/** Stated and assumed quantities in one line, which unfolds into a form. */
export function SettingsLine() {
  return (
    <section class="settings" aria-label={text('page-settings-title')}>
      {refusedSettings.value !== null && (
        <div class="notice" role="alert">
          <p>
            <strong>{text('page-settings-refused')}</strong> {refusedSettings.value}
          </p>
        </div>
      )}
      <details>
        <summary>
          <span>
            <span class="line">
              {ballInWords()} · {airInWords()} · {gravityInWords()}
            </span>{' '}
            {text('page-settings-change')}
          </span>
        </summary>
        <SettingsForm />
      </details>
    </section>
  );
}

/** Marks a quantity that was assumed. */
const unlessStated = (stated: boolean): string => (stated ? '' : ` (${text('page-lab-assumed')})`);

function ballInWords(): string {
  const { kind, mass_kg, diameter_m } = settings.value.ball ?? {};
  const words = [
    isOwnBall(settings.value) ? '' : ballName(kind ?? UNSTATED),
    mass_kg === undefined ? '' : `${number(1e3 * mass_kg)} g`,
    diameter_m === undefined ? '' : `${number(1e3 * diameter_m)} mm`,
  ];
  return `${text('page-settings-ball')}: ${words.filter((word) => word !== '').join(', ')}`;
}

function airInWords(): string {
  const { drag, temperature_k, pressure_pa, density_kg_m3 } = settings.value.air ?? {};
  if (drag === 'none') return text('page-settings-no-drag');
  if (density_kg_m3 === 0) return text('page-settings-vacuum');
  if (density_kg_m3 !== undefined)
    return `${text('page-settings-air')}: ${number(density_kg_m3)} kg/m³`;
  const usual = catalogue.value?.usual_air;
  const temperature = (temperature_k ?? usual?.temperature_k ?? 293.15) - 273.15;
  const pressure = (pressure_pa ?? usual?.pressure_pa ?? 101325) / 100;
  const stated = temperature_k !== undefined || pressure_pa !== undefined;
  return `${text('page-settings-air')}: ${number(temperature)} °C, ${fixed(pressure, 0, language.value)} hPa${unlessStated(stated)}`;
}

function gravityInWords(): string {
  const { gravity_m_s2, latitude_deg } = settings.value.gravity ?? {};
  if (latitude_deg !== undefined)
    return `${text('page-settings-latitude')} ${number(latitude_deg)}°`;
  const g = gravity_m_s2 ?? catalogue.value?.standard_gravity_m_s2 ?? 9.80665;
  return `${text('page-settings-gravity')} ${number(g)}\u00a0m/s²`;
}

const number = (value: number): string =>
  Number(value.toPrecision(4)).toLocaleString(language.value, { useGrouping: false });
