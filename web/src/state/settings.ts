/** What the reader stated of ball, air, gravity and drop. The address holds the same. */
import { computed, signal } from '@preact/signals';
import { recall, remember } from '../address/memory.ts';
import { hashOf, note, parseRoute } from '../address/route.ts';
import { settingsFromParameters, settingsToParameters } from '../address/settings.ts';
import type { Settings } from '../lab/index.ts';
import { UNSTATED } from '../text/names.ts';

export const settings = signal<Settings>({});
/** The way back to the laboratory, with its set-up. */
export const labAddress = computed(() => hashOf('lab', settingsToParameters(settings.value)));

export function goToLab(): void {
  location.hash = labAddress.peek();
}

/** Parameters of the address that are not valid. */
export const unreadable = signal<readonly string[]>([]);

/** Under which name the browser remembers the ball that was chosen last. */
const BALL = 'ball';

/**
 * Takes the settings of the address, at the start and when a link changes it. One without settings means
 * the ball that was chosen last.
 */
export function readSettings(): void {
  const { view, parameters } = parseRoute(location.hash);
  if (view !== 'lab') return;
  const ball = parameters.size === 0 ? recall(BALL) : null;
  const read = settingsFromParameters(ball === null ? parameters : new URLSearchParams({ ball }));
  unreadable.value = read.unreadable;
  const same =
    settingsToParameters(read.settings).toString() ===
    settingsToParameters(settings.peek()).toString();
  if (!same) settings.value = read.settings;
  if (ball !== null) writeSettings();
}

/** Changes settings of a group; `undefined` returns one to what is assumed. */
export function change<G extends keyof Settings>(
  group: G,
  changes: { [K in keyof NonNullable<Settings[G]>]?: NonNullable<Settings[G]>[K] | undefined },
): void {
  const fields = Object.entries({ ...settings.peek()[group], ...changes });
  const stated = fields.filter(([, value]) => value !== undefined && value !== null);
  const { [group]: _, ...others } = settings.peek();
  settings.value =
    stated.length > 0 ? { ...others, [group]: Object.fromEntries(stated) } : (others as Settings);
  writeSettings();
}

/** Whether a ball is stated by mass and diameter alone. */
export const isOwnBall = ({ ball }: Settings): boolean =>
  ball?.kind === undefined && (ball?.mass_kg !== undefined || ball?.diameter_m !== undefined);

/** Chooses a ball by its name, and remembers it; `UNSTATED` states none. */
export function chooseBall(name: string): void {
  const kind = name === UNSTATED ? undefined : name;
  remember(BALL, kind ?? null);
  change('ball', { kind, mass_kg: undefined, diameter_m: undefined });
}

/** States a ball by its name, this time. */
export function stateBall(name: string): void {
  change('ball', { kind: name, mass_kg: undefined, diameter_m: undefined });
}

export function forgetSettings(): void {
  remember(BALL, null);
  settings.value = {};
  writeSettings();
}

/** Puts the settings into the address. */
export function writeSettings(): void {
  note('lab', settingsToParameters(settings.peek()));
}
