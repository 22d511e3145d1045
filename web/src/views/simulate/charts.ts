import type { ChartSpec, Layer } from '../../chart/spec.ts';
import type { Simulated } from '../../lab/index.ts';
import type { Run } from '../../state/simulating.ts';
import type { Meaning } from '../../style/colours.ts';
import type { Texts } from '../../text/texts.ts';

/** The inks of kept runs; the present one has the colour of a model with air. */
const INKS: readonly Meaning[] = ['ink', 'edge', 'soft'];

interface Drawn {
  readonly simulated: Simulated;
  readonly meaning: Meaning;
  readonly label: string;
  readonly kept: boolean;
}

function drawn(now: Simulated, runs: readonly Run[], texts: Texts): readonly Drawn[] {
  const words = texts.simulate;
  const hasDrag = now.document.simulations[0]?.terminal_speed_m_s !== null;
  return [
    ...runs.map((run, index) => ({
      simulated: run.simulated,
      meaning: INKS[index % INKS.length] ?? 'ink',
      label: words.run(run.number),
      kept: true,
    })),
    { simulated: now, meaning: hasDrag ? 'drag' : 'plain', label: words.thisRun, kept: false },
  ];
}

/** Height against time of the present run and of those that were kept. */
export function heightsOfRuns(now: Simulated, runs: readonly Run[], texts: Texts): ChartSpec {
  const words = texts.simulate;
  return {
    x: { label: words.x, fromZero: true },
    y: { label: words.y, fromZero: true },
    layers: drawn(now, runs, texts).map(({ simulated, meaning, label, kept }): Layer => {
      const curve = simulated.curves[0];
      return {
        kind: 'line',
        meaning,
        label: runs.length > 0 ? label : '',
        thin: kept,
        dashed: kept,
        x: curve?.time_s ?? [],
        y: (curve?.height_m ?? []).map((height) => (height === null ? null : 100 * height)),
      };
    }),
  };
}

/** Flight times on a logarithmic scale. */
export function flightsOfRuns(now: Simulated, runs: readonly Run[], texts: Texts): ChartSpec {
  const words = texts.simulate;
  return {
    x: { label: words.flightX, counting: true },
    y: { label: words.flightY, log: true },
    heightRem: 14,
    layers: drawn(now, runs, texts).map(({ simulated, meaning, label, kept }): Layer => {
      const bounces = simulated.document.simulations[0]?.bounces ?? [];
      const flying = bounces.filter((bounce) => bounce.flight_time_s > 0);
      return {
        kind: 'points',
        meaning,
        label,
        hollow: kept,
        x: flying.map((bounce) => bounce.number),
        y: flying.map((bounce) => bounce.flight_time_s),
      };
    }),
  };
}
