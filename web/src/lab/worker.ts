/**
 * The worker: the science, and what it takes to talk to it.
 *
 * Calls are answered one by one. If the science traps (a fault in it, or a file that breaks a
 * decoder), it must not be used again: the answer says so, and the page starts another worker.
 */

import * as decoding from './engine/decoders.js';
import * as science from './engine/engine.js';
import type { LabReason, LabRefusal } from './error.ts';
import type {
  Call,
  FigureRequest,
  FromWorker,
  Give,
  Level,
  Messages,
  Sound,
  Take,
  ToWorker,
} from './protocol.ts';
import type { Demo, Heard } from './types.ts';

/** Samples that do not fit into this memory cannot be kept, in bytes. */
const MOST_SAMPLE_BYTES = 480e6;

type Answer<C extends Call> = { give: Give<C>; transfer?: Transferable[] };
type Handlers = {
  [C in Call]: (take: Take<C>, progress: (share: number) => void) => Answer<C>;
};

class TooLong extends Error {
  readonly reason: LabReason;

  constructor(minutes: number, channels: number) {
    super(`more than ${minutes} minutes in ${channels} channels are too long for a browser`);
    this.reason = { code: 'too-long', minutes, channels };
  }
}

const analyst = lazily(() => new science.Analyst());
const ears = new Map<number, science.Hearer>();

const handlers: Handlers = {
  catalogue: () => ({ give: JSON.parse(science.catalogue()) }),

  open: ({ bytes, name, channel }, progress) => {
    const content = new Uint8Array(bytes);
    if (science.isList(name)) {
      return { give: { heard: JSON.parse(science.hearTimes(content, name)), sound: null } };
    }
    const decoder = new decoding.Decoder(content, name);
    const sampleRateHz = decoder.sampleRateHz();
    const expected = (decoder.durationS() ?? 0) * sampleRateHz;
    const channels = Array.from({ length: decoder.channels() }, () => new Samples(expected));
    const hearer = new science.Hearer(sampleRateHz, channels.length, channel);
    let frames = 0;
    let more = true;
    while (more) {
      more = decoder.decodeOn();
      channels.forEach((all, channel) => {
        const samples = decoder.takeSamples(channel);
        hearer.bring(channel, samples);
        all.push(samples);
        frames = all.length;
      });
      hearer.hear();
      if (4 * frames * channels.length > MOST_SAMPLE_BYTES) {
        throw new TooLong(Math.floor(frames / sampleRateHz / 60), channels.length);
      }
      if (expected > 0) {
        progress(Math.min(1, frames / expected));
      }
    }
    const planes = channels.map((samples) => samples.all());
    return heardAt(hearer, decoder.format(), decoder.warnings(), name, planes, sampleRateHz);
  },

  hear: ({ channels, sampleRateHz, name, format }, progress) => {
    const hearer = new science.Hearer(sampleRateHz, channels.length, null);
    const frames = channels[0]?.length ?? 0;
    for (let at = 0; at < frames; at += sampleRateHz) {
      channels.forEach((samples, channel) => {
        hearer.bring(channel, samples.subarray(at, at + sampleRateHz));
      });
      hearer.hear();
      progress(Math.min(1, (at + sampleRateHz) / frames));
    }
    return heardAt(hearer, format, [], name, channels, sampleRateHz);
  },

  demo: ({ seed }) => {
    const rendering = science.Rendering.demo(seed);
    const demo: Demo = JSON.parse(rendering.about());
    const samples = rendering.takeSamples();
    return {
      give: { demo, samples, sampleRateHz: rendering.sampleRateHz() },
      transfer: buffers([samples]),
    };
  },

  listen: ({ ear, sampleRateHz }) => {
    ears.set(ear, new science.Hearer(sampleRateHz, 1, null));
    return { give: null };
  },
  push: ({ ear, samples }) => {
    const hearer = known(ear);
    hearer.bring(0, samples);
    hearer.hear();
    return { give: JSON.parse(hearer.soFar()) };
  },
  finish: ({ ear, name, format }) => {
    const hearer = known(ear);
    ears.delete(ear);
    const heard: Heard = JSON.parse(hearer.finish(name, format, []));
    const levels = levelsOf(hearer);
    return { give: { heard, levels }, transfer: buffers(levels.map((level) => level.extremes)) };
  },
  deafen: ({ ear }) => {
    ears.get(ear)?.free();
    ears.delete(ear);
    return { give: null };
  },

  analyse: ({ request }) => ({ give: JSON.parse(analyst().analyse(JSON.stringify(request))) }),
  chart: (asked) => ({ give: JSON.parse(figure(asked, (...of) => analyst().chart(...of))) }),
  figure: (asked) => ({ give: JSON.parse(figure(asked, (...of) => analyst().figure(...of))) }),
  waveform: ({ request, level, sampleRateHz, messages }) => {
    const stepS = level.samplesPerBin / sampleRateHz;
    const asked = JSON.stringify(request);
    const drawn = analyst().waveform(asked, level.extremes, stepS, translator(messages));
    return { give: JSON.parse(drawn) };
  },
  report: ({ request, level, sampleRateHz, made, messages }) => {
    const stepS = (level?.samplesPerBin ?? 1) / sampleRateHz;
    const extremes = level?.extremes ?? new Float32Array();
    const words = translator(messages);
    return { give: analyst().report(JSON.stringify(request), extremes, stepS, made, words) };
  },
  rows: ({ request }) => ({ give: analyst().rows(JSON.stringify(request)) }),

  onset: ({ samples, sampleRateHz, startS, timeS }) => ({
    give: JSON.parse(science.onsetNear(samples, sampleRateHz, startS, timeS)),
  }),
  spectrogram: ({ samples, sampleRateHz, columns, rows }) => {
    const found = new science.Spectrogram(samples, sampleRateHz, columns, rows);
    const cells = found.takeCells();
    return {
      give: { columns, rows, topHz: found.topHz(), cells, floorDb: found.floorDb() },
      transfer: buffers([cells]),
    };
  },
  wav: ({ channels: [left, right], sampleRateHz }) => {
    const nothing = new Float32Array();
    const bytes = science.wav(left ?? nothing, right ?? nothing, sampleRateHz);
    return { give: bytes as Uint8Array<ArrayBuffer>, transfer: buffers([bytes]) };
  },

  simulate: ({ request }) => ({ give: JSON.parse(science.simulate(JSON.stringify(request))) }),
  synthesise: ({ request, scene }) => {
    const rendering = science.Rendering.synthesise(JSON.stringify(request), JSON.stringify(scene));
    const samples = rendering.takeSamples();
    return {
      give: { samples, sampleRateHz: rendering.sampleRateHz() },
      transfer: buffers([samples]),
    };
  },
  simulationCharts: ({ runs, messages }) => ({
    give: JSON.parse(science.simulationCharts(JSON.stringify(runs), translator(messages))),
  }),
  dropCharts: ({ drops, messages }) => ({
    give: JSON.parse(science.dropCharts(JSON.stringify(drops), translator(messages))),
  }),
  lessonCharts: ({ messages }) => ({
    give: JSON.parse(science.lessonCharts(translator(messages))),
  }),
  puzzleAnswer: ({ choice, messages }) => ({
    give: JSON.parse(science.puzzleAnswer(JSON.stringify(choice), translator(messages))),
  }),
  puzzleSolution: ({ choice }) => ({
    give: JSON.parse(science.puzzleSolution(JSON.stringify(choice))),
  }),
  paper: () => ({ give: JSON.parse(science.paperDocument()) }),
};

/** Languages that were asked for, by their codes. */
const translators = new Map<string, science.Translator>();

function translator({ code, sources }: Messages): science.Translator {
  const known = translators.get(code);
  if (known) return known;
  const made = new science.Translator(code, [...sources]);
  translators.set(code, made);
  return made;
}

function figure(
  { request, drop, name, simulation, messages }: FigureRequest,
  ask: (
    request: string,
    drop: number,
    name: string,
    simulation: string | undefined,
    translator: science.Translator,
  ) => string,
): string {
  const compared = simulation ? JSON.stringify(simulation) : undefined;
  return ask(JSON.stringify(request), drop, name, compared, translator(messages));
}

/** Samples that come bit by bit, for a length that is known more or less. */
class Samples {
  #all: Float32Array<ArrayBuffer>;
  length = 0;

  constructor(expected: number) {
    this.#all = new Float32Array(Math.min(Math.ceil(expected) + 1, MOST_SAMPLE_BYTES / 4));
  }

  push(samples: Float32Array): void {
    const needed = this.length + samples.length;
    if (needed > this.#all.length) {
      const larger = new Float32Array(Math.max(needed, 2 * this.#all.length));
      larger.set(this.#all.subarray(0, this.length));
      this.#all = larger;
    }
    this.#all.set(samples, this.length);
    this.length = needed;
  }

  all(): Float32Array<ArrayBuffer> {
    return this.length === this.#all.length ? this.#all : this.#all.slice(0, this.length);
  }
}

function heardAt(
  hearer: science.Hearer,
  format: string,
  warnings: string[],
  name: string,
  channels: Float32Array[],
  sampleRateHz: number,
): { give: { heard: Heard; sound: Sound }; transfer: Transferable[] } {
  const heard: Heard = JSON.parse(hearer.finish(name, format, warnings));
  const levels = levelsOf(hearer);
  return {
    give: { heard, sound: { sampleRateHz, channels, levels } },
    transfer: buffers([...channels, ...levels.map((level) => level.extremes)]),
  };
}

function levelsOf(finished: science.Hearer): Level[] {
  return Array.from(finished.samplesPerBin(), (samplesPerBin, level) => ({
    samplesPerBin,
    extremes: finished.takeLevel(level),
  }));
}

function known(ear: number): science.Hearer {
  const hearer = ears.get(ear);
  if (hearer === undefined) {
    throw new Error('nobody is listening any more; listen again');
  }
  return hearer;
}

function buffers(arrays: ArrayBufferView[]): Transferable[] {
  return [...new Set(arrays.map((array) => array.buffer as ArrayBuffer))];
}

function lazily<T>(make: () => T): () => T {
  let made: T | undefined;
  return () => {
    made ??= make();
    return made;
  };
}

/** What went wrong, as the page is told; and whether the science can still be used. */
function refusalOf(error: unknown, call: Call): { refusal: LabRefusal; broken: boolean } {
  if (typeof error === 'string') {
    return { refusal: JSON.parse(error), broken: false };
  }
  const broken = error instanceof WebAssembly.RuntimeError || error instanceof RangeError;
  const refused = (kind: LabRefusal['kind'], message: string, reason: LabReason | null) => ({
    refusal: { kind, message, reason },
    broken,
  });
  if (error instanceof TooLong) return refused('too-long', error.message, error.reason);
  if (error instanceof RangeError) {
    return refused('too-long', 'there is not enough memory for it', { code: 'no-memory' });
  }
  if (broken && call === 'open') {
    return refused('damaged', 'the decoder does not survive this file', { code: 'breaks-decoder' });
  }
  return refused('fault', String(error), null);
}

function say(message: FromWorker, transfer: Transferable[] = []): void {
  postMessage(message, { transfer });
}

function answer<C extends Call>(id: number, call: C, take: Take<C>): void {
  try {
    const progress = (share: number) => say({ kind: 'progress', id, share });
    const { give, transfer } = handlers[call](take, progress);
    say({ kind: 'done', id, give }, transfer);
  } catch (error) {
    say({ kind: 'refused', id, ...refusalOf(error, call) });
  }
}

/** Calls that came before the science did. */
let waiting: (() => void)[] | null = [];

addEventListener('message', ({ data }: MessageEvent<ToWorker>) => {
  if (data.kind === 'start') {
    science.initSync({ module: data.engine });
    if (data.decoders !== null) {
      decoding.initSync({ module: data.decoders });
    }
    const calls = waiting ?? [];
    waiting = null;
    for (const call of calls) {
      call();
    }
    return;
  }
  const call = () => answer(data.id, data.call, data.take);
  if (waiting === null) {
    call();
  } else {
    waiting.push(call);
  }
});
