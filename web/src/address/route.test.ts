import { expect, test } from 'vitest';
import { hashOf, parseRoute } from './route.ts';

test('a view with its parameters', () => {
  const { view, parameters } = parseRoute('#simulate?e=0.9');
  expect(view).toBe('simulate');
  expect(parameters.get('e')).toBe('0.9');
  expect(hashOf(view, parameters)).toBe('#simulate?e=0.9');
});

test('an unknown place is the laboratory', () => {
  for (const hash of ['', '#', '#nowhere', '#/lab']) expect(parseRoute(hash).view).toBe('lab');
  expect(hashOf('lab')).toBe('#lab');
});
