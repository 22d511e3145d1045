import type { Known } from '../store/drops.ts';

/** Mean and scatter of several values. */
export interface Spread {
  readonly count: number;
  readonly mean: number;
  readonly meanSd: number | null;
  readonly scatter: number | null;
  /** What a single one claims, on average (root mean square). */
  readonly claimed: number | null;
}

export function spreadOf(values: readonly (Known | null)[]): Spread | undefined {
  const known = values.filter((value): value is Known => value !== null);
  const count = known.length;
  if (count === 0) return undefined;
  const mean = known.reduce((sum, { value }) => sum + value, 0) / count;
  const squares = known.reduce((sum, { value }) => sum + (value - mean) ** 2, 0);
  // The same drop kept twice does not scatter: what is left of it is the noise of the sum.
  const spread = Math.sqrt(squares / (count - 1));
  const scatter = count > 1 ? (spread < 1e-12 * Math.abs(mean) ? 0 : spread) : null;
  const claims = known.flatMap(({ sd }) => (sd === null ? [] : [sd ** 2]));
  return {
    count,
    mean,
    meanSd: scatter === null ? null : scatter / Math.sqrt(count),
    scatter,
    claimed:
      claims.length === 0
        ? null
        : Math.sqrt(claims.reduce((sum, claim) => sum + claim, 0) / claims.length),
  };
}
