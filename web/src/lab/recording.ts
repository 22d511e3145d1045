import type { Impact, RecordingResult } from './engine/types.ts';
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
    sampleRateHz: number,
    columns: number,
    rows: number,
  ): Promise<Spectrogram>;
  wav(channels: Float32Array[], sampleRateHz: number): Promise<Blob>;
}

/** How much sound before and after a time is searched for the onset next to it. */
const BEFORE_S = 2;
const AFTER_S = 0.5;

/**
 * A recording, or a list of times: the drops in it, and its sound.
 *
 * The samples lie in the memory of the page, so that drawing and playing need not wait.
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

  /** The samples of the channel with the drops; empty for a list of times. */
  get dropChannel(): Float32Array {
    const { source } = this.result;
    const channel = source.kind === 'sound' ? source.channel - 1 : 0;
    return this.sound?.channels[channel] ?? new Float32Array();
  }

  /** The samples of the channel with the drops from one time to another: a view, not a copy. */
  samples(fromS: number, toS: number): Float32Array {
    const rate = this.sound?.sampleRateHz ?? 1;
    const from = Math.max(0, Math.floor(fromS * rate));
    return this.dropChannel.subarray(from, Math.max(from, Math.ceil(toS * rate)));
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
    const samples = this.samples(timeS - BEFORE_S, timeS + AFTER_S).slice();
    const startS = Math.max(0, Math.floor((timeS - BEFORE_S) * rate)) / rate;
    const onset = await this.#services.onset(samples, rate, startS, timeS);
    return onset !== null && Math.abs(onset.time_s - timeS) <= withinS ? onset : null;
  }

  /** How the energy lies over time and frequency, as many columns and rows as asked for. */
  async spectrogram(
    fromS: number,
    toS: number,
    columns: number,
    rows: number,
  ): Promise<Spectrogram | null> {
    if (this.sound === null) {
      return null;
    }
    const samples = this.samples(fromS, toS).slice();
    return this.#services.spectrogram(samples, this.sound.sampleRateHz, columns, rows);
  }

  /** The recording as a WAV file of 32-bit samples: exactly what was recorded. */
  async wav(): Promise<Blob | null> {
    if (this.sound === null) {
      return null;
    }
    const { channels, sampleRateHz } = this.sound;
    const copies = channels.map((channel) => channel.slice());
    return this.#services.wav(copies, sampleRateHz);
  }
}
