/**
 * What is stated of ball, air, gravity and drop: the reader's own set-up, from which each new recording starts, and the
 * one that came with the drop in the workspace. The address holds the one that counts.
 */
import { computed, signal } from '@preact/signals';
import { recall, remember } from '../address/memory.ts';
import { hashOf, note, parseRoute } from '../address/route.ts';
import { settingsFromParameters, settingsToParameters } from '../address/settings.ts';
import type { Settings } from '../lab/index.ts';
import { UNSTATED } from '../text/names.ts';

/** Under which name the browser remembers the reader's own set-up. */
const OWN = 'bouncelab.set-up';

/** The reader's own set-up: links, the demo and simulations do not change it. */
export const own = signal<Settings>(
  settingsFromParameters(new URLSearchParams(recall(OWN) ?? '')).settings,
);
/** The set-up of a drop that was not recorded here now: of a link, the demo, a simulation, the table. */
const borrowed = signal<Settings | null>(null);
/** A set-up that a link brought when no drop was there to use it. */
export const offered = signal<Settings | null>(null);

/** What the drop in the workspace is analysed with. */
export const settings = computed<Settings>(() => borrowed.value ?? own.value);

const addressOf = (stated: Settings): string => settingsToParameters(stated).toString();

/** The way back to the laboratory, with its set-up. */
export const labAddress = computed(() => hashOf('lab', settingsToParameters(settings.value)));

export function goToLab(): void {
  location.hash = labAddress.peek();
}

/** Parameters of the address that are not valid. */
export const unreadable = signal<readonly string[]>([]);

/**
 * Reads the settings of the address, at the start and when a link changes it. They are those of the drop in the
 * workspace; without one, the reader is asked whether drops recorded from now on shall have them.
 */
export function readSettings(hasDrop: boolean): void {
  const { view, parameters } = parseRoute(location.hash);
  if (view !== 'lab') return;
  const read = settingsFromParameters(parameters);
  unreadable.value = read.unreadable;
  const isNew =
    addressOf(read.settings) !== '' && addressOf(read.settings) !== addressOf(settings.peek());
  if (isNew && hasDrop) borrowed.value = read.settings;
  offered.value = isNew && !hasDrop ? read.settings : null;
}

/** Takes the set-up of a link as the reader's own, or leaves it. */
export function decide(isTaken: boolean): void {
  if (isTaken && offered.peek()) setOwn(offered.peek() as Settings);
  offered.value = null;
  writeSettings();
}

/** A new drop lies in the workspace: with a set-up of its own, or with the reader's. */
export function startFrom(setup: Settings | null): void {
  borrowed.value = setup;
  offered.value = null;
  writeSettings();
}

function setOwn(next: Settings): void {
  own.value = next;
  // A height is that of one drop: it is not what the next visit begins with.
  const { drop: _, ...lasting } = next;
  remember(OWN, addressOf(lasting) || null);
}

function set(next: Settings): void {
  if (borrowed.peek()) borrowed.value = next;
  else setOwn(next);
  writeSettings();
}

/** Changes settings of a group; `undefined` returns one to what is assumed. */
export function change<G extends keyof Settings>(group: G, changes: Changes<G>): void {
  set(withChanges(settings.peek(), group, changes));
}

type Changes<G extends keyof Settings> = {
  [K in keyof NonNullable<Settings[G]>]?: NonNullable<Settings[G]>[K] | undefined;
};

/** Settings with changes in a group; what is undefined is left out. */
export function withChanges<G extends keyof Settings>(
  from: Settings,
  group: G,
  changes: Changes<G>,
): Settings {
  const fields = Object.entries({ ...from[group], ...changes });
  const stated = fields.filter(([, value]) => value !== undefined && value !== null);
  const { [group]: _, ...others } = from;
  return stated.length > 0
    ? { ...others, [group]: Object.fromEntries(stated) }
    : (others as Settings);
}

/** Whether a ball is stated by mass and diameter alone. */
export const isOwnBall = ({ ball }: Settings): boolean =>
  ball?.kind === undefined && (ball?.mass_kg !== undefined || ball?.diameter_m !== undefined);

/** Chooses a ball by its name; `UNSTATED` states none. */
export function chooseBall(name: string): void {
  const kind = name === UNSTATED ? undefined : name;
  change('ball', { kind, mass_kg: undefined, diameter_m: undefined });
}

/** Between these the gravity of a place on Earth lies, m/s². */
const ON_EARTH = { least: 9.76, most: 9.84 };

/** What of a set-up few drops have: other gravity, no air, a stated height. */
export function unusualOf({ gravity, air, drop }: Settings): Settings {
  const { gravity_m_s2 } = gravity ?? {};
  const isElsewhere =
    gravity_m_s2 !== undefined && (gravity_m_s2 < ON_EARTH.least || gravity_m_s2 > ON_EARTH.most);
  const isOtherAir = air?.drag === 'none' || air?.density_kg_m3 !== undefined;
  return {
    ...(isElsewhere && { gravity: { gravity_m_s2 } }),
    ...(isOtherAir && { air }),
    ...(drop?.height_m !== undefined && { drop: { height_m: drop.height_m } }),
  };
}

/** Returns what is unusual to what is assumed. */
export function resetUnusual(): void {
  const groups = Object.keys(unusualOf(settings.peek()));
  const left = Object.entries(settings.peek()).filter(([group]) => !groups.includes(group));
  set(Object.fromEntries(left));
}

export function forgetSettings(): void {
  set({});
}

/** Puts the settings into the address. */
function writeSettings(): void {
  note('lab', settingsToParameters(settings.peek()));
}
