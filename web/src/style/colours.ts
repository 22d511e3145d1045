import { computed, effect, signal } from '@preact/signals';
import { recall, remember } from '../address/memory.ts';
import { media } from './media.ts';

export type Theme = 'system' | 'light' | 'dark';

const KEY = 'bouncelab.theme';
const systemDark = media('(prefers-color-scheme: dark)');
/** Whether the system states all colours, as for high contrast: then the page has no theme of its own. */
export const forced = media('(forced-colors: active)');

export const theme = signal<Theme>(remembered());
const applied = computed<Theme>(() => (forced.value ? 'system' : theme.value));
export const dark = computed(() =>
  applied.value === 'system' ? systemDark.value : applied.value === 'dark',
);

function remembered(): Theme {
  const stored = recall(KEY);
  return stored === 'light' || stored === 'dark' ? stored : 'system';
}

/** Keeps the page and the memory of the browser in step with the theme. */
export function followTheme(): void {
  effect(() => {
    if (applied.value === 'system') delete document.documentElement.dataset['theme'];
    else document.documentElement.dataset['theme'] = applied.value;
    remember(KEY, theme.value === 'system' ? null : theme.value);
  });
}

/** The font of the page in a size, for canvases. */
export function fontOf(sizeRem: number): string {
  const { fontSize } = getComputedStyle(document.documentElement);
  return `${sizeRem * Number.parseFloat(fontSize)}px ${getComputedStyle(document.body).fontFamily}`;
}

/** A colour of the style sheet by its name, resolved for the present theme. */
export function colour(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

/** A colour with an opacity from 0 to 1 over the background of the current theme. */
export function tinted(name: string, strength: number): string {
  const share = Math.round(100 * strength);
  return `color-mix(in srgb, ${colour(name)} ${share}%, ${colour('paper')})`;
}
