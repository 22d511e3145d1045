/** The laboratory's engine, as the page sees it. */

export type * from './engine/types.ts';
export { LabError, type LabErrorKind, type LabReason } from './error.ts';
export { type DetectOptions, Lab, Listening, type OpenOptions, type WorkOptions } from './lab.ts';
export { ENGLISH, type Level, type Messages, type Sound, type Spectrogram } from './protocol.ts';
export { Recording } from './recording.ts';
