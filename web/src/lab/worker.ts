/**
 * The worker: the engine, and what it takes to call it.
 *
 * Calls are answered one by one. If the engine traps (a fault in it, or a file that breaks a
 * decoder), it must not be used again: the answer contains that, and the page starts another worker.
 */

import * as decoding from './engine/decoders.js';
import * as science from './engine/engine.js';
import type { Demo, Gap, RecordingResult } from './engine/types.ts';
import type { LabReason, LabRefusal } from './error.ts';
import { FileSound, openFile } from './file-sound.ts';
import type {
  Call,
  FigureRequest,
  FromWorker,
  Level,
  Messages,
  Request,
  Response,
  SoundOutline,
  ToWorker,
} from './protocol.ts';

/** Maximum number of samples of all channels: two hours of two channels, whose picture takes 115 MB. */
const MAX_SAMPLES = 2 * 2 * 3600 * 48_000;
/** The least number of bytes that a sample takes, in Opus for speech: a header that states more samples than fit is wrong. */
const MIN_SAMPLE_BYTES = 0.005;

/** What a call may use besides its request. */
interface Context {
  readonly translator: science.Translator;
  readonly messages: Messages;
  progress(share: number): void;
}
type Answer<C extends Call> = { response: Response<C>; transfer?: Transferable[] | undefined };
type Handlers = { [C in Call]: (request: Request<C>, context: Context) => Answer<C> };

class TooLong extends Error {
  readonly reason: LabReason;

  constructor(minutes: number, channels: number) {
    super(`more than ${minutes} minutes in ${channels} channels are too long for a browser`);
    this.reason = { code: 'too-long', minutes, channels };
  }
}

const analyst = lazily(() => new science.Analyst());
/** The file whose sound was read last. */
let reading: { readonly id: number; readonly sound: FileSound } | undefined;
/** Detectors of recordings that go on. */
const sessions = new Map<number, science.Detector>();

const handlers: Handlers = {
  catalogue: () => ({ response: JSON.parse(science.catalogue()) }),

  open: ({ channel, ...of }, { progress }) => {
    const opened = openFile(of);
    const list = opened.list();
    if (list !== undefined) {
      return { response: { result: JSON.parse(science.listed(list)), sound: null } };
    }
    const decoder = opened.decoder(of.rateHz ?? undefined);
    const sampleRateHz = decoder.sampleRateHz();
    const expected = (decoder.durationS() ?? 0) * sampleRateHz;
    const channels = decoder.channels();
    const mustFit = (frames: number): void => {
      if (frames * channels > MAX_SAMPLES) {
        throw new TooLong(Math.floor(MAX_SAMPLES / channels / sampleRateHz / 60), channels);
      }
    };
    if (of.file.size > MIN_SAMPLE_BYTES * expected * channels) mustFit(expected);
    const detector = new science.Detector(sampleRateHz, channels, channel);
    let frames = 0;
    for (let more = true; more; ) {
      more = decoder.decodeOn();
      for (let channel = 0; channel < channels; channel += 1) {
        const samples = decoder.takeSamples(channel);
        detector.push(channel, samples);
        if (channel === 0) frames += samples.length;
      }
      mustFit(frames);
      if (expected > 0) progress(Math.min(1, frames / expected));
    }
    const gaps: Gap[] = JSON.parse(decoder.gaps());
    const file = { format: decoder.format(), warnings: decoder.warnings(), gaps };
    const response = detected(detector, file, { sampleRateHz, frames, channels, gaps });
    return { response, transfer: buffersOf(response.sound) };
  },
  read: ({ id, channel, from, to, ...of }) => {
    if (reading?.id !== id) reading = { id, sound: new FileSound(of) };
    const samples = reading.sound.read(channel, from, to);
    return { response: samples, transfer: buffers([samples]) };
  },

  detect: ({ channels, sampleRateHz, format, gaps }, { progress }) => {
    const detector = new science.Detector(sampleRateHz, channels.length, null);
    const frames = channels[0]?.length ?? 0;
    for (let at = 0; at < frames; at += sampleRateHz) {
      channels.forEach((samples, channel) => {
        detector.push(channel, samples.subarray(at, at + sampleRateHz));
      });
      progress(Math.min(1, (at + sampleRateHz) / frames));
    }
    const known = { sampleRateHz, frames, channels: channels.length, gaps };
    const response = detected(detector, { format, warnings: '[]', gaps }, known);
    return {
      response: { ...response, channels },
      transfer: [...buffersOf(response.sound), ...buffers(channels)],
    };
  },

  demo: ({ seed }) => {
    const rendering = science.Rendering.demo(seed);
    const demo: Demo = JSON.parse(rendering.about());
    const { response, transfer } = rendered(rendering);
    return { response: { demo, ...response }, transfer };
  },

  listen: ({ session, sampleRateHz }) => {
    sessions.set(session, new science.Detector(sampleRateHz, 1, null));
    return { response: null };
  },
  push: ({ session, samples, gaps }) => {
    const detector = known(session);
    detector.lose(JSON.stringify(gaps));
    detector.push(0, samples);
    return { response: JSON.parse(detector.soFar()) };
  },
  finish: ({ session, format }) => {
    const detector = known(session);
    sessions.delete(session);
    const result: RecordingResult = JSON.parse(detector.finish(format, '[]'));
    const levels = levelsOf(detector);
    const transfer = buffers(levels.map((level) => level.extremes));
    return { response: { result, levels }, transfer };
  },
  cancel: ({ session }) => {
    sessions.get(session)?.free();
    sessions.delete(session);
    return { response: null };
  },

  analyse: ({ request }, { translator }) => ({
    response: JSON.parse(analyst().analyse(JSON.stringify(request), translator)),
  }),
  chart: (request, context) => ({
    response: figure(request, context, (...of) => analyst().chart(...of)),
  }),
  figure: (request, context) => ({
    response: figure(request, context, (...of) => analyst().figure(...of)),
  }),
  waveform: ({ request, level, sampleRateHz }, { translator }) => {
    const stepS = level.samplesPerBin / sampleRateHz;
    const asked = JSON.stringify(request);
    return { response: JSON.parse(analyst().waveform(asked, level.extremes, stepS, translator)) };
  },
  report: ({ request, level, sampleRateHz, made }, { translator }) => {
    const stepS = (level?.samplesPerBin ?? 1) / sampleRateHz;
    const extremes = level?.extremes ?? new Float32Array();
    const asked = JSON.stringify(request);
    return { response: analyst().report(asked, extremes, stepS, made, translator) };
  },
  csv: ({ request }, { translator }) => ({
    response: analyst().csv(JSON.stringify(request), translator),
  }),

  rules: (_, { messages: { code, sources } }) => ({
    response: JSON.parse(decoding.rules(code, [...sources])),
  }),
  judge: ({ request }, { translator }) => ({
    response: JSON.parse(analyst().judge(JSON.stringify(request), translator)),
  }),
  verdictReport: ({ request }, { translator }) => ({
    response: analyst().verdictReport(JSON.stringify(request), translator),
  }),

  rebounds: ({ request }) => ({
    response: JSON.parse(analyst().rebounds(JSON.stringify(request))),
  }),
  methodCheck: ({ day }) => ({ response: JSON.parse(science.methodCheck(day)) }),
  sha256: ({ bytes }) => ({ response: decoding.sha256(new Uint8Array(bytes)) }),
  newJob: ({ request }) => ({ response: JSON.parse(decoding.newJob(JSON.stringify(request))) }),
  job: ({ files, change }, { messages: { code, sources } }) => {
    const asked = change ? JSON.stringify(change) : undefined;
    return { response: JSON.parse(decoding.job(JSON.stringify(files), asked, code, [...sources])) };
  },
  jobReport: ({ files, check, isOnePage }, { messages: { code, sources } }) => {
    const [job, now] = [JSON.stringify(files), JSON.stringify(check)];
    return { response: decoding.jobReport(job, now, isOnePage, code, [...sources]) };
  },

  dropLink: ({ drop, page }) => ({
    response: JSON.parse(decoding.dropLink(JSON.stringify(drop), page)),
  }),
  qrCode: ({ address }) => ({ response: JSON.parse(decoding.qrCode(address)) }),
  readQrCode: ({ grey, width }) => ({ response: decoding.readQrCode(grey, width) ?? null }),
  sheet: ({ name, isMarkdown, address, messages: { code, sources } }) => ({
    response: decoding.sheet(name, isMarkdown, address, code, [...sources]),
  }),
  linkedDrop: ({ code }) => ({ response: JSON.parse(decoding.linkedDrop(code)) }),

  study: ({ request }, { messages: { code, sources } }) => ({
    response: JSON.parse(decoding.study(JSON.stringify(request), code, [...sources])),
  }),
  dropCharts: ({ drops }, { messages: { code, sources } }) => ({
    response: JSON.parse(decoding.dropCharts(JSON.stringify(drops), code, [...sources])),
  }),
  studyReport: ({ request }, { messages: { code, sources } }) => ({
    response: decoding.studyReport(JSON.stringify(request), code, [...sources]),
  }),

  onset: ({ samples, sampleRateHz, startS, timeS }) => ({
    response: JSON.parse(science.onsetNear(samples, sampleRateHz, startS, timeS)),
  }),
  spectrogram: ({ samples, margin, sampleRateHz, columns, rows }) => {
    const found = new science.Spectrogram(samples, margin, sampleRateHz, columns, rows);
    const cells = found.takeCells();
    return {
      response: { columns, rows, topHz: found.topHz(), cells, floorDb: found.floorDb() },
      transfer: buffers([cells]),
    };
  },
  wav: ({ channels: [left, right], sampleRateHz, gaps }) => {
    const nothing = new Float32Array();
    const lost = JSON.stringify(gaps);
    const bytes = science.wav(left ?? nothing, right ?? nothing, sampleRateHz, lost);
    return { response: bytes as Uint8Array<ArrayBuffer>, transfer: buffers([bytes]) };
  },

  simulate: ({ request }, { translator }) => ({
    response: JSON.parse(science.simulate(JSON.stringify(request), translator)),
  }),
  synthesise: ({ request, scene }) => {
    const rendering = science.Rendering.synthesise(JSON.stringify(request), JSON.stringify(scene));
    return rendered(rendering);
  },
  simulationCharts: ({ runs }, { translator }) => ({
    response: JSON.parse(science.simulationCharts(JSON.stringify(runs), translator)),
  }),
  lessonCharts: (_, { messages: { code, sources } }) => ({
    response: JSON.parse(decoding.lessonCharts(code, [...sources])),
  }),
  puzzleAnswer: ({ choice }, { translator }) => ({
    response: JSON.parse(science.puzzleAnswer(JSON.stringify(choice), translator)),
  }),
  puzzleSolution: ({ choice }) => ({
    response: JSON.parse(science.puzzleSolution(JSON.stringify(choice))),
  }),
  paper: (_, { messages: { code, sources } }) => ({
    response: JSON.parse(decoding.paperDocument(code, [...sources])),
  }),
};

/** Languages that were asked for, by their codes. */
const translators = new Map<string, science.Translator>();

function translatorOf({ code, sources }: Messages): science.Translator {
  const known = translators.get(code);
  if (known) return known;
  const made = new science.Translator(code, [...sources]);
  translators.set(code, made);
  return made;
}

function figure<T>(
  { request, drop, name, simulation }: FigureRequest,
  { translator }: Context,
  draw: (
    request: string,
    drop: number,
    name: string,
    simulation: string | undefined,
    translator: science.Translator,
  ) => string,
): T {
  const compared = simulation ? JSON.stringify(simulation) : undefined;
  return JSON.parse(draw(JSON.stringify(request), drop, name, compared, translator));
}

function rendered(rendering: science.Rendering): Answer<'synthesise'> {
  const samples = rendering.takeSamples() as Float32Array<ArrayBuffer>;
  return {
    response: { samples, sampleRateHz: rendering.sampleRateHz() },
    transfer: buffers([samples]),
  };
}

function detected(
  detector: science.Detector,
  file: { format: string; warnings: string; gaps: readonly Gap[] },
  known: Omit<SoundOutline, 'levels'>,
): { result: RecordingResult; sound: SoundOutline } {
  detector.lose(JSON.stringify(file.gaps));
  const result: RecordingResult = JSON.parse(detector.finish(file.format, file.warnings));
  return { result, sound: { ...known, levels: levelsOf(detector) } };
}

const buffersOf = ({ levels }: SoundOutline): Transferable[] =>
  buffers(levels.map((level) => level.extremes));

function levelsOf(finished: science.Detector): Level[] {
  return Array.from(finished.samplesPerBin(), (samplesPerBin, level) => ({
    samplesPerBin,
    extremes: finished.takeLevel(level),
  }));
}

function known(session: number): science.Detector {
  const detector = sessions.get(session);
  if (detector === undefined) {
    throw new Error('the recording was ended; listen again');
  }
  return detector;
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

/** What went wrong, in the language of the page where the science says it; and whether the engine can still be used. */
function refusalOf(
  error: unknown,
  call: Call,
  messages: Messages,
): { refusal: LabRefusal; broken: boolean } {
  if (typeof error === 'string') {
    const refusal: LabRefusal = JSON.parse(error);
    if (refusal.diagnostic) {
      const diagnostic = JSON.stringify(refusal.diagnostic);
      refusal.message = translatorOf(messages).diagnostic(diagnostic);
    }
    return { refusal, broken: false };
  }
  const broken = error instanceof WebAssembly.RuntimeError || error instanceof RangeError;
  const refused = (kind: LabRefusal['kind'], message: string, reason: LabReason | null) => ({
    refusal: { kind, message, reason, diagnostic: null },
    broken,
  });
  if (error instanceof TooLong) return refused('too-long', error.message, error.reason);
  if (error instanceof RangeError) {
    return refused('too-long', 'there is not enough memory for it', { code: 'no-memory' });
  }
  if (broken && (call === 'open' || call === 'read')) {
    return refused('damaged', 'the decoder fails on this file', { code: 'breaks-decoder' });
  }
  return refused('fault', String(error), null);
}

function send(message: FromWorker, transfer: Transferable[] = []): void {
  postMessage(message, { transfer });
}

function answer<C extends Call>(
  id: number,
  call: C,
  request: Request<C>,
  messages: Messages,
): void {
  try {
    const progress = (share: number) => send({ kind: 'progress', id, share });
    const context = { translator: translatorOf(messages), messages, progress };
    const { response, transfer } = handlers[call](request, context);
    send({ kind: 'done', id, response }, transfer);
  } catch (error) {
    send({ kind: 'refused', id, ...refusalOf(error, call, messages) });
  }
}

/** Calls that came before the engine was there. */
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
  const call = () => answer(data.id, data.call, data.request, data.messages);
  if (waiting === null) {
    call();
  } else {
    waiting.push(call);
  }
});
