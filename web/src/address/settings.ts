/**
 * Settings as part of the address, so that a set-up can be shared as a link. Units are those people
 * write, the names say which; what is left out is assumed.
 */
import type { Settings } from '../lab/index.ts';

/** How one setting is written into the address and read back. */
interface Field {
  readonly key: string;
  write(settings: Settings): string | undefined;
  /** `undefined` if the text is no valid value. */
  read(text: string): Settings | undefined;
}

type NumberKey = {
  [K in keyof Settings]-?: NonNullable<Settings[K]> extends number ? K : never;
}[keyof Settings];

type TextKey = {
  [K in keyof Settings]-?: NonNullable<Settings[K]> extends string ? K : never;
}[keyof Settings];

type FlagKey = {
  [K in keyof Settings]-?: NonNullable<Settings[K]> extends boolean ? K : never;
}[keyof Settings];

/** A number, shown as `si / size + offset`. */
function number(key: string, setting: NumberKey, size = 1, offset = 0): Field {
  return {
    key,
    write: (settings) => {
      const value = settings[setting];
      return value === undefined || value === null ? undefined : tidy(value / size + offset);
    },
    read: (text) => {
      const value = readNumber(text);
      return value === undefined ? undefined : { [setting]: clean((value - offset) * size) };
    },
  };
}

function text(key: string, setting: TextKey): Field {
  return {
    key,
    write: (settings) => settings[setting] ?? undefined,
    read: (word) => (/^[\w.:-]{1,40}$/.test(word) ? { [setting]: word } : undefined),
  };
}

function flag(key: string, setting: FlagKey): Field {
  return {
    key,
    write: (settings) => {
      const value = settings[setting];
      return value === undefined || value === null ? undefined : value ? 'yes' : 'no';
    },
    read: (word) => (word === 'yes' || word === 'no' ? { [setting]: word === 'yes' } : undefined),
  };
}

/** No drop has more. */
const MAX_FLIGHTS = 10_000;

const INFERRED = ['gravity', 'drag', 'contact-time'] as const;

const FIELDS: readonly Field[] = [
  text('ball', 'ball'),
  number('mass_g', 'mass_kg', 1e-3),
  number('diameter_mm', 'diameter_m', 1e-3),
  number('contact_ms', 'contact_time_s', 1e-3),
  text('drag', 'drag'),
  number('temperature_c', 'temperature_k', 1, -273.15),
  number('pressure_hpa', 'pressure_pa', 100),
  number('humidity_percent', 'relative_humidity', 0.01),
  number('air_kg_m3', 'air_density_kg_m3'),
  number('air_pa_s', 'air_viscosity_pa_s'),
  flag('buoyancy', 'buoyancy'),
  flag('added_mass', 'added_mass'),
  number('gravity', 'gravity_m_s2'),
  number('latitude', 'latitude_deg'),
  number('altitude_m', 'altitude_m'),
  number('height_cm', 'height_m', 0.01),
  number('height_sd_mm', 'height_sd_m', 1e-3),
  flag('first_detected', 'first_detected'),
  {
    key: 'law',
    write: (settings) => settings.restitution_laws?.join('.'),
    read: (word) =>
      /^[a-z.-]{1,80}$/.test(word) ? { restitution_laws: word.split('.') } : undefined,
  },
  {
    key: 'infer',
    write: (settings) => settings.infer?.join('.'),
    read: (word) => {
      const infer = INFERRED.filter((name) => word.split('.').includes(name));
      return infer.length > 0 ? { infer } : undefined;
    },
  },
  {
    key: 'flights',
    write: (settings) => settings.flights?.join('-'),
    read: (word) => {
      const [from = 0, to = 0] = word.split('-').map(Number);
      const fine =
        Number.isInteger(from) &&
        Number.isInteger(to) &&
        from >= 1 &&
        to > from &&
        to <= MAX_FLIGHTS;
      return fine ? { flights: [from, to] } : undefined;
    },
  },
];

/** Settings as the parameters of an address, in a fixed order. */
export function settingsToParameters(settings: Settings): URLSearchParams {
  const parameters = new URLSearchParams();
  for (const field of FIELDS) {
    const value = field.write(settings);
    if (value !== undefined) parameters.set(field.key, value);
  }
  return parameters;
}

/** Settings of an address, and the names of the parts that make no sense. */
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
    if (read) settings = { ...settings, ...read };
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
