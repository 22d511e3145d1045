/** A simulated drop as part of the address. */
import { readNumber, tidy } from './settings.ts';

/** Where the sliders of the simulation stand. */
export interface SimulationSetup {
  readonly heightM: number;
  readonly restitution: number;
  /** -d ln e/d ln v. */
  readonly slope: number;
  readonly ball: string;
  readonly drag: string;
  readonly body: string;
  /** A restitution law with its numbers; if empty, that of the sliders. */
  readonly law: string;
  /** Pressure of the air as a share of what it is there. */
  readonly air: number;
}

export const USUAL: SimulationSetup = {
  heightM: 0.305,
  restitution: 0.94,
  slope: 0,
  ball: 'table-tennis-40',
  drag: 'standard',
  body: 'earth',
  law: '',
  air: 1,
};

/** The sliders with a number: where they begin and end, and how they are written. */
export const SLIDERS = {
  heightM: { key: 'height_cm', size: 0.01, min: 0.05, max: 2, step: 0.005 },
  restitution: { key: 'e', size: 1, min: 0.3, max: 0.99, step: 0.0025 },
  slope: { key: 'slope', size: 1, min: 0, max: 0.1, step: 0.0025 },
  air: { key: 'air_percent', size: 0.01, min: 0, max: 2, step: 0.02 },
} as const;
export type Slider = keyof typeof SLIDERS;

const WORDS = ['ball', 'drag', 'body', 'law'] as const;

export function simulationToParameters(setup: SimulationSetup): URLSearchParams {
  const parameters = new URLSearchParams();
  for (const [name, { key, size }] of Object.entries(SLIDERS)) {
    const value = setup[name as Slider];
    if (value !== USUAL[name as Slider]) parameters.set(key, tidy(value / size));
  }
  for (const name of WORDS) {
    if (setup[name] !== USUAL[name]) parameters.set(name, setup[name]);
  }
  return parameters;
}

/** An invalid value is replaced by the default: a slider always shows the value in use. */
export function simulationFromParameters(parameters: URLSearchParams): SimulationSetup {
  const setup: { -readonly [K in keyof SimulationSetup]: SimulationSetup[K] } = { ...USUAL };
  for (const [name, { key, size, min, max }] of Object.entries(SLIDERS)) {
    const value = readNumber(parameters.get(key) ?? '');
    if (value === undefined) continue;
    setup[name as Slider] = Math.min(max, Math.max(min, Number((value * size).toPrecision(10))));
  }
  for (const name of WORDS) {
    const word = parameters.get(name);
    if (word !== null && /^[\w.:,-]{1,60}$/.test(word)) setup[name] = word;
  }
  return setup;
}
