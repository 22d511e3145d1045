/** How a panel of a chart looks and moves: the one place that knows uPlot's options. */
import type uPlot from 'uplot';
import { fixed } from '../format/quantity.ts';
import type { Axis, Panel } from '../lab/index.ts';
import { colour, fontOf } from '../style/colours.ts';
import { drawLayers } from './painters.ts';
import { labelOf } from './points.ts';
import { tip } from './tip.ts';

/** Size of the text of the page, in CSS pixels. */
const rem = (): number => Number.parseFloat(getComputedStyle(document.documentElement).fontSize);

/** Of numbers and names of the axes, in units of the width of text. */
const AXES_REM = 6;
/** Figure pixels are meant for text of this size. */
const FIGURE_TEXT = 14;
/** Like `Scale` in the science, which numbers whole ones only. */
const COUNTS = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];

export function optionsOf(panel: Panel, width: number, language: string): uPlot.Options {
  const { x, y } = panel;
  const inner = Math.min((panel.height / FIGURE_TEXT) * rem(), Math.max(0.7 * width, 6 * rem()));
  const named = y.names.length * 1.9 * rem();
  return {
    width,
    height: Math.max(inner, named) + AXES_REM * rem(),
    padding: [rem(), rem() * 0.75, 0, 0],
    legend: { show: false },
    cursor: { points: { show: false }, drag: { x: true, y: false, dist: 6 }, y: false, x: false },
    scales: {
      // All at first, and again after a double click; between them what was chosen by dragging.
      x: {
        time: false,
        distr: x.scale.kind === 'log' ? 3 : 1,
        range: (_, low, high) => [low, high],
      },
      y: { distr: y.scale.kind === 'log' ? 3 : 1, range: () => [y.scale.low, y.scale.high] },
    },
    axes: [axis(x, language, false), axis(y, language, true)],
    series: [{}, { show: true, paths: () => null, points: { show: false } }],
    hooks: { draw: [(plot) => drawLayers(plot, panel)] },
    plugins: [tip(panel, language)],
  };
}

/** The ends of the axis: uPlot wants data to know what all of them is. */
export function dataOf({ x, y }: Panel): uPlot.AlignedData {
  return [
    [x.scale.low, x.scale.high],
    [y.scale.low, y.scale.high],
  ];
}

function axis(of: Axis, language: string, upright: boolean): uPlot.Axis {
  const size = rem();
  const font = fontOf(0.8125);
  const labelled = of.ticks === 'labelled';
  const rows = of.names.length;
  return {
    show: of.ticks !== 'hidden' || rows > 0,
    ...(labelled && of.quantity !== '' ? { label: labelOf(of) } : {}),
    labelFont: font,
    labelSize: 1.5 * size,
    font,
    stroke: colour('soft'),
    size: upright ? widthOf(of, size) : 1.9 * size,
    space: (upright ? 2.2 : 4) * size,
    gap: 4,
    grid: { show: rows === 0 && of.ticks !== 'hidden', stroke: colour('line'), width: 1 },
    ticks: { show: false },
    ...(of.scale.kind === 'counting' ? { incrs: COUNTS } : {}),
    ...(rows > 0 ? { splits: () => of.names.map((_, row) => rows - row - 0.5) } : {}),
    filter: (_plot, splits) => splits,
    values: (_plot, splits) => (labelled ? labels(splits, of, language) : splits.map(() => '')),
  };
}

/** Of names as much as the longest takes, but not all of a phone. */
function widthOf(of: Axis, size: number): number {
  const longest = Math.max(0, ...of.names.map((name) => (name.split('\n')[0] ?? '').length));
  return longest > 0 ? Math.min(0.5 * longest + 1, 11) * size : 3.25 * size;
}

/** Numbers along an axis, with as many decimals as they differ by, or the names of rows. */
function labels(splits: readonly (number | null)[], of: Axis, language: string): string[] {
  if (of.names.length > 0) return of.names.map((name) => name.split('\n')[0] ?? '');
  if (of.scale.kind === 'log') return splits.map((split) => logLabel(split, splits, language));
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
