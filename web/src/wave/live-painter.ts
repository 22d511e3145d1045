/** Draws the last seconds of what is recorded. */
import type { SoFar } from '../lab/index.ts';
import type { LiveEnvelope } from '../sound/live-envelope.ts';
import { colour } from '../style/colours.ts';
import { CERTAIN } from './mark.ts';

export function paintLive(
  canvas: HTMLCanvasElement,
  envelope: LiveEnvelope,
  soFar: SoFar | null,
): void {
  const context = canvas.getContext('2d');
  if (!context) return;
  const ratio = devicePixelRatio;
  const { clientWidth: width, clientHeight: height } = canvas;
  if (canvas.width !== Math.round(width * ratio)) canvas.width = Math.round(width * ratio);
  if (canvas.height !== Math.round(height * ratio)) canvas.height = Math.round(height * ratio);
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);

  const bins = envelope.seconds * envelope.binsPerSecond;
  const first = Math.max(0, envelope.newest - bins);
  const step = width / bins;
  const middle = height / 2;
  const peak = loudest(envelope, first);
  context.fillStyle = colour('line');
  context.fillRect(0, middle - 0.5, width, 1);
  context.fillStyle = colour('edge');
  for (let bin = first; bin <= envelope.newest; bin += 1) {
    const [low, high] = envelope.bin(bin);
    const top = middle - (high / peak) * (middle - 8);
    const tall = Math.max(1, ((high - low) / peak) * (middle - 8));
    context.fillRect((bin - first) * step, top, Math.max(step, 0.75), tall);
  }
  for (const impact of soFar?.drop?.impacts ?? []) {
    const x = (impact.time_s * envelope.binsPerSecond - first) * step;
    if (x < 0 || x > width) continue;
    const certain = impact.probability >= CERTAIN;
    context.strokeStyle = colour(certain ? 'measured' : 'warning');
    context.setLineDash(certain ? [] : [4, 3]);
    context.beginPath();
    context.moveTo(x, 4);
    context.lineTo(x, height - 4);
    context.stroke();
  }
  context.setLineDash([]);
}

/** The largest visible magnitude, but at least the level of a whisper, so that noise is drawn small. */
function loudest(envelope: LiveEnvelope, first: number): number {
  let peak = 0.01;
  for (let bin = first; bin <= envelope.newest; bin += 1) {
    const [low, high] = envelope.bin(bin);
    peak = Math.max(peak, high, -low);
  }
  return peak;
}
