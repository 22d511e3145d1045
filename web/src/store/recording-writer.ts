/**
 * Writes a recording to the database while it goes on. It never stops the recording: when the disk is
 * full it reports that once, and the sound stays in memory, whole.
 */
import type { Gap } from '../lab/index.ts';
import { joined } from './blocks.ts';
import { isFull } from './database.ts';
import { countBlocks, putBlock, putRecording, type StoredRecording } from './recordings.ts';

/** What can go wrong with keeping. */
export type KeepFault = 'full' | 'unavailable';

export interface WriterEvents {
  fault(fault: KeepFault): void;
  /** The number of samples written to the disk since the last report. */
  saved(samples: number): void;
}

export class RecordingWriter {
  #recording: StoredRecording;
  #waiting: Float32Array<ArrayBuffer>[] = [];
  #waitingSamples = 0;
  #index = 0;
  #queue: Promise<void>;
  #fault: KeepFault | undefined;

  constructor(
    recording: StoredRecording,
    private readonly events: WriterEvents,
  ) {
    this.#recording = recording;
    this.#queue = this.#guarded(() => putRecording(recording));
  }

  get recording(): StoredRecording {
    return this.#recording;
  }

  /** Takes a block; about once a second one goes to the disk. */
  add(samples: Float32Array<ArrayBuffer>): void {
    this.#waiting.push(samples);
    this.#waitingSamples += samples.length;
    if (this.#waitingSamples >= this.recording.rateHz) this.#write();
  }

  /** Notes that sound was lost; the silence in its place is added as sound is. */
  lose(gap: Gap): void {
    this.#note({ gaps: [...(this.#recording.gaps ?? []), gap] });
  }

  /** Writes the rest; true if all of it is on the disk, and was not deleted there meanwhile. */
  async finish(): Promise<boolean> {
    this.#write();
    let blocks = 0;
    this.#enqueue(async () => {
      blocks = await countBlocks(this.#recording.id);
    });
    await this.#queue;
    return this.#fault === undefined && blocks === this.#index;
  }

  /** Notes that the recording came to its end and was opened, so that it is not offered again. */
  async close(): Promise<void> {
    this.#note({ finished: true });
    await this.#queue;
  }

  #note(changes: Partial<StoredRecording>): void {
    const changed = { ...this.#recording, ...changes };
    this.#recording = changed;
    this.#enqueue(() => putRecording(changed));
  }

  #write(): void {
    if (this.#waiting.length === 0) return;
    const samples = joined(this.#waiting);
    const index = this.#index;
    this.#waiting = [];
    this.#waitingSamples = 0;
    this.#index += 1;
    this.#enqueue(async () => {
      await putBlock(this.#recording.id, index, samples);
      this.events.saved(samples.length);
    });
  }

  #enqueue(work: () => Promise<void>): void {
    this.#queue = this.#queue.then(() => this.#guarded(work));
  }

  async #guarded(work: () => Promise<void>): Promise<void> {
    if (this.#fault !== undefined) return;
    try {
      await work();
    } catch (error) {
      this.#fault = isFull(error) ? 'full' : 'unavailable';
      this.events.fault(this.#fault);
    }
  }
}
