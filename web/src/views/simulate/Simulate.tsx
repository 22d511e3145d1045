import { HeightCurve, hopsOfSimulation } from '../../app/HeightCurve.tsx';
import { Rich } from '../../app/Rich.tsx';
import { Figure, useAnswer } from '../../chart/Figure.tsx';
import { fixed, LENGTH, PERCENT, rounded, SPEED, TIME } from '../../format/quantity.ts';
import type { Simulation } from '../../lab/index.ts';
import { engine } from '../../state/engine.ts';
import {
  dropped,
  impossible,
  outcome,
  requestOf,
  runs,
  simulating,
} from '../../state/simulating.ts';
import { language, parts, text } from '../../text/language.ts';
import { RunTools } from './RunTools.tsx';
import { Sliders } from './Sliders.tsx';

/** Simulates a drop: sliders on one side, results on the other. */
export function Simulate() {
  const done = outcome.value;
  const compared = [
    ...runs.value.map(({ setup, number }) => ({
      name: text('page-simulate-run', { index: number }),
      request: requestOf(setup),
    })),
    ...(done ? [{ name: text('page-simulate-this-run'), request: requestOf(done.setup) }] : []),
  ];
  const charts = useAnswer(() => engine().simulationCharts(compared), compared);
  const simulation = done?.simulated.simulations[0];
  return (
    <>
      <div class="words intro">
        <h1>{text('page-simulate-title')}</h1>
        <p class="soft">{text('page-simulate-lead')}</p>
      </div>
      <div class="simulate">
        <div class="stack">
          <Sliders />
          <RunTools />
        </div>
        <div class="stack results">
          {impossible.value !== null && (
            <p class="notice" role="alert">
              {text('page-simulate-impossible')} {impossible.value}
            </p>
          )}
          {simulation && <Outcome simulation={simulation} />}
          {simulation && <HeightCurve hops={hopsOfSimulation(simulation)} since={dropped.value} />}
          {done && <Figure chart={charts?.[0]} />}
          {done && <Figure chart={charts?.[1]} numbers />}
        </div>
      </div>
    </>
  );
}

/** The simulated drop in a sentence. */
function Outcome({ simulation }: { readonly simulation: Simulation }) {
  const spoken = language.value;
  const energy = simulation.initial_energy_j;
  const share = (joules: number): string => rounded(joules / energy, 2, PERCENT, spoken);
  const lost = simulation.lost_to_surface_j + simulation.lost_to_air_j;
  return (
    <div class="words" role="status" aria-busy={simulating.value}>
      <p class="lead">
        <Rich
          parts={parts('page-simulate-says', {
            bounces: fixed(simulation.bounces.length, 0, spoken),
            time: rounded(simulation.total_time_s, 3, TIME, spoken),
            path: rounded(simulation.total_path_m, 3, LENGTH, spoken),
          })}
        />
      </p>
      <p>
        {lost > 0 && (
          <Rich
            parts={parts('page-simulate-losses', {
              surface: share(simulation.lost_to_surface_j),
              air: share(simulation.lost_to_air_j),
            })}
          />
        )}{' '}
        <Rich
          parts={
            simulation.terminal_speed_m_s === null
              ? parts('page-simulate-no-terminal')
              : parts('page-simulate-terminal', {
                  speed: rounded(simulation.terminal_speed_m_s, 2, SPEED, spoken),
                })
          }
        />
      </p>
    </div>
  );
}
