import { expect, test } from 'vitest';
import { LiveEnvelope } from './live-envelope.ts';

test('bins hold the extremes, whatever the blocks', () => {
  const envelope = new LiveEnvelope(8, 2, 2);
  envelope.add(Float32Array.of(0.1, -0.5, 0.2));
  expect(envelope.add(Float32Array.of(0.3, 0.9, 0, 0, 0))).toBeCloseTo(0.9);
  expect(envelope.bin(0)[0]).toBeCloseTo(-0.5);
  expect(envelope.bin(0)[1]).toBeCloseTo(0.3);
  expect(envelope.bin(1)[1]).toBeCloseTo(0.9);
});

test('what is older than the window is forgotten', () => {
  const envelope = new LiveEnvelope(4, 1, 2);
  envelope.add(Float32Array.of(1, 1, 0, 0, 0.5, 0.5, 0, 0, 0));
  expect(envelope.bin(0)).toEqual([0, 0]);
  expect(envelope.newest).toBe(4);
});
