import { expect, test } from 'vitest';
import { advance, begin, canRedo, canUndo, redo, replace, undo } from './history.ts';

test('what is undone can be done again, until something else is done', () => {
  const three = advance(advance(begin('a'), 'b'), 'c');
  const one = undo(undo(three));
  expect(one.present).toBe('a');
  expect(canUndo(one)).toBe(false);
  expect(redo(one).present).toBe('b');
  const other = advance(redo(one), 'd');
  expect(canRedo(other)).toBe(false);
  expect(undo(other).present).toBe('b');
});

test('undoing nothing changes nothing', () => {
  const start = begin(1);
  expect(undo(start)).toBe(start);
  expect(redo(start)).toBe(start);
});

test('a change within a drag is no step of its own', () => {
  const dragged = replace(replace(advance(begin(0), 1), 2), 3);
  expect(undo(dragged).present).toBe(0);
});

test('the same value again is no step', () => {
  const start = begin('a');
  expect(advance(start, 'a')).toBe(start);
});
