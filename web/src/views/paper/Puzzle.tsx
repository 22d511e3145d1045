import { useMemo, useState } from 'preact/hooks';
import { Paragraphs } from '../../app/Paragraphs.tsx';
import { Rich } from '../../app/Rich.tsx';
import { Slider } from '../../app/Slider.tsx';
import { Chart } from '../../chart/Chart.tsx';
import type { ChartSpec } from '../../chart/spec.ts';
import { CENTIMETRE, fixed, plain } from '../../format/quantity.ts';
import { language, texts } from '../../text/language.ts';
import { flightTimes, HEIGHT_M, lineThrough, PRINTED, requestOf, solvedFor } from './experiment.ts';
import { useSimulation } from './simulation.ts';

/** What the reader chooses: the truth, and how it is looked at. */
interface Choice {
  readonly restitution: number;
  readonly slope: number;
  readonly flights: number;
}

const MOST_FLIGHTS = 40;
/** What a bounce loses for each m/s when ten flights reproduce the paper (`bouncelab paper`). */
const SOLVING_SLOPE = 0.02374;

/** The puzzle as a toy: make a drop with air, lay the paper's line through it, compare. */
export function Puzzle() {
  const words = texts.value.paper.four;
  const spoken = language.value;
  const [choice, setChoice] = useState<Choice>({ restitution: 0.935, slope: 0, flights: 10 });
  const drag = useSimulation(
    requestOf('constant:0.4', choice.restitution, choice.slope, MOST_FLIGHTS + 1),
  );
  const vacuum = useSimulation(
    requestOf('none', choice.restitution, choice.slope, MOST_FLIGHTS + 1),
  );
  const times = drag ? flightTimes(drag) : [];
  const line = lineThrough(times.slice(0, choice.flights));
  const hit =
    Math.abs(line.restitution - PRINTED.restitution) < 5e-4 &&
    Math.abs(line.heightM - PRINTED.heightM) < 5e-4;
  const solve = async (slope: number, flights: number): Promise<void> => {
    setChoice({ restitution: await solvedFor(slope, flights), slope, flights });
  };
  return (
    <section class="beside">
      <div class="words">
        <h2>{words.title}</h2>
        <Paragraphs of={words.text} />
        <Slider
          label={words.e}
          min={0.9}
          max={0.98}
          step={0.0005}
          value={choice.restitution}
          shown={fixed(choice.restitution, 4, spoken)}
          onInput={(restitution) => setChoice({ ...choice, restitution })}
        />
        <Slider
          label={words.slope}
          min={0}
          max={0.04}
          step={0.0005}
          value={choice.slope}
          shown={fixed(choice.slope, 4, spoken)}
          onInput={(slope) => setChoice({ ...choice, slope })}
        />
        <Slider
          label={words.flights}
          min={3}
          max={MOST_FLIGHTS}
          step={1}
          value={choice.flights}
          shown={fixed(choice.flights, 0, spoken)}
          onInput={(flights) => setChoice({ ...choice, flights })}
        />
        <div class="row">
          <button type="button" class="quiet" onClick={() => void solve(0, 10)}>
            {words.solveDrag}
          </button>
          <button type="button" class="quiet" onClick={() => void solve(0, 21)}>
            {words.solveMany}
          </button>
          <button type="button" class="quiet" onClick={() => void solve(SOLVING_SLOPE, 10)}>
            {words.solveSlope}
          </button>
        </div>
        {times.length > 2 && (
          <p class="lead" role="status">
            <Rich
              parts={words.lineSays(
                fixed(line.restitution, 4, spoken),
                plain(line.heightM, CENTIMETRE, 3, spoken),
              )}
            />{' '}
            {hit && <strong>{words.hit}</strong>}
          </p>
        )}
        <p class="soft">
          {words.paperSays} {words.truth}
        </p>
      </div>
      <Sinking drag={times} vacuum={vacuum ? flightTimes(vacuum) : []} flights={choice.flights} />
    </section>
  );
}

interface SinkingProps {
  readonly drag: readonly number[];
  readonly vacuum: readonly number[];
  readonly flights: number;
}

/** The drop height that the line finds, against how many flights it is given. */
function Sinking({ drag, vacuum, flights }: SinkingProps) {
  const all = texts.value;
  const words = all.paper.four;
  const spoken = language.value;
  const key = `${drag.join()}|${vacuum.join()}|${flights}`;
  const spec = useMemo((): ChartSpec | undefined => {
    if (drag.length < 4 || vacuum.length < 4) return undefined;
    const heights = (times: readonly number[]) =>
      times.slice(2).map((_, i) => 100 * lineThrough(times.slice(0, i + 3)).heightM);
    const counts = (times: readonly number[]) => times.slice(2).map((_, i) => i + 3);
    const now = 100 * lineThrough(drag.slice(0, flights)).heightM;
    return {
      x: { label: words.x, counting: true },
      y: { label: words.y, atLeast: 6 },
      layers: [
        {
          kind: 'line',
          meaning: 'plain',
          label: all.figures.noAir,
          x: counts(vacuum),
          y: heights(vacuum),
        },
        {
          kind: 'line',
          meaning: 'drag',
          label: all.figures.model,
          x: counts(drag),
          y: heights(drag),
        },
        { kind: 'points', meaning: 'drag', label: '', x: [flights], y: [now] },
      ],
      levels: [
        { at: 100 * PRINTED.heightM, label: words.paperPoint, meaning: 'measured' },
        { at: 100 * HEIGHT_M, label: plain(HEIGHT_M, CENTIMETRE, 3, spoken), meaning: 'ink' },
      ],
    };
  }, [key, words, spoken]);
  return (
    <figure class="figure-box">
      {spec ? <Chart spec={spec} /> : <div class="chart waiting" />}
      <figcaption>{words.see}</figcaption>
    </figure>
  );
}
