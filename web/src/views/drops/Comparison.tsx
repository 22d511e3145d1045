import { Figure, useAnswer } from '../../chart/Figure.tsx';
import { engine } from '../../state/engine.ts';
import type { KeptDrop } from '../../store/drops.ts';

/** Drops side by side, and the restitution of each over the speed. */
export function Comparison({ drops }: { readonly drops: readonly KeptDrop[] }) {
  const compared = drops.map(({ name, restitution, restitutions }) => ({
    name,
    restitution: restitution?.value ?? null,
    restitution_sd: restitution?.sd ?? null,
    impacts: restitutions.map(({ speedMS, value }): [number, number] => [speedMS, value]),
  }));
  const charts = useAnswer(() => engine().dropCharts(compared), compared);
  if (drops.length < 2) return null;
  return (
    <div class="pairs">
      <Figure chart={charts?.[0]} />
      <Figure chart={charts?.[1]} />
    </div>
  );
}
