/** The figures of a drop, in the order of their tabs. */
import type { ChartSpec } from '../chart/spec.ts';
import type { Analysed, DocumentDrop, HeightCurve, Series } from '../lab/index.ts';
import type { Texts } from '../text/texts.ts';
import { compareChart } from './compare.ts';
import { dragChart } from './drag.ts';
import { energyChart } from './energy.ts';
import { flightsChart, residualsChart } from './flights.ts';
import { heightsChart } from './heights.ts';
import { restitutionChart } from './restitution.ts';

export const FIGURES = ['restitution', 'flights', 'heights', 'energy', 'drag', 'compare'] as const;
export type FigureId = (typeof FIGURES)[number];

/** What figures are made of. */
export interface Material {
  readonly analysed: Analysed;
  readonly drop: DocumentDrop;
  readonly series: Series | undefined;
  readonly overlay: HeightCurve | null;
  readonly logDrag: boolean;
}

/** The charts of a figure; none if there is nothing to show. */
export function chartsOf(id: FigureId, material: Material, texts: Texts): readonly ChartSpec[] {
  const { analysed, drop, series, overlay, logDrag } = material;
  const some = (...charts: readonly (ChartSpec | undefined)[]): ChartSpec[] =>
    charts.filter((chart): chart is ChartSpec => chart !== undefined);
  switch (id) {
    case 'restitution':
      return drop.impacts.some((impact) => impact.restitution !== null)
        ? [restitutionChart(drop, texts)]
        : [];
    case 'flights':
      return some(flightsChart(drop, texts), residualsChart(drop, texts));
    case 'heights':
      return [heightsChart(drop, texts)];
    case 'energy':
      return some(series && energyChart(series, texts));
    case 'drag':
      return some(dragChart(analysed.drag, drop.corrected?.fastest_m_s ?? null, logDrag, texts));
    case 'compare':
      return some(series && compareChart(series, overlay, texts));
  }
}

/** The name under which the engine draws the same figure. */
export function engineName(id: FigureId, logDrag: boolean): string {
  const names: Record<FigureId, string> = {
    restitution: 'restitution',
    flights: 'flight-times',
    heights: 'bounce-heights',
    energy: 'bounce-energies',
    drag: logDrag ? 'drag-log' : 'drag',
    compare: 'height',
  };
  return names[id];
}
