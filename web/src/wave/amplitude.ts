/** How high a sample is drawn. */
import { type Pyramid, peakBetween, peakOf } from './pyramid.ts';
import type { Viewport } from './viewport.ts';

/** By the loudest of the recording; by the loudest in sight; in decibels below the loudest. */
export const AMPLITUDES = ['whole', 'view', 'decibels'] as const;
export type Amplitude = (typeof AMPLITUDES)[number];

/** Softer than this below the loudest shows as nothing, dB. */
const SOFTEST_DB = -60;

/** The height of a sample as a share of what there is above the middle, -1 to 1. */
export function heightOf(
  amplitude: Amplitude,
  pyramid: Pyramid,
  { startS, endS }: Viewport,
): (sample: number) => number {
  const peak = amplitude === 'view' ? peakBetween(pyramid, startS, endS) : peakOf(pyramid);
  if (!(peak > 0) || !Number.isFinite(peak)) return () => 0;
  if (amplitude !== 'decibels') return (sample) => sample / peak;
  return (sample) => {
    const db = 20 * Math.log10(Math.abs(sample) / peak);
    return Math.sign(sample) * Math.max(0, 1 - db / SOFTEST_DB);
  };
}
