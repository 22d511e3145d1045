/** How a chart looks and moves: the one place that knows uPlot's options. */
import type uPlot from 'uplot';
import { fixed } from '../format/quantity.ts';
import { colour, fontOf } from '../style/colours.ts';
import { drawBars, drawErrors, drawLabels, drawLevels } from './painters.ts';
import { type Axis, type ChartSpec, type Layer, padded, yValues } from './spec.ts';
import { tip } from './tip.ts';

/** Size of the text of the page, in CSS pixels. */
export const rem = (): number =>
  Number.parseFloat(getComputedStyle(document.documentElement).fontSize);

const HEIGHT_REM = 20;

export function optionsOf(spec: ChartSpec, width: number, language: string): uPlot.Options {
  const levels = spec.levels ?? [];
  const upright = levels.filter((level) => level.upright).map((level) => level.at);
  const across = levels.filter((level) => !level.upright).map((level) => level.at);
  const xRange = padded([...spec.layers.flatMap((layer) => [...layer.x]), ...upright], spec.x);
  const yRange = padded([...yValues(spec.layers), ...across], spec.y);
  return {
    width,
    height: Math.min((spec.heightRem ?? HEIGHT_REM) * rem(), Math.max(0.8 * width, 12 * rem())),
    padding: [rem() * 1.25, rem() * 0.75, 0, 0],
    legend: { show: false },
    cursor: {
      points: { show: false },
      drag: { x: true, y: false, dist: 6 },
      y: false,
      x: false,
    },
    scales: {
      x: { time: false, distr: spec.x.log ? 3 : 1, range: ranger(xRange) },
      y: { distr: spec.y.log ? 3 : 1, range: () => yRange },
    },
    axes: [axis(spec.x, language, false), axis(spec.y, language, true)],
    series: [{}, ...spec.layers.flatMap(seriesOf)],
    bands: bandsOf(spec.layers),
    hooks: {
      drawSeries: [],
      draw: [
        (plot) => drawLevels(plot, spec),
        (plot) => drawBars(plot, spec),
        (plot) => drawErrors(plot, spec),
        (plot) => drawLabels(plot, spec),
      ],
    },
    plugins: [tip(spec, language)],
  };
}

/** All at first, and again after a double click; between them what was chosen by dragging. */
function ranger(all: [number, number]): uPlot.Scale.Range {
  return (plot, low, high) => {
    const data = plot.data[0];
    const ends = [data[0], data[data.length - 1]];
    const isAll = low === ends[0] && high === ends[1];
    return isAll || low === null || high === null ? all : [low, high];
  };
}

function axis(of: Axis, language: string, upright: boolean): uPlot.Axis {
  const size = rem();
  const soft = colour('soft');
  const font = fontOf(0.8125);
  return {
    label: of.label,
    labelFont: font,
    labelSize: 1.5 * size,
    font,
    stroke: soft,
    size: (upright ? 3.25 : 1.9) * size,
    space: (upright ? 2.2 : 4) * size,
    gap: 4,
    grid: { stroke: colour('line'), width: 1 },
    ticks: { show: false },
    ...(of.counting ? { incrs: [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000] } : {}),
    filter: (_plot, splits) => splits,
    values: (_plot, splits) => labels(splits, of, language),
  };
}

/** Numbers along an axis, with as many decimals as they differ by. */
function labels(splits: readonly (number | null)[], of: Axis, language: string): string[] {
  if (of.log) return splits.map((split) => logLabel(split, splits, language));
  const step = Math.abs((splits[1] ?? 1) - (splits[0] ?? 0)) || 1;
  const decimals = [0, 1, 2, 3, 4, 5, 6].find((places) => isWhole(step * 10 ** places)) ?? 6;
  return splits.map((split) => (split === null ? '' : fixed(split, decimals, language)));
}

const isWhole = (value: number): boolean => Math.abs(value - Math.round(value)) < 1e-6 * value;

/** On a logarithmic axis only round numbers are written: fewer the more decades there are. */
function logLabel(
  split: number | null,
  splits: readonly (number | null)[],
  language: string,
): string {
  if (split === null || !(split > 0)) return '';
  const known = splits.filter((other): other is number => other !== null && other > 0);
  const decades = Math.log10((known.at(-1) ?? 1) / (known[0] ?? 1));
  const exponent = Math.floor(Math.log10(split) + 1e-9);
  const leading = Math.round(split / 10 ** exponent);
  const written = decades > 2.2 ? [1] : decades > 1.2 ? [1, 2, 5] : [1, 2, 3, 5, 7];
  return written.includes(leading) ? fixed(split, Math.max(0, -exponent), language) : '';
}

function seriesOf(layer: Layer): uPlot.Series[] {
  const stroke = colour(layer.meaning);
  switch (layer.kind) {
    case 'line':
      return [
        {
          stroke,
          width: layer.thin ? 1.25 : 2,
          spanGaps: false,
          points: { show: false },
          ...(layer.dashed ? { dash: [6, 4] } : {}),
        },
      ];
    case 'points':
      return [
        {
          stroke,
          paths: () => null,
          points: {
            show: true,
            size: layer.hollow ? 7 : 7,
            width: 1.5,
            stroke,
            fill: layer.hollow ? colour('paper') : stroke,
          },
        },
      ];
    case 'band': {
      const edge: uPlot.Series = { width: 0, points: { show: false }, spanGaps: false };
      return [edge, { ...edge }];
    }
    case 'bars':
      return [{ stroke, paths: () => null, points: { show: false } }];
  }
}

function bandsOf(layers: readonly Layer[]): uPlot.Band[] {
  const bands: uPlot.Band[] = [];
  let column = 1;
  for (const layer of layers) {
    if (layer.kind === 'band') {
      const tint =
        layer.meaning === 'drag'
          ? 'drag-tint'
          : layer.meaning === 'plain'
            ? 'plain-tint'
            : 'measured-tint';
      bands.push({ series: [column + 1, column], fill: colour(tint), dir: -1 });
      column += 2;
    } else column += 1;
  }
  return bands;
}
