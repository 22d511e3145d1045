import { expect, test } from 'vitest';
import { spreadOf } from './spread.ts';

/** Values and standard deviation worked out by hand: mean 0.9, squares 0.0002, over n - 1 = 2. */
test('mean, scatter, and what a single drop claims', () => {
  const spread = spreadOf([
    { value: 0.89, sd: 0.003 },
    { value: 0.9, sd: 0.004 },
    { value: 0.91, sd: null },
    null,
  ]);
  expect(spread?.count).toBe(3);
  expect(spread?.mean).toBeCloseTo(0.9);
  expect(spread?.scatter).toBeCloseTo(0.01);
  expect(spread?.meanSd).toBeCloseTo(0.01 / Math.sqrt(3));
  expect(spread?.claimed).toBeCloseTo(Math.sqrt((9e-6 + 16e-6) / 2));
});

test('the same drop kept again does not scatter', () => {
  const drop = { value: 0.9528697445876, sd: 1e-5 };
  expect(spreadOf([drop, drop, drop])).toMatchObject({ scatter: 0, meanSd: 0 });
});

test('one drop has no scatter, none has nothing', () => {
  expect(spreadOf([{ value: 0.9, sd: null }])).toEqual({
    count: 1,
    mean: 0.9,
    meanSd: null,
    scatter: null,
    claimed: null,
  });
  expect(spreadOf([null])).toBeUndefined();
});
