/** Listening: the microphone to the engine, to the disk and to the screen, block by block. */
import { signal } from '@preact/signals';
import type { Gap, Listening, Recording, SoFar } from '../lab/index.ts';
import { keepAwake } from '../sound/awake.ts';
import { LiveEnvelope } from '../sound/live-envelope.ts';
import { type Microphone, MicrophoneError, openMicrophone } from '../sound/microphone.ts';
import { stop } from '../sound/player.ts';
import { joined } from '../store/blocks.ts';
import { newId } from '../store/id.ts';
import { lock } from '../store/locks.ts';
import { RecordingWriter } from '../store/recording-writer.ts';
import { region, text } from '../text/language.ts';
import { engine, faultOf } from './engine.ts';
import { askToLast } from './lasting.ts';
import { hush, tellAnswer, vibrate } from './telling.ts';
import { busy, fail, fault, type Origin, phase, processing, put } from './workspace.ts';

/** What runs by while listening. */
export const live = signal<LiveEnvelope | null>(null);
/** Loudness now, 0 to 1. */
export const level = signal(0);
export const soFar = signal<SoFar | null>(null);
/** Seconds of sound that are on the disk. */
export const savedS = signal(0);

/** What helps when no drop is heard; `null` as long as nothing is to be said. */
export const hint = signal<'quiet' | 'no-bounces' | null>(null);

/** Seconds without a drop before the page says what helps. */
const HINT_AFTER_S = 6;
/** So many times louder than what came before, a block is a sound. */
const STANDS_OUT = 4;
/** Sounds that are no bounces, before the page says so: a ball begins with fewer. */
const MANY_SOUNDS = 3;

/** Seconds of silence before the page says so. */
const SILENT_AFTER_S = 2;
/** Listening ends by itself after this time: no drop lasts as long. */
const LONGEST_S = 1800;
const SHOWN_S = 6;
const BINS_PER_SECOND = 200;
/** Softer than this shows as nothing. */
const SOFTEST_DB = -60;

/** Who gets a recording when it ends. */
type Taker = (name: string, recording: Recording, origin: Origin) => void | Promise<void>;

/** A recording that goes on. */
interface LiveRecording {
  readonly taker: Taker;
  readonly microphone: Microphone;
  readonly listening: Listening;
  readonly writer: RecordingWriter;
  /** Lets the screen go dark again. */
  readonly rest: () => void;
  /** What the engine has not received yet, because it still works on what came before. */
  waiting: Float32Array<ArrayBuffer>[];
  /** Where sound was lost in what is waiting. */
  gaps: Gap[];
  asking: boolean;
  recordedS: number;
  hasSound: boolean;
  /** The level that is usual here, and how many sounds stood out from it. */
  usual: number;
  sounds: number;
}

let current: LiveRecording | undefined;

export async function listen(taker: Taker = put): Promise<void> {
  if (busy.peek()) return;
  // The microphone would record it.
  stop();
  hush();
  fault.value = null;
  phase.value = { kind: 'starting' };
  // What comes before the engine is ready is not lost.
  const early: ((now: LiveRecording) => void)[] = [];
  const take = (work: (now: LiveRecording) => void): void => {
    if (current) work(current);
    else early.push(work);
  };
  let microphone: Microphone | undefined;
  try {
    microphone = await openMicrophone({
      block: (samples) => take((now) => receive(now, samples)),
      missing: (frames) => take((now) => lose(now, frames)),
      lost: () => {
        fault.value = { key: 'ended' };
        void stopListening();
      },
      muted: (isMuted) => {
        if (isMuted) fault.value = { key: 'silent' };
        else noteSound();
      },
    });
    current = await begin(microphone, taker);
    processing.value = microphone.processing;
    for (const work of early) work(current);
    phase.value = { kind: 'listening' };
  } catch (error) {
    await microphone?.close();
    fail(error instanceof MicrophoneError ? { key: error.fault } : faultOf(error));
  }
}

async function begin(microphone: Microphone, taker: Taker): Promise<LiveRecording> {
  const { rateHz } = microphone;
  const startedAt = Date.now();
  const date = new Date(startedAt).toLocaleString(region.peek());
  const recording = {
    id: newId(),
    name: text('page-lab-recording-name', { date }),
    rateHz,
    startedAt,
    finished: false,
  };
  const listening = await engine().listen(rateHz);
  soFar.value = null;
  hint.value = null;
  live.value = new LiveEnvelope(rateHz, SHOWN_S, BINS_PER_SECOND);
  lock(recording.id);
  savedS.value = 0;
  const writer = new RecordingWriter(recording, {
    fault: (problem) => {
      fault.value = { key: problem };
    },
    saved: (samples) => {
      savedS.value += samples / rateHz;
    },
  });
  void askToLast();
  return {
    taker,
    microphone,
    listening,
    writer,
    rest: keepAwake(),
    waiting: [],
    gaps: [],
    asking: false,
    recordedS: 0,
    hasSound: false,
    usual: 0,
    sounds: 0,
  };
}

function receive(now: LiveRecording, samples: Float32Array<ArrayBuffer>): void {
  now.writer.add(samples);
  const peak = live.peek()?.add(samples) ?? 0;
  // Decibels, because levels span a thousandfold.
  level.value = Math.min(1, Math.max(0, 1 - (20 * Math.log10(Math.max(peak, 1e-9))) / SOFTEST_DB));
  now.recordedS += samples.length / now.microphone.rateHz;
  noteSilence(now, peak);
  noteHint(now, peak);
  now.waiting.push(samples);
  if (!now.asking) void ask(now);
  if (now.recordedS > LONGEST_S) void stopListening();
}

/** Puts silence in the place of sound that the browser did not deliver, so that all later times hold. */
function lose(now: LiveRecording, frames: number): void {
  const duration_s = frames / now.microphone.rateHz;
  if (now.recordedS + duration_s > LONGEST_S) return void stopListening();
  const gap = { start_s: now.recordedS, duration_s, certain: true };
  now.gaps.push(gap);
  now.writer.lose(gap);
  receive(now, new Float32Array(frames));
}

/**
 * Sends the engine what has come since the last request, and shows what it answers. However slow the
 * machine, it never falls behind by more than one request.
 */
async function ask(now: LiveRecording): Promise<void> {
  now.asking = true;
  while (current === now && now.waiting.length > 0) {
    // If the engine fails, the samples are kept, and it is asked again when the recording ends.
    const answer = await send(now).catch(() => undefined);
    if (current !== now || !answer) continue;
    soFar.value = answer;
    if (answer.at_rest) void stopListening(true);
  }
  now.asking = false;
}

function send(now: LiveRecording): Promise<SoFar> {
  const [samples, gaps] = [joined(now.waiting), now.gaps];
  now.waiting = [];
  now.gaps = [];
  return now.listening.push(samples, gaps);
}

function noteSilence(now: LiveRecording, peak: number): void {
  if (now.hasSound) return;
  now.hasSound = peak > 0;
  if (now.hasSound) noteSound();
  else if (now.recordedS > SILENT_AFTER_S) fault.value ??= { key: 'silent' };
}

/** Says what helps when a ball should have been heard by now. */
function noteHint(now: LiveRecording, peak: number): void {
  if (now.usual > 0 && peak > STANDS_OUT * now.usual) now.sounds += 1;
  now.usual += 0.1 * (peak - now.usual);
  const isLate = now.recordedS > HINT_AFTER_S && !soFar.peek()?.drop;
  hint.value = isLate ? (now.sounds < MANY_SOUNDS ? 'quiet' : 'no-bounces') : null;
}

function noteSound(): void {
  if (fault.peek()?.key === 'silent') fault.value = null;
}

/** Ends the recording: by hand, or because the ball rests. */
export async function stopListening(atRest = false): Promise<void> {
  const ended = current;
  if (!ended) return;
  current = undefined;
  if (atRest) vibrate();
  const { writer, listening, microphone, rest, taker } = ended;
  const { name, id } = writer.recording;
  level.value = 0;
  rest();
  phase.value = { kind: 'reading', name };
  await microphone.close();
  void send(ended).catch(() => undefined);
  const stored = await writer.finish();
  try {
    const storedAs = stored ? id : null;
    const recording = await finished(listening, name);
    await taker(name, recording, { storedAs, processing: microphone.processing });
    if (atRest && taker === put) tellAnswer();
    await writer.close();
  } catch (error) {
    // Not closed: the recording is offered again when the page is loaded the next time.
    fail(faultOf(error));
  }
  live.value = null;
}

/** Ends the recording; if the engine failed, all samples are processed once more. */
async function finished(listening: Listening, name: string) {
  try {
    return await listening.finish(name);
  } catch {
    const { sampleRateHz, gaps } = listening;
    const known = { format: 'microphone', gaps };
    return engine().detect([listening.samples()], sampleRateHz, name, known);
  }
}
