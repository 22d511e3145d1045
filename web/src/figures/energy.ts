import type { ChartSpec } from '../chart/spec.ts';
import type { Series } from '../lab/index.ts';
import type { Texts } from '../text/texts.ts';

/** What the surface and the air take at each bounce, stacked. */
export function energyChart(series: Series, texts: Texts): ChartSpec | undefined {
  const words = texts.figures.energy;
  const { energies } = series;
  if (energies.length === 0) return undefined;
  const x = energies.map((energy) => energy.number);
  const surface = energies.map((energy) => 1e3 * Math.max(0, energy.lost_to_surface_j));
  const both = energies.map(
    (energy, i) => (surface[i] as number) + 1e3 * Math.max(0, energy.lost_to_air_j),
  );
  return {
    x: { label: words.x, counting: true },
    y: { label: words.y, fromZero: true },
    layers: [
      { kind: 'bars', meaning: 'measured', label: words.surface, x, y: surface },
      { kind: 'bars', meaning: 'drag', label: words.air, x, y: both, from: surface },
    ],
  };
}
