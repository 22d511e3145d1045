import type { ChartSpec, Layer } from '../chart/spec.ts';
import type { HeightCurve, Series } from '../lab/index.ts';
import type { Texts } from '../text/texts.ts';

/** Height against time as heard, over the best model or over a simulation of the reader. */
export function compareChart(
  series: Series,
  overlay: HeightCurve | null,
  texts: Texts,
): ChartSpec | undefined {
  const words = texts.figures;
  if (series.measured.time_s.length === 0) return undefined;
  const layers: Layer[] = [];
  const curve = (from: HeightCurve, label: string, meaning: Layer['meaning'], thin: boolean) => {
    if (from.time_s.length === 0) return;
    layers.push({
      kind: 'line',
      meaning,
      label,
      thin,
      x: from.time_s,
      y: from.height_m.map((height) => (height === null ? null : 100 * height)),
    });
  };
  curve(
    overlay ?? series.simulated,
    overlay ? words.compare.overlay : words.compare.simulated,
    'drag',
    false,
  );
  curve(series.measured, words.measured, 'measured', true);
  return {
    x: { label: words.compare.x },
    y: { label: words.compare.y, fromZero: true },
    layers,
  };
}
