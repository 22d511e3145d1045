import { expect, test } from 'vitest';
import { lineThrough } from './experiment.ts';

/**
 * Flight times of a drop from 30.5 cm with constant e = 0.9529 and a terminal speed of 9.384954 m/s,
 * g = 9.81, by an independent solver: their line says e = 0.9375 and 28.77 cm.
 */
const TIMES = [0.4605, 0.4272, 0.3977, 0.3714, 0.3477, 0.3263, 0.3067, 0.2887, 0.2722, 0.2569];

test('the straight line of the paper', () => {
  const line = lineThrough(TIMES);
  expect(line.restitution).toBeCloseTo(0.9375, 3);
  expect(line.heightM).toBeCloseTo(0.2877, 3);
});

/** T_n = 2 e^n sqrt(2 h0/g), so that the line finds what was put in. */
test('without air the line finds the truth', () => {
  const times = Array.from(
    { length: 8 },
    (_, i) => 2 * 0.9 ** (i + 1) * Math.sqrt((2 * 0.5) / 9.81),
  );
  const line = lineThrough(times);
  expect(line.restitution).toBeCloseTo(0.9, 10);
  expect(line.heightM).toBeCloseTo(0.5, 10);
});
