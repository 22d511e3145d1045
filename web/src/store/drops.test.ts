import { expect, test } from 'vitest';
import { type KeptDrop, upToDate } from './drops.ts';

test('a drop that an earlier version kept is read as one of today', () => {
  const impact = { number: 1, time_s: 0.5, probability: 1, level_db: -20 };
  const kept = { marks: { edited: true, impacts: [{ ...impact, sigma_s: 1e-5 }, impact] } };
  expect(upToDate(kept as unknown as KeptDrop).marks).toEqual({
    edited: true,
    probability: 1,
    impacts: [
      { ...impact, time_sd_s: 1e-5 },
      { ...impact, time_sd_s: null },
    ],
  });
  const now = upToDate(kept as unknown as KeptDrop);
  expect(upToDate(now)).toEqual(now);
});
