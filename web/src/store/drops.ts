/** Drops that were kept: their results, with what set-up, and where their sound is. */
import type { Comparable, DropMarks, Impact, Settings } from '../lab/index.ts';
import { addIfNew, transact } from './database.ts';

/** A value with its standard deviation. */
export interface Known {
  readonly value: number;
  readonly sd: number | null;
}

export interface KeptDrop {
  readonly id: string;
  readonly name: string;
  /** Milliseconds since 1970. */
  readonly keptAt: number;
  /** The ball in words of the engine. */
  readonly ball: string;
  readonly restitution: Known | null;
  readonly dropHeightM: Known | null;
  /** Restitution against speed, the air taken out. */
  readonly restitutions: readonly { readonly speedMS: number; readonly value: number }[];
  readonly settings: Settings;
  readonly marks: DropMarks;
  /** Its sound in the database; `null` for a list of times. */
  readonly recording: string | null;
  /** Who dropped the ball; empty if not given. */
  readonly student: string;
  /** The surface on which the ball was dropped; empty if not given. */
  readonly surface: string;
  /** What it adds to a study of many drops; `null` where it cannot be computed, absent if an earlier version kept the drop. */
  readonly comparable?: Comparable | null;
}

/** What a drop was as it was heard: its impacts in steps of 10 µs, which links keep. */
export const soundOf = ({ impacts }: DropMarks): string =>
  impacts.map(({ time_s }) => Math.round(time_s * 1e5)).join();

export async function putDrop(drop: KeptDrop): Promise<void> {
  await transact(['drops'], 'readwrite', (t) => t.objectStore('drops').put(drop));
}

/** Changes some of what a stored drop has. The rest stays as it is, whoever changed it meanwhile. */
export async function alterDrop(id: string, change: Partial<KeptDrop>): Promise<void> {
  await transact(['drops'], 'readwrite', (t) => {
    const store = t.objectStore('drops');
    const found: IDBRequest<KeptDrop | undefined> = store.get(id);
    found.onsuccess = () => {
      if (found.result) store.put({ ...found.result, ...change });
    };
    return undefined;
  });
}

/** Adds drops to the stored ones, which stay as they are; returns the number of new ones. */
export async function addDrops(drops: readonly KeptDrop[]): Promise<number> {
  let added = 0;
  await transact(['drops'], 'readwrite', (t) => {
    // The transaction may be run once more.
    added = 0;
    for (const drop of drops) {
      addIfNew(t.objectStore('drops'), drop, () => {
        added += 1;
      });
    }
    return undefined;
  });
  return added;
}

export async function allDrops(): Promise<KeptDrop[]> {
  const drops =
    (await transact<KeptDrop[]>(['drops'], 'readonly', (t) => t.objectStore('drops').getAll())) ??
    [];
  return drops.map(upToDate).sort((a, b) => a.keptAt - b.keptAt);
}

/** What an earlier version did not keep. */
type Earlier = Omit<KeptDrop, 'student' | 'surface'> & Partial<KeptDrop>;

/** A drop that an earlier version kept: its impacts had `sigma_s`, and no probability of the drop. */
export function upToDate(drop: Earlier): KeptDrop {
  const impacts = drop.marks.impacts.map(
    ({ sigma_s, ...impact }: Impact & { sigma_s?: number }) => ({
      ...impact,
      time_sd_s: impact.time_sd_s ?? sigma_s ?? null,
    }),
  );
  const { student = '', surface = '' } = drop;
  return {
    ...drop,
    student,
    surface,
    marks: { ...drop.marks, probability: drop.marks.probability ?? 1, impacts },
  };
}

export async function deleteDrop(id: string): Promise<void> {
  await transact(['drops'], 'readwrite', (t) => {
    t.objectStore('drops').delete(id);
    return undefined;
  });
}
