import { useEffect, useState } from 'preact/hooks';
import type { Simulated, SimulationRequest } from '../../lab/index.ts';
import { engine } from '../../state/engine.ts';

/** The outcome of a simulation; the last one stays until the next is there. */
export function useSimulation(request: SimulationRequest): Simulated | undefined {
  const [simulated, setSimulated] = useState<Simulated>();
  const asked = JSON.stringify(request);
  useEffect(() => {
    let current = true;
    engine()
      .simulate(JSON.parse(asked) as SimulationRequest)
      .then(
        (done) => {
          if (current) setSimulated(done);
        },
        () => undefined,
      );
    return () => {
      current = false;
    };
  }, [asked]);
  return simulated;
}
