/**
 * Writes a recording to the database while it goes on. It never stops the recording: when the disk is
 * full it reports that once, and the sound stays in memory, whole.
 */
import { joined } from './blocks.ts';
import { isFull } from './database.ts';
import { putBlock, putRecording, type StoredRecording } from './recordings.ts';

/** What can go wrong with keeping. */
export type KeepFault = 'full' | 'unavailable';

export class RecordingWriter {
  #waiting: Float32Array<ArrayBuffer>[] = [];
  #waitingSamples = 0;
  #index = 0;
  #queue: Promise<void>;
  #fault: KeepFault | undefined;

  constructor(
    readonly recording: StoredRecording,
    private readonly onFault: (fault: KeepFault) => void,
  ) {
    this.#queue = this.#guarded(() => putRecording(recording));
  }

  /** Takes a block; about once a second one goes to the disk. */
  add(samples: Float32Array<ArrayBuffer>): void {
    this.#waiting.push(samples);
    this.#waitingSamples += samples.length;
    if (this.#waitingSamples >= this.recording.rateHz) this.#write();
  }

  /** Writes the rest; true if all of it is on the disk. */
  async finish(): Promise<boolean> {
    this.#write();
    await this.#queue;
    return this.#fault === undefined;
  }

  /** Notes that the recording came to its end and was opened, so that it is not offered again. */
  async close(): Promise<void> {
    this.#enqueue(() => putRecording({ ...this.recording, finished: true }));
    await this.#queue;
  }

  #write(): void {
    if (this.#waiting.length === 0) return;
    const samples = joined(this.#waiting);
    const index = this.#index;
    this.#waiting = [];
    this.#waitingSamples = 0;
    this.#index += 1;
    this.#enqueue(() => putBlock(this.recording.id, index, samples));
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
      this.onFault(this.#fault);
    }
  }
}
