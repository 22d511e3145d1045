/** Keeping drops in the browser, and what they show together. */
import { computed, signal } from '@preact/signals';
import { allDrops, alterDrop, deleteDrop, type KeptDrop, putDrop } from '../store/drops.ts';
import { newId } from '../store/id.ts';
import { lock, locked } from '../store/locks.ts';
import { addRecording, deleteRecording } from '../store/recordings.ts';
import { setMarks } from './editing.ts';
import { askToLast, lookAtLasting } from './lasting.ts';
import { pupil } from './lesson.ts';
import { linkOfDrop } from './linking.ts';
import { dropNear, forEngine } from './marks.ts';
import { type Measured, measureMarks, summaryOf } from './measuring.ts';
import { openLinked, openStored } from './opening.ts';
import { goToLab, settings } from './settings.ts';
import { isWhole } from './sound.ts';
import {
  type Answer,
  analysed,
  drop,
  edits,
  lookAt,
  place,
  present,
  workspace,
} from './workspace.ts';

export const kept = signal<readonly KeptDrop[]>([]);
/** False where the browser keeps nothing. */
export const canKeep = signal(true);

/** Drops that were ticked to be compared. */
export const ticked = signal<ReadonlySet<string>>(new Set());

/** Which drops are compared: all, as long as none is ticked. */
export const compared = computed(() => {
  const some = kept.value.filter(({ id }) => ticked.value.has(id));
  return some.length === 0 ? kept.value : some;
});

export function tick(id: string): void {
  const next = new Set(ticked.peek());
  if (!next.delete(id)) next.add(id);
  ticked.value = next;
}

/** Counts the changes of kept drops: what was read before one of them is old. */
let changes = 0;

export async function loadKept(): Promise<void> {
  try {
    const seen = changes;
    const found = await allDrops();
    if (seen !== changes) return await loadKept();
    kept.value = found;
    canKeep.value = true;
    await lookAtLasting();
  } catch {
    canKeep.value = false;
  }
}

/** Keeps the drop in the workspace; false if the browser has no storage left for it. */
export async function keepDrop(name: string): Promise<boolean> {
  const recording = workspace.peek();
  const result = drop.peek();
  const marks = present.peek();
  if (!recording || !result || !marks) return false;
  try {
    const sound = recording.storedAs ?? (await storeSound(name));
    const keptDrop: KeptDrop = {
      id: newId(),
      name,
      keptAt: Date.now(),
      ball: analysed.peek()?.ball ?? '',
      ...summaryOf(result),
      ...comparableOf(analysed.peek()),
      settings: settings.peek(),
      marks: forEngine(marks, result.probability),
      recording: sound,
      student: pupil().name,
      surface: pupil().surface,
    };
    await putDrop(keptDrop);
    changes += 1;
    void askToLast();
    workspace.value = { ...recording, storedAs: sound };
    kept.value = [...kept.peek(), keptDrop];
    return true;
  } catch {
    return false;
  }
}

/** What the drop in the workspace adds to a study; nothing as long as the inference runs. */
function comparableOf(answer: Answer | null): Pick<KeptDrop, 'comparable'> {
  if (!answer?.inference) return {};
  return { comparable: answer.comparable[place.peek()] ?? null };
}

/** Puts the sound of an opened file or of the demo into the database, unless it is too long. */
async function storeSound(name: string): Promise<string | null> {
  const recording = workspace.peek()?.recording;
  if (!recording?.sound || !isWhole.peek()) return null;
  const { sampleRateHz: rateHz, gaps } = recording.sound;
  const id = newId();
  lock(id);
  const stored = { id, name, rateHz, gaps, startedAt: Date.now(), finished: true };
  await addRecording(stored, await recording.samples(0, recording.durationS));
  return id;
}

/** Keeps what lies in the workspace beyond the end of the page: its sound, or its times in the address. */
export async function rescue(): Promise<void> {
  const loaded = workspace.peek();
  if (!loaded || loaded.storedAs !== null) return;
  if (loaded.pyramid && isWhole.peek()) await storeSound(loaded.name).catch(() => undefined);
  else {
    const link = await linkOfDrop(loaded.name).catch(() => undefined);
    // Without an event: this page would open the drop, and take it out of the address before its end.
    if (link) history.replaceState(null, '', link.address);
  }
}

/** What a reader may write about a kept drop. */
type Labels = Partial<Pick<KeptDrop, 'name' | 'student' | 'surface'>>;

/** Changes a kept drop. */
export async function alter(id: string, labels: Labels | Partial<Measured>): Promise<void> {
  await alterDrop(id, labels);
  changes += 1;
  kept.value = kept.peek().map((found) => (found.id === id ? { ...found, ...labels } : found));
}

/** States another ball of a kept drop, which is analysed again. */
export async function stateBallOf({ id, marks, settings }: KeptDrop, ball: string): Promise<void> {
  const [measured] = await measureMarks([marks], { ...settings, ball: { kind: ball } });
  if (measured) await alter(id, measured);
}

/** Drops that were deleted last, until the next deletion or the end of the page. */
export const deleted = signal<readonly KeptDrop[]>([]);

/** Deletes drops. Their sounds go when nothing can bring the drops back. */
export async function remove(drops: readonly KeptDrop[]): Promise<void> {
  await forgetDeleted();
  for (const { id } of drops) await deleteDrop(id);
  changes += 1;
  const gone = new Set(drops.map(({ id }) => id));
  kept.value = kept.peek().filter(({ id }) => !gone.has(id));
  deleted.value = drops;
}

export async function bringBack(): Promise<void> {
  for (const keptDrop of deleted.peek()) await putDrop(keptDrop);
  deleted.value = [];
  await loadKept();
}

/** Frees the storage of what was deleted for good: sounds that no drop uses any more, here or elsewhere. */
async function forgetDeleted(): Promise<void> {
  const used = new Set((await allDrops()).map(({ recording }) => recording));
  // What lies in a workspace may be kept once more.
  const inUse = await locked();
  for (const { recording } of deleted.peek()) {
    if (recording !== null && !used.has(recording) && !inUse.has(recording))
      await deleteRecording(recording);
  }
  deleted.value = [];
}

/** Loads a kept drop as it was left: its sound, its set-up, its impacts. */
export async function openKept(drop: KeptDrop): Promise<void> {
  const { name, settings, marks, recording } = drop;
  goToLab();
  if (recording === null) {
    await openLinked({ name, settings, times_s: marks.impacts.map(({ time_s }) => time_s) });
    return;
  }
  // What lies in the workspace instead has other marks.
  if (!(await openStored(recording, settings))) return;
  lookAt(dropNear(edits.peek(), marks));
  if (marks.edited) setMarks(marks);
}
