import { expect, test } from 'vitest';
import type { Settings } from '../lab/index.ts';
import { readNumber, settingsFromParameters, settingsToParameters } from './settings.ts';

const roundTrip = (settings: Settings): Settings =>
  settingsFromParameters(new URLSearchParams(settingsToParameters(settings).toString())).settings;

test('every setting survives the address', () => {
  const settings: Settings = {
    ball: { kind: 'steel:0.01', contact_time_s: 0.001 },
    air: {
      drag: 'constant:0.4',
      temperature_k: 296.15,
      pressure_pa: 95000,
      relative_humidity: 0.35,
      buoyancy: false,
    },
    gravity: { gravity_m_s2: 9.81 },
    drop: { height_m: 0.305, height_sd_m: 0.001, first_detected: true },
    inference: { restitution_laws: ['constant', 'power'], infer: ['gravity', 'contact-time'] },
    analysis: { flights: [1, 10] },
  };
  expect(roundTrip(settings)).toEqual(settings);
  const own: Settings = {
    ball: { mass_kg: 0.0025, diameter_m: 0.038 },
    gravity: { latitude_deg: -33.9, altitude_m: 20 },
  };
  expect(roundTrip(own)).toEqual(own);
});

test('a link reads as people write', () => {
  const parameters = settingsToParameters({
    drop: { height_m: 0.305 },
    air: { temperature_k: 293.15 },
  });
  expect(parameters.toString()).toBe('temperature_c=20&height_cm=30.5');
});

test('nothing stated is an empty address', () => {
  expect(settingsToParameters({}).toString()).toBe('');
});

test('invalid values are named, the valid ones are used', () => {
  const read = settingsFromParameters(
    new URLSearchParams('ball=<script>&height_cm=tall&flights=1-1e9&temperature_c=20,5&unknown=1'),
  );
  expect(read.unreadable).toEqual(['ball', 'height_cm', 'flights']);
  expect(read.settings).toEqual({ air: { temperature_k: 293.65 } });
});

test('numbers with a comma, a sign or an exponent; nothing else', () => {
  expect(readNumber(' 30,5 ')).toBe(30.5);
  expect(readNumber('\u22121.5')).toBe(-1.5);
  expect(readNumber('1e-3')).toBe(0.001);
  for (const wrong of ['', '1.2.3', '12abc', 'NaN', 'Infinity', '1,000.5', '1e999']) {
    expect(readNumber(wrong)).toBeUndefined();
  }
});
