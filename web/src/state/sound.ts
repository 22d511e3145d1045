/** The sound in the workspace: to look at closely, to play a part of it, and to save all of it. */
import { computed, effect, signal } from '@preact/signals';
import type { Recording } from '../lab/index.ts';
import { play, playing, SPEEDS, type Speed, stop } from '../sound/player.ts';
import type { Amplitude } from '../wave/amplitude.ts';
import { covers, type Part } from '../wave/pyramid.ts';
import { CoalescingQueue } from './coalescing-queue.ts';
import { faultOf } from './engine.ts';
import { fail, view, workspace } from './workspace.ts';

export const speed = signal<Speed>(SPEEDS[0]);

/** How loudness is drawn. */
export const amplitude = signal<Amplitude>('whole');

/** The longest sound that is taken as a whole, to be saved or kept with a drop: as long as a recording, s. */
const LONGEST_WHOLE_S = 1801;
export const isWhole = computed(() => (workspace.value?.durationS ?? 0) <= LONGEST_WHOLE_S);

/** More samples than these are in sight only where a picture needs none. */
const MAX_SAMPLES = 1 << 19;

interface Read extends Part {
  readonly of: Recording;
}
const read = signal<Read | null>(null);
/** The samples in sight and those beside, where one looks so closely that they are drawn. */
export const part = computed(() =>
  read.value?.of === workspace.value?.recording ? read.value : null,
);

const reader = new CoalescingQueue<Omit<Read, 'samples'> & { readonly to: number }>(
  async ({ of, rateHz, from, to }) => {
    // A file that is gone shows as coarsely as it is remembered.
    const samples = await of.samples(from / rateHz, to / rateHz).catch(() => null);
    if (samples) read.value = { of, rateHz, from, samples };
  },
);

/** From now on the samples in sight are read. */
export function keepRead(): void {
  effect(() => {
    const seen = view.value;
    const { recording: of, pyramid } = workspace.value ?? {};
    if (!of || !pyramid) return;
    const { rateHz, frames } = pyramid;
    const count = Math.ceil((seen.endS - seen.startS) * rateHz);
    if (count > MAX_SAMPLES || (part.peek() && covers(part.peek(), seen, frames))) return;
    const first = Math.floor(seen.startS * rateHz) - count;
    reader.ask({ of, rateHz, from: Math.max(0, first), to: first + 3 * count });
  });
}

/** Plays what is seen, from its beginning; or stops. */
export async function playView(): Promise<void> {
  const loaded = workspace.peek();
  if (playing.peek() || !loaded?.pyramid) return stop();
  const { startS, endS } = view.peek();
  const { recording, pyramid, name } = loaded;
  const sound = {
    rateHz: pyramid.rateHz,
    read: (fromS: number, toS: number) => recording.samples(fromS, toS),
  };
  try {
    await play(sound, startS, endS, speed.peek());
  } catch (error) {
    fail({ ...faultOf(error), about: name });
  }
}
