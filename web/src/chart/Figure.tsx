import { useEffect, useState } from 'preact/hooks';
import type { Chart as Description } from '../lab/index.ts';
import { messages } from '../text/language.ts';
import { Chart } from './Chart.tsx';
import { NumbersOf } from './NumbersOf.tsx';

interface FigureProps {
  readonly chart: Description | undefined;
  /** What to see in it, where the page knows better than the chart. */
  readonly see?: string;
  readonly numbers?: boolean;
}

/** A chart with its sentence; its height is kept free until it is there. */
export function Figure({ chart, see, numbers = false }: FigureProps) {
  return (
    <figure class="figure-box">
      <figcaption>{see ?? chart?.caption}</figcaption>
      {chart ? <Chart chart={chart} /> : <div class="chart waiting" />}
      {numbers && chart && <NumbersOf chart={chart} />}
    </figure>
  );
}

/** What the engine gives for a question, again for each language; the last answer stays until the next. */
export const useAnswer = <T,>(ask: () => Promise<T>, of: unknown): T | undefined =>
  useLatest(ask, of).answer;

/** The same, and whether it is the answer to this question. */
export function useLatest<T>(
  ask: () => Promise<T>,
  of: unknown,
): { readonly answer: T | undefined; readonly isCurrent: boolean } {
  const { code } = messages.value;
  const question = JSON.stringify([of, code]);
  const [{ answer, answered }, setAnswer] = useState<{ answer?: T; answered?: string }>({});
  useEffect(() => {
    let current = true;
    ask().then(
      (found) => {
        if (current) setAnswer({ answer: found, answered: question });
      },
      () => undefined,
    );
    return () => {
      current = false;
    };
  }, [question]);
  return { answer, isCurrent: answered === question };
}
