/** What a hand does to the impacts of the chosen drop. Each step can be undone. */
import { signal } from '@preact/signals';
import { fixed } from '../format/quantity.ts';
import type { DropMarks } from '../lab/index.ts';
import { language, text } from '../text/language.ts';
import { type Mark, nearest } from '../wave/mark.ts';
import { revealing, widthS } from '../wave/viewport.ts';
import { advance, redo as redone, replace, undo as undone } from './history.ts';
import { added, asDetected, type Edits, markAt, marksOf, removed, withChange } from './marks.ts';
import { chosenDrop, cursorS, edits, present, selected, view, workspace } from './workspace.ts';

/** What was done, for screen readers. */
export const announced = signal('');

/** How far from a hand's choice the sound may begin, as a share of what is seen. */
const SNAP_SHARE = 0.02;
const SNAP_MOST_S = 0.05;

function update(change: (edits: Edits) => Edits): void {
  const index = chosenDrop.peek();
  edits.value = edits.peek().map((drop, i) => (i === index ? change(drop) : drop));
}

/** Nearer than that are no two impacts: the ball still touches. */
const SAME_S = 5e-4;

const numberOf = (id: number): number =>
  (present.peek()?.present.findIndex((mark) => mark.id === id) ?? -1) + 1;

const say = (timeS: number): string => fixed(timeS, 4, language.peek());

/** The onset at a moment that was chosen by hand, if a sound begins there. */
async function snapped(timeS: number): Promise<Partial<Mark>> {
  const reach = Math.min(SNAP_MOST_S, SNAP_SHARE * widthS(view.peek()));
  const found = await workspace
    .peek()
    ?.recording.onsetNear(timeS, reach)
    .catch(() => null);
  return found
    ? {
        timeS: found.time_s,
        timeSdS: found.time_sd_s,
        levelDb: found.level_db,
        quietBeforeS: null,
        lnAlike: null,
      }
    : { timeS, quietBeforeS: null, lnAlike: null };
}

export async function add(timeS: number): Promise<void> {
  const mark = { ...markAt(timeS), ...(await snapped(timeS)) };
  const there = nearest(present.peek()?.present ?? [], mark.timeS, SAME_S);
  if (there) return choose(there);
  update((drop) => added(drop, mark));
  selected.value = mark.id;
  cursorS.value = mark.timeS;
  announced.value = text('page-wave-added', { seconds: say(mark.timeS) });
}

/** Selects a mark and brings it into sight. */
export function choose(mark: Mark): void {
  selected.value = mark.id;
  bringIntoSight(mark);
}

export function remove(id: number): void {
  const number = numberOf(id);
  if (number === 0) return;
  update((drop) => removed(drop, id));
  selected.value = null;
  announced.value = text('page-wave-removed', { number });
}

/** The impacts before the drag began, to which one undo returns. */
let beforeDrag: readonly Mark[] | undefined;

export function drag(id: number, timeS: number): void {
  beforeDrag ??= present.peek()?.present;
  const changes = { timeS, timeSdS: null, probability: 1 };
  update((drop) => replace(drop, withChange(drop.present, id, changes)));
}

/** The drag is over: it counts as one step, and the mark snaps to the sound if one begins there. */
export async function dragEnd(id: number): Promise<void> {
  const before = beforeDrag;
  beforeDrag = undefined;
  if (!before) return;
  const at = present.peek()?.present.find((mark) => mark.id === id)?.timeS;
  if (at === undefined) return;
  const changes = await snapped(at);
  update((drop) => {
    const moved = withChange(drop.present, id, changes);
    return advance({ ...drop, present: before }, moved);
  });
  follow(id);
}

export function nudge(id: number, byS: number): void {
  update((drop) => {
    const mark = drop.present.find((candidate) => candidate.id === id);
    if (!mark) return drop;
    const timeS = Math.max(0, mark.timeS + byS);
    return advance(drop, withChange(drop.present, id, { timeS, timeSdS: null, probability: 1 }));
  });
  follow(id);
}

export async function snap(id: number): Promise<void> {
  const at = present.peek()?.present.find((mark) => mark.id === id)?.timeS;
  if (at === undefined) return;
  const changes = { ...(await snapped(at)), probability: 1 };
  update((drop) => advance(drop, withChange(drop.present, id, changes)));
  follow(id);
}

/** The cursor goes with the mark that moved. */
function follow(id: number): void {
  const mark = present.peek()?.present.find((candidate) => candidate.id === id);
  if (!mark) return;
  bringIntoSight(mark);
  announced.value = text('page-wave-moved', { number: numberOf(id), seconds: say(mark.timeS) });
}

function bringIntoSight({ timeS }: Mark): void {
  cursorS.value = timeS;
  view.value = revealing(view.peek(), timeS, workspace.peek()?.durationS ?? 0);
}

export function undo(): void {
  update(undone);
  keepSelection();
  announced.value = text('page-wave-undone');
}

export function redo(): void {
  update(redone);
  keepSelection();
  announced.value = text('page-wave-redone');
}

/** As it was detected, in one step that can be undone too. */
export function restore(): void {
  update((drop) => advance(drop, asDetected(drop)));
  keepSelection();
}

/** Impacts that a hand had set before, or that were only possibly a drop. */
export function setMarks(kept: Pick<DropMarks, 'impacts'>): void {
  update((drop) => advance(drop, marksOf(kept.impacts)));
}

function keepSelection(): void {
  if (selected.peek() !== null && numberOf(selected.peek() as number) === 0) selected.value = null;
}
