/** What of a chart can be read as numbers, free of any chart library. */
import type { Axis, Layer } from '../lab/index.ts';

export interface Point {
  readonly x: number;
  readonly y: number;
  readonly name: string;
}

/** The quantity with its unit, as in "height (cm)". */
export const labelOf = ({ quantity, unit }: Axis): string =>
  unit === '' ? quantity : `${quantity} (${unit})`;

/** The points of a line, single ones, and the tops of boxes; bands and rules have none. */
export function pointsOf(layer: Layer): readonly Point[] {
  const { name } = layer;
  const known = (x: number | null, y: number | null): Point[] =>
    x === null || y === null ? [] : [{ x, y, name }];
  switch (layer.kind) {
    case 'line':
    case 'points':
      return layer.points.flatMap(([x, y]) => known(x, y));
    case 'boxes':
      return layer.boxes.flatMap(([left, right, , top]) =>
        left === null || right === null ? [] : known((left + right) / 2, top),
      );
    default:
      return [];
  }
}

/** The layers that stand in the legend: those with a name, each name once. */
export function legendOf(layers: readonly Layer[]): readonly Layer[] {
  const seen = new Set<string>();
  return layers.filter(({ name }) => name !== '' && !seen.has(name) && seen.add(name));
}
