/** The sound on the bench: to hear a part of it, and to save all of it. */
import { signal } from '@preact/signals';
import { play, playing, SPEEDS, type Speed, stop } from '../sound/player.ts';
import { onBench, view } from './bench.ts';

export const speed = signal<Speed>(SPEEDS[0]);

/** Plays what is seen, from its beginning; or stops. */
export async function hearView(): Promise<void> {
  const bench = onBench.peek();
  if (playing.peek() || !bench?.pyramid) return stop();
  const { startS, endS } = view.peek();
  const samples = bench.recording.samples(startS, endS);
  await play(samples, bench.pyramid.rateHz, startS, speed.peek());
}
