/** The experiment of the paper, and the straight line that it lays through the flight times. */
import type { Settings, Simulated, SimulationRequest } from '../../lab/index.ts';
import { engine } from '../../state/engine.ts';

export const HEIGHT_M = 0.305;
export const GRAVITY = 9.81;
/** What the paper's line says. */
export const PRINTED = { restitution: 0.9375, heightM: 0.267 } as const;
/** From the buoyancy and the Reynolds number that the paper prints. */
const AIR_KG_M3 = 1.2276;
const AIR_M2_S = 1.5e-5;

/** Its ball of 2.5 g and 38 mm in its air, without buoyancy like the paper. */
export function settingsOf(drag: string): Settings {
  return {
    mass_kg: 2.5e-3,
    diameter_m: 38e-3,
    contact_time_s: 0,
    gravity_m_s2: GRAVITY,
    air_density_kg_m3: AIR_KG_M3,
    air_viscosity_pa_s: AIR_M2_S * AIR_KG_M3,
    buoyancy: false,
    added_mass: false,
    drag,
  };
}

/** A drop of it; the restitution is that at 1 m/s, and falls by `slope` for each m/s. */
export function requestOf(
  drag: string,
  restitution: number,
  slope: number,
  bounces?: number,
): SimulationRequest {
  return {
    settings: settingsOf(drag),
    height_m: HEIGHT_M,
    restitution:
      slope === 0
        ? { law: 'constant', restitution }
        : { law: 'linear', at_rest: restitution + slope, loss_per_speed_s_m: slope },
    ...(bounces === undefined ? {} : { bounces }),
  };
}

export const flightTimes = (simulated: Simulated): number[] =>
  (simulated.document.simulations[0]?.bounces ?? [])
    .map((bounce) => bounce.flight_time_s)
    .filter((time) => time > 0);

/** What the straight line says. */
export interface Line {
  readonly restitution: number;
  readonly heightM: number;
}

/**
 * The least-squares line through log10 T_n against n (paper, Eqs. 4 to 6, Eq. 6 as it must be:
 * h0 = g (10^b)^2/8).
 */
export function lineThrough(times: readonly number[], gravity = GRAVITY): Line {
  const n = times.length;
  const logs = times.map(Math.log10);
  const meanX = (n + 1) / 2;
  const meanY = logs.reduce((sum, y) => sum + y, 0) / n;
  let xy = 0;
  let xx = 0;
  logs.forEach((y, i) => {
    const x = i + 1 - meanX;
    xy += x * (y - meanY);
    xx += x * x;
  });
  const slope = xy / xx;
  const intercept = meanY - slope * meanX;
  return { restitution: 10 ** slope, heightM: (gravity * 10 ** (2 * intercept)) / 8 };
}

/** The restitution at 1 m/s with which the line of so many flights says what the paper's says. */
export async function solvedFor(slope: number, flights: number): Promise<number> {
  let [low, high] = [0.88, 0.995];
  while (high - low > 1e-5) {
    const middle = (low + high) / 2;
    const simulated = await engine().simulate(
      requestOf('constant:0.4', middle, slope, flights + 1),
    );
    const line = lineThrough(flightTimes(simulated).slice(0, flights));
    if (line.restitution < PRINTED.restitution) low = middle;
    else high = middle;
  }
  return (low + high) / 2;
}
