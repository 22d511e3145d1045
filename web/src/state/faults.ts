/** What went wrong, as a key of its message, and what exactly. */
import type { LabReason } from '../lab/index.ts';

export type FaultKey =
  | 'refused'
  | 'missing'
  | 'busy'
  | 'insecure'
  | 'unsupported'
  | 'ended'
  | 'unknown'
  | 'silent'
  | 'full'
  | 'unavailable'
  | 'empty'
  | 'unsupported-file'
  | 'damaged'
  | 'times'
  | 'rate'
  | 'huge'
  | 'setting'
  | 'link'
  | 'no-drop'
  | 'fault'
  | 'keep'
  | 'series-full'
  | 'series-known'
  | 'series-storage'
  | 'archive'
  | 'bad-drop'
  | 'archive-newer'
  | 'archive-storage';

export interface Fault {
  readonly key: FaultKey;
  /** What exactly, as data. */
  readonly reason?: LabReason | undefined;
  /** What exactly, in English, where there is no message for it. */
  readonly detail?: string | undefined;
  /** What it is about, as the name of a file. */
  readonly about?: string | undefined;
}
