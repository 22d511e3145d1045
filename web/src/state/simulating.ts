/** A simulated drop: where the sliders stand, what follows, and the runs that were kept. */
import { computed, effect, signal } from '@preact/signals';
import { note, parseRoute } from '../address/route.ts';
import {
  type SimulationSetup,
  simulationFromParameters,
  simulationToParameters,
  USUAL,
} from '../address/simulation.ts';
import type { SceneRequest, SimulationDocument, SimulationRequest } from '../lab/index.ts';
import { play } from '../sound/player.ts';
import { text } from '../text/language.ts';
import { CoalescingQueue } from './coalescing-queue.ts';
import { catalogue, engine, messageOf } from './engine.ts';
import { openSamples } from './opening.ts';
import { goToLab } from './settings.ts';
import { chosenDrop, drop, type Workspace, workspace } from './workspace.ts';

/** Where the sliders stood, and what follows. */
export interface Outcome {
  readonly setup: SimulationSetup;
  readonly simulated: SimulationDocument;
}

/** A run that was kept to be compared. */
export interface Run extends Outcome {
  readonly number: number;
}

export const setup = signal<SimulationSetup>(USUAL);
/** Of the latest set-up that is simulated: the sliders may have moved on. */
export const outcome = signal<Outcome | null>(null);
/** The message of the engine if it cannot be simulated. */
export const impossible = signal<string | null>(null);

/** Whether what is shown is of where the sliders stood before. */
export const simulating = computed(
  () => impossible.value === null && outcome.value?.setup !== setup.value,
);

/** When the ball was let fall last, by the clock of the page in milliseconds. */
export const dropped = signal<number | undefined>(undefined);

export const runs = signal<readonly Run[]>([]);
const MAX_RUNS = 3;

/** A run that a measured drop is compared with. */
interface Laid {
  readonly over: Workspace;
  readonly dropIndex: number;
  readonly request: SimulationRequest;
}

const laid = signal<Laid | null>(null);
/** The run laid over the measurement that is looked at; over another it would mean nothing. */
export const overlay = computed(() => {
  const isHere = laid.value?.over === workspace.value && laid.value?.dropIndex === chosenDrop.value;
  return isHere ? (laid.value?.request ?? null) : null;
});

/** The restitution of the slider is that at 1 m/s. */
const AT_SPEED_M_S = 1;

const lawOfSliders = (restitution: number, slope: number): string =>
  slope === 0 ? String(restitution) : `power:${restitution},${AT_SPEED_M_S},${slope}`;

export function requestOf(asked: SimulationSetup): SimulationRequest {
  const { heightM, restitution, slope, ball, drag, body, law, air } = asked;
  const where = catalogue.peek()?.bodies.find(({ name }) => name === body);
  const density = (where?.air_density_kg_m3 ?? 0) * air;
  const inAir = where && {
    density_kg_m3: density,
    ...(where.air_viscosity_pa_s !== null && density > 0
      ? { viscosity_pa_s: where.air_viscosity_pa_s }
      : {}),
  };
  return {
    settings: {
      ball: { kind: ball },
      air: { drag, ...inAir },
      ...(where ? { gravity: { gravity_m_s2: where.gravity_m_s2 } } : {}),
    },
    height_m: heightM,
    restitution: law || lawOfSliders(restitution, slope),
  };
}

const simulator = new CoalescingQueue<SimulationSetup>(async (asked) => {
  try {
    outcome.value = { setup: asked, simulated: await engine().simulate(requestOf(asked)) };
    dropped.value = performance.now();
    impossible.value = null;
  } catch (error) {
    impossible.value = messageOf(error);
  }
});

/** Begins to follow the sliders, and the address. */
export function keepSimulated(): void {
  effect(() => {
    if (catalogue.value) simulator.ask(setup.value);
  });
}

export function readSimulation(): void {
  const { view, parameters } = parseRoute(location.hash);
  if (view === 'simulate') setup.value = simulationFromParameters(parameters);
}

export function move(changes: Partial<SimulationSetup>): void {
  setup.value = { ...setup.peek(), ...changes };
  note('simulate', simulationToParameters(setup.peek()));
}

export function keepRun(): void {
  const done = outcome.peek();
  if (!done) return;
  const number = (runs.peek().at(-1)?.number ?? 0) + 1;
  runs.value = [...runs.peek(), { ...done, number }].slice(-MAX_RUNS);
}

export function removeRun(number: number): void {
  runs.value = runs.peek().filter((run) => run.number !== number);
}

/** How a simulated drop is made to sound. */
const SCENE: SceneRequest = {
  voice: 'table-tennis',
  snr_db: 40,
  sample_rate_hz: 44_100,
  seed: 1,
  lead_in_s: 0.3,
  tail_s: 0.5,
};

export async function playRun(): Promise<void> {
  const { samples, sampleRateHz } = await engine().synthesise(requestOf(setup.peek()), SCENE);
  // The sound begins before the release, the curve with the first impact.
  const fallS = outcome.peek()?.simulated.simulations[0]?.bounces[0]?.time_s ?? 0;
  dropped.value = performance.now() + 1000 * (SCENE.lead_in_s + fallS);
  const at = (timeS: number): number => Math.round(timeS * sampleRateHz);
  const read = async (fromS: number, toS: number) => samples.slice(at(fromS), at(toS));
  await play({ rateHz: sampleRateHz, read }, 0, samples.length / sampleRateHz, 1);
}

/** Into the workspace with it, as if it had been recorded. */
export async function analyseRun(): Promise<void> {
  const asked = requestOf(setup.peek());
  const { samples, sampleRateHz } = await engine().synthesise(asked, SCENE);
  goToLab();
  // What was put in is what is known of it.
  await openSamples(samples, sampleRateHz, text('page-simulate-this-run'), asked.settings);
}

/** Lays the run over the measurement in the workspace. */
export function layOver(): void {
  const done = outcome.peek();
  const over = workspace.peek();
  if (!over || !done || !drop.peek()) return;
  laid.value = { over, dropIndex: chosenDrop.peek(), request: requestOf(done.setup) };
}

/** Takes it off again. */
export function takeOff(): void {
  laid.value = null;
}
