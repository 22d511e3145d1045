/** Ways into the workspace other than the microphone: a file, a list of times, the demo, the database. */
import { LabError, type LinkedDrop, type Recording } from '../lab/index.ts';
import { joined } from '../store/blocks.ts';
import { lock } from '../store/locks.ts';
import { getRecording, samplesOf } from '../store/recordings.ts';
import { text } from '../text/language.ts';
import { engine, faultOf } from './engine.ts';
import { stateBall } from './settings.ts';
import { busy, fail, fault, phase, put } from './workspace.ts';

/** While something else is recorded or read, nothing is opened: the page offers it then nowhere. */
async function load(
  name: string,
  open: () => Promise<Recording>,
  storedAs: string | null = null,
): Promise<void> {
  if (busy.peek()) return;
  fault.value = null;
  phase.value = { kind: 'reading', name };
  try {
    put(name, await open(), storedAs);
  } catch (error) {
    fail({ ...faultOf(error), about: name });
  }
}

export function openFile(file: File): Promise<void> {
  return load(file.name, async () => {
    if (file.size === 0) {
      throw new LabError('empty', `${file.name} has no content`, {
        reason: { code: 'empty', what: 'content' },
      });
    }
    return engine().open(file, {
      onProgress: (share) => {
        if (phase.peek().kind === 'reading') {
          phase.value = { kind: 'reading', name: file.name, share };
        }
      },
    });
  });
}

export const openTimes = (times: string): Promise<void> =>
  load(text('page-lab-pasted-name'), () => engine().paste(times));

/** The drop of a link, which has times and no sound. */
export const openLinked = ({ name, times_s }: LinkedDrop): Promise<void> =>
  load(name, () => engine().paste(times_s.join('\n')));

/** The ball that is heard in the demo. */
const DEMO_BALL = 'table-tennis-40';

export function openDemo(): Promise<void> {
  const name = text('page-lab-demo-name');
  return load(name, async () => {
    const { recording } = await engine().demo(name);
    stateBall(DEMO_BALL);
    return recording;
  });
}

/** Samples that were made. */
export function openSamples(samples: Float32Array, rateHz: number, name: string): Promise<void> {
  return load(name, () => engine().detect([samples], rateHz, name));
}

/** A recording of the database. */
export async function openStored(id: string): Promise<void> {
  lock(id);
  const stored = await getRecording(id);
  if (!stored) return fail({ key: 'damaged' });
  const { name, rateHz, gaps } = stored;
  const samples = joined(await samplesOf(id));
  return load(name, () => engine().detect([samples], rateHz, name, 'samples', gaps), id);
}
