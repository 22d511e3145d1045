import { expect, test } from 'vitest';
import { beside, type Mark, nearest } from './mark.ts';

const marks: Mark[] = [0.5, 1, 1.2].map((timeS, id) => ({
  id,
  timeS,
  probability: 1,
  timeSdS: null,
  levelDb: null,
  quietBeforeS: null,
  lnAlike: null,
  number: null,
}));

test('the nearest mark, if it is within reach', () => {
  expect(nearest(marks, 1.11, 0.15)?.id).toBe(2);
  expect(nearest(marks, 0.8, 0.1)).toBeUndefined();
});

test('the mark before and after a moment, not the one at it', () => {
  expect(beside(marks, 1, 1)?.id).toBe(2);
  expect(beside(marks, 1, -1)?.id).toBe(0);
  expect(beside(marks, 1.2, 1)).toBeUndefined();
});
