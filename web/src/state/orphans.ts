/**
 * Sounds in the database that no kept drop uses: cut short by a crash, or recorded and not kept. Those cut
 * short wait until the reader decides; of the others the newest waits, and older ones are deleted.
 */
import { signal } from '@preact/signals';
import { allDrops } from '../store/drops.ts';
import { locked } from '../store/locks.ts';
import {
  allRecordings,
  deleteRecording,
  putRecording,
  type StoredRecording,
} from '../store/recordings.ts';
import { openStored } from './opening.ts';

export const orphans = signal<readonly StoredRecording[]>([]);

/** Looks once, at the start. */
export async function findOrphans(): Promise<void> {
  const used = new Set((await allDrops()).map(({ recording }) => recording));
  const inUse = await locked();
  const unused = (await allRecordings()).filter(({ id }) => !used.has(id) && !inUse.has(id));
  const newest = unused.findLast(({ finished }) => finished);
  const isOffered = (recording: StoredRecording): boolean =>
    !recording.finished || recording === newest;
  orphans.value = unused.filter(isOffered);
  for (const recording of unused) {
    if (!isOffered(recording)) await deleteRecording(recording.id);
  }
}

export const forget = (id: string): void => {
  orphans.value = orphans.peek().filter((recording) => recording.id !== id);
};

export async function openOrphan(recording: StoredRecording): Promise<void> {
  if (!(await openStored(recording.id))) return;
  await putRecording({ ...recording, finished: true });
  forget(recording.id);
}

export async function throwAway({ id }: StoredRecording): Promise<void> {
  forget(id);
  await deleteRecording(id);
}
