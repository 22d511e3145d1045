import { expect, test } from 'vitest';
import cases from '../../../crates/bouncelab-report/tests/quantity.json' with { type: 'json' };
import {
  estimated,
  fixed,
  LENGTH,
  NUMBER,
  PERCENT,
  rounded,
  SPEED,
  TIME,
  type Unit,
  unbroken,
} from './quantity.ts';

const UNITS: Readonly<Record<string, Unit>> = {
  number: NUMBER,
  percent: PERCENT,
  length: LENGTH,
  time: TIME,
  speed: SPEED,
};

test('the table of cases of the engine', () => {
  expect(cases.length).toBeGreaterThan(40);
  for (const { value, sd, digits, unit, text } of cases) {
    const of = UNITS[unit] ?? [];
    const written =
      digits === undefined ? estimated(value, sd, of, 'en') : rounded(value, digits, of, 'en');
    expect(written).toBe(unbroken(text));
  }
});

test('numbers are written in the manner of the language', () => {
  expect(estimated(0.946, 0.004, PERCENT, 'de')).toBe(unbroken('94,6 ± 0,4 %'));
  expect(estimated(0.946, 0.004, PERCENT, 'fr')).toBe(unbroken('94,6 ± 0,4 %'));
  expect(estimated(1234.5, 0.4, NUMBER, 'es')).toBe(unbroken('1234,5 ± 0,4'));
});

test('fixed decimals have a true minus sign, and zero has none', () => {
  expect(fixed(-1.5, 1, 'en')).toBe('\u22121.5');
  expect(fixed(-0.01, 1, 'de')).toBe('0,0');
  expect(fixed(2.5, 0, 'en')).toBe('2');
});
