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
export function useAnswer<T>(ask: () => Promise<T>, of: unknown): T | undefined {
  const [answer, setAnswer] = useState<T>();
  const question = JSON.stringify(of);
  const { code } = messages.value;
  useEffect(() => {
    let current = true;
    ask().then(
      (found) => {
        if (current) setAnswer(found);
      },
      () => undefined,
    );
    return () => {
      current = false;
    };
  }, [question, code]);
  return answer;
}
