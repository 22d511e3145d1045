import { computed, effect, signal } from '@preact/signals';
import { recall, remember } from '../address/memory.ts';

export type Theme = 'system' | 'light' | 'dark';

const KEY = 'bouncelab.theme';
const prefersDark = globalThis.matchMedia?.('(prefers-color-scheme: dark)');
const systemDark = signal(prefersDark?.matches ?? false);
prefersDark?.addEventListener('change', (event) => {
  systemDark.value = event.matches;
});

export const theme = signal<Theme>(remembered());
export const dark = computed(() =>
  theme.value === 'system' ? systemDark.value : theme.value === 'dark',
);

function remembered(): Theme {
  const stored = recall(KEY);
  return stored === 'light' || stored === 'dark' ? stored : 'system';
}

/** Keeps the page and the memory of the browser in step with the theme. */
export function followTheme(): void {
  effect(() => {
    const chosen = theme.value;
    if (chosen === 'system') delete document.documentElement.dataset['theme'];
    else document.documentElement.dataset['theme'] = chosen;
    remember(KEY, chosen === 'system' ? null : chosen);
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

/** So much of a colour, from 0 to 1, on the paper of the present theme. */
export function tinted(name: string, strength: number): string {
  const share = Math.round(100 * strength);
  return `color-mix(in srgb, ${colour(name)} ${share}%, ${colour('paper')})`;
}
