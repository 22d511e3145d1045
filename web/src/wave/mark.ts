/** An impact as it stands on the waveform. */
export interface Mark {
  /** Stays the same while it is moved. */
  readonly id: number;
  readonly timeS: number;
  /** That it is an impact of this drop. */
  readonly probability: number;
  /** Standard uncertainty of the time, s; unknown if it was set by hand. */
  readonly timeSdS: number | null;
  readonly levelDb: number | null;
  /** How long nothing as loud was heard before it, s; known for the first impact detected. */
  readonly quietBeforeS: number | null;
  /** Logarithm of how much more it sounds like this ball than like any other sound; known for the first impact detected. */
  readonly lnAlike: number | null;
  /** Its number as detected; a missed impact leaves a gap. */
  readonly number: number | null;
}

export { CONFIDENT_PROBABILITY as CERTAIN } from '../lab/engine/types.ts';

export const inOrder = (marks: readonly Mark[]): readonly Mark[] =>
  marks.toSorted((a, b) => a.timeS - b.timeS);

/** The mark nearest to a moment, if it is within reach. */
export function nearest(marks: readonly Mark[], timeS: number, reachS: number): Mark | undefined {
  let found: Mark | undefined;
  let least = reachS;
  for (const mark of marks) {
    const distance = Math.abs(mark.timeS - timeS);
    if (distance <= least) {
      least = distance;
      found = mark;
    }
  }
  return found;
}

/** The next mark after a moment, or before it. */
export function beside(marks: readonly Mark[], timeS: number, direction: 1 | -1): Mark | undefined {
  const sorted = inOrder(marks);
  const beyond = (mark: Mark): boolean => (mark.timeS - timeS) * direction > 1e-9;
  return direction > 0 ? sorted.find(beyond) : sorted.findLast(beyond);
}
