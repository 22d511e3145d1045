/** What kept drops say together, by groups. */
import { signal } from '@preact/signals';
import type { StudyRequest } from '../lab/index.ts';
import type { KeptDrop } from '../store/drops.ts';
import { text } from '../text/language.ts';
import { ballName, UNSTATED } from '../text/names.ts';
import { alter, kept } from './keeping.ts';
import { measureMarks } from './measuring.ts';
import { isOwnBall } from './settings.ts';

/** What drops can be compared by. */
export const FIELDS = ['ball', 'surface', 'student'] as const;
export type Field = (typeof FIELDS)[number];

/** The fields that make groups. */
export const grouping = signal<ReadonlySet<Field>>(new Set(['ball', 'surface']));

export function toggle(field: Field): void {
  const next = new Set(grouping.peek());
  if (!next.delete(field)) next.add(field);
  grouping.value = next;
}

/** The preset of a drop, if it is of one; `UNSTATED` if no ball was stated. */
export const presetOf = ({ settings }: KeptDrop): string | undefined =>
  isOwnBall(settings) ? undefined : (settings.ball?.kind ?? UNSTATED);

/** The ball by its name in the language of the page, where it has one. */
export function ballOf(drop: KeptDrop): string {
  const preset = presetOf(drop);
  return preset === undefined ? drop.ball : ballName(preset);
}

/** Whether drops are of one ball on one surface: others have no mean. */
export const areAlike = (drops: readonly KeptDrop[]): boolean =>
  new Set(drops.map((drop) => JSON.stringify([ballOf(drop), drop.surface]))).size < 2;

const levelOf = (drop: KeptDrop, field: Field): string =>
  field === 'ball' ? ballOf(drop) : drop[field];

export const fieldName = (field: Field): string => text(`page-class-${field}`);

/** Drops as the engine compares them. */
export function studyOf(drops: readonly KeptDrop[], made: string | null): StudyRequest {
  // What every drop has of its own is no other factor than the drop.
  const isShared = (field: Field): boolean =>
    new Set(drops.map((drop) => levelOf(drop, field))).size < drops.length;
  const fields = FIELDS.filter((field) => grouping.value.has(field) || isShared(field));
  const factorsOf = (drop: KeptDrop): [string, string][] =>
    fields
      .map((field): [string, string] => [field, levelOf(drop, field)])
      .filter(([, level]) => level !== '');
  return {
    title: text('page-drops-title'),
    drops: drops.map((drop) => ({
      name: drop.name,
      factors: Object.fromEntries(factorsOf(drop)),
      comparable: drop.comparable ?? null,
      impacts: drop.restitutions.map(({ speedMS, value }): [number, number] => [speedMS, value]),
    })),
    by: FIELDS.filter((field) => grouping.value.has(field)),
    made,
  };
}

/** Analyses drops of which it is not known what they add: an earlier version kept them, or others saved them. */
export function complete(): Promise<void> {
  completing ??= completeEach().finally(() => {
    completing = undefined;
  });
  return completing;
}

/** One at a time, however often it is asked for. */
let completing: Promise<void> | undefined;

async function completeEach(): Promise<void> {
  for (const { id } of kept.peek()) {
    const incomplete = () =>
      kept.peek().find((drop) => drop.id === id && drop.comparable === undefined);
    const drop = incomplete();
    if (!drop) continue;
    const measured = await measureMarks([drop.marks], drop.settings).catch(() => undefined);
    // A drop whose ball was corrected meanwhile has been analysed with that ball.
    if (measured && incomplete()) await alter(id, { comparable: measured[0]?.comparable ?? null });
  }
}
