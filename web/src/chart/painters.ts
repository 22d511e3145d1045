/** What uPlot does not draw by itself: error bars, stacked bars, levels and direct labels. */
import type uPlot from 'uplot';
import { colour, fontOf, type Meaning } from '../style/colours.ts';
import type { ChartSpec, Layer, Line } from './spec.ts';

/** Ink for words in a colour: as dark as reading needs. */
export function inkOf(meaning: Meaning): string {
  if (meaning === 'drag') return colour('drag-text');
  if (meaning === 'plain') return colour('plain-text');
  if (meaning === 'warning') return colour('ink');
  return colour(meaning);
}

const px = (plot: uPlot, x: number): number => plot.valToPos(x, 'x', true);
const py = (plot: uPlot, y: number): number => plot.valToPos(y, 'y', true);

function clipped(plot: uPlot, draw: (context: CanvasRenderingContext2D) => void): void {
  const { ctx, bbox } = plot;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  draw(ctx);
  ctx.restore();
}

export function drawErrors(plot: uPlot, spec: ChartSpec): void {
  clipped(plot, (context) => {
    for (const layer of spec.layers) {
      if (layer.kind !== 'points' || !layer.sd) continue;
      context.strokeStyle = colour(layer.meaning);
      context.lineWidth = 1.25 * devicePixelRatio;
      context.beginPath();
      layer.x.forEach((x, i) => {
        const y = layer.y[i];
        const sd = layer.sd?.[i];
        if (y === null || y === undefined || !sd) return;
        context.moveTo(px(plot, x), py(plot, y - sd));
        context.lineTo(px(plot, x), py(plot, y + sd));
      });
      context.stroke();
    }
  });
}

export function drawBars(plot: uPlot, spec: ChartSpec): void {
  clipped(plot, (context) => {
    for (const layer of spec.layers) {
      if (layer.kind !== 'bars') continue;
      context.fillStyle = colour(layer.meaning);
      const half = Math.max(1, 0.35 * Math.abs(px(plot, 1) - px(plot, 0)));
      layer.x.forEach((x, i) => {
        const top = py(plot, layer.y[i] as number);
        const foot = py(plot, layer.from?.[i] ?? 0);
        context.fillRect(px(plot, x) - half, top, 2 * half, foot - top);
      });
    }
  });
}

export function drawLevels(plot: uPlot, spec: ChartSpec): void {
  const { ctx: context, bbox } = plot;
  for (const level of spec.levels ?? []) {
    const at = level.upright ? px(plot, level.at) : py(plot, level.at);
    const inside = level.upright
      ? at >= bbox.left && at <= bbox.left + bbox.width
      : at >= bbox.top && at <= bbox.top + bbox.height;
    if (!inside) continue;
    context.save();
    context.strokeStyle = colour(level.meaning);
    context.lineWidth = 1.5 * devicePixelRatio;
    context.setLineDash([5 * devicePixelRatio, 4 * devicePixelRatio]);
    context.beginPath();
    context.moveTo(level.upright ? at : bbox.left, level.upright ? bbox.top : at);
    context.lineTo(
      level.upright ? at : bbox.left + bbox.width,
      level.upright ? bbox.top + bbox.height : at,
    );
    context.stroke();
    const pad = 5 * devicePixelRatio;
    if (level.upright) {
      const room = at < bbox.left + bbox.width / 2;
      write(
        plot,
        level.label,
        at + (room ? pad : -pad),
        bbox.top + 3 * pad,
        level.meaning,
        room ? 'left' : 'right',
      );
    } else write(plot, level.label, bbox.left + pad, at - pad, level.meaning, 'left');
    context.restore();
  }
}

/**
 * Curves are named beside them: no key to look up. Curves that only rise or fall have their name at
 * their middle, on the side that is free; others at their end. Points are named in the key above.
 */
export function drawLabels(plot: uPlot, spec: ChartSpec): void {
  const gap = 8 * devicePixelRatio;
  const height = 16 * devicePixelRatio;
  let steady = 0;
  let wavy = 0;
  for (const layer of spec.layers) {
    if (layer.kind !== 'line' || layer.label === '') continue;
    const seen = inSight(plot, layer);
    const [first, end] = [seen[0], seen.at(-1)];
    if (!first || !end) continue;
    const middleX = first.x + 0.6 * (end.x - first.x);
    const middle = seen.find(({ x }) => x >= middleX) ?? end;
    if (isSteady(seen)) {
      const falls = first.y <= end.y;
      const above = steady % 2 === 0;
      const y = above ? middle.y - gap : middle.y + gap + height / 2;
      const right = falls === above;
      write(
        plot,
        layer.label,
        middle.x + (right ? gap : -gap),
        y,
        layer.meaning,
        right ? 'left' : 'right',
      );
      steady += 1;
    } else {
      write(plot, layer.label, end.x, end.y - gap - wavy * height, layer.meaning, 'right');
      wavy += 1;
    }
  }
}

interface Place {
  readonly x: number;
  readonly y: number;
}

function inSight(plot: uPlot, layer: Line): readonly Place[] {
  const { left, top, width, height } = plot.bbox;
  return layer.x.flatMap((at, i) => {
    const value = layer.y[i];
    if (value === null || value === undefined) return [];
    const place = { x: px(plot, at), y: py(plot, value) };
    const inside =
      place.x >= left - 1 &&
      place.x <= left + width + 1 &&
      place.y >= top - 1 &&
      place.y <= top + height + 1;
    return inside ? [place] : [];
  });
}

/** Whether a curve only rises or only falls. */
function isSteady(places: readonly Place[]): boolean {
  const steps = places.slice(1).map((place, i) => place.y - (places[i]?.y ?? place.y));
  return steps.every((step) => step >= -0.5) || steps.every((step) => step <= 0.5);
}

/** Words beside a place, moved as far as it takes to be whole. */
function write(
  plot: uPlot,
  words: string,
  x: number,
  y: number,
  meaning: Meaning,
  align: 'left' | 'right',
): void {
  const { ctx: context, bbox } = plot;
  context.save();
  context.font = fontOf(0.8125 * devicePixelRatio);
  context.textAlign = 'left';
  context.textBaseline = 'alphabetic';
  context.setLineDash([]);
  // A rim of paper keeps words legible over lines.
  context.strokeStyle = colour('paper');
  context.lineWidth = 4 * devicePixelRatio;
  context.lineJoin = 'round';
  const { width } = context.measureText(words);
  const from = align === 'left' ? x : x - width;
  const left = Math.max(bbox.left, Math.min(from, bbox.left + bbox.width - width));
  const foot = Math.min(y, bbox.top + bbox.height - 4 * devicePixelRatio);
  context.strokeText(words, left, foot);
  context.fillStyle = inkOf(meaning);
  context.fillText(words, left, foot);
  context.restore();
}

/** The kinds of layer whose names stand in the key. */
export const inKey = (layer: Layer): boolean => layer.kind !== 'line' && layer.label !== '';
