import { expect, test } from 'vitest';
import { actionOf } from './keys.ts';

const key = (
  name: string,
  held: Partial<Record<'shiftKey' | 'altKey' | 'ctrlKey', boolean>> = {},
) =>
  actionOf({ key: name, shiftKey: false, altKey: false, ctrlKey: false, metaKey: false, ...held });

test('arrows move the cursor, finely with Shift, and the impact with Alt', () => {
  expect(key('ArrowLeft')).toEqual({ kind: 'cursor', by: -1, fine: false });
  expect(key('ArrowRight', { shiftKey: true })).toEqual({ kind: 'cursor', by: 1, fine: true });
  expect(key('ArrowRight', { altKey: true })).toEqual({ kind: 'nudge', by: 1 });
});

test('undo and redo are where hands expect them', () => {
  expect(key('z', { ctrlKey: true })).toEqual({ kind: 'undo' });
  expect(key('Z', { ctrlKey: true, shiftKey: true })).toEqual({ kind: 'redo' });
  expect(key('y', { ctrlKey: true })).toEqual({ kind: 'redo' });
});

test('keys of the browser stay with the browser', () => {
  for (const name of ['Tab', 'F5', 'a', 'r']) expect(key(name)).toBeUndefined();
  expect(key('r', { ctrlKey: true })).toBeUndefined();
});
