import { expect, test } from 'vitest';
import { advance, redo, undo } from './history.ts';
import {
  added,
  asDetected,
  dropNear,
  editsOf,
  forEngine,
  isEdited,
  markAt,
  removed,
  withChange,
} from './marks.ts';

const detected = [1, 2, 4].map((number) => ({
  number,
  time_s: number / 2,
  time_sd_s: 1e-5,
  probability: 0.98,
  level_db: -20,
  quiet_before_s: null,
  ln_alike: null,
}));

test('what no hand touched goes to the engine as it was detected, gaps in the numbers included', () => {
  expect(forEngine(editsOf(detected), 0.99)).toEqual({
    edited: false,
    probability: 0.99,
    impacts: detected,
  });
});

test('an added impact is in order of time, and can be undone and done again', () => {
  const before = editsOf(detected);
  const after = added(before, markAt(1.5));
  expect(after.present.map(({ timeS }) => timeS)).toEqual([0.5, 1, 1.5, 2]);
  expect(isEdited(after)).toBe(true);
  expect(isEdited(undo(after))).toBe(false);
  expect(redo(undo(after)).present).toHaveLength(4);
});

test('removing what is not there is no step', () => {
  const before = editsOf(detected);
  expect(removed(before, -1)).toBe(before);
  const first = before.present[0];
  expect(removed(before, first?.id ?? 0).present).toHaveLength(2);
});

test('a mark that is moved past another changes places with it', () => {
  const { present } = editsOf(detected);
  const moved = withChange(present, present[0]?.id ?? 0, { timeS: 1.2, timeSdS: null });
  expect(moved.map(({ timeS }) => timeS)).toEqual([1, 1.2, 2]);
  expect(moved[1]?.timeSdS).toBeNull();
});

test('what was put back as it was detected is not edited, however many steps lie between', () => {
  let edits = editsOf(detected);
  for (let step = 0; step < 500; step += 1) edits = added(edits, markAt(3 + step));
  const restored = advance(edits, asDetected(edits));
  expect(isEdited(restored)).toBe(false);
  expect(forEngine(restored, 1)).toMatchObject({ edited: false, impacts: detected });
});

test('a kept drop is found again among those of its recording, edited or not', () => {
  const later = detected.map((one) => ({ ...one, time_s: 10 + one.time_s }));
  const drops = [editsOf(detected), editsOf(later)];
  const first = drops[1]?.present[0];
  const kept = removed(drops[1] ?? editsOf(later), first?.id ?? 0);
  expect(dropNear(drops, forEngine(kept, 1))).toBe(1);
  expect(dropNear(drops, forEngine(editsOf(detected), 1))).toBe(0);
});
