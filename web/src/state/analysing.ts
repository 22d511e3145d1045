/** Keeps the analysis in step with the impacts and the settings: at once roughly, soon exactly. */
import { batch, effect } from '@preact/signals';
import { type AnalysisRequest, LabError } from '../lab/index.ts';
import { analysed, edits, workspace, refining, refusedSettings } from './workspace.ts';
import { engine, messageOf } from './engine.ts';
import { CoalescingQueue } from './coalescing-queue.ts';
import { forEngine } from './marks.ts';
import { settings } from './settings.ts';

/** What is asked of the engine now, also for exports. */
export function request(): AnalysisRequest | undefined {
  const loaded = workspace.peek();
  return loaded
    ? engine().request(loaded.recording, settings.peek(), edits.peek().map(forEngine))
    : undefined;
}

/** Asks again as soon as the last rough answer is there, so that a dragged marker never queues up. */
const analyser = new CoalescingQueue<AnalysisRequest>(
  (job) =>
    new Promise<void>((next) => {
      engine()
        .analyse(job, (rough) => {
          // While the inference runs, the words of the last one would be about other impacts.
          if (job === wanted) {
            analysed.value = rough;
            refusedSettings.value = null;
          }
          next();
        })
        .then(
          (exact) => {
            if (job !== wanted) return;
            batch(() => {
              analysed.value = exact;
              refining.value = false;
            });
          },
          (error: unknown) => {
            if (job === wanted && !LabError.isMoot(error)) refuse(error);
          },
        )
        .finally(next);
    }),
);

/** What was asked last; answers to anything else come too late. */
let wanted: AnalysisRequest | undefined;

function refuse(error: unknown): void {
  batch(() => {
    refusedSettings.value = messageOf(error);
    refining.value = false;
  });
}

/** From now on every change is analysed. */
export function keepAnalysed(): void {
  effect(() => {
    const drops = edits.value;
    // A change of settings is a change too.
    void settings.value;
    if (!workspace.peek()) return;
    if (drops.every((drop) => drop.present.length < 2)) {
      wanted = undefined;
      analysed.value = null;
      refining.value = false;
      return;
    }
    wanted = request();
    if (!wanted) return;
    refining.value = true;
    analyser.ask(wanted);
  });
}
