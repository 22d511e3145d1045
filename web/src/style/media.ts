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

const matches = (query: string): boolean => globalThis.matchMedia?.(query).matches ?? false;

/** Whether it is used with a finger. */
export const touched = matches('(pointer: coarse)');
/** Whether it is a phone, and no tablet. */
export const isPhone = matches('(pointer: coarse) and (max-width: 47.99rem)');
