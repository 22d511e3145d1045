/** Ways into the workspace other than the microphone: a file, a list of times, the demo, the database. */
import { signal } from '@preact/signals';
import { LabError, type LinkedDrop, type Recording, type Settings } from '../lab/index.ts';
import { joined } from '../store/blocks.ts';
import { lock } from '../store/locks.ts';
import { getRecording, samplesOf } from '../store/recordings.ts';
import { text } from '../text/language.ts';
import { engine, faultOf } from './engine.ts';
import { busy, fail, fault, type Origin, phase, put } from './workspace.ts';

/** While something else is recorded or read, nothing is opened: the page offers it then nowhere. */
async function load(
  name: string,
  open: () => Promise<Recording>,
  origin: Origin = {},
): Promise<void> {
  if (busy.peek()) return;
  fault.value = null;
  phase.value = { kind: 'reading', name };
  try {
    put(name, await open(), origin);
  } catch (error) {
    fail({ ...faultOf(error), about: name });
  }
}

/** A file of samples whose rate has to be stated. */
export const withoutRate = signal<File | null>(null);

/** Opens a file; `rateHz` is that of samples whose file does not state it. */
export async function openFile(file: File, rateHz?: number): Promise<void> {
  if (busy.peek()) return;
  withoutRate.value = null;
  await load(file.name, async () => {
    if (file.size === 0) {
      throw new LabError('empty', `${file.name} has no content`, {
        reason: { code: 'empty', what: 'content' },
      });
    }
    return engine().open(file, {
      rateHz,
      onProgress: (share) => {
        if (phase.peek().kind === 'reading') {
          phase.value = { kind: 'reading', name: file.name, share };
        }
      },
    });
  });
  const reason = fault.peek()?.reason;
  if (reason?.code === 'times' && reason.problem.code === 'no-rate') {
    fault.value = { key: 'rate', about: file.name };
    withoutRate.value = file;
  }
}

export const openTimes = (times: string): Promise<void> =>
  load(text('page-lab-pasted-name'), () => engine().paste(times));

/** A drop that has times and no sound, with the set-up that it was made with. */
export const openLinked = ({
  name,
  times_s,
  settings,
}: Omit<LinkedDrop, 'surface'>): Promise<void> =>
  load(name, () => engine().paste(times_s.join('\n')), { setup: settings });

/** The ball that is heard in the demo. */
const DEMO: Settings = { ball: { kind: 'table-tennis-40' } };

export function openDemo(): Promise<void> {
  const name = text('page-lab-demo-name');
  return load(name, async () => (await engine().demo(name)).recording, { setup: DEMO });
}

/** Samples that were made, of what is known. */
export function openSamples(
  samples: Float32Array<ArrayBuffer>,
  rateHz: number,
  name: string,
  setup: Settings,
): Promise<void> {
  return load(name, () => engine().detect([samples], rateHz, name), { setup });
}

/** A recording of the database, with the set-up of the drop that was kept of it, if one was. */
export async function openStored(id: string, setup?: Settings): Promise<void> {
  lock(id);
  const stored = await getRecording(id);
  if (!stored) return fail({ key: 'damaged' });
  const { name, rateHz, gaps } = stored;
  const samples = joined(await samplesOf(id));
  const open = () => engine().detect([samples], rateHz, name, 'samples', gaps);
  return load(name, open, { storedAs: id, ...(setup && { setup }) });
}
