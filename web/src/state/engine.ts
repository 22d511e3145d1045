/** The engine of the laboratory: loaded once, used by all. */
import { signal } from '@preact/signals';
import { type Catalogue, Lab, LabError } from '../lab/index.ts';
import { messages } from '../text/language.ts';
import type { Fault, FaultKey } from './faults.ts';

let lab: Lab | undefined;

/** Balls, laws and bodies to choose from, once they are loaded. */
export const catalogue = signal<Catalogue | null>(null);
/** Set when the engine could not be started at all. */
export const broken = signal<string | null>(null);

export function engine(): Lab {
  lab ??= new Lab(() => messages.peek());
  return lab;
}

/** Starts the engine and asks what it offers. */
export async function start(): Promise<void> {
  try {
    catalogue.value = await engine().catalogue();
    prepareAtLeisure();
  } catch (error) {
    broken.value = messageOf(error);
  }
}

/** Loads what opens files, so that the first file need not wait for it. */
function prepareAtLeisure(): void {
  const soon = globalThis.requestIdleCallback ?? ((work: () => void) => setTimeout(work, 1000));
  // If it fails, for want of a network perhaps, the first file tries again and says so.
  soon(
    () =>
      void engine()
        .prepare()
        .catch(() => undefined),
  );
}

export const messageOf = (error: unknown): string =>
  error instanceof Error ? error.message : String(error);

const FAULTS: Partial<Record<LabError['kind'], FaultKey>> = {
  empty: 'empty',
  unsupported: 'unsupported-file',
  damaged: 'damaged',
  times: 'times',
  setting: 'setting',
  link: 'link',
  'too-long': 'huge',
};

/** What the page says of an error of the engine. */
export function faultOf(error: unknown): Fault {
  const known = error instanceof LabError ? error : undefined;
  const key = (known && FAULTS[known.kind]) ?? 'fault';
  return known?.reason ? { key, reason: known.reason } : { key, detail: messageOf(error) };
}
