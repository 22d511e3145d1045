import { type ReadonlySignal, signal } from '@preact/signals';

/** Whether a query of the style sheets holds, also when that changes; never where there is no window. */
export function media(query: string): ReadonlySignal<boolean> {
  const list = globalThis.matchMedia?.(query);
  const matches = signal(list?.matches ?? false);
  list?.addEventListener('change', (event) => {
    matches.value = event.matches;
  });
  return matches;
}

/** Whether it is used with a finger: what is said of taps and of the phone follows from it. */
export const handheld = globalThis.matchMedia?.('(pointer: coarse)').matches ?? false;
