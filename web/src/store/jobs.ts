/** Test series: the files of each, which are those of a job of the program. */
import type { JobFiles } from '../lab/index.ts';
import { transact } from './database.ts';

export interface StoredJob {
  readonly id: string;
  readonly name: string;
  /** The title of its rule, in the language of the last change. */
  readonly title: string;
  readonly files: JobFiles;
  /** Counts its changes: what was read before one of them is old. */
  readonly revision: number;
  /** Milliseconds since 1970. */
  readonly changedAt: number;
}

/** A recording of a job, by its name there. */
interface JobSound {
  readonly job: string;
  readonly file: string;
  readonly content: Blob;
}

/** The jobs, the one that was changed last first. */
export async function allJobs(): Promise<StoredJob[]> {
  const jobs = await transact<StoredJob[]>(['jobs'], 'readonly', (t) =>
    t.objectStore('jobs').getAll(),
  );
  return (jobs ?? []).sort((a, b) => b.changedAt - a.changedAt);
}

export const getJob = (id: string): Promise<StoredJob | undefined> =>
  transact<StoredJob>(['jobs'], 'readonly', (t) => t.objectStore('jobs').get(id));

/**
 * Writes a job together with a new recording, both or neither. Returns what was written, or nothing if another window
 * has changed the job since it was read.
 */
export async function writeJob(
  job: StoredJob,
  sound?: { readonly file: string; readonly content: Blob },
): Promise<StoredJob | undefined> {
  const next = { ...job, revision: job.revision + 1, changedAt: Date.now() };
  const kept: JobSound | undefined = sound && { job: job.id, ...sound };
  let isOld = false;
  let refused: unknown;
  const work = (t: IDBTransaction): undefined => {
    const known = t.objectStore('jobs').get(job.id) as IDBRequest<StoredJob | undefined>;
    known.onsuccess = () => {
      isOld = (known.result?.revision ?? 0) !== job.revision;
      if (isOld) return;
      try {
        if (kept) t.objectStore('sounds').put(kept);
        t.objectStore('jobs').put(next);
      } catch (error) {
        refused = error;
        t.abort();
      }
    };
  };
  await transact(['jobs', 'sounds'], 'readwrite', work).catch((error: unknown) => {
    throw refused ?? error;
  });
  return isOld ? undefined : next;
}

/** @throws If it is not there. */
export async function jobSound(job: string, file: string): Promise<Blob> {
  const sound = await transact<JobSound>(['sounds'], 'readonly', (t) =>
    t.objectStore('sounds').get([job, file]),
  );
  if (!sound) throw new Error(`${file} is not in the storage of the browser`);
  return sound.content;
}

export async function deleteJob(id: string): Promise<void> {
  await transact(['jobs', 'sounds'], 'readwrite', (t) => {
    t.objectStore('jobs').delete(id);
    // Every key that begins with the job.
    t.objectStore('sounds').delete(IDBKeyRange.bound([id, ''], [id, '\uffff']));
    return undefined;
  });
}
