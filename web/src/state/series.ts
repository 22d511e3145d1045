/** Test series: jobs of the program, which this browser keeps. What a job is, the engine knows. */
import { signal } from '@preact/signals';
import {
  type JobChange,
  type JobShown,
  LabError,
  type NewJob,
  type Recording,
  type Settings,
} from '../lab/index.ts';
import { zip } from '../store/archive.ts';
import { joined } from '../store/blocks.ts';
import { isFull } from '../store/database.ts';
import { newId } from '../store/id.ts';
import { allJobs, deleteJob, getJob, jobSound, type StoredJob, writeJob } from '../store/jobs.ts';
import { deleteRecording, type StoredRecording, samplesOf } from '../store/recordings.ts';
import { text } from '../text/language.ts';
import { engine, faultOf } from './engine.ts';
import type { Fault } from './faults.ts';
import { askToLast } from './lasting.ts';
import { listen } from './listening.ts';
import { forget } from './orphans.ts';
import { endInVain, reading } from './reading.ts';
import { busy, fault, idle, type Origin, phase } from './workspace.ts';

/** A job that is open: as it is kept, and as the engine shows it. */
interface OpenJob {
  readonly stored: StoredJob;
  readonly shown: JobShown;
}

export const jobs = signal<readonly StoredJob[]>([]);
export const open = signal<OpenJob | null>(null);
/** A recording that could not be kept: it is in memory until this page closes. */
export const unkept = signal<File | null>(null);
/** Who drops the ball; the operator of the notes if empty. */
export const operator = signal('');

export async function loadJobs(): Promise<void> {
  await guarded(async () => {
    jobs.value = await allJobs();
  });
}

/** Makes a job, with the check of the method, and opens it. */
export async function begin(request: NewJob): Promise<void> {
  await working(request.name, async () => {
    const files = await engine().newJob(request);
    const check = await engine().methodCheck(today());
    const id = newId();
    const stored = { id, name: request.name, title: '', files, revision: 0, changedAt: 0 };
    await write(stored, { change: 'checked', check });
    void askToLast();
  });
}

/** Opens a job as it was left, and in the language of now. */
export async function openJob(id: string): Promise<void> {
  await working('', async () => {
    const stored = await getJob(id);
    if (!stored) return void (await loadJobs());
    open.value = { stored, shown: await engine().job(stored.files) };
    await compute();
  });
}

export function closeJob(): void {
  open.value = null;
  unkept.value = null;
  fault.value = null;
  void loadJobs();
}

export async function removeJob(id: string): Promise<void> {
  await guarded(() => deleteJob(id));
  await loadJobs();
}

/** Counts recordings in the next places. */
export async function addFiles(files: readonly File[]): Promise<void> {
  for (const file of files) {
    if (!(await working(file.name, () => count(file, file.name)))) return;
  }
}

/** Records a drop, and counts it when the ball rests. */
export const recordDrop = (): Promise<void> => listen(take);

/** Tries once more to keep what could not be kept. */
export async function keepAgain(): Promise<void> {
  const file = unkept.peek();
  if (file) await working(file.name, () => count(file, file.name));
}

/** Counts a recording that was interrupted. */
export async function countInterrupted({ id, name, rateHz, gaps }: StoredRecording): Promise<void> {
  await working(name, async () => {
    const wav = await engine().wav([joined(await samplesOf(id))], rateHz, gaps);
    await count(new File([wav], 'drop.wav'), text('page-series-interrupted'));
    forget(id);
    await deleteRecording(id);
  });
}

/** A recording counts no more; its sound stays. */
export async function repeat(number: number, reason: string): Promise<void> {
  await changed({ change: 'repeated', number, reason });
}

/** States parts of the notes, what was kept, and the settings of all drops; true if that is kept. */
export function state(
  fields: Readonly<Record<string, string>>,
  kept: readonly string[],
  settings: Settings,
): Promise<boolean> {
  return changed({ change: 'stated', fields, kept: [...kept], settings });
}

/** The report as HTML, with a check of the method of now. */
export async function reportOf({ shown }: OpenJob, isOnePage: boolean): Promise<string> {
  return engine().jobReport(shown.files, await engine().methodCheck(today()), isOnePage);
}

/** The folder of the job as a ZIP, for the program. */
export function zipOf({ stored, shown }: OpenJob, folder: string): Promise<Blob> {
  const { notes, journal } = stored.files;
  const sounds = shown.recordings.map(
    ({ file }) => [`${folder}/${file}`, () => jobSound(stored.id, file)] as const,
  );
  return zip([
    [`${folder}/job.toml`, async () => new Blob([notes])],
    [`${folder}/journal.jsonl`, async () => new Blob([journal])],
    ...sounds,
  ]);
}

/** What was listened to, as it is kept in a job. */
async function take(name: string, recording: Recording, { storedAs }: Origin): Promise<void> {
  await working(name, async () => {
    const wav = await recording.wav();
    if (!wav) return;
    await count(new File([wav], 'drop.wav'), text('page-series-microphone'));
    // The job has it now.
    if (storedAs) await deleteRecording(storedAs);
  });
}

/** Keeps a recording and counts it: both, or neither. */
async function count(file: File, givenAs: string): Promise<void> {
  const job = open.peek();
  if (!job) return;
  // As a file, also what was recorded: so the program finds the same in it.
  const rebounds = await reboundsIn(job.shown, file);
  const sha256 = await engine().sha256(file);
  const change: JobChange = {
    change: 'added',
    sha256,
    ending: endingOf(file.name),
    given_as: givenAs,
    operator: operator.peek(),
    added: stamp(new Date()),
    rebounds,
  };
  unkept.value = file;
  await write(job.stored, change, file);
  unkept.value = null;
}

async function reboundsIn({ rule, settings }: JobShown, file: File): Promise<unknown[]> {
  const { name, result } = await reading(file.name, (reader) => engine().open(file, reader));
  if (result.drops.length === 0) throw new NoDrop();
  const drops = result.drops.map(({ impacts, probability }) => ({
    impacts,
    probability,
    edited: false,
  }));
  return engine().rebounds({ rule, settings, place: { name, source: result.source, drops } });
}

/** Computes the rebounds that other settings, or another version of the page, ask for anew. */
async function compute(): Promise<void> {
  for (const { number, file } of open.peek()?.shown.recordings ?? []) {
    const job = open.peek();
    const asked = job?.shown.recordings.find((recording) => recording.number === number);
    if (!job || !asked?.counts || asked.is_known) continue;
    const sound = new File([await jobSound(job.stored.id, file)], file);
    const rebounds = await reboundsIn(job.shown, sound);
    await write(job.stored, { change: 'computed', number, rebounds });
  }
}

async function changed(change: JobChange): Promise<boolean> {
  const job = open.peek();
  if (!job) return false;
  return working(job.shown.name, async () => {
    await write(job.stored, change);
    await compute();
  });
}

/** Changes a job on the disk, then on the page. What another window has changed meanwhile stays. */
async function write(job: StoredJob, change: JobChange, content?: Blob): Promise<void> {
  const shown = await engine().job(job.files, change);
  const { files, name, title } = shown;
  const file = shown.recordings.at(-1)?.file;
  const sound = content && file !== undefined ? { file, content } : undefined;
  const stored = await writeJob({ ...job, files, name, title }, sound);
  if (stored) {
    open.value = { stored, shown };
    return;
  }
  const newer = await getJob(job.id);
  if (!newer) throw new Error('the test series was deleted in another window');
  return write(newer, change, content);
}

class NoDrop extends Error {}

/** One thing at a time; true if it was done. What fails is said, and what was kept stays. */
async function working(name: string, work: () => Promise<void>): Promise<boolean> {
  // The recording that has just ended is what is worked on.
  if (busy.peek() && phase.peek().kind !== 'reading') return false;
  phase.value = { kind: 'reading', name };
  const isDone = await guarded(work);
  if (isDone) idle();
  return isDone;
}

async function guarded(work: () => Promise<void>): Promise<boolean> {
  fault.value = null;
  try {
    await work();
    return true;
  } catch (error) {
    endInVain(error, seriesFault(error));
    return false;
  }
}

function seriesFault(error: unknown): Fault {
  if (error instanceof NoDrop) return { key: 'no-drop' };
  if (isFull(error)) return { key: 'series-full' };
  if (error instanceof DOMException) return { key: 'series-storage', detail: error.message };
  const isKnown = error instanceof LabError && error.reason?.code === 'counted';
  if (isKnown) unkept.value = null;
  return isKnown ? { ...faultOf(error), key: 'series-known' } : faultOf(error);
}

const endingOf = (name: string): string => /\.([A-Za-z0-9]{1,5})$/.exec(name)?.[1] ?? 'wav';

/** Date and time here, as the program writes them. */
export function stamp(now: Date): string {
  const two = (number: number): string => String(Math.floor(Math.abs(number))).padStart(2, '0');
  const [aheadMin, day] = [-now.getTimezoneOffset(), dayOf(now)];
  const time = [now.getHours(), now.getMinutes(), now.getSeconds()].map(two).join(':');
  return `${day} ${time} ${aheadMin < 0 ? '-' : '+'}${two(aheadMin / 60)}${two(aheadMin % 60)}`;
}

function dayOf(now: Date): string {
  const parts = [now.getFullYear(), now.getMonth() + 1, now.getDate()];
  return parts.map((part) => String(part).padStart(2, '0')).join('-');
}

const today = (): string => dayOf(new Date());
