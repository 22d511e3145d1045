/** Drops that were kept: what they said, with what set-up, and where their sound is. */
import type { DropMarks, Settings } from '../lab/index.ts';
import { transact } from './database.ts';

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
}

export async function putDrop(drop: KeptDrop): Promise<void> {
  await transact(['drops'], 'readwrite', (t) => t.objectStore('drops').put(drop));
}

export async function allDrops(): Promise<KeptDrop[]> {
  const drops =
    (await transact<KeptDrop[]>(['drops'], 'readonly', (t) => t.objectStore('drops').getAll())) ??
    [];
  return drops.sort((a, b) => a.keptAt - b.keptAt);
}

export async function deleteDrop(id: string): Promise<void> {
  await transact(['drops'], 'readwrite', (t) => {
    t.objectStore('drops').delete(id);
    return undefined;
  });
}
