/** Listening: the microphone to the engine, to the disk and to the eye, block by block. */
import { signal } from '@preact/signals';
import type { Listening, SoFar } from '../lab/index.ts';
import { keepAwake } from '../sound/awake.ts';
import { LiveEnvelope } from '../sound/live-envelope.ts';
import { type Microphone, MicrophoneError, openMicrophone } from '../sound/microphone.ts';
import { stop } from '../sound/player.ts';
import { joined } from '../store/blocks.ts';
import { lock } from '../store/locks.ts';
import { newId } from '../store/id.ts';
import { RecordingWriter } from '../store/recording-writer.ts';
import { region, texts } from '../text/language.ts';
import { busy, fail, fault, phase, put } from './workspace.ts';
import { engine, faultOf } from './engine.ts';

/** What runs by while listening. */
export const live = signal<LiveEnvelope | null>(null);
/** Loudness now, 0 to 1. */
export const level = signal(0);
export const soFar = signal<SoFar | null>(null);

/** Seconds of silence before the reader is told. */
const SILENT_AFTER_S = 2;
/** Nobody drops a ball for so long; then it ends by itself too. */
const LONGEST_S = 1800;
const SHOWN_S = 6;
const BINS_PER_SECOND = 200;
/** Softer than this shows as nothing. */
const SOFTEST_DB = -60;

/** A recording that goes on. */
interface Take {
  readonly microphone: Microphone;
  readonly ear: Listening;
  readonly keeper: RecordingWriter;
  /** Lets the screen go dark again. */
  readonly rest: () => void;
  /** What the engine has not been given yet, because it still thinks about what came before. */
  waiting: Float32Array<ArrayBuffer>[];
  asking: boolean;
  heardS: number;
  heardAnything: boolean;
}

let take: Take | undefined;

export async function listen(): Promise<void> {
  if (busy.peek()) return;
  // It would hear itself.
  stop();
  fault.value = null;
  phase.value = { kind: 'starting' };
  // What comes before the engine is ready is not lost.
  const early: Float32Array<ArrayBuffer>[] = [];
  let microphone: Microphone | undefined;
  try {
    microphone = await openMicrophone({
      block: (samples) => {
        if (take) hear(take, samples);
        else early.push(samples);
      },
      lost: () => {
        fault.value = { key: 'ended' };
        void stopListening();
      },
      muted: (isMuted) => {
        if (isMuted) fault.value = { key: 'silent' };
        else tellOfSound();
      },
    });
    take = await begin(microphone);
    for (const samples of early) hear(take, samples);
    phase.value = { kind: 'listening' };
  } catch (error) {
    await microphone?.close();
    fail(error instanceof MicrophoneError ? { key: error.fault } : faultOf(error));
  }
}

async function begin(microphone: Microphone): Promise<Take> {
  const { rateHz } = microphone;
  const startedAt = Date.now();
  const date = new Date(startedAt).toLocaleString(region.peek());
  const recording = {
    id: newId(),
    name: texts.peek().lab.recordingName(date),
    rateHz,
    startedAt,
    finished: false,
  };
  const ear = await engine().listen(rateHz);
  soFar.value = null;
  live.value = new LiveEnvelope(rateHz, SHOWN_S, BINS_PER_SECOND);
  lock(recording.id);
  const keeper = new RecordingWriter(recording, (problem) => {
    fault.value = { key: problem };
  });
  return {
    microphone,
    ear,
    keeper,
    rest: keepAwake(),
    waiting: [],
    asking: false,
    heardS: 0,
    heardAnything: false,
  };
}

function hear(now: Take, samples: Float32Array<ArrayBuffer>): void {
  now.keeper.add(samples);
  const peak = live.peek()?.add(samples) ?? 0;
  // Decibels, because ears and impacts span a thousandfold.
  level.value = Math.min(1, Math.max(0, 1 - (20 * Math.log10(Math.max(peak, 1e-9))) / SOFTEST_DB));
  now.heardS += samples.length / now.microphone.rateHz;
  tellOfSilence(now, peak);
  now.waiting.push(samples);
  if (!now.asking) void ask(now);
  if (now.heardS > LONGEST_S) void stopListening();
}

/**
 * Gives the engine what has come since the last question, and shows what it says. However slow the
 * machine, it never falls behind by more than one question.
 */
async function ask(now: Take): Promise<void> {
  now.asking = true;
  while (take === now && now.waiting.length > 0) {
    // Should the engine stumble, the samples are kept, and it is asked again when the recording ends.
    const said = await give(now).catch(() => undefined);
    if (take !== now || !said) continue;
    soFar.value = said;
    if (said.at_rest) void stopListening();
  }
  now.asking = false;
}

function give(now: Take): Promise<SoFar> {
  const samples = joined(now.waiting);
  now.waiting = [];
  return now.ear.push(samples);
}

function tellOfSilence(now: Take, peak: number): void {
  if (now.heardAnything) return;
  now.heardAnything = peak > 0;
  if (now.heardAnything) tellOfSound();
  else if (now.heardS > SILENT_AFTER_S) fault.value ??= { key: 'silent' };
}

function tellOfSound(): void {
  if (fault.peek()?.key === 'silent') fault.value = null;
}

export async function stopListening(): Promise<void> {
  const ended = take;
  if (!ended) return;
  take = undefined;
  const { keeper, ear, microphone, rest } = ended;
  const { name, id } = keeper.recording;
  level.value = 0;
  rest();
  phase.value = { kind: 'reading', name };
  await microphone.close();
  void give(ended).catch(() => undefined);
  const stored = await keeper.finish();
  try {
    put(name, await finished(ear, name), stored ? id : null);
    await keeper.close();
  } catch (error) {
    // Not closed: the recording is offered again when the page is loaded the next time.
    fail(faultOf(error));
  }
  live.value = null;
}

/** Ends the listening; should the engine have stumbled, it hears all of it once more. */
async function finished(ear: Listening, name: string) {
  try {
    return await ear.finish(name);
  } catch {
    return engine().hear([ear.samples()], ear.sampleRateHz, name, 'microphone');
  }
}
