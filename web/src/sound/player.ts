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

/** Something to play: samples a second, and those from one time to another. */
export interface Playable {
  readonly rateHz: number;
  read(fromS: number, toS: number): Promise<Float32Array<ArrayBuffer>>;
}

/** Length of what is read at once, s: the next part is read while one is played. */
const PART_S = 20;

let context: AudioContext | undefined;
/** What is played, or waits. */
interface Part {
  readonly node: AudioBufferSourceNode;
  readonly ended: Promise<unknown>;
}
let parts: Part[] = [];
/** Counts what was stopped: what is read for it comes too late. */
let stops = 0;

/** Plays a sound from one time to another; what was played before stops. */
export async function play(
  { rateHz, read }: Playable,
  fromS: number,
  toS: number,
  speed: number,
): Promise<void> {
  stop();
  const mine = stops;
  context ??= new AudioContext();
  await context.resume();
  let nextAt = 0;
  for (let partS = fromS; partS < toS; partS += PART_S) {
    const samples = await read(partS, Math.min(toS, partS + PART_S));
    if (mine !== stops) return;
    if (samples.length === 0) break;
    const part = partOf(context, samples, rateHz, speed);
    nextAt = Math.max(nextAt, context.currentTime);
    part.node.start(nextAt);
    if (partS === fromS) playing.value = { fromS, speed, startedAt: nextAt };
    nextAt += samples.length / rateHz / speed;
    parts.push(part);
    if (parts.length > 1) await parts.shift()?.ended;
    if (mine !== stops) return;
  }
  await parts[0]?.ended;
  if (mine === stops) stop();
}

function partOf(
  context: AudioContext,
  samples: Float32Array<ArrayBuffer>,
  rateHz: number,
  speed: number,
): Part {
  const buffer = context.createBuffer(1, samples.length, rateHz);
  buffer.copyToChannel(samples, 0);
  const node = context.createBufferSource();
  node.buffer = buffer;
  node.playbackRate.value = speed;
  node.connect(context.destination);
  return { node, ended: new Promise((end) => node.addEventListener('ended', end)) };
}

export function stop(): void {
  stops += 1;
  for (const { node } of parts) {
    node.stop();
    node.disconnect();
  }
  parts = [];
  playing.value = null;
}

/** The moment of the recording that is played now, s. */
export function playheadS(): number | null {
  const now = playing.value;
  if (!now || !context) return null;
  return now.fromS + (context.currentTime - now.startedAt) * now.speed;
}
