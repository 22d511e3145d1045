import { expect, test } from 'vitest';
import {
  between,
  CENTIMETRE,
  decimalsFor,
  fixed,
  PERCENT,
  PLAIN,
  plain,
  uncertain,
} from './quantity.ts';

const THIN = '\u202f';

/** The rule of `bouncelab_report::quantity`: one digit, or two when it begins with 1 or 2. */
test('an uncertainty has one digit, or two when it begins with 1 or 2', () => {
  expect(uncertain(0.94612, 0.0021, PERCENT, 'en')).toBe(`94.61 ± 0.21${THIN}%`);
  expect(uncertain(0.30441, 0.0062, CENTIMETRE, 'en')).toBe(`30.4 ± 0.6${THIN}cm`);
  expect(uncertain(0.946, 0.0004, PLAIN, 'en')).toBe('0.9460 ± 0.0004');
});

test('what rounds up to begin with 1 has the two digits of a 1', () => {
  expect(uncertain(5, 0.0999, PLAIN, 'en')).toBe('5.00 ± 0.10');
  expect(decimalsFor(0.2999)).toBe(1);
});

test('a value without uncertainty keeps the digits asked for', () => {
  expect(plain(0.30500001, CENTIMETRE, 3, 'en')).toBe(`30.5${THIN}cm`);
  expect(uncertain(0.5, null, PLAIN, 'en')).toBe('0.500');
});

test('numbers are written in the manner of the language', () => {
  expect(uncertain(0.946, 0.004, PERCENT, 'de')).toBe(`94,6 ± 0,4${THIN}%`);
  expect(uncertain(0.946, 0.004, PERCENT, 'fr')).toBe(`94,6 ± 0,4${THIN}%`);
  expect(uncertain(1234.5, 0.4, PLAIN, 'es')).toBe('1234,5 ± 0,4');
  expect(fixed(-1.5, 1, 'en')).toBe('\u22121.5');
});

test('a range ends where its uncertainty ends', () => {
  expect(between([0.46012, 0.49333], 0.008, CENTIMETRE, 'to', 'en')).toBe(`46.0 to 49.3${THIN}cm`);
});

test('an uncertainty above ten rounds the digits before the point', () => {
  expect(uncertain(1234, 31, PLAIN, 'en')).toBe('1230 ± 30');
});

test('zero without an uncertainty is zero, whatever the digits asked for', () => {
  expect(plain(0, PLAIN, 3, 'en')).toBe('0');
  expect(plain(0, CENTIMETRE, 3, 'de')).toBe('0\u202fcm');
});
