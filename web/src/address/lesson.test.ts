import { expect, test } from 'vitest';
import { type Lesson, lessonFromParameters, lessonToParameters } from './lesson.ts';

test('a lesson survives the address', () => {
  const lesson: Lesson = {
    balls: ['table-tennis-40', 'marble'],
    surfaces: ['Holz, lackiert', 'Stein & Beton'],
    heightsM: [0.5, 1.005],
  };
  const address = lessonToParameters(lesson).toString();
  expect(lessonFromParameters(new URLSearchParams(address))).toEqual(lesson);
  const open: Lesson = { balls: [], surfaces: [], heightsM: [] };
  expect(lessonFromParameters(lessonToParameters(open))).toEqual(open);
});

test('what is not valid in it is left out, and an address without one has none', () => {
  expect(lessonFromParameters(new URLSearchParams('ball=tennis'))).toBeNull();
  const address = 'lesson=tennis.<b>.tennis&surfaces=%20;wood&heights_cm=50;tall;-1;1,5';
  expect(lessonFromParameters(new URLSearchParams(address))).toEqual({
    balls: ['tennis'],
    surfaces: ['wood'],
    heightsM: [0.5, 0.015],
  });
});
