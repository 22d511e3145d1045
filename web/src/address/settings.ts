/**
 * Settings as part of the address, so that a set-up can be shared as a link. Units are those people
 * write, the names say which; what is left out is assumed.
 */
import type { Inferred, Settings } from '../lab/index.ts';

/** How one setting is written into the address and read back. */
interface Field {
  readonly key: string;
  write(settings: Settings): string | undefined;
  /** `undefined` if the text is no valid value. */
  read(text: string): Settings | undefined;
}

type Group = keyof Settings;
/** The settings of a group that are of a type. */
type KeyOf<G extends Group, T> = {
  [K in keyof NonNullable<Settings[G]>]-?: NonNullable<NonNullable<Settings[G]>[K]> extends T
    ? K
    : never;
}[keyof NonNullable<Settings[G]>];

/** A setting with the texts that stand for its values. */
function field<T, G extends Group>(
  key: string,
  group: G,
  setting: KeyOf<G, T>,
  write: (value: T) => string,
  read: (text: string) => T | undefined,
): Field {
  return {
    key,
    write: (settings) => {
      const fields = settings[group] as Partial<Record<KeyOf<G, T>, T>> | undefined;
      const value = fields?.[setting];
      return value === undefined || value === null ? undefined : write(value);
    },
    read: (text) => {
      const value = read(text);
      return value === undefined ? undefined : { [group]: { [setting]: value } };
    },
  };
}

/** A number, shown as `si / size + offset`. */
const number = <G extends Group>(
  key: string,
  group: G,
  setting: KeyOf<G, number>,
  size = 1,
  offset = 0,
): Field =>
  field<number, G>(
    key,
    group,
    setting,
    (value) => tidy(value / size + offset),
    (text) => {
      const value = readNumber(text);
      return value === undefined ? undefined : clean((value - offset) * size);
    },
  );

const text = <G extends Group>(key: string, group: G, setting: KeyOf<G, string>): Field =>
  field<string, G>(
    key,
    group,
    setting,
    (value) => value,
    (word) => (/^[\w.:-]{1,40}$/.test(word) ? word : undefined),
  );

const flag = <G extends Group>(key: string, group: G, setting: KeyOf<G, boolean>): Field =>
  field<boolean, G>(
    key,
    group,
    setting,
    (value) => (value ? 'yes' : 'no'),
    (word) => (word === 'yes' || word === 'no' ? word === 'yes' : undefined),
  );

/** No drop has more. */
const MAX_FLIGHTS = 10_000;

const INFERRED = ['gravity', 'drag', 'contact-time'] as const;

const FIELDS: readonly Field[] = [
  text('ball', 'ball', 'kind'),
  number('mass_g', 'ball', 'mass_kg', 1e-3),
  number('diameter_mm', 'ball', 'diameter_m', 1e-3),
  number('contact_ms', 'ball', 'contact_time_s', 1e-3),
  text('drag', 'air', 'drag'),
  number('temperature_c', 'air', 'temperature_k', 1, -273.15),
  number('pressure_hpa', 'air', 'pressure_pa', 100),
  number('humidity_percent', 'air', 'relative_humidity', 0.01),
  number('air_kg_m3', 'air', 'density_kg_m3'),
  number('air_pa_s', 'air', 'viscosity_pa_s'),
  flag('buoyancy', 'air', 'buoyancy'),
  flag('added_mass', 'air', 'added_mass'),
  number('gravity', 'gravity', 'gravity_m_s2'),
  number('latitude', 'gravity', 'latitude_deg'),
  number('altitude_m', 'gravity', 'altitude_m'),
  number('height_cm', 'drop', 'height_m', 0.01),
  number('height_sd_mm', 'drop', 'height_sd_m', 1e-3),
  flag('first_detected', 'drop', 'first_detected'),
  field(
    'law',
    'inference',
    'restitution_laws',
    (laws: string[]) => laws.join('.'),
    (word) => (/^[a-z.-]{1,80}$/.test(word) ? word.split('.') : undefined),
  ),
  field(
    'infer',
    'inference',
    'infer',
    (inferred: Inferred[]) => inferred.join('.'),
    (word) => {
      const infer = INFERRED.filter((name) => word.split('.').includes(name));
      return infer.length > 0 ? infer : undefined;
    },
  ),
  field(
    'flights',
    'analysis',
    'flights',
    (flights: [number, number]) => flights.join('-'),
    (word): [number, number] | undefined => {
      const [from = 0, to = 0] = word.split('-').map(Number);
      const fine =
        Number.isInteger(from) &&
        Number.isInteger(to) &&
        from >= 1 &&
        to > from &&
        to <= MAX_FLIGHTS;
      return fine ? [from, to] : undefined;
    },
  ),
];

/** The same settings with others in their place. */
export function merged(settings: Settings, changes: Settings): Settings {
  const groups = Object.entries(changes).map(([group, fields]) => [
    group,
    { ...settings[group as Group], ...fields },
  ]);
  return { ...settings, ...Object.fromEntries(groups) };
}

/** Settings as the parameters of an address, in a fixed order. */
export function settingsToParameters(settings: Settings): URLSearchParams {
  const parameters = new URLSearchParams();
  for (const field of FIELDS) {
    const value = field.write(settings);
    if (value !== undefined) parameters.set(field.key, value);
  }
  return parameters;
}

/** Settings of an address, and the names of the parts that are not valid. */
export function settingsFromParameters(parameters: URLSearchParams): {
  settings: Settings;
  unreadable: string[];
} {
  let settings: Settings = {};
  const unreadable: string[] = [];
  for (const field of FIELDS) {
    const value = parameters.get(field.key);
    if (value === null) continue;
    const read = field.read(value);
    if (read) settings = merged(settings, read);
    else unreadable.push(field.key);
  }
  return { settings, unreadable };
}

/** As many digits as anybody states, without the noise of binary fractions. */
export const tidy = (value: number): string => String(clean(value));

const clean = (value: number): number => Number(value.toPrecision(10));

/** A number as people write it: with a point or a comma. */
export function readNumber(written: string): number | undefined {
  const trimmed = written.trim().replace(',', '.').replace('\u2212', '-');
  if (!/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(trimmed)) return undefined;
  const number = Number(trimmed);
  return Number.isFinite(number) ? number : undefined;
}
