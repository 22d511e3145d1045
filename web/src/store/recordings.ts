/** Sounds in the browser's database, written as they come, so that a crash loses a second at most. */
import type { Gap } from '../lab/index.ts';
import { addIfNew, blocksOf, transact } from './database.ts';

/** What is known of a sound that was kept. */
export interface StoredRecording {
  readonly id: string;
  readonly name: string;
  readonly rateHz: number;
  /** Milliseconds since 1970. */
  readonly startedAt: number;
  /** False while it is being recorded; still false when the page comes back after a crash. */
  readonly finished: boolean;
  /** Where sound was lost, and silence stands in its place. */
  readonly gaps?: readonly Gap[];
}

interface Block {
  readonly recording: string;
  readonly index: number;
  readonly samples: Float32Array<ArrayBuffer>;
}

export async function putRecording(recording: StoredRecording): Promise<void> {
  await transact(['recordings'], 'readwrite', (t) => t.objectStore('recordings').put(recording));
}

export async function putBlock(
  recording: string,
  index: number,
  samples: Float32Array<ArrayBuffer>,
): Promise<void> {
  const block: Block = { recording, index, samples };
  await transact(['blocks'], 'readwrite', (t) => t.objectStore('blocks').put(block));
}

/** Stores a sound as a whole, unless it is there already. */
export async function addRecording(
  recording: StoredRecording,
  samples: Float32Array<ArrayBuffer>,
): Promise<void> {
  const block: Block = { recording: recording.id, index: 0, samples };
  await transact(['recordings', 'blocks'], 'readwrite', (t) => {
    addIfNew(t.objectStore('recordings'), recording, () => t.objectStore('blocks').add(block));
    return undefined;
  });
}

export async function getRecording(id: string): Promise<StoredRecording | undefined> {
  return transact<StoredRecording>(['recordings'], 'readonly', (t) =>
    t.objectStore('recordings').get(id),
  );
}

/** How many blocks of a recording there are. */
export async function countBlocks(id: string): Promise<number> {
  const count = await transact(['blocks'], 'readonly', (t) =>
    t.objectStore('blocks').count(blocksOf(id)),
  );
  return count ?? 0;
}

/** The sound of a recording, block by block. */
export async function samplesOf(id: string): Promise<Float32Array<ArrayBuffer>[]> {
  const blocks =
    (await transact<Block[]>(['blocks'], 'readonly', (t) =>
      t.objectStore('blocks').getAll(blocksOf(id)),
    )) ?? [];
  return blocks.map((block) => block.samples);
}

export async function deleteRecording(id: string): Promise<void> {
  await transact(['recordings', 'blocks'], 'readwrite', (t) => {
    t.objectStore('recordings').delete(id);
    t.objectStore('blocks').delete(blocksOf(id));
    return undefined;
  });
}

/** Every sound in the database, the oldest first. */
export async function allRecordings(): Promise<StoredRecording[]> {
  const all =
    (await transact<StoredRecording[]>(['recordings'], 'readonly', (t) =>
      t.objectStore('recordings').getAll(),
    )) ?? [];
  return all.sort((a, b) => a.startedAt - b.startedAt);
}
