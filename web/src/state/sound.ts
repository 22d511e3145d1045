/** The sound in the workspace: to play a part of it, and to save all of it. */
import { signal } from '@preact/signals';
import { play, playing, SPEEDS, type Speed, stop } from '../sound/player.ts';
import type { Amplitude } from '../wave/amplitude.ts';
import { view, workspace } from './workspace.ts';

export const speed = signal<Speed>(SPEEDS[0]);

/** How loudness is drawn. */
export const amplitude = signal<Amplitude>('whole');

/** Plays what is seen, from its beginning; or stops. */
export async function playView(): Promise<void> {
  const loaded = workspace.peek();
  if (playing.peek() || !loaded?.pyramid) return stop();
  const { startS, endS } = view.peek();
  const samples = loaded.recording.samples(startS, endS);
  await play(samples, loaded.pyramid.rateHz, startS, speed.peek());
}
