/** Ways into the workspace other than the microphone: a file, a list of times, the demo, the database. */
import { signal } from '@preact/signals';
import { LabError, type LinkedDrop, type Recording, type Settings } from '../lab/index.ts';
import { joined } from '../store/blocks.ts';
import { lock } from '../store/locks.ts';
import { getRecording, samplesOf } from '../store/recordings.ts';
import { text } from '../text/language.ts';
import { engine, faultOf } from './engine.ts';
import { endInVain, type Reader, reading } from './reading.ts';
import { busy, fail, fault, type Origin, put } from './workspace.ts';

/**
 * Puts what is read in the workspace; false if that failed, or was cancelled. While something else is recorded or
 * read, nothing is opened: the page offers it then nowhere.
 */
async function load(
  name: string,
  open: (reader: Reader) => Promise<Recording>,
  origin: Origin = {},
): Promise<boolean> {
  if (busy.peek()) return false;
  fault.value = null;
  try {
    put(name, await reading(name, open), origin);
    return true;
  } catch (error) {
    endInVain(error, { ...faultOf(error), about: name });
    return false;
  }
}

/** A file of samples whose rate has to be stated. */
export const withoutRate = signal<File | null>(null);

/** Opens a file; `rateHz` is that of samples whose file does not state it. */
export async function openFile(file: File, rateHz?: number): Promise<void> {
  if (busy.peek()) return;
  withoutRate.value = null;
  await load(file.name, async (reader) => {
    if (file.size === 0) {
      throw new LabError('empty', `${file.name} has no content`, {
        reason: { code: 'empty', what: 'content' },
      });
    }
    return engine().open(file, { rateHz, ...reader });
  });
  const reason = fault.peek()?.reason;
  if (reason?.code === 'times' && reason.problem.code === 'no-rate') {
    fault.value = { key: 'rate', about: file.name };
    withoutRate.value = file;
  }
}

export const openTimes = (times: string): Promise<boolean> =>
  load(text('page-lab-pasted-name'), (reader) => engine().paste(times, reader));

/** A drop that has times and no sound, with the set-up that it was made with. */
export const openLinked = ({
  name,
  times_s,
  settings,
}: Omit<LinkedDrop, 'surface'>): Promise<boolean> =>
  load(name, (reader) => engine().paste(times_s.join('\n'), reader), { setup: settings });

/** The ball that is heard in the demo. */
const DEMO: Settings = { ball: { kind: 'table-tennis-40' } };

export function openDemo(): Promise<boolean> {
  const name = text('page-lab-demo-name');
  const open = async (reader: Reader) => (await engine().demo(name, reader)).recording;
  return load(name, open, { setup: DEMO });
}

/** Samples that were made, of what is known. */
export function openSamples(
  samples: Float32Array<ArrayBuffer>,
  rateHz: number,
  name: string,
  setup: Settings,
): Promise<boolean> {
  return load(name, (reader) => engine().detect([samples], rateHz, name, reader), { setup });
}

/** A recording of the database, with the set-up of the drop that was kept of it, if one was; whether it is open. */
export async function openStored(id: string, setup?: Settings): Promise<boolean> {
  lock(id);
  const stored = await getRecording(id);
  if (!stored) {
    fail({ key: 'damaged' });
    return false;
  }
  const { name, rateHz, gaps = [] } = stored;
  const open = async (reader: Reader) =>
    engine().detect([joined(await samplesOf(id))], rateHz, name, { gaps, ...reader });
  return load(name, open, { storedAs: id, ...(setup && { setup }) });
}
