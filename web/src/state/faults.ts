/** What went wrong, as a key of the texts, and what exactly. */
import type { LabReason } from '../lab/index.ts';
import type { Texts } from '../text/texts.ts';

export type FaultKey = keyof Texts['faults'];

export interface Fault {
  readonly key: FaultKey;
  /** What exactly, for the texts to say. */
  readonly reason?: LabReason | undefined;
  /** What exactly, in English, where the texts have no words for it. */
  readonly detail?: string | undefined;
  /** What it is about, as the name of a file. */
  readonly about?: string | undefined;
}
