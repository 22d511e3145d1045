import { expect, test } from 'vitest';
import { type ChartSpec, keyOf, padded, yValues } from './spec.ts';

test('error bars are in sight, gaps do not count', () => {
  expect(
    yValues([
      { kind: 'points', meaning: 'measured', label: '', x: [1, 2], y: [5, null], sd: [1, null] },
    ]),
  ).toEqual([4, 6]);
});

test('noise does not fill the picture', () => {
  const [low, high] = padded([0.95, 0.9501], { label: '', atLeast: 0.02 });
  expect(high - low).toBeGreaterThan(0.02);
});

test('a logarithmic axis keeps its room by a factor, and no data are no fault', () => {
  const [low, high] = padded([0.01, 1], { label: '', log: true });
  expect(low).toBeGreaterThan(0);
  expect(low).toBeLessThan(0.01);
  expect(high).toBeGreaterThan(1);
  expect(padded([], { label: '' })).toEqual([0, 1]);
});

test('a name stands in the key once', () => {
  const points = { kind: 'points', meaning: 'measured', label: 'a', x: [], y: [] } as const;
  const spec: ChartSpec = { x: { label: '' }, y: { label: '' }, layers: [points, points] };
  expect(keyOf(spec)).toHaveLength(1);
});
