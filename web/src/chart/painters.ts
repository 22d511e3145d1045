/** Draws the layers of a panel over the axes of uPlot. */
import type uPlot from 'uplot';
import type { Dashes, Layer, Marker, Panel } from '../lab/index.ts';
import { colour, fontOf, tinted } from '../style/colours.ts';

type Context = CanvasRenderingContext2D;
type Value = number | null;

/** Radius of a point, in CSS pixels. */
const RADIUS = 3.5;
/** Lines are meant for pictures of text of 14 px. */
const STROKE = 0.9;

const DASHES: Record<Dashes, readonly number[]> = {
  solid: [],
  dashed: [6, 4],
  dotted: [2.5, 4],
  long: [18, 5],
};

export function drawLayers(plot: uPlot, { layers }: Panel): void {
  const { ctx, bbox } = plot;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  // Areas and standard errors must not hide points.
  for (const layer of layers) drawBelow(plot, layer);
  for (const layer of layers) drawAbove(plot, layer);
  ctx.restore();
}

const px = (plot: uPlot, x: Value): number =>
  x === null ? Number.NaN : plot.valToPos(x, 'x', true);
const py = (plot: uPlot, y: Value): number =>
  y === null ? Number.NaN : plot.valToPos(y, 'y', true);

function drawBelow(plot: uPlot, layer: Layer): void {
  const { ctx } = plot;
  ctx.fillStyle = tinted(layer.meaning, layer.strength);
  if (layer.kind === 'band') {
    ctx.beginPath();
    for (const [i, [x, low]] of layer.points.entries())
      to(ctx, i === 0, px(plot, x), py(plot, low));
    for (const [x, , high] of layer.points.toReversed())
      to(ctx, false, px(plot, x), py(plot, high));
    ctx.fill();
  } else if (layer.kind === 'boxes') {
    for (const [left, right, bottom, top] of layer.boxes) {
      // On whole pixels, so that there is no seam between neighbours; no bar is too thin to be seen.
      const [x, y] = [Math.round(px(plot, left)), Math.round(py(plot, top))];
      const [end, foot] = [Math.round(px(plot, right)), Math.round(py(plot, bottom))];
      ctx.fillRect(x, y, Math.max(1, end - x), foot - y);
    }
  } else if (layer.kind === 'points') {
    ctx.strokeStyle = tinted(layer.meaning, 0.35 * layer.strength);
    ctx.lineWidth = 4 * devicePixelRatio;
    ctx.beginPath();
    layer.points.forEach(([x, y], i) => {
      const sd = layer.errors[i];
      if (y === null || !sd) return;
      ctx.moveTo(px(plot, x), py(plot, y - sd));
      ctx.lineTo(px(plot, x), py(plot, y + sd));
    });
    ctx.stroke();
  }
}

function drawAbove(plot: uPlot, layer: Layer): void {
  const { ctx, bbox } = plot;
  ctx.strokeStyle = ctx.fillStyle = tinted(layer.meaning, layer.strength);
  switch (layer.kind) {
    case 'line':
      stroke(ctx, layer.width, layer.dashes, () => {
        let begins = true;
        for (const [x, y] of layer.points) {
          begins = !to(ctx, begins, px(plot, x), py(plot, y));
        }
      });
      break;
    case 'rule': {
      const [x, y] = [px(plot, layer.at), py(plot, layer.at)];
      const { left, top, width, height } = bbox;
      stroke(ctx, layer.width, layer.dashes, () => {
        ctx.moveTo(layer.upright ? x : left, layer.upright ? top : y);
        ctx.lineTo(layer.upright ? x : left + width, layer.upright ? top + height : y);
      });
      const right = x < left + width / 2;
      if (layer.upright) write(plot, layer.name, x, top + 15 * devicePixelRatio, right);
      break;
    }
    case 'points':
      for (const [x, y] of layer.points) drawPoint(plot, px(plot, x), py(plot, y), layer.marker);
      break;
    case 'labels':
      layer.points.forEach(([x, y], i) => {
        const foot = py(plot, y) + 4.5 * devicePixelRatio;
        write(plot, layer.texts[i] ?? '', px(plot, x), foot, true);
      });
  }
}

function stroke(ctx: Context, width: number, dashes: Dashes, path: () => void): void {
  ctx.lineWidth = STROKE * width * devicePixelRatio;
  ctx.setLineDash(DASHES[dashes].map((length) => length * devicePixelRatio));
  ctx.beginPath();
  path();
  ctx.stroke();
  ctx.setLineDash([]);
}

/** Continues the line to a point, or begins it there; false if there is no point. */
function to(ctx: Context, begins: boolean, x: number, y: number): boolean {
  if (Number.isNaN(x + y)) return false;
  if (begins) ctx.moveTo(x, y);
  else ctx.lineTo(x, y);
  return true;
}

/** A point; one above or below the panel is an arrow head at its edge. */
function drawPoint({ ctx, bbox }: uPlot, x: number, y: number, marker: Marker): void {
  const r = (marker === 'speck' ? 0.5 : 1) * RADIUS * devicePixelRatio;
  const bottom = bbox.top + bbox.height;
  ctx.beginPath();
  if (marker !== 'speck' && (y < bbox.top || y > bottom)) {
    const [tip, base] = y < bbox.top ? [bbox.top, bbox.top + 2 * r] : [bottom, bottom - 2 * r];
    triangle(ctx, x, tip, base, r);
    ctx.fill();
    return;
  }
  if (marker === 'triangle' || marker === 'open-triangle') triangle(ctx, x, y + r, y - r, 1.2 * r);
  else ctx.arc(x, y, r, 0, 2 * Math.PI);
  if (marker === 'ring' || marker === 'open-triangle') {
    const ink = ctx.fillStyle;
    ctx.fillStyle = colour('paper');
    ctx.fill();
    ctx.fillStyle = ink;
    ctx.lineWidth = 1.5 * devicePixelRatio;
    ctx.stroke();
  } else ctx.fill();
}

function triangle(ctx: Context, x: number, tip: number, base: number, half: number): void {
  ctx.moveTo(x, tip);
  ctx.lineTo(x - half, base);
  ctx.lineTo(x + half, base);
  ctx.closePath();
}

/** A label next to a point, moved until it is wholly visible. */
function write(plot: uPlot, words: string, x: number, foot: number, right: boolean): void {
  const { ctx, bbox } = plot;
  const gap = 6 * devicePixelRatio;
  ctx.font = fontOf(0.8125 * devicePixelRatio);
  ctx.textAlign = 'left';
  ctx.textBaseline = 'alphabetic';
  // A rim of paper keeps words legible over lines.
  ctx.strokeStyle = colour('paper');
  ctx.lineWidth = 4 * devicePixelRatio;
  ctx.lineJoin = 'round';
  const { width } = ctx.measureText(words);
  const from = right ? x + gap : x - gap - width;
  const left = Math.max(bbox.left, Math.min(from, bbox.left + bbox.width - width));
  ctx.strokeText(words, left, foot);
  ctx.fillText(words, left, foot);
}
