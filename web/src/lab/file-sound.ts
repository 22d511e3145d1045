/** The file of a worker: read part by part, decoded from where it is needed, never held as a whole. */
import * as decoding from './engine/decoders.js';
import type { SoundFile } from './protocol.ts';

/** Bytes that are read at once: each reading takes as long as a hundred kilobytes. */
const PART_BYTES = 1 << 20;
/** Samples that stay decoded: those of three minutes in one channel. */
const MAX_SAMPLES = 8e6;

let file = new Blob();
let part = new Uint8Array();
let partStart = 0;

/** What the decoders read the file by. */
function readPart(position: number, into: Uint8Array): number {
  if (position < partStart || position >= partStart + part.length) {
    const wanted = file.slice(position, position + PART_BYTES);
    part = new Uint8Array(new FileReaderSync().readAsArrayBuffer(wanted));
    partStart = position;
  }
  const found = part.subarray(position - partStart, position - partStart + into.length);
  into.set(found);
  return found.length;
}
Object.assign(globalThis, { readPart });

/** Opens a file, which takes the place of the last one. */
export function openFile({ file: wanted, name }: SoundFile): decoding.Opened {
  file = wanted;
  part = new Uint8Array();
  return new decoding.Opened(file.size, name);
}

/** Consecutive samples of all channels. */
interface Block {
  readonly start: number;
  readonly planes: readonly Float32Array[];
}

/** The sound of a file at any place. To an earlier place it is decoded once more from its beginning. */
export class FileSound {
  readonly #of: SoundFile;
  #decoder: decoding.Decoder;
  #blocks: Block[] = [];
  #end = 0;

  constructor(of: SoundFile) {
    this.#of = of;
    this.#decoder = decoderOf(of);
  }

  /** Samples of a channel; the last ones only as far as there is sound. */
  read(channel: number, from: number, to: number): Float32Array<ArrayBuffer> {
    const first = this.#blocks[0]?.start ?? this.#end;
    if (from < first) {
      this.#decoder.free();
      this.#decoder = decoderOf(this.#of);
      this.#blocks = [];
      this.#end = 0;
    }
    const samples = new Float32Array(Math.max(0, to - from));
    const copy = ({ start, planes }: Block): void => {
      const plane = planes[channel] ?? new Float32Array();
      const begin = Math.max(0, from - start);
      const found = plane.subarray(begin, Math.max(begin, to - start));
      if (found.length > 0) samples.set(found, start + begin - from);
    };
    for (const block of this.#blocks) copy(block);
    for (let more = true; more && this.#end < to; ) {
      more = this.#decoder.decodeOn();
      copy(this.#take());
    }
    return samples.slice(0, Math.max(0, this.#end - from));
  }

  #take(): Block {
    const channels = this.#decoder.channels();
    const planes = Array.from({ length: channels }, (_, channel) =>
      this.#decoder.takeSamples(channel),
    );
    const block = { start: this.#end, planes };
    this.#blocks.push(block);
    this.#end += planes[0]?.length ?? 0;
    const mayStay = MAX_SAMPLES / channels;
    while (this.#end - (this.#blocks[0]?.start ?? 0) > mayStay) this.#blocks.shift();
    return block;
  }
}

const decoderOf = (of: SoundFile): decoding.Decoder => openFile(of).decoder(of.rateHz ?? undefined);
