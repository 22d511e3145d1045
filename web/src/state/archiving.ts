/** All kept drops with their sounds as one file: to save it, and to keep what was saved elsewhere. */
import { type ArchivedSound, ArchiveError, pack } from '../store/archive.ts';
import { joined } from '../store/blocks.ts';
import { addDrops, allDrops, type KeptDrop } from '../store/drops.ts';
import { lock } from '../store/locks.ts';
import { addRecording, allRecordings, samplesOf } from '../store/recordings.ts';
import { engine } from './engine.ts';
import type { Fault } from './faults.ts';

/** Collects everything that was kept. */
export async function archive(): Promise<Blob> {
  const kept = await allDrops();
  const used = new Set(kept.map(({ recording }) => recording));
  const recordings = (await allRecordings()).filter(({ id }) => used.has(id));
  const stored = new Set(recordings.map(({ id }) => id));
  const drops = kept.map((drop) =>
    // A drop whose sound is lost still has its impacts.
    drop.recording !== null && stored.has(drop.recording) ? drop : { ...drop, recording: null },
  );
  return pack({ drops, recordings }, async ({ id, rateHz }) =>
    engine().wav([joined(await samplesOf(id))], rateHz),
  );
}

/** Adds the drops of an archive and their sounds to the kept ones; returns the number of new ones. */
export async function keepArchived(
  drops: readonly KeptDrop[],
  sounds: readonly ArchivedSound[],
): Promise<number> {
  const used = new Set(drops.map(({ recording }) => recording));
  for (const { recording, samples } of sounds.filter(({ recording: { id } }) => used.has(id))) {
    // Until its drop is stored, other windows must not delete it as unused.
    lock(recording.id);
    await addRecording(recording, await samples());
  }
  return addDrops(drops);
}

const FAULTS = { newer: 'archive-newer', damaged: 'archive', huge: 'huge' } as const;

/** What the page says of a file that could not be added. */
export function archiveFaultOf(error: unknown): Fault {
  if (!(error instanceof ArchiveError)) return { key: 'archive-storage' };
  return { key: FAULTS[error.kind] };
}
