import { expect, test } from 'vitest';
import { columnOf, levelFor, type Pyramid, peakOf } from './pyramid.ts';

const levels = [
  { samplesPerBin: 2, extremes: Float32Array.of(-1, 1, -2, 0, 0, 3, -4, 2) },
  { samplesPerBin: 4, extremes: Float32Array.of(-2, 1, -4, 3) },
];
const pyramid: Pyramid = { rateHz: 8, frames: 8, levels };

test('the level is the coarsest with at least one bin a column', () => {
  expect(levelFor(pyramid, 1)?.samplesPerBin).toBe(2);
  expect(levelFor(pyramid, 3)?.samplesPerBin).toBe(2);
  expect(levelFor(pyramid, 100)?.samplesPerBin).toBe(4);
});

test('a column holds the least and greatest of all bins that it touches', () => {
  const column = new Float32Array(2);
  const [fine] = levels;
  if (!fine) throw new Error('no level');
  columnOf(fine, 1, 5, column, 0);
  expect([...column]).toEqual([-2, 3]);
  columnOf(fine, 6, 20, column, 0);
  expect([...column]).toEqual([-4, 2]);
});

test('the peak is that of the whole', () => {
  expect(peakOf(pyramid)).toBe(4);
});
