import { expect, test } from 'vitest';
import type { Layer } from '../lab/index.ts';
import { labelOf, legendOf, pointsOf } from './points.ts';

const of = (name: string): Layer => ({
  name,
  meaning: 'measured',
  strength: 1,
  kind: 'points',
  points: [
    [1, 5],
    [2, null],
  ],
  errors: [],
  marker: 'dot',
});

test('gaps are no points', () => {
  expect(pointsOf(of('a'))).toEqual([{ x: 1, y: 5, name: 'a' }]);
});

test('a bar is read at its top', () => {
  const bars: Layer = { ...of('bar'), kind: 'boxes', boxes: [[0.5, 1.5, 0, 7]] };
  expect(pointsOf(bars)).toEqual([{ x: 1, y: 7, name: 'bar' }]);
});

test('a name stands in the legend once, and only if there is one', () => {
  expect(legendOf([of('a'), of(''), of('a')])).toHaveLength(1);
});

test('an axis names its unit if it has one', () => {
  const scale = { kind: 'linear', low: 0, high: 1 } as const;
  const axis = { quantity: 'height', unit: 'cm', scale, ticks: 'labelled', names: [] } as const;
  expect(labelOf({ ...axis, names: [] })).toBe('height (cm)');
  expect(labelOf({ ...axis, names: [], unit: '' })).toBe('height');
});
