/** What went wrong, as a key of the texts, with the exact words of the engine where there are some. */
import type { Texts } from '../text/texts.ts';

export type FaultKey = keyof Texts['faults'];

export interface Fault {
  readonly key: FaultKey;
  /** In the words of the engine. */
  readonly detail?: string | undefined;
  /** What it is about, as the name of a file. */
  readonly about?: string | undefined;
}
