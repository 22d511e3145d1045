import { Connection, type Modules, type Port } from './connection.ts';
import type {
  Analysed,
  AnalysisRequest,
  Catalogue,
  Chart,
  ComparedDrop,
  Demo,
  Drawn,
  DropLink,
  DropMarks,
  Gap,
  JobChange,
  JobFiles,
  JobShown,
  Judged,
  LinkedDrop,
  NewJob,
  PaperDocument,
  PuzzleAnswer,
  PuzzleChoice,
  ReboundRequest,
  RuleChoice,
  SceneRequest,
  Settings,
  SimulationDocument,
  SimulationRequest,
  SimulationRun,
  SoFar,
  Studied,
  StudyRequest,
  VerdictRequest,
} from './engine/types.ts';
import { LabError } from './error.ts';
import {
  ENGLISH,
  type FigureRequest,
  type Level,
  type Messages,
  type Sound,
  type Spectrogram,
} from './protocol.ts';
import { Recording, type Services } from './recording.ts';

/** What long work tells, and what ends it. */
export interface WorkOptions {
  /** Cancels it. */
  signal?: AbortSignal;
  /** Progress, 0 to 1. */
  onProgress?: (share: number) => void;
}

/** How a recording is opened. */
export interface OpenOptions extends WorkOptions {
  /** The only channel to listen to, the first being 1; the one with the most evidence if left out. */
  channel?: number;
  /** The rate in Hz of samples whose file does not state it. */
  rateHz?: number | undefined;
}

/** How drops are detected in samples. */
export interface DetectOptions extends WorkOptions {
  /** Where the samples are from, as the source of the result says it; `samples` if left out. */
  format?: string;
  /** Where sound was lost, and silence stands in its place. */
  gaps?: readonly Gap[];
}

/**
 * The laboratory: the science, in workers that run next to the page.
 *
 * ```ts
 * const lab = new Lab();
 * const recording = await lab.open(file);
 * const analysed = await lab.analyse(lab.request(recording, { ball: { kind: 'table-tennis-40' } }));
 * ```
 *
 * Every method rejects with a `LabError`, whose `message` is for people.
 */
export class Lab {
  readonly #spawn: () => Port;
  readonly #load: (part: Part) => Promise<WebAssembly.Module>;
  /** The worker for requests that must be answered at once. */
  readonly #front: Connection;
  /** The worker for long requests. */
  readonly #back: Connection;
  readonly #messages: () => Messages;
  /** The worker that reads the sound of files, once it is needed. */
  #reader: Connection | undefined;
  #turn = 0;
  #sessions = 0;
  #files = 0;

  /** Answers are in the language that `messages` has when they are asked for. */
  constructor(
    messages: () => Messages = () => ENGLISH,
    spawn: () => Port = spawnWorker,
    load = loader(),
  ) {
    this.#messages = messages;
    this.#spawn = spawn;
    this.#load = load;
    this.#front = new Connection(spawn, this.#modules(false), messages);
    this.#back = new Connection(spawn, this.#modules(false), messages);
  }

  /**
   * Loads the decoders, which are due when a file is opened: to be called when the page has nothing
   * else to do.
   */
  async prepare(): Promise<void> {
    await this.#load('decoders');
  }

  /** Balls, laws, voices and bodies to choose from. */
  catalogue(): Promise<Catalogue> {
    return this.#front.call('catalogue', {});
  }

  /**
   * Reads a recording of any format, or a list of times (by the ending of its name, such as .csv or
   * .xlsx), and detects the drops in it.
   */
  async open(file: File | { name: string; blob: Blob }, options: OpenOptions = {}) {
    const blob = file instanceof File ? file : file.blob;
    const of = { file: blob, name: file.name, rateHz: options.rateHz ?? null };
    const request = { ...of, channel: options.channel ?? null };
    // A worker of its own: a damaged file may break the decoder, and long ones can be called off.
    const { result, sound } = await this.#alone(true, options.signal, (connection) =>
      connection.call('open', request, { progress: options.onProgress }),
    );
    this.#files += 1;
    const id = this.#files;
    const read: Sound['read'] = (channel, from, to) => {
      this.#reader ??= new Connection(this.#spawn, this.#modules(true), this.#messages);
      return this.#reader.call('read', { ...of, id, channel, from, to });
    };
    return new Recording(file.name, result, sound && { ...sound, read }, this.#services);
  }

  /** Impact times as a person pastes them: one a line, or a table, or an array. */
  async paste(text: string, options: WorkOptions = {}): Promise<Recording> {
    return this.open({ name: 'times.txt', blob: new Blob([text]) }, options);
  }

  /** Detects drops in samples that are in memory, as those of a simulation or of the database. They are taken away. */
  async detect(
    channels: Float32Array<ArrayBuffer>[],
    sampleRateHz: number,
    name: string,
    { format = 'samples', gaps = [], signal, onProgress }: DetectOptions = {},
  ): Promise<Recording> {
    const transfer = channels.map((channel) => channel.buffer);
    const request = { channels, sampleRateHz, format, gaps };
    const found = await this.#alone(false, signal, (connection) =>
      connection.call('detect', request, { transfer, progress: onProgress }),
    );
    const sound = { ...found.sound, read: readerOf(found.channels) };
    return new Recording(name, found.result, sound, this.#services);
  }

  /** The paper's drop, simulated: its recording (by this name), its settings and the truth. */
  async demo(
    name?: string,
    options: WorkOptions = {},
    seed = 1,
  ): Promise<{ recording: Recording; demo: Demo }> {
    const { demo, samples, sampleRateHz } = await this.#front.call('demo', { seed });
    const of = { format: 'WAV', ...options };
    const recording = await this.detect([samples], sampleRateHz, name ?? demo.name, of);
    return { recording, demo };
  }

  /** Begins to listen to samples that come bit by bit. */
  async listen(sampleRateHz: number): Promise<Listening> {
    this.#sessions += 1;
    const session = this.#sessions;
    await this.#front.call('listen', { session, sampleRateHz });
    return new Listening(this.#front, session, sampleRateHz, this.#services);
  }

  /** The drops of a recording as they were detected, or edited, ready to be analysed. */
  request(recording: Recording, settings: Settings, drops?: DropMarks[]): AnalysisRequest {
    const {
      source,
      strongest_band,
      diagnostics,
      no_drop,
      candidates,
      drops: detected,
    } = recording.result;
    const asDetected = detected.map(({ impacts, probability }) => ({
      impacts,
      probability,
      edited: false,
    }));
    return {
      name: recording.name,
      source,
      strongest_band,
      // What may be a drop is offered by the page itself.
      diagnostics: diagnostics.filter(({ code }) => code !== 'possible-drop'),
      no_drop,
      candidates,
      drops: drops ?? asDetected,
      settings,
      inference: true,
    };
  }

  /**
   * Analyses drops. `onQuick` gets the log-linear fit and the restitution of each impact within
   * milliseconds; what is returned has the inference too.
   *
   * The latest call wins: one before it that is not yet answered rejects as `superseded`.
   */
  async analyse(
    request: AnalysisRequest,
    onQuick?: (analysed: Analysed) => void,
  ): Promise<Analysed> {
    this.#turn += 1;
    const turn = this.#turn;
    if (onQuick) {
      const quick = await this.#front.call('analyse', {
        request: { ...request, inference: false },
      });
      this.#mustBeLatest(turn);
      onQuick(quick);
    }
    // One at a time: while the last one is still at work, later ones replace each other.
    await this.#idle();
    this.#mustBeLatest(turn);
    const analysed = this.#back.call('analyse', { request });
    this.#working = analysed.then(
      () => undefined,
      () => undefined,
    );
    const result = await analysed;
    this.#mustBeLatest(turn);
    return result;
  }

  /** Analyses drops that are not those in the workspace: no later call takes its place. */
  analyseBeside(request: AnalysisRequest): Promise<Analysed> {
    return this.#back.call('analyse', { request });
  }

  /**
   * A figure of a drop as a chart, by a name from `Analysed.figures`. The worker that made the analysis
   * remembers it.
   */
  chart(asked: FigureRequest): Promise<Chart> {
    const worker = asked.request.inference ? this.#back : this.#front;
    return worker.call('chart', asked);
  }

  /** The same as a picture, as the program draws it. */
  figure(asked: FigureRequest): Promise<Drawn> {
    return this.#back.call('figure', asked);
  }

  /** Draws the waveform with its impacts, as the program does. */
  async waveform(recording: Recording, request: AnalysisRequest): Promise<Drawn> {
    const level = pictured(recording);
    if (level === null || recording.sound === null) {
      throw new LabError('empty', 'a list of times has no waveform');
    }
    const { sampleRateHz } = recording.sound;
    return this.#back.call('waveform', { request, level, sampleRateHz });
  }

  /** The report of an analysis as one HTML file, as the program writes it but for the language. */
  report(recording: Recording, request: AnalysisRequest, made: Date): Promise<string> {
    return this.#back.call('report', {
      request,
      level: pictured(recording),
      sampleRateHz: recording.sound?.sampleRateHz ?? 1,
      made: made.toISOString().slice(0, 10),
    });
  }

  /** The impacts as CSV, as the program writes them. */
  csv(request: AnalysisRequest): Promise<string> {
    return this.#back.call('csv', { request });
  }

  /** The rules by which drops can be judged. */
  rules(): Promise<RuleChoice[]> {
    return this.#alone(true, undefined, (connection) => connection.call('rules', {}));
  }

  /** Judges drops by a rule. */
  judge(request: VerdictRequest): Promise<Judged> {
    return this.#back.call('judge', { request });
  }

  /** The report of a verdict as one HTML file. */
  verdictReport(request: VerdictRequest): Promise<string> {
    return this.#back.call('verdictReport', { request });
  }

  /** The rebounds of the drops of a recording, by a rule. */
  rebounds(request: ReboundRequest): Promise<unknown[]> {
    return this.#back.call('rebounds', { request });
  }

  /** The check of the method on a synthesised recording, on a day. */
  methodCheck(day: string): Promise<unknown> {
    return this.#back.call('methodCheck', { day });
  }

  /** The SHA-256 of a file, in hexadecimal. */
  async sha256(file: Blob): Promise<string> {
    const bytes = await file.arrayBuffer();
    return this.#alone(true, undefined, (connection) =>
      connection.call('sha256', { bytes }, { transfer: [bytes] }),
    );
  }

  /** The files of a new job. */
  newJob(request: NewJob): Promise<JobFiles> {
    return this.#alone(true, undefined, (connection) => connection.call('newJob', { request }));
  }

  /** A job after a change, if there is one. */
  job(files: JobFiles, change: JobChange | null = null): Promise<JobShown> {
    return this.#alone(true, undefined, (connection) => connection.call('job', { files, change }));
  }

  /** The report of a job as one HTML file, with the check of the method of now. */
  jobReport(files: JobFiles, check: unknown, isOnePage: boolean): Promise<string> {
    return this.#alone(true, undefined, (connection) =>
      connection.call('jobReport', { files, check, isOnePage }),
    );
  }

  /** A drop as a link and a QR code, for a page at this address, which ends where the drop begins. */
  dropLink(drop: LinkedDrop, page: string): Promise<DropLink> {
    return this.#alone(true, undefined, (connection) =>
      connection.call('dropLink', { drop, page }),
    );
  }

  /** Any other link with its QR code. */
  qrCode(address: string): Promise<DropLink> {
    return this.#alone(true, undefined, (connection) => connection.call('qrCode', { address }));
  }

  /** The lesson sheet of this name, as HTML or as Markdown, for pupils who use the page at this address. */
  sheet(name: string, isMarkdown: boolean, address: string, messages: Messages): Promise<string> {
    return this.#alone(true, undefined, (connection) =>
      connection.call('sheet', { name, isMarkdown, address, messages }),
    );
  }

  /** The text of a QR code in a picture of these grey levels, row by row, if one can be read. */
  readQrCode(grey: Uint8Array, width: number): Promise<string | null> {
    return this.#alone(true, undefined, (connection) =>
      connection.call('readQrCode', { grey, width }),
    );
  }

  /** The drop at the end of a link. */
  linkedDrop(code: string): Promise<LinkedDrop> {
    return this.#alone(true, undefined, (connection) => connection.call('linkedDrop', { code }));
  }

  /** The study of several drops. */
  study(request: StudyRequest): Promise<Studied> {
    return this.#alone(true, undefined, (connection) => connection.call('study', { request }));
  }

  /** The report of it as one HTML file. */
  studyReport(request: StudyRequest): Promise<string> {
    return this.#alone(true, undefined, (connection) =>
      connection.call('studyReport', { request }),
    );
  }

  /** Simulates a drop under one or more drag laws. */
  simulate(request: SimulationRequest): Promise<SimulationDocument> {
    return this.#front.call('simulate', { request });
  }

  /** Height against time and flight times of simulated drops, the last of which is the present one. */
  simulationCharts(runs: SimulationRun[]): Promise<Chart[]> {
    return this.#front.call('simulationCharts', { runs });
  }

  /** The restitution of each of several drops, and that of their impacts. */
  dropCharts(drops: ComparedDrop[]): Promise<Chart[]> {
    return this.#alone(true, undefined, (connection) => connection.call('dropCharts', { drops }));
  }

  /** What a simulated drop sounds like. */
  synthesise(
    request: SimulationRequest,
    scene: SceneRequest,
  ): Promise<{ samples: Float32Array<ArrayBuffer>; sampleRateHz: number }> {
    return this.#front.call('synthesise', { request, scene });
  }

  /** The paper's numbers, computed again. */
  paper(): Promise<PaperDocument> {
    return this.#alone(true, undefined, (connection) => connection.call('paper', {}));
  }

  /** The charts of the lesson about the paper. */
  lessonCharts(): Promise<Chart[]> {
    return this.#alone(true, undefined, (connection) => connection.call('lessonCharts', {}));
  }

  /** The log-linear fit of the paper for a choice. */
  puzzleAnswer(choice: PuzzleChoice): Promise<PuzzleAnswer> {
    return this.#front.call('puzzleAnswer', { choice });
  }

  /** The choice with the restitution for which the log-linear fit gives the paper's result. */
  puzzleSolution(choice: PuzzleChoice): Promise<PuzzleChoice> {
    return this.#front.call('puzzleSolution', { choice });
  }

  /** Samples of one or two channels as WAV, 32 bits each: exactly as they are, with their gaps. They are taken away. */
  async wav(
    channels: Float32Array[],
    sampleRateHz: number,
    gaps: readonly Gap[] = [],
  ): Promise<Blob> {
    const transfer = channels.map((channel) => channel.buffer as ArrayBuffer);
    const bytes = await this.#front.call('wav', { channels, sampleRateHz, gaps }, { transfer });
    return new Blob([bytes], { type: 'audio/wav' });
  }

  /** Ends all workers. */
  close(): void {
    this.#front.close();
    this.#back.close();
    this.#reader?.close();
  }

  #working: Promise<void> = Promise.resolve();

  async #idle(): Promise<void> {
    let working: Promise<void> | undefined;
    while (working !== this.#working) {
      working = this.#working;
      await working;
    }
  }

  #mustBeLatest(turn: number): void {
    if (turn !== this.#turn) {
      throw new LabError('superseded', 'a newer analysis took its place');
    }
  }

  async #modules(withDecoders: boolean): Promise<Modules> {
    const [engine, decoders] = await Promise.all([
      this.#load('engine'),
      withDecoders ? this.#load('decoders') : null,
    ]);
    return { engine, decoders };
  }

  /** Work in a worker of its own, which ends with it. */
  async #alone<T>(
    withDecoders: boolean,
    signal: AbortSignal | undefined,
    work: (connection: Connection) => Promise<T>,
  ): Promise<T> {
    const connection = new Connection(this.#spawn, this.#modules(withDecoders), this.#messages);
    const cancel = () => connection.close();
    if (signal?.aborted) {
      throw new LabError('cancelled', 'called off');
    }
    signal?.addEventListener('abort', cancel, { once: true });
    try {
      return await work(connection);
    } finally {
      signal?.removeEventListener('abort', cancel);
      connection.close();
    }
  }

  readonly #services = {
    onset: (samples: Float32Array, sampleRateHz: number, startS: number, timeS: number) =>
      this.#front.call(
        'onset',
        { samples, sampleRateHz, startS, timeS },
        { transfer: [samples.buffer as ArrayBuffer] },
      ),
    spectrogram: (
      samples: Float32Array,
      margin: number,
      sampleRateHz: number,
      columns: number,
      rows: number,
    ): Promise<Spectrogram> =>
      this.#front.call(
        'spectrogram',
        { samples, margin, sampleRateHz, columns, rows },
        { transfer: [samples.buffer as ArrayBuffer] },
      ),
    wav: (channels: Float32Array[], sampleRateHz: number, gaps: readonly Gap[]) =>
      this.wav(channels, sampleRateHz, gaps),
  };
}

/** A recording that is going on. What was pushed is kept here, so that nothing can lose it. */
export class Listening {
  readonly sampleRateHz: number;
  readonly #connection: Connection;
  readonly #session: number;
  readonly #services: Services;
  readonly #blocks: Float32Array[] = [];
  /** Where sound was lost, and silence was pushed in its place. */
  readonly gaps: Gap[] = [];
  #frames = 0;

  constructor(connection: Connection, session: number, sampleRateHz: number, services: Services) {
    this.#connection = connection;
    this.#session = session;
    this.sampleRateHz = sampleRateHz;
    this.#services = services;
  }

  /** How long it has been recording. */
  get durationS(): number {
    return this.#frames / this.sampleRateHz;
  }

  /** Takes the next samples, and the gaps that begin in them; answers what was detected so far. */
  push(samples: Float32Array, gaps: readonly Gap[] = []): Promise<SoFar> {
    this.#blocks.push(samples);
    this.#frames += samples.length;
    this.gaps.push(...gaps);
    return this.#connection.call('push', { session: this.#session, samples, gaps });
  }

  /** All samples so far. */
  samples(): Float32Array<ArrayBuffer> {
    const all = new Float32Array(this.#frames);
    let at = 0;
    for (const block of this.#blocks) {
      all.set(block, at);
      at += block.length;
    }
    return all;
  }

  /** Ends it: what was detected. */
  async finish(name: string, format = 'microphone'): Promise<Recording> {
    const request = { session: this.#session, format };
    const { result, levels } = await this.#connection.call('finish', request);
    const { sampleRateHz, gaps } = this;
    const [frames, read] = [this.#frames, readerOf([this.samples()])];
    const sound = { sampleRateHz, frames, channels: 1, levels, gaps, read };
    return new Recording(name, result, sound, this.#services);
  }

  /** Ends it without detection. */
  async discard(): Promise<void> {
    await this.#connection.call('cancel', { session: this.#session });
  }
}

/** Reads samples that are in memory. */
function readerOf(channels: readonly Float32Array<ArrayBuffer>[]): Sound['read'] {
  return async (channel, from, to) => channels[channel]?.slice(from, to) ?? new Float32Array();
}

/** The level that a picture of the whole is drawn from. */
function pictured(recording: Recording): Level | null {
  const ENOUGH_BINS = 32_768;
  const levels = recording.sound?.levels;
  return (
    levels?.find(({ extremes }) => extremes.length <= 2 * ENOUGH_BINS) ?? levels?.at(-1) ?? null
  );
}

function spawnWorker(): Port {
  return new Worker(new URL('./worker.ts', import.meta.url), { type: 'module', name: 'lab' });
}

/** The compiled modules of the science. */
type Part = 'engine' | 'decoders';

/** Loads and compiles the parts of the science, each once for all workers. */
function loader(): (part: Part) => Promise<WebAssembly.Module> {
  const urls = {
    engine: new URL('./engine/engine_bg.wasm', import.meta.url),
    decoders: new URL('./engine/decoders_bg.wasm', import.meta.url),
  };
  const loaded = new Map<Part, Promise<WebAssembly.Module>>();
  return (part) => {
    const known = loaded.get(part);
    if (known !== undefined) {
      return known;
    }
    const loading = compile(urls[part]);
    loaded.set(part, loading);
    // A failed load, such as without a network, is tried again at the next request.
    loading.catch(() => loaded.delete(part));
    return loading;
  };
}

async function compile(url: URL): Promise<WebAssembly.Module> {
  try {
    return await WebAssembly.compileStreaming(fetch(url));
  } catch (error) {
    throw new LabError('fault', 'a part of the laboratory could not be loaded', { cause: error });
  }
}
