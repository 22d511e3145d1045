import type { Gap, Impact, RecordingResult } from './engine/types.ts';
import type { Level, Sound, Spectrogram } from './protocol.ts';

/** What a recording asks of the workers. */
export interface Services {
  onset(
    samples: Float32Array,
    sampleRateHz: number,
    startS: number,
    timeS: number,
  ): Promise<Impact | null>;
  spectrogram(
    samples: Float32Array,
    margin: number,
    sampleRateHz: number,
    columns: number,
    rows: number,
  ): Promise<Spectrogram>;
  wav(channels: Float32Array[], sampleRateHz: number, gaps: readonly Gap[]): Promise<Blob>;
}

/** How much sound before and after a time is searched for the onset next to it. */
const BEFORE_S = 2;
const AFTER_S = 0.5;

/** Samples before and after a part that the windows of its spectrogram reach, and those of a part. */
const MARGIN = 256;
const PART = 1 << 21;

/**
 * A recording, or a list of times: the drops in it, and its sound.
 *
 * Samples of a file are read from it when they are needed, so that an hour of sound takes little memory.
 */
export class Recording {
  readonly name: string;
  /** The drops in it, without the inference; those of an analysis go by the settings. */
  readonly result: RecordingResult;
  /** `null` for a list of times. */
  readonly sound: Sound | null;
  readonly #services: Services;

  constructor(name: string, result: RecordingResult, sound: Sound | null, services: Services) {
    this.name = name;
    this.result = result;
    this.sound = sound;
    this.#services = services;
  }

  get durationS(): number {
    const { source, drops } = this.result;
    if (source.kind === 'sound') {
      return source.duration_s;
    }
    return drops[0]?.impacts.at(-1)?.time_s ?? 0;
  }

  /** The samples of the channel with the drops from one time to another; none for a list of times. */
  async samples(fromS: number, toS: number): Promise<Float32Array<ArrayBuffer>> {
    const rate = this.sound?.sampleRateHz ?? 1;
    const from = Math.max(0, Math.floor(fromS * rate));
    return this.#read(from, Math.max(from, Math.ceil(toS * rate)));
  }

  async #read(from: number, to: number): Promise<Float32Array<ArrayBuffer>> {
    const { sound } = this;
    const { source } = this.result;
    if (sound === null || source.kind !== 'sound') return new Float32Array();
    return sound.read(source.channel - 1, from, Math.min(to, sound.frames));
  }

  /** The coarsest level whose bins are no longer than this; `null` where samples are due. */
  level(secondsPerPixel: number): Level | null {
    const longest = secondsPerPixel * (this.sound?.sampleRateHz ?? 0);
    return this.sound?.levels.findLast((level) => level.samplesPerBin <= longest) ?? null;
  }

  /** The onset nearest to a time, if one lies within the given number of seconds. */
  async onsetNear(timeS: number, withinS = 0.02): Promise<Impact | null> {
    if (this.sound === null) {
      return null;
    }
    const rate = this.sound.sampleRateHz;
    const samples = await this.samples(timeS - BEFORE_S, timeS + AFTER_S);
    const startS = Math.max(0, Math.floor((timeS - BEFORE_S) * rate)) / rate;
    const onset = await this.#services.onset(samples, rate, startS, timeS);
    return onset !== null && Math.abs(onset.time_s - timeS) <= withinS ? onset : null;
  }

  /** How the energy lies over time and frequency, as many columns and rows as asked for; it ends with the signal. */
  async spectrogram(
    fromS: number,
    toS: number,
    columns: number,
    rows: number,
    signal?: AbortSignal,
  ): Promise<Spectrogram | null> {
    if (this.sound === null) {
      return null;
    }
    const rate = this.sound.sampleRateHz;
    const [from, to] = [fromS, toS].map((timeS) => Math.floor(timeS * rate)) as [number, number];
    const at = (column: number): number => from + Math.floor(((to - from) * column) / columns);
    const perPart = Math.max(1, Math.floor((PART * columns) / Math.max(1, to - from)));
    const cells = new Uint8Array(columns * rows);
    let found: Spectrogram | null = null;
    for (let column = 0; column < columns; column += perPart) {
      const end = Math.min(columns, column + perPart);
      const samples = await this.#padded(at(column) - MARGIN, at(end) + MARGIN);
      if (signal?.aborted) return null;
      found = await this.#services.spectrogram(samples, MARGIN, rate, end - column, rows);
      cells.set(found.cells, column * rows);
    }
    return found && { ...found, columns, cells };
  }

  /** Samples with silence where there is no sound. */
  async #padded(from: number, to: number): Promise<Float32Array<ArrayBuffer>> {
    const padded = new Float32Array(to - from);
    padded.set(await this.#read(Math.max(0, from), to), Math.max(0, -from));
    return padded;
  }

  /** The recording as a WAV file of 32-bit samples: exactly what was recorded. */
  async wav(): Promise<Blob | null> {
    if (this.sound === null) {
      return null;
    }
    const { channels, frames, sampleRateHz, gaps } = this.sound;
    const planes: Float32Array[] = [];
    for (let channel = 0; channel < channels; channel += 1) {
      planes.push(await this.sound.read(channel, 0, frames));
    }
    return this.#services.wav(planes, sampleRateHz, gaps);
  }
}
