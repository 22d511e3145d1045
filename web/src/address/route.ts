/**
 * Where the reader is: everything after the `#` of the address. It never reaches a server, so that a
 * shared set-up stays between those who share it.
 */
import { signal } from '@preact/signals';

export const VIEWS = ['lab', 'simulate', 'paper', 'drops', 'series'] as const;
export type View = (typeof VIEWS)[number];

export interface Route {
  readonly view: View;
  readonly parameters: URLSearchParams;
}

export function parseRoute(hash: string): Route {
  const [name = '', query = ''] = hash.replace(/^#\/?/, '').split('?', 2);
  const view = VIEWS.find((candidate) => candidate === name) ?? 'lab';
  return { view, parameters: new URLSearchParams(query) };
}

export function hashOf(view: View, parameters?: URLSearchParams): string {
  const query = parameters?.toString() ?? '';
  return query === '' ? `#${view}` : `#${view}?${query}`;
}

export const route = signal<Route>(parseRoute(globalThis.location?.hash ?? ''));

globalThis.addEventListener?.('hashchange', () => {
  route.value = parseRoute(location.hash);
});

/** Notes parameters in the address without a step in the history of the browser. */
export function note(view: View, parameters: URLSearchParams): void {
  if (route.peek().view !== view) return;
  const hash = hashOf(view, parameters);
  if (hash !== location.hash) history.replaceState(null, '', hash);
}

/** The whole address of a view with parameters, to share. */
export function addressOf(view: View, parameters?: URLSearchParams): string {
  return location.href.split('#', 1)[0] + hashOf(view, parameters);
}
