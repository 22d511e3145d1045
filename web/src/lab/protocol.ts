import type {
  Analysed,
  AnalysisRequest,
  Catalogue,
  Chart,
  ComparedDrop,
  Demo,
  Drawn,
  DropLink,
  Gap,
  Impact,
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
  RecordingResult,
  RuleChoice,
  SceneRequest,
  SimulationDocument,
  SimulationRequest,
  SimulationRun,
  SoFar,
  Studied,
  StudyRequest,
  VerdictRequest,
} from './engine/types.ts';
import type { LabRefusal } from './error.ts';

/** The messages of a language: its code, and its files as they are. English is part of the engine. */
export interface Messages {
  readonly code: string;
  readonly sources: readonly string[];
}

export const ENGLISH: Messages = { code: 'en', sources: [] };

/** A figure of a drop: its index and the name of the figure. */
export interface FigureRequest {
  readonly request: AnalysisRequest;
  readonly drop: number;
  readonly name: string;
  /** What the drop is compared with. */
  readonly simulation: SimulationRequest | null;
}

/** Minimum and maximum sample of bins of equal length, fine to coarse. */
export interface Level {
  samplesPerBin: number;
  /** Minimum and maximum of each bin, one after the other. */
  extremes: Float32Array;
}

/** What is known of a sound without its samples. */
export interface SoundOutline {
  readonly sampleRateHz: number;
  /** Samples of each channel. */
  readonly frames: number;
  readonly channels: number;
  /** Of the channel with the drops. */
  readonly levels: readonly Level[];
  /** Where sound was lost, and silence stands in its place. */
  readonly gaps: readonly Gap[];
}

/** A sound, whose samples are read where they are needed. */
export interface Sound extends SoundOutline {
  /** The samples of a channel, counted from 0, with numbers from `from` to `to` - 1; outside the sound it has no samples. */
  read(channel: number, from: number, to: number): Promise<Float32Array<ArrayBuffer>>;
}

/** A file as it is decoded. */
export interface SoundFile {
  readonly file: Blob;
  readonly name: string;
  /** The rate of samples whose file does not state it. */
  readonly rateHz: number | null;
}

/** A spectrogram: one byte for each cell, rows from low to high frequency, columns one by one. */
export interface Spectrogram {
  columns: number;
  rows: number;
  /** Frequency at the top. */
  topHz: number;
  /** Level in half decibels above `floorDb`, column after column. */
  cells: Uint8Array;
  floorDb: number;
}

/** What the worker does: what each call asks, and what is answered. */
export interface Calls {
  catalogue: { request: Record<never, never>; response: Catalogue };
  open: {
    request: SoundFile & { channel: number | null };
    response: { result: RecordingResult; sound: SoundOutline | null };
  };
  /** `id` tells one file from another. */
  read: {
    request: SoundFile & { id: number; channel: number; from: number; to: number };
    response: Float32Array<ArrayBuffer>;
  };
  detect: {
    request: {
      channels: Float32Array<ArrayBuffer>[];
      sampleRateHz: number;
      format: string;
      gaps: readonly Gap[];
    };
    response: {
      result: RecordingResult;
      sound: SoundOutline;
      channels: Float32Array<ArrayBuffer>[];
    };
  };
  demo: {
    request: { seed: number };
    response: { demo: Demo; samples: Float32Array<ArrayBuffer>; sampleRateHz: number };
  };
  listen: { request: { session: number; sampleRateHz: number }; response: null };
  push: {
    request: { session: number; samples: Float32Array; gaps: readonly Gap[] };
    response: SoFar;
  };
  finish: {
    request: { session: number; format: string };
    response: { result: RecordingResult; levels: Level[] };
  };
  cancel: { request: { session: number }; response: null };
  analyse: { request: { request: AnalysisRequest }; response: Analysed };
  chart: { request: FigureRequest; response: Chart };
  figure: { request: FigureRequest; response: Drawn };
  waveform: {
    request: {
      request: AnalysisRequest;
      level: Level;
      sampleRateHz: number;
    };
    response: Drawn;
  };
  report: {
    request: {
      request: AnalysisRequest;
      level: Level | null;
      sampleRateHz: number;
      made: string;
    };
    response: string;
  };
  csv: { request: { request: AnalysisRequest }; response: string };
  rules: { request: Record<never, never>; response: RuleChoice[] };
  judge: { request: { request: VerdictRequest }; response: Judged };
  verdictReport: { request: { request: VerdictRequest }; response: string };
  rebounds: { request: { request: ReboundRequest }; response: unknown[] };
  methodCheck: { request: { day: string }; response: unknown };
  sha256: { request: { bytes: ArrayBuffer }; response: string };
  newJob: { request: { request: NewJob }; response: JobFiles };
  job: { request: { files: JobFiles; change: JobChange | null }; response: JobShown };
  jobReport: {
    request: { files: JobFiles; check: unknown; isOnePage: boolean };
    response: string;
  };
  dropLink: { request: { drop: LinkedDrop; page: string }; response: DropLink };
  qrCode: { request: { address: string }; response: DropLink };
  readQrCode: { request: { grey: Uint8Array; width: number }; response: string | null };
  sheet: {
    request: { name: string; isMarkdown: boolean; address: string; messages: Messages };
    response: string;
  };
  linkedDrop: { request: { code: string }; response: LinkedDrop };
  study: { request: { request: StudyRequest }; response: Studied };
  studyReport: { request: { request: StudyRequest }; response: string };
  onset: {
    request: { samples: Float32Array; sampleRateHz: number; startS: number; timeS: number };
    response: Impact | null;
  };
  spectrogram: {
    request: {
      samples: Float32Array;
      /** Samples at both ends that are not shown. */
      margin: number;
      sampleRateHz: number;
      columns: number;
      rows: number;
    };
    response: Spectrogram;
  };
  wav: {
    request: { channels: Float32Array[]; sampleRateHz: number; gaps: readonly Gap[] };
    response: Uint8Array<ArrayBuffer>;
  };
  simulate: { request: { request: SimulationRequest }; response: SimulationDocument };
  synthesise: {
    request: { request: SimulationRequest; scene: SceneRequest };
    response: { samples: Float32Array<ArrayBuffer>; sampleRateHz: number };
  };
  simulationCharts: { request: { runs: SimulationRun[] }; response: Chart[] };
  dropCharts: { request: { drops: ComparedDrop[] }; response: Chart[] };
  lessonCharts: { request: Record<never, never>; response: Chart[] };
  puzzleAnswer: { request: { choice: PuzzleChoice }; response: PuzzleAnswer };
  puzzleSolution: { request: { choice: PuzzleChoice }; response: PuzzleChoice };
  paper: { request: Record<never, never>; response: PaperDocument };
}

export type Call = keyof Calls;
export type Request<C extends Call> = Calls[C]['request'];
export type Response<C extends Call> = Calls[C]['response'];

/** From the page to the worker. */
export type ToWorker =
  | { kind: 'start'; engine: WebAssembly.Module; decoders: WebAssembly.Module | null }
  | {
      [C in Call]: {
        kind: 'call';
        id: number;
        call: C;
        request: Request<C>;
        /** The language of the answer. */
        messages: Messages;
      };
    }[Call];

/** From the worker to the page. */
export type FromWorker =
  | { kind: 'progress'; id: number; share: number }
  | { kind: 'done'; id: number; response: unknown }
  | { kind: 'refused'; id: number; refusal: LabRefusal; broken: boolean };
