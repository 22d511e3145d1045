/** Keeps the analysis in step with the impacts and the settings: at once quickly, soon in full. */
import { batch, effect } from '@preact/signals';
import { type Analysed, type AnalysisRequest, type DropMarks, LabError } from '../lab/index.ts';
import { messages } from '../text/language.ts';
import { CoalescingQueue } from './coalescing-queue.ts';
import { engine, messageOf } from './engine.ts';
import { forEngine } from './marks.ts';
import { settings } from './settings.ts';
import { analysed, edits, refining, refusedSettings, workspace } from './workspace.ts';

/** What is asked of the engine now, also for exports: drops without a flight say nothing. */
export function request(): AnalysisRequest | undefined {
  const loaded = workspace.peek();
  if (!loaded) return undefined;
  const { recording } = loaded;
  const detected = recording.result.drops;
  const drops = edits
    .peek()
    .map((drop, index) => forEngine(drop, detected[index]?.probability ?? 1))
    .filter(hasFlight);
  return engine().request(recording, settings.peek(), drops);
}

const hasFlight = ({ impacts }: DropMarks): boolean => impacts.length > 1;

interface Job {
  readonly request: AnalysisRequest;
  readonly places: readonly number[];
}

/** Asks again as soon as the last quick answer is there, so that a dragged marker never queues up. */
const analyser = new CoalescingQueue<Job>(
  (job) =>
    new Promise<void>((next) => {
      const show = (answer: Analysed, inference: boolean): void => {
        // While the inference runs, the words of the last one would be about other impacts.
        if (job !== wanted) return;
        batch(() => {
          analysed.value = { ...answer, inference, places: job.places };
          refusedSettings.value = null;
          refining.value = !inference;
        });
      };
      engine()
        .analyse(job.request, (quick) => {
          show(quick, false);
          next();
        })
        .then(
          (full) => show(full, true),
          (error: unknown) => {
            if (job === wanted && !LabError.isMoot(error)) refuse(error);
          },
        )
        .finally(next);
    }),
);

/** What was asked last; answers to anything else come too late. */
let wanted: Job | undefined;

function refuse(error: unknown): void {
  batch(() => {
    refusedSettings.value = messageOf(error);
    refining.value = false;
  });
}

/** From now on every change is analysed; a change of settings or language is one too. */
export function keepAnalysed(): void {
  effect(() => {
    const drops = edits.value;
    void [settings.value, messages.value];
    const asked = request();
    if (!asked) return;
    let count = 0;
    const places = drops.map(({ present }) => (present.length > 1 ? count++ : -1));
    wanted = { request: asked, places };
    refining.value = count > 0;
    analyser.ask(wanted);
  });
}
