/** Draws a part of a sound with its marks onto a canvas. Nothing here knows of events or state. */
import { colour } from '../style/colours.ts';
import { CERTAIN, type Mark } from './mark.ts';
import { columnOf, covers, levelFor, type Part, type Pyramid } from './pyramid.ts';
import { tickDecimals, ticks, type Viewport, widthS } from './viewport.ts';

/** Space for the flags of the marks above and the ruler below, and between ticks, for texts of 16 px. */
const FLAGS = 22;
const RULER = 20;
const TICK_SPACING = 66;

/** Colours of one theme, read once and not for every frame. */
export interface Palette {
  readonly wave: string;
  readonly axis: string;
  readonly grid: string;
  readonly text: string;
  readonly mark: string;
  readonly doubtful: string;
  readonly chosen: string;
  readonly paper: string;
}

export function palette(): Palette {
  return {
    wave: colour('edge'),
    axis: colour('edge'),
    grid: colour('line'),
    text: colour('soft'),
    mark: colour('measured'),
    doubtful: colour('warning'),
    chosen: colour('measured-tint'),
    paper: colour('paper'),
  };
}

export interface Scene {
  readonly pyramid: Pyramid;
  /** The samples in sight, if they were read. */
  readonly part: Part | null;
  readonly view: Viewport;
  /** The height of a sample as a share of what there is above the middle. */
  readonly heightOf: (sample: number) => number;
  readonly marks: readonly Mark[];
  readonly selected: number | null;
  readonly cursorS: number | null;
  readonly playheadS: number | null;
  readonly seconds: (value: number, decimals: number) => string;
}

/** What a canvas needs to know of its screen. */
export interface Surface {
  readonly context: CanvasRenderingContext2D;
  readonly width: number;
  readonly height: number;
  readonly ratio: number;
  /** How much larger than 16 px the text of the page is. */
  readonly scale: number;
  readonly font: string;
  readonly palette: Palette;
}

export const xOf = (timeS: number, view: Viewport, width: number): number =>
  ((timeS - view.startS) / widthS(view)) * width;

export const timeAt = (x: number, view: Viewport, width: number): number =>
  view.startS + (x / width) * widthS(view);

export function paint(surface: Surface, scene: Scene): void {
  const { context, width, height, ratio } = surface;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  paintRuler(surface, scene);
  paintChosen(surface, scene);
  paintSound(surface, scene);
  paintMarks(surface, scene);
  paintLine(surface, scene, scene.cursorS, surface.palette.text, [2, 3]);
  paintLine(surface, scene, scene.playheadS, surface.palette.doubtful, []);
}

function paintRuler(surface: Surface, { view, seconds }: Scene): void {
  const { context, width, height, scale, font, palette: colours } = surface;
  const spacing = TICK_SPACING * scale;
  context.font = font;
  context.textBaseline = 'alphabetic';
  context.fillStyle = colours.text;
  context.strokeStyle = colours.grid;
  context.lineWidth = 1;
  const decimals = tickDecimals(view, width, spacing);
  context.beginPath();
  for (const tick of ticks(view, width, spacing)) {
    const x = Math.round(xOf(tick, view, width)) + 0.5;
    context.moveTo(x, FLAGS * scale);
    context.lineTo(x, height - RULER * scale);
    const label = seconds(tick, decimals);
    const half = context.measureText(label).width / 2;
    const at = Math.min(Math.max(x, half + 1), width - half - 1);
    context.fillText(label, at - half, height - 5 * scale);
  }
  context.stroke();
}

/** Height of the sound above and below its middle. */
function frame({ height, scale }: Surface): { middle: number; half: number } {
  const free = height - (FLAGS + RULER) * scale;
  return { middle: FLAGS * scale + free / 2, half: free / 2 - 2 };
}

function paintSound(surface: Surface, scene: Scene): void {
  const { width, ratio } = surface;
  const perColumn = (widthS(scene.view) * scene.pyramid.rateHz) / (width * ratio);
  const finest = scene.pyramid.levels[0];
  if (!finest) return;
  const { part, pyramid, view } = scene;
  const isClose = perColumn < finest.samplesPerBin;
  if (part && isClose && covers(part, view, pyramid.frames)) paintSamples(surface, scene, part);
  else paintColumns(surface, scene, perColumn);
}

let columns = new Float32Array(0);

function paintColumns(surface: Surface, scene: Scene, perColumn: number): void {
  const { context, width, ratio, palette: colours } = surface;
  const { pyramid, view, heightOf } = scene;
  const level = levelFor(pyramid, perColumn);
  if (!level) return;
  const count = Math.ceil(width * ratio);
  if (columns.length < 2 * count) columns = new Float32Array(2 * count);
  const from = view.startS * pyramid.rateHz;
  const { middle, half } = frame(surface);
  const step = 1 / ratio;
  context.fillStyle = colours.wave;
  context.beginPath();
  for (let column = 0; column < count; column += 1) {
    const first = from + column * perColumn;
    if (first >= pyramid.frames) break;
    columnOf(level, first, first + perColumn, columns, column);
    const low = half * heightOf(columns[2 * column] as number);
    const high = half * heightOf(columns[2 * column + 1] as number);
    context.rect(column * step, middle - high, step, Math.max(high - low, step));
  }
  context.fill();
}

/** Closer than the pyramid: the samples themselves, joined by a line. */
function paintSamples(surface: Surface, scene: Scene, { rateHz, from, samples }: Part): void {
  const { context, width, palette: colours } = surface;
  const { view, heightOf } = scene;
  const { middle, half } = frame(surface);
  const first = Math.max(0, Math.floor(view.startS * rateHz) - from);
  const last = Math.min(samples.length - 1, Math.ceil(view.endS * rateHz) - from);
  context.strokeStyle = colours.wave;
  context.lineWidth = 1.25;
  context.lineJoin = 'round';
  context.beginPath();
  for (let i = first; i <= last; i += 1) {
    const x = xOf((from + i) / rateHz, view, width);
    const y = middle - half * heightOf(samples[i] as number);
    if (i === first) context.moveTo(x, y);
    else context.lineTo(x, y);
  }
  context.stroke();
}

/** The chosen mark stands on a tint, under the sound. */
function paintChosen(surface: Surface, { marks, view, selected }: Scene): void {
  const { context, width, height, scale, palette: colours } = surface;
  const mark = marks.find(({ id }) => id === selected);
  if (!mark) return;
  const x = xOf(mark.timeS, view, width);
  context.fillStyle = colours.chosen;
  context.fillRect(x - 7 * scale, FLAGS * scale, 14 * scale, height - (FLAGS + RULER) * scale);
}

function paintMarks(surface: Surface, { marks, view, selected }: Scene): void {
  const { context, width, height, scale, palette: colours } = surface;
  const [flags, foot] = [FLAGS * scale, height - RULER * scale];
  let lastLabel = Number.NEGATIVE_INFINITY;
  let lastX = Number.NEGATIVE_INFINITY;
  marks.forEach((mark, index) => {
    const x = xOf(mark.timeS, view, width);
    if (x < -12 || x > width + 12) return;
    const certain = mark.probability >= CERTAIN;
    const chosen = mark.id === selected;
    const at = Math.round(x) + 0.5;
    context.strokeStyle = certain ? colours.mark : colours.doubtful;
    context.lineWidth = chosen ? 2 : 1;
    // Where the marks stand close the sound must stay in sight.
    context.globalAlpha = chosen ? 1 : 0.25 + 0.5 * Math.min(1, (x - lastX) / 24);
    lastX = x;
    context.setLineDash(certain ? [] : [4, 3]);
    context.beginPath();
    context.moveTo(at, flags - 4 * scale);
    context.lineTo(at, foot);
    context.stroke();
    context.setLineDash([]);
    context.globalAlpha = 1;
    paintFlag(surface, at, certain, chosen);
    const label = String(index + 1);
    if (chosen || x - lastLabel > 22 * scale) {
      context.fillStyle = chosen ? colours.mark : colours.text;
      context.fillText(label, at - context.measureText(label).width / 2, 11 * scale);
      lastLabel = x;
    }
  });
}

/** A disc when certain, a ring when not: the colour is never the only sign. */
function paintFlag(surface: Surface, x: number, certain: boolean, chosen: boolean): void {
  const { context, scale, palette: colours } = surface;
  context.beginPath();
  context.arc(x, (FLAGS - 5) * scale, (chosen ? 5 : 3.5) * scale, 0, 2 * Math.PI);
  context.fillStyle = certain ? colours.mark : colours.paper;
  context.fill();
  context.strokeStyle = certain ? colours.mark : colours.doubtful;
  context.lineWidth = 1.5;
  context.stroke();
}

function paintLine(
  surface: Surface,
  { view }: Scene,
  timeS: number | null,
  stroke: string,
  dash: number[],
): void {
  if (timeS === null || timeS < view.startS || timeS > view.endS) return;
  const { context, width, height, scale } = surface;
  const x = Math.round(xOf(timeS, view, width)) + 0.5;
  context.strokeStyle = stroke;
  context.lineWidth = 1.5;
  context.setLineDash(dash);
  context.beginPath();
  context.moveTo(x, FLAGS * scale);
  context.lineTo(x, height - RULER * scale);
  context.stroke();
  context.setLineDash([]);
}
