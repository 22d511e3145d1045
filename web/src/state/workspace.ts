/**
 * What lies in the workspace: the recording, its drops with their impacts, and the results. The views
 * show these signals; the functions of this folder change them.
 */
import { batch, computed, signal } from '@preact/signals';
import type { Analysed, Drop, QuantityList, Recording, Settings } from '../lab/index.ts';
import type { Processing } from '../sound/microphone.ts';
import { stop } from '../sound/player.ts';
import type { Pyramid } from '../wave/pyramid.ts';
import { framing, type Viewport, whole } from '../wave/viewport.ts';
import type { Fault } from './faults.ts';
import { begin } from './history.ts';
import { type Edits, editsOf, isEdited } from './marks.ts';
import { startFrom } from './settings.ts';

/** What goes on. */
export type Phase =
  | { readonly kind: 'empty' }
  | { readonly kind: 'starting' }
  | { readonly kind: 'listening' }
  /** `share` is how far it is, 0 to 1, where that is known. */
  | {
      readonly kind: 'reading';
      readonly name: string;
      readonly share?: number;
      /** Ends it, where it takes long. */
      readonly cancel?: () => void;
    }
  | { readonly kind: 'ready' };

/** The loaded recording or list of times. */
export interface Workspace {
  readonly name: string;
  readonly recording: Recording;
  /** `null` for a list of times. */
  readonly pyramid: Pyramid | null;
  readonly durationS: number;
  /** Under which its sound is kept in the database, if it is. */
  readonly storedAs: string | null;
}

export const phase = signal<Phase>({ kind: 'empty' });
/** While it listens or reads, nothing else is loaded. */
export const busy = computed(() => !['empty', 'ready'].includes(phase.value.kind));
export const fault = signal<Fault | null>(null);
export const workspace = signal<Workspace | null>(null);

/** One for each drop. */
export const edits = signal<readonly Edits[]>([]);
/** The drop that is looked at. */
export const chosenDrop = signal(0);
export const present = computed<Edits | undefined>(() => edits.value[chosenDrop.value]);
export const marks = computed(() => present.value?.present ?? []);

/** An answer of the engine, and the place of each drop of the workspace in it; -1 without a flight. */
export interface Answer extends Analysed {
  readonly inference: boolean;
  readonly places: readonly number[];
}

export const analysed = signal<Answer | null>(null);
/** Whether the inference still runs. */
export const refining = signal(false);
/** The message of the engine, if it refused the settings. */
export const refusedSettings = signal<string | null>(null);

export const view = signal<Viewport>(whole(1));
export const selected = signal<number | null>(null);
export const cursorS = signal<number | null>(null);

/** The chosen drop, as analysed; and its place among those analysed. */
export const place = computed(() => analysed.value?.places[chosenDrop.value] ?? -1);
export const drop = computed<Drop | undefined>(() => analysed.value?.document.drops[place.value]);
/** What to read of it first. */
export const headline = computed(() => analysed.value?.headlines[place.value]);
/** Its reported quantities, method by method. */
export const quantities = computed<readonly QuantityList[]>(
  () => analysed.value?.quantities[place.value] ?? [],
);
export const edited = computed(() => present.value !== undefined && isEdited(present.value));

/** What comes with a recording. */
export interface Origin {
  /** Under which its sound is kept in the database, if it is. */
  readonly storedAs?: string | null;
  /** The set-up that it was made with; the reader's own if it brings none. */
  readonly setup?: Settings;
  /** What the microphone did to it. */
  readonly processing?: readonly Processing[];
}

/** What the microphone does to the sound that is recorded, or did to that in the workspace. */
export const processing = signal<readonly Processing[]>([]);

/** Puts something in the workspace; what lay there is gone from the page, not from the database. */
export function put(
  name: string,
  recording: Recording,
  { storedAs, setup, ...from }: Origin = {},
): void {
  const { sound } = recording;
  stop();
  batch(() => {
    startFrom(setup ?? null);
    processing.value = from.processing ?? [];
    workspace.value = {
      name,
      recording,
      pyramid: sound && { ...sound, rateHz: sound.sampleRateHz },
      durationS: recording.durationS,
      storedAs: storedAs ?? null,
    };
    // Without a drop there is an empty one, so that impacts can be marked by hand.
    const drops = recording.result.drops.map(({ impacts }) => editsOf(impacts));
    edits.value = drops.length > 0 ? drops : [begin([])];
    analysed.value = null;
    refusedSettings.value = null;
    selected.value = null;
    cursorS.value = null;
    phase.value = { kind: 'ready' };
    lookAt(0);
  });
}

/** Chooses a drop and brings it into sight. */
export function lookAt(index: number): void {
  const durationS = workspace.peek()?.durationS ?? 0;
  chosenDrop.value = index;
  const impacts = edits.peek()[index]?.present ?? [];
  const [first, last] = [impacts[0], impacts.at(-1)];
  view.value = first && last ? framing(first.timeS, last.timeS, durationS) : whole(durationS);
}

/** Nothing is listened to or read any more; what lies in the workspace stays. */
export function idle(): void {
  phase.value = { kind: workspace.peek() ? 'ready' : 'empty' };
}

/** Shows what went wrong; what lies in the workspace stays. */
export function fail(what: Fault): void {
  batch(() => {
    fault.value = what;
    idle();
  });
}
