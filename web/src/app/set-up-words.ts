/** A set-up in words. */
import { fixed } from '../format/quantity.ts';
import type { Settings } from '../lab/index.ts';
import { catalogue } from '../state/engine.ts';
import { isOwnBall } from '../state/settings.ts';
import { language, text } from '../text/language.ts';
import { ballName, UNSTATED } from '../text/names.ts';

const number = (value: number): string =>
  Number(value.toPrecision(4)).toLocaleString(language.value, { useGrouping: false });

/** Marks a quantity that was assumed. */
const unlessStated = (stated: boolean): string => (stated ? '' : ` (${text('page-lab-assumed')})`);

/** A quantity with its name. */
const named = (id: string, value: string): string =>
  text('page-setup-named', { name: text(id), value });

export function ballInWords(settings: Settings): string {
  const { kind, mass_kg, diameter_m } = settings.ball ?? {};
  const words = [
    isOwnBall(settings) ? '' : ballName(kind ?? UNSTATED),
    mass_kg === undefined ? '' : `${number(1e3 * mass_kg)}\u00a0g`,
    diameter_m === undefined ? '' : `${number(1e3 * diameter_m)}\u00a0mm`,
  ];
  return named('page-settings-ball', words.filter((word) => word !== '').join(', '));
}

export function airInWords({ air }: Settings): string {
  const { drag, temperature_k, pressure_pa, density_kg_m3 } = air ?? {};
  if (drag === 'none') return text('page-settings-no-drag');
  if (density_kg_m3 === 0) return text('page-settings-vacuum');
  if (density_kg_m3 !== undefined)
    return named('page-settings-air', `${number(density_kg_m3)}\u00a0kg/m³`);
  const usual = catalogue.value?.usual_air;
  const temperature = (temperature_k ?? usual?.temperature_k ?? 293.15) - 273.15;
  const pressure = (pressure_pa ?? usual?.pressure_pa ?? 101325) / 100;
  const stated = temperature_k !== undefined || pressure_pa !== undefined;
  const value = `${number(temperature)}\u00a0°C, ${fixed(pressure, 0, language.value)}\u00a0hPa`;
  return named('page-settings-air', value + unlessStated(stated));
}

export function gravityInWords({ gravity }: Settings): string {
  const { gravity_m_s2, latitude_deg } = gravity ?? {};
  if (latitude_deg !== undefined)
    return `${text('page-settings-latitude')} ${number(latitude_deg)}°`;
  const g = gravity_m_s2 ?? catalogue.value?.standard_gravity_m_s2 ?? 9.80665;
  return `${text('page-settings-gravity')}\u00a0${number(g)}\u00a0m/s²`;
}

/** What is stated, and nothing of what is assumed. */
export function statedInWords(settings: Settings): string {
  const { ball, air, gravity, drop } = settings;
  const words = [
    ball && ballInWords(settings),
    air && airInWords(settings),
    gravity && gravityInWords(settings),
    drop?.height_m !== undefined &&
      named('page-settings-height', `${number(100 * drop.height_m)}\u00a0cm`),
  ];
  return words.filter(Boolean).join(' · ');
}
