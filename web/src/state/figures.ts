/** The figure that is looked at, as a chart of the engine. */
import { computed, effect, signal } from '@preact/signals';
import type { Chart, FigureTab } from '../lab/index.ts';
import { request } from './analysing.ts';
import { CoalescingQueue } from './coalescing-queue.ts';
import { engine } from './engine.ts';
import { overlay } from './simulating.ts';
import { analysed, place } from './workspace.ts';

/** The figures that there are of the chosen drop. */
export const figures = computed<readonly FigureTab[]>(
  () => analysed.value?.figures[place.value] ?? [],
);
const chosen = signal('restitution');
/** The figure that was chosen, or the first while the analysis has none of this name. */
export const shown = computed(() =>
  figures.value.some(({ name }) => name === chosen.value)
    ? chosen.value
    : (figures.value[0]?.name ?? ''),
);
/** Shows another one. */
export const show = (name: string): void => {
  chosen.value = name;
};

/** `null` until it is there. */
export const figure = signal<Chart | null>(null);

/** What is asked of the engine to draw the figure of this name. */
export function figureRequest(name: string, inference: boolean) {
  const asked = request();
  return (
    asked && {
      request: { ...asked, inference },
      drop: place.peek(),
      name,
      simulation: overlay.peek(),
    }
  );
}

type Job = NonNullable<ReturnType<typeof figureRequest>>;

const drawer = new CoalescingQueue<Job>(async (job) => {
  try {
    figure.value = await engine().chart(job);
  } catch {
    // Of what just changed; the next analysis asks again.
    figure.value = null;
  }
});

/** From now on the figure follows the analysis, the choice of the reader and the language. */
export function keepDrawn(): void {
  let last = '';
  effect(() => {
    const [answer, name] = [analysed.value, shown.value];
    // Another simulation is another figure.
    void overlay.value;
    const job = answer && name !== '' ? figureRequest(name, answer.inference) : undefined;
    const now = `${place.value} ${name}`;
    if (!job || now !== last) figure.value = null;
    last = now;
    if (job) drawer.ask(job);
  });
}
