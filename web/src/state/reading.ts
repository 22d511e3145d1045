/** What is read: nothing else is loaded meanwhile, the page shows how far it is, and it can be cancelled. */
import { LabError, type WorkOptions } from '../lab/index.ts';
import { faultOf } from './engine.ts';
import { fail, idle, phase } from './workspace.ts';

/** What tells whoever reads that it is cancelled, and takes how far it is. */
export type Reader = Required<WorkOptions>;

/** Reads something of this name; it can be cancelled until that is done. */
export async function reading<T>(name: string, read: (reader: Reader) => Promise<T>): Promise<T> {
  const controller = new AbortController();
  const cancel = (): void => controller.abort();
  phase.value = { kind: 'reading', name, cancel };
  const onProgress = (share: number): void => {
    phase.value = { kind: 'reading', name, cancel, share };
  };
  try {
    return await read({ signal: controller.signal, onProgress });
  } finally {
    phase.value = { kind: 'reading', name };
  }
}

/** After an error: it is shown, unless the work was cancelled. */
export function endInVain(error: unknown, what = faultOf(error)): void {
  if (error instanceof LabError && error.kind === 'cancelled') idle();
  else fail(what);
}
