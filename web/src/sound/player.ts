import { signal } from '@preact/signals';

/** How fast a part is played; slower is also lower, as with a tape, so that nothing is invented. */
export const SPEEDS = [1, 0.5, 0.25, 0.1] as const;
export type Speed = (typeof SPEEDS)[number];

/** What is played now. */
export interface Playing {
  /** Where in the recording it began, s. */
  readonly fromS: number;
  readonly speed: number;
  /** When it began, on the clock of the audio context. */
  readonly startedAt: number;
}

export const playing = signal<Playing | null>(null);

let context: AudioContext | undefined;
let source: AudioBufferSourceNode | undefined;

/** Plays samples from now on; what was played before stops. */
export async function play(
  samples: Float32Array,
  rateHz: number,
  fromS: number,
  speed: number,
): Promise<void> {
  stop();
  if (samples.length === 0) return;
  context ??= new AudioContext();
  await context.resume();
  const buffer = context.createBuffer(1, samples.length, rateHz);
  buffer.copyToChannel(samples.slice(), 0);
  const node = context.createBufferSource();
  node.buffer = buffer;
  node.playbackRate.value = speed;
  node.connect(context.destination);
  node.onended = () => {
    if (source === node) stop();
  };
  source = node;
  node.start();
  playing.value = { fromS, speed, startedAt: context.currentTime };
}

export function stop(): void {
  if (source) {
    source.onended = null;
    source.stop();
    source.disconnect();
    source = undefined;
  }
  playing.value = null;
}

/** The moment of the recording that is played now, s. */
export function playheadS(): number | null {
  const now = playing.value;
  if (!now || !context) return null;
  return now.fromS + (context.currentTime - now.startedAt) * now.speed;
}
