/** What the reader stated of ball, air, gravity and drop. The address holds the same. */
import { computed, signal } from '@preact/signals';
import { hashOf, note, parseRoute } from '../address/route.ts';
import { settingsFromParameters, settingsToParameters } from '../address/settings.ts';
import type { Settings } from '../lab/index.ts';

export const settings = signal<Settings>({});
/** The way back to the laboratory, with its set-up. */
export const labAddress = computed(() => hashOf('lab', settingsToParameters(settings.value)));

export function goToLab(): void {
  location.hash = labAddress.peek();
}

/** Parts of the address that were not understood. */
export const unreadable = signal<readonly string[]>([]);

/** Takes the settings of the address, at the start and when a link changes it. */
export function readSettings(): void {
  const { view, parameters } = parseRoute(location.hash);
  if (view !== 'lab') return;
  const read = settingsFromParameters(parameters);
  unreadable.value = read.unreadable;
  const same =
    settingsToParameters(read.settings).toString() ===
    settingsToParameters(settings.peek()).toString();
  if (!same) settings.value = read.settings;
}

/** Changes settings; `undefined` returns one to what is assumed. */
export function change(changes: { [K in keyof Settings]?: Settings[K] | undefined }): void {
  const merged = { ...settings.peek(), ...changes };
  const stated = Object.entries(merged).filter(
    ([, value]) => value !== undefined && value !== null,
  );
  settings.value = Object.fromEntries(stated) as Settings;
  writeSettings();
}

export function forgetSettings(): void {
  settings.value = {};
  writeSettings();
}

/** Puts the settings into the address. */
export function writeSettings(): void {
  note('lab', settingsToParameters(settings.peek()));
}
