/** The layers of a chart over one common column of x, as uPlot wants them. */
import uPlot from 'uplot';
import type { ChartSpec, Layer } from './spec.ts';

/** How many columns of y a layer takes. */
export const columnsOf = (layer: Layer): number => (layer.kind === 'band' ? 2 : 1);

export function dataOf(spec: ChartSpec): uPlot.AlignedData {
  const tables = spec.layers.map((layer): uPlot.AlignedData => {
    const x = [...layer.x];
    return layer.kind === 'band' ? [x, [...layer.low], [...layer.high]] : [x, [...layer.y]];
  });
  if (tables.length === 0) return [[]];
  // Gaps that are in the data stay gaps; what only joining leaves open is bridged.
  const keepNulls = spec.layers.map((layer) => [0, ...Array(columnsOf(layer)).fill(1)]);
  return uPlot.join(tables, keepNulls);
}
