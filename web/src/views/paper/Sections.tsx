import { useMemo } from 'preact/hooks';
import { Chart } from '../../chart/Chart.tsx';
import { Key } from '../../chart/Key.tsx';
import type { ChartSpec } from '../../chart/spec.ts';
import { texts } from '../../text/language.ts';
import { flightTimes, GRAVITY, lineThrough, PRINTED, requestOf, settingsOf } from './experiment.ts';
import { useSimulation } from './simulation.ts';

interface FigureProps {
  readonly spec: ChartSpec | undefined;
  readonly see: string;
}

function Figure({ spec, see }: FigureProps) {
  return (
    <figure class="figure-box">
      {spec && <Key spec={spec} />}
      {spec ? <Chart spec={spec} /> : <div class="chart waiting" />}
      <figcaption>{see}</figcaption>
    </figure>
  );
}

/** Flight times without air: a straight line, as the paper's Eq. 4 says. */
export function RulerFigure() {
  const words = texts.value;
  const simulated = useSimulation(requestOf('none', PRINTED.restitution, 0, 30));
  const spec = useMemo((): ChartSpec | undefined => {
    if (!simulated) return undefined;
    const times = flightTimes(simulated);
    const numbers = times.map((_, i) => i + 1);
    const { restitution, heightM } = lineThrough(times);
    const first = Math.sqrt((8 * heightM) / GRAVITY);
    return {
      x: { label: words.figures.flights.x, counting: true },
      y: { label: words.figures.flights.y, log: true },
      heightRem: 18,
      layers: [
        {
          kind: 'line',
          meaning: 'plain',
          label: words.figures.straightLine,
          x: numbers,
          y: numbers.map((n) => first * restitution ** n),
        },
        { kind: 'points', meaning: 'plain', label: '', x: numbers, y: times },
      ],
    };
  }, [simulated, words]);
  return <Figure spec={spec} see={words.paper.one.see} />;
}

/** Speeds from a tenth of a metre a second to beyond the terminal speed. */
const SPEEDS = Array.from({ length: 61 }, (_, i) => 0.1 * 10 ** (i / 30));

/** Drag over weight by both laws of the paper (its Figs. 6 and 7). */
export function DragFigure() {
  const words = texts.value;
  const constant = useSimulation(requestOf('constant:0.4', 0.935, 0, 2));
  const sphere = useSimulation(requestOf('clift-grace-weber', 0.935, 0, 2));
  const spec = useMemo((): ChartSpec | undefined => {
    const terminal = constant?.document.simulations[0]?.terminal_speed_m_s;
    if (!terminal || !sphere) return undefined;
    return {
      x: { label: words.figures.drag.x, log: true },
      y: { label: words.figures.drag.y, log: true },
      heightRem: 17,
      layers: [
        {
          kind: 'line',
          meaning: 'plain',
          dashed: true,
          label: 'C_D = 0.4',
          x: SPEEDS,
          y: SPEEDS.map((speed) => 100 * (speed / terminal) ** 2),
        },
        {
          kind: 'line',
          meaning: 'drag',
          label: 'C_D(Re)',
          x: SPEEDS,
          y: SPEEDS.map((speed) => 100 * dragOverWeight(speed)),
        },
      ],
      levels: [{ at: 2.405, label: words.paper.three.first, meaning: 'measured', upright: true }],
    };
  }, [constant, sphere, words]);
  return <Figure spec={spec} see={words.paper.three.see} />;
}

/** By the drag law of Clift and Gauvin (1971), as the engine has it. */
function dragOverWeight(speed: number): number {
  const {
    diameter_m = 0,
    mass_kg = 1,
    air_density_kg_m3: density = 0,
    air_viscosity_pa_s = 1,
  } = settingsOf('');
  const reynolds = (density * speed * diameter_m) / air_viscosity_pa_s;
  const coefficient =
    (24 / reynolds) * (1 + 0.15 * reynolds ** 0.687) + 0.42 / (1 + 42500 * reynolds ** -1.16);
  const area = (Math.PI / 4) * diameter_m ** 2;
  return (density * area * coefficient * speed ** 2) / (2 * mass_kg * GRAVITY);
}

/** The whole drop with and without air (the paper's Fig. 8). */
export function HeightFigure() {
  const words = texts.value;
  const air = useSimulation(requestOf('constant:0.4', 0.935, 0));
  const vacuum = useSimulation(requestOf('none', 0.935, 0));
  const spec = useMemo((): ChartSpec | undefined => {
    const [withAir, without] = [air?.curves[0], vacuum?.curves[0]];
    if (!withAir || !without) return undefined;
    const cm = (heights: readonly (number | null)[]) =>
      heights.map((height) => (height === null ? null : 100 * height));
    return {
      x: { label: words.simulate.x, fromZero: true },
      y: { label: words.simulate.y, fromZero: true },
      heightRem: 14,
      layers: [
        {
          kind: 'line',
          meaning: 'plain',
          label: words.figures.noAir,
          thin: true,
          x: without.time_s,
          y: cm(without.height_m),
        },
        {
          kind: 'line',
          meaning: 'drag',
          label: words.figures.model,
          thin: true,
          x: withAir.time_s,
          y: cm(withAir.height_m),
        },
      ],
    };
  }, [air, vacuum, words]);
  return <Figure spec={spec} see={words.paper.three.seeHeight} />;
}
