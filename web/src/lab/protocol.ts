import type { LabRefusal } from './error.ts';
import type {
  Analysed,
  AnalysisRequest,
  Catalogue,
  Chart,
  ComparedDrop,
  Demo,
  Drawn,
  Heard,
  OnsetFound,
  PaperDocument,
  PuzzleAnswer,
  PuzzleChoice,
  SceneRequest,
  SimulationDocument,
  SimulationRequest,
  SimulationRun,
  SoFar,
} from './types.ts';

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
  readonly messages: Messages;
}

/** Least and greatest sample of bins of equal length, fine to coarse. */
export interface Level {
  samplesPerBin: number;
  /** Least and greatest of each bin, one after the other. */
  extremes: Float32Array;
}

/** A recording that was decoded, or ended. */
export interface Sound {
  sampleRateHz: number;
  /** The samples of each channel. */
  channels: Float32Array[];
  /** Of the channel that was believed. */
  levels: Level[];
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

/** What the worker does: what each call takes, and what it gives. */
export interface Calls {
  catalogue: { take: Record<never, never>; give: Catalogue };
  open: {
    take: { bytes: ArrayBuffer; name: string; channel: number | null };
    give: { heard: Heard; sound: Sound | null };
  };
  hear: {
    take: { channels: Float32Array[]; sampleRateHz: number; name: string; format: string };
    give: { heard: Heard; sound: Sound };
  };
  demo: {
    take: { seed: number };
    give: { demo: Demo; samples: Float32Array; sampleRateHz: number };
  };
  listen: { take: { ear: number; sampleRateHz: number }; give: null };
  push: { take: { ear: number; samples: Float32Array }; give: SoFar };
  finish: {
    take: { ear: number; name: string; format: string };
    give: { heard: Heard; levels: Level[] };
  };
  deafen: { take: { ear: number }; give: null };
  analyse: { take: { request: AnalysisRequest }; give: Analysed };
  chart: { take: FigureRequest; give: Chart };
  figure: { take: FigureRequest; give: Drawn };
  waveform: {
    take: {
      request: AnalysisRequest;
      level: Level;
      sampleRateHz: number;
      messages: Messages;
    };
    give: Drawn;
  };
  report: {
    take: {
      request: AnalysisRequest;
      level: Level | null;
      sampleRateHz: number;
      made: string;
      messages: Messages;
    };
    give: string;
  };
  rows: { take: { request: AnalysisRequest }; give: string };
  onset: {
    take: { samples: Float32Array; sampleRateHz: number; startS: number; timeS: number };
    give: OnsetFound | null;
  };
  spectrogram: {
    take: { samples: Float32Array; sampleRateHz: number; columns: number; rows: number };
    give: Spectrogram;
  };
  wav: { take: { channels: Float32Array[]; sampleRateHz: number }; give: Uint8Array<ArrayBuffer> };
  simulate: { take: { request: SimulationRequest }; give: SimulationDocument };
  synthesise: {
    take: { request: SimulationRequest; scene: SceneRequest };
    give: { samples: Float32Array; sampleRateHz: number };
  };
  simulationCharts: { take: { runs: SimulationRun[]; messages: Messages }; give: Chart[] };
  dropCharts: { take: { drops: ComparedDrop[]; messages: Messages }; give: Chart[] };
  lessonCharts: { take: { messages: Messages }; give: Chart[] };
  puzzleAnswer: { take: { choice: PuzzleChoice; messages: Messages }; give: PuzzleAnswer };
  puzzleSolution: { take: { choice: PuzzleChoice }; give: PuzzleChoice };
  paper: { take: Record<never, never>; give: PaperDocument };
}

export type Call = keyof Calls;
export type Take<C extends Call> = Calls[C]['take'];
export type Give<C extends Call> = Calls[C]['give'];

/** From the page to the worker. */
export type ToWorker =
  | { kind: 'start'; engine: WebAssembly.Module; decoders: WebAssembly.Module | null }
  | { [C in Call]: { kind: 'call'; id: number; call: C; take: Take<C> } }[Call];

/** From the worker to the page. */
export type FromWorker =
  | { kind: 'progress'; id: number; share: number }
  | { kind: 'done'; id: number; give: unknown }
  | { kind: 'refused'; id: number; refusal: LabRefusal; broken: boolean };
