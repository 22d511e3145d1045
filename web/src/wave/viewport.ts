/** The part of a recording that is seen: pure arithmetic, so that it can be tested without a screen. */
export interface Viewport {
  readonly startS: number;
  readonly endS: number;
}

/** The closest one can look: a few hundred samples. */
const CLOSEST_S = 0.004;

export const widthS = (view: Viewport): number => view.endS - view.startS;

export const whole = (durationS: number): Viewport => ({
  startS: 0,
  endS: Math.max(durationS, CLOSEST_S),
});

/** Keeps the view inside the recording, at its width where that is possible. */
export function clamped(view: Viewport, durationS: number): Viewport {
  const full = Math.max(durationS, CLOSEST_S);
  const width = Math.min(Math.max(widthS(view), CLOSEST_S), full);
  const startS = Math.min(Math.max(view.startS, 0), full - width);
  return { startS, endS: startS + width };
}

/** Zooms by a factor (above 1: closer), the moment `aroundS` staying where it is. */
export function zoomed(
  view: Viewport,
  factor: number,
  aroundS: number,
  durationS: number,
): Viewport {
  const full = Math.max(durationS, CLOSEST_S);
  const width = Math.min(Math.max(widthS(view) / factor, CLOSEST_S), full);
  const share = widthS(view) > 0 ? (aroundS - view.startS) / widthS(view) : 0.5;
  const startS = aroundS - share * width;
  return clamped({ startS, endS: startS + width }, durationS);
}

/** Moves by a number of seconds. */
export function panned(view: Viewport, byS: number, durationS: number): Viewport {
  return clamped({ startS: view.startS + byS, endS: view.endS + byS }, durationS);
}

/** The smallest move that makes a time visible, with a margin. */
export function revealing(view: Viewport, timeS: number, durationS: number): Viewport {
  const margin = 0.1 * widthS(view);
  if (timeS < view.startS + margin) return panned(view, timeS - margin - view.startS, durationS);
  if (timeS > view.endS - margin) return panned(view, timeS + margin - view.endS, durationS);
  return view;
}

/** A stretch with margins around it, as of one drop. */
export function framing(fromS: number, toS: number, durationS: number): Viewport {
  const margin = 0.06 * (toS - fromS) + 0.02;
  return clamped({ startS: fromS - margin, endS: toS + margin }, durationS);
}

/** Round moments for the ruler, about every `spacing` pixels. */
export function ticks(view: Viewport, pixels: number, spacing: number): readonly number[] {
  const step = roundStep((widthS(view) * spacing) / Math.max(pixels, 1));
  const first = Math.ceil(view.startS / step);
  const last = Math.floor(view.endS / step);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => (first + i) * step);
}

/** The next of 1, 2, 5, 10, ... */
export function roundStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  const found = [1, 2, 5].find((digit) => digit * power >= least * (1 - 1e-9));
  return (found ?? 10) * power;
}

/** Decimals with which neighbouring ticks differ. */
export function tickDecimals(view: Viewport, pixels: number, spacing: number): number {
  const step = roundStep((widthS(view) * spacing) / Math.max(pixels, 1));
  return Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
}
