/** Shows the value of the point nearest to the pointer, also after a tap. */
import type uPlot from 'uplot';
import { NUMBER, rounded } from '../format/quantity.ts';
import type { Panel } from '../lab/index.ts';
import { type Point, pointsOf } from './points.ts';

const REACH = 28;

export function tip(panel: Panel, language: string): uPlot.Plugin {
  const points = panel.layers.flatMap(pointsOf);
  const box = document.createElement('div');
  box.className = 'tip';
  box.hidden = true;

  const update = (plot: uPlot): void => {
    const { left = -1, top = -1 } = plot.cursor;
    const found = left < 0 ? undefined : nearest(plot, points, left, top);
    box.hidden = found === undefined;
    if (!found) return;
    const number = (value: number): string => rounded(value, 4, NUMBER, language);
    // Along an axis of names there is nothing to read.
    const numbers = panel.y.names.length > 0 ? [found.x] : [found.x, found.y];
    box.textContent = [...numbers.map(number), found.name].filter(Boolean).join(' · ');
    const half = Math.min(box.offsetWidth / 2, plot.over.clientWidth / 2);
    const at = Math.min(Math.max(found.left, half), plot.over.clientWidth - half);
    box.style.left = `${at}px`;
    box.style.top = `${found.top}px`;
  };

  return { hooks: { init: (plot) => plot.over.append(box), setCursor: update } };
}

interface Found extends Point {
  readonly left: number;
  readonly top: number;
}

function nearest(
  plot: uPlot,
  points: readonly Point[],
  left: number,
  top: number,
): Found | undefined {
  let found: Found | undefined;
  let least = REACH ** 2;
  for (const point of points) {
    const place = { left: plot.valToPos(point.x, 'x'), top: plot.valToPos(point.y, 'y') };
    const distance = (place.left - left) ** 2 + (place.top - top) ** 2;
    if (distance < least) {
      least = distance;
      found = { ...point, ...place };
    }
  }
  return found;
}
