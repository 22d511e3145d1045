import { Rich } from '../../app/Rich.tsx';
import { Figure, useAnswer } from '../../chart/Figure.tsx';
import { fixed, METRE, METRE_PER_SECOND, PERCENT, plain, SECOND } from '../../format/quantity.ts';
import type { Simulation } from '../../lab/index.ts';
import { engine } from '../../state/engine.ts';
import { impossible, outcome, requestOf, runs, simulating } from '../../state/simulating.ts';
import { language, texts } from '../../text/language.ts';
import { RunTools } from './RunTools.tsx';
import { Sliders } from './Sliders.tsx';

/** Drop a ball that does not exist: sliders on one side, what follows on the other. */
export function Simulate() {
  const words = texts.value.simulate;
  const done = outcome.value;
  const compared = [
    ...runs.value.map(({ setup, number }) => ({
      name: words.run(number),
      request: requestOf(setup),
    })),
    ...(done ? [{ name: words.thisRun, request: requestOf(done.setup) }] : []),
  ];
  const charts = useAnswer(() => engine().simulationCharts(compared), compared);
  const simulation = done?.simulated.simulations[0];
  return (
    <>
      <div class="words intro">
        <h1>{words.title}</h1>
        <p class="soft">{words.lead}</p>
      </div>
      <div class="simulate">
        <div class="stack">
          <Sliders />
          <RunTools />
        </div>
        <div class="stack results">
          {impossible.value !== null && (
            <p class="notice" role="alert">
              {words.impossible} {impossible.value}
            </p>
          )}
          {simulation && <Outcome simulation={simulation} />}
          {done && <Figure chart={charts?.[0]} />}
          {done && <Figure chart={charts?.[1]} numbers />}
        </div>
      </div>
    </>
  );
}

/** What becomes of the ball, in words. */
function Outcome({ simulation }: { readonly simulation: Simulation }) {
  const words = texts.value.simulate;
  const spoken = language.value;
  const energy = simulation.initial_energy_j;
  const share = (joules: number): string => plain(joules / energy, PERCENT, 2, spoken);
  const lost = simulation.lost_to_surface_j + simulation.lost_to_air_j;
  return (
    <div class="words" role="status" aria-busy={simulating.value}>
      <p class="lead">
        <Rich
          parts={words.says(
            fixed(simulation.bounces.length, 0, spoken),
            plain(simulation.total_time_s, SECOND, 3, spoken),
            plain(simulation.total_path_m, METRE, 3, spoken),
          )}
        />
      </p>
      <p>
        {lost > 0 && (
          <Rich
            parts={words.losses(
              share(simulation.lost_to_surface_j),
              share(simulation.lost_to_air_j),
            )}
          />
        )}{' '}
        <Rich
          parts={
            simulation.terminal_speed_m_s === null
              ? words.noTerminal
              : words.terminal(plain(simulation.terminal_speed_m_s, METRE_PER_SECOND, 2, spoken))
          }
        />
      </p>
    </div>
  );
}
