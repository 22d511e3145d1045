/**
 * A sound at every magnification: each level holds the minimum and maximum sample of ever longer bins.
 * Drawing a column then looks at a few bins, however long the recording.
 */

import type { Level } from '../lab/index.ts';
import type { Viewport } from './viewport.ts';

export interface Pyramid {
  readonly rateHz: number;
  /** How many samples the sound has. */
  readonly frames: number;
  /** The finest first. */
  readonly levels: readonly Level[];
}

/** Samples of a sound from one of them on. */
export interface Part {
  readonly rateHz: number;
  readonly from: number;
  readonly samples: Float32Array;
}

/** Whether a part has all samples of a view of a sound. */
export function covers(part: Part | null, { startS, endS }: Viewport, frames: number): boolean {
  if (!part) return false;
  const { rateHz, from, samples } = part;
  return from <= startS * rateHz && from + samples.length >= Math.min(frames, endS * rateHz);
}

/** The coarsest level with at least one bin a column. */
export function levelFor(pyramid: Pyramid, samplesPerColumn: number): Level | undefined {
  let chosen = pyramid.levels[0];
  for (const level of pyramid.levels) {
    if (level.samplesPerBin > samplesPerColumn) break;
    chosen = level;
  }
  return chosen;
}

/** Minimum and maximum between two samples, written into `into` at column `column`. */
export function columnOf(
  level: Level,
  fromSample: number,
  toSample: number,
  into: Float32Array,
  column: number,
): void {
  const { extremes, samplesPerBin } = level;
  const count = extremes.length / 2;
  const first = Math.max(0, Math.floor(fromSample / samplesPerBin));
  const last = Math.min(count, Math.max(first + 1, Math.ceil(toSample / samplesPerBin)));
  let least = Number.POSITIVE_INFINITY;
  let greatest = Number.NEGATIVE_INFINITY;
  for (let bin = first; bin < last; bin += 1) {
    const low = extremes[2 * bin] as number;
    const high = extremes[2 * bin + 1] as number;
    if (low < least) least = low;
    if (high > greatest) greatest = high;
  }
  into[2 * column] = least;
  into[2 * column + 1] = greatest;
}

/** The largest sample of the whole, for the height of the picture. */
export function peakOf(pyramid: Pyramid): number {
  const coarsest = pyramid.levels.at(-1);
  let peak = 0;
  for (const value of coarsest?.extremes ?? []) peak = Math.max(peak, Math.abs(value));
  return peak;
}

/** The largest sample between two moments. */
export function peakBetween(pyramid: Pyramid, startS: number, endS: number): number {
  const [from, to] = [startS * pyramid.rateHz, endS * pyramid.rateHz];
  const level = levelFor(pyramid, (to - from) / 1000);
  if (!level) return 0;
  const extremes = new Float32Array(2);
  columnOf(level, from, to, extremes, 0);
  return Math.max(0, -(extremes[0] as number), extremes[1] as number);
}
