import { useMemo } from 'preact/hooks';
import { Chart } from '../../chart/Chart.tsx';
import { Key } from '../../chart/Key.tsx';
import type { ChartSpec, Layer } from '../../chart/spec.ts';
import type { KeptDrop } from '../../store/drops.ts';
import type { Meaning } from '../../style/colours.ts';
import { texts } from '../../text/language.ts';

/** Drops beside each other, and the restitution of each over the speed. */
export function Comparison({ drops }: { readonly drops: readonly KeptDrop[] }) {
  const words = texts.value;
  const each = useMemo(() => eachDrop(drops, words.drops.x, words.drops.e), [drops, words]);
  const curves = useMemo(() => overSpeed(drops, words.figures.restitution), [drops, words]);
  if (drops.length < 2) return null;
  return (
    <div class="pairs">
      <figure class="figure-box">
        <Chart spec={each} />
        <figcaption>{words.drops.see}</figcaption>
      </figure>
      <figure class="figure-box">
        <Key spec={curves} />
        <Chart spec={curves} />
        <figcaption>{words.drops.seeRestitution}</figcaption>
      </figure>
    </div>
  );
}

function eachDrop(drops: readonly KeptDrop[], x: string, y: string): ChartSpec {
  const known = drops.filter(({ restitution }) => restitution !== null);
  return {
    x: { label: x, counting: true, atLeast: drops.length + 1 },
    y: { label: y, atLeast: 0.01 },
    heightRem: 16,
    layers: [
      {
        kind: 'points',
        meaning: 'measured',
        label: '',
        x: known.map((drop) => drops.indexOf(drop) + 1),
        y: known.map(({ restitution }) => restitution?.value ?? null),
        sd: known.map(({ restitution }) => restitution?.sd ?? null),
      },
    ],
  };
}

/** More than that many cannot be told apart. */
const MOST = 4;
const INKS: readonly Meaning[] = ['measured', 'ink', 'edge', 'soft'];

function overSpeed(
  drops: readonly KeptDrop[],
  words: { readonly x: string; readonly y: string },
): ChartSpec {
  return {
    x: { label: words.x, fromZero: true },
    y: { label: words.y, atLeast: 0.02 },
    heightRem: 16,
    layers: drops.slice(-MOST).map(
      (drop, index): Layer => ({
        kind: 'points',
        meaning: INKS[index] ?? 'soft',
        label: drop.name,
        hollow: index > 0,
        x: drop.restitutions.map(({ speedMS }) => speedMS),
        y: drop.restitutions.map(({ value }) => value),
      }),
    ),
  };
}
