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

/** Above the frame, and of the name of the axis below it, in units of the width of text. */
const PADDING_REM = 1;
const LABEL_REM = 1.5;
/** Size of numbers and names, and from line to line. */
const NUMBERS_REM = 0.8125;
const LINE_REM = 1.1;
/** Between numbers or names and the frame. */
const GAP_PX = 4;
/** Names of rows are broken into lines of this many letters. */
const NAME_LETTERS = 20;
/** An equation is one word. */
const BETWEEN_WORDS = /(?<!=) (?!=)/;
/** Figure pixels are meant for text of this size. */
const FIGURE_TEXT = 14;
/** Like `Scale` in the science, which numbers whole ones only. */
const COUNTS = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];

/** Those of the first panel of a row, whose frame is as high as the names of the row need. */
export function optionsOf(row: readonly Panel[], width: number, language: string): uPlot.Options {
  const panel = row[0] as Panel;
  const { x, y } = panel;
  const inner = Math.min((panel.height / FIGURE_TEXT) * rem(), Math.max(0.7 * width, 6 * rem()));
  const named = Math.max(...row.map((panel) => heightOfNames(panel.y.names)));
  const beyond = beyondEnds(x, width, language);
  const below = (x.ticks === 'labelled' ? LABEL_REM : 0) * rem() + sizeOfX(x);
  return {
    width,
    height: Math.max(inner, named) + PADDING_REM * rem() + below,
    padding: [PADDING_REM * rem(), beyond * rem(), 0, y.ticks === 'labelled' ? 0 : beyond * rem()],
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
    hooks: { draw: [(plot) => drawLayers(plot, panel), (plot) => drawNames(plot, y)] },
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
  const font = fontOf(NUMBERS_REM);
  const labelled = of.ticks === 'labelled';
  const rows = of.names.length;
  return {
    show: of.ticks !== 'hidden' || rows > 0,
    // The name of the upright axis stands above the panel, where a long one fits in several lines.
    ...(labelled && !upright && of.quantity !== '' ? { label: labelOf(of) } : {}),
    labelFont: font,
    labelSize: LABEL_REM * size,
    font,
    stroke: colour('soft'),
    size: upright ? (_plot, numbers) => widthOf(of, numbers ?? []) : sizeOfX(of),
    space: SPACE_REM[upright ? 'upright' : 'level'] * size,
    gap: GAP_PX,
    grid: { show: rows === 0 && of.ticks !== 'hidden', stroke: colour('line'), width: 1 },
    ticks: { show: false },
    ...(of.scale.kind === 'counting' ? { incrs: COUNTS } : {}),
    ...(rows > 0 ? { splits: () => of.names.map((_, row) => rows - row - 0.5) } : {}),
    filter: (_plot, splits) => splits,
    values: (_plot, splits) => (labelled ? labels(splits, of, language) : splits.map(() => '')),
  };
}

/** Between the numbers of an axis there is at least this, in units of the width of text. */
const SPACE_REM = { upright: 2.2, level: 4 };

/** Beside the frame: half of the number at the end of its axis. */
function beyondEnds({ scale }: Axis, width: number, language: string): number {
  const { low, high } = scale;
  const decimals = decimalsOf(stepOver(((high - low) * SPACE_REM.level * rem()) / width));
  return Math.max(0.75, 0.25 * fixed(high, decimals, language).length);
}

/** The step that uPlot takes where numbers may be so far apart. */
function stepOver(least: number): number {
  const size = 10 ** Math.floor(Math.log10(least));
  return ([1, 2, 2.5, 5].find((step) => step * size >= least) ?? 10) * size;
}

/** As many decimals as multiples of a step have. */
const decimalsOf = (step: number): number =>
  [0, 1, 2, 3, 4, 5, 6].find((places) => isWhole(step * 10 ** places)) ?? 6;

/** The names of rows one below the other, each as high as the one with most lines. */
function heightOfNames(names: readonly string[]): number {
  const lines = names.map((name) => linesOf(name).length);
  return names.length * (LINE_REM * Math.max(0, ...lines) + 0.8) * rem();
}

/** The height that the numbers below a panel take. */
const sizeOfX = ({ ticks }: Axis): number =>
  ({ labelled: 1.9, grid: 0.5, hidden: 0 })[ticks] * rem();

/** The width before a panel: as much as the longest line of the names takes, or the longest number. */
function widthOf(of: Axis, numbers: readonly string[]): number {
  if (of.ticks !== 'labelled') return 0.25 * rem();
  const longest = (texts: readonly string[]) => Math.max(0, ...texts.map(({ length }) => length));
  const name = longest(of.names.flatMap(linesOf));
  return (name > 0 ? 0.5 * name + 0.75 : Math.max(3.25, 0.5 * longest(numbers) + 0.5)) * rem();
}

/** A name in lines: broken between words, and where the engine breaks it. */
function linesOf(name: string): string[] {
  const lines: string[] = [];
  for (const part of name.split('\n')) {
    let line = '';
    for (const word of part.split(BETWEEN_WORDS)) {
      if (line !== '' && line.length + word.length >= NAME_LETTERS) {
        lines.push(line);
        line = word;
      } else line = line === '' ? word : `${line} ${word}`;
    }
    lines.push(line);
  }
  return lines;
}

/** Writes the names of rows, each around the middle of its row: uPlot would begin there. */
function drawNames(plot: uPlot, { names }: Axis): void {
  const { ctx, bbox } = plot;
  const pixel = devicePixelRatio;
  ctx.font = fontOf(NUMBERS_REM * pixel);
  ctx.fillStyle = colour('soft');
  ctx.textAlign = 'right';
  ctx.textBaseline = 'middle';
  for (const [row, name] of names.entries()) {
    const lines = linesOf(name);
    const middle = plot.valToPos(names.length - row - 0.5, 'y', true);
    for (const [index, line] of lines.entries()) {
      const below = (index - (lines.length - 1) / 2) * LINE_REM * rem() * pixel;
      ctx.fillText(line, bbox.left - GAP_PX * pixel, middle + below);
    }
  }
}

/** Numbers along an axis, with as many decimals as they differ by; names of rows are written apart. */
function labels(splits: readonly (number | null)[], of: Axis, language: string): string[] {
  if (of.names.length > 0) return of.names.map(() => '');
  if (of.scale.kind === 'log') return splits.map((split) => logLabel(split, splits, language));
  const step = Math.abs((splits[1] ?? 1) - (splits[0] ?? 0)) || 1;
  const decimals = decimalsOf(step);
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
