/** The impacts of each drop, with all that was done to them: pure steps over histories. */
import type { DropMarks, Impact } from '../lab/index.ts';
import { inOrder, type Mark } from '../wave/mark.ts';
import { advance, begin, type History } from './history.ts';

export type Edits = History<readonly Mark[]>;

let nextId = 1;

export function marksOf(impacts: readonly Impact[]): readonly Mark[] {
  return impacts.map((impact) => ({
    id: nextId++,
    timeS: impact.time_s,
    probability: impact.probability,
    timeSdS: impact.time_sd_s,
    levelDb: impact.level_db,
    quietBeforeS: impact.quiet_before_s,
    lnAlike: impact.ln_alike,
    number: impact.number,
  }));
}

export const editsOf = (impacts: readonly Impact[]): Edits => begin(marksOf(impacts));

/** A mark that a hand sets. */
export function markAt(timeS: number): Mark {
  const unknown = { timeSdS: null, levelDb: null, quietBeforeS: null, lnAlike: null, number: null };
  return { id: nextId++, timeS, probability: 1, ...unknown };
}

export function added(edits: Edits, mark: Mark): Edits {
  return advance(edits, inOrder([...edits.present, mark]));
}

export function removed(edits: Edits, id: number): Edits {
  const rest = edits.present.filter((mark) => mark.id !== id);
  return rest.length === edits.present.length ? edits : advance(edits, rest);
}

/** The marks with one of them changed, in order. */
export function withChange(
  marks: readonly Mark[],
  id: number,
  changes: Partial<Mark>,
): readonly Mark[] {
  return inOrder(marks.map((mark) => (mark.id === id ? { ...mark, ...changes } : mark)));
}

/** As it was detected, before any change by hand. */
export const asDetected = ({ past, present }: Edits): readonly Mark[] => past[0] ?? present;

/** Whether a hand has changed anything since it was detected. */
export const isEdited = (edits: Edits): boolean => edits.present !== asDetected(edits);

/** As the engine wants them. Numbers with their gaps hold as long as no hand changed anything. */
export function forEngine(edits: Edits, probability: number): DropMarks {
  return {
    probability,
    edited: isEdited(edits),
    impacts: edits.present.map((mark, index) => ({
      number: mark.number ?? index + 1,
      time_s: mark.timeS,
      time_sd_s: mark.timeSdS,
      probability: mark.probability,
      level_db: mark.levelDb,
      quiet_before_s: mark.quietBeforeS,
      ln_alike: mark.lnAlike,
    })),
  };
}

/** Which of several drops begins next to where a kept one begins. */
export function dropNear(drops: readonly Edits[], { impacts }: DropMarks): number {
  const beginsAt = impacts[0]?.time_s ?? 0;
  const apart = drops.map(({ present: [first] }) =>
    Math.abs((first?.timeS ?? Number.POSITIVE_INFINITY) - beginsAt),
  );
  return apart.indexOf(Math.min(...apart));
}
