import { expect, test } from 'vitest';
import { heightOf } from './amplitude.ts';
import type { Pyramid } from './pyramid.ts';

/** A loud sound in the first second, a faint one in the next. */
const pyramid: Pyramid = {
  rateHz: 2,
  frames: 4,
  levels: [{ samplesPerBin: 2, extremes: new Float32Array([-0.5, 0.5, -0.005, 0.005]) }],
};
const [loud, faint] = [
  { startS: 0, endS: 1 },
  { startS: 1, endS: 2 },
];

test('a faint sound is as high as the view if it is scaled to it', () => {
  expect(heightOf('whole', pyramid, faint)(0.005)).toBeCloseTo(0.01, 6);
  expect(heightOf('view', pyramid, faint)(0.005)).toBeCloseTo(1, 6);
  expect(heightOf('view', pyramid, loud)(-0.25)).toBeCloseTo(-0.5, 6);
});

test('in decibels a hundredth is 40 dB down, and what is too soft is nothing', () => {
  const height = heightOf('decibels', pyramid, faint);
  expect(height(0.5)).toBeCloseTo(1, 6);
  expect(height(-0.005)).toBeCloseTo(-1 / 3, 6);
  expect(height(0.0001)).toBe(0);
  expect(height(0)).toBe(0);
});

test('silence has no height', () => {
  const silent = { ...pyramid, levels: [{ samplesPerBin: 2, extremes: new Float32Array(4) }] };
  for (const amplitude of ['whole', 'view', 'decibels'] as const) {
    expect(heightOf(amplitude, silent, loud)(0)).toBe(0);
  }
});
