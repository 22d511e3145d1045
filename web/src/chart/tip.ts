/** Shows the value of the point nearest to the pointer, also after a tap. */
import type uPlot from 'uplot';
import { PLAIN, plain } from '../format/quantity.ts';
import type { ChartSpec } from './spec.ts';

const REACH = 28;

export function tip(spec: ChartSpec, language: string): uPlot.Plugin {
  const box = document.createElement('div');
  box.className = 'tip';
  box.hidden = true;

  const update = (plot: uPlot): void => {
    const { left = -1, top = -1 } = plot.cursor;
    const found = left < 0 ? undefined : nearestPoint(plot, spec, left, top);
    box.hidden = found === undefined;
    if (!found) return;
    const number = (value: number): string => plain(value, PLAIN, 4, language);
    box.textContent = `${number(found.x)} · ${number(found.y)}${found.label ? ` · ${found.label}` : ''}`;
    const half = Math.min(box.offsetWidth / 2, plot.over.clientWidth / 2);
    const at = Math.min(Math.max(found.left, half), plot.over.clientWidth - half);
    box.style.left = `${at}px`;
    box.style.top = `${found.top}px`;
  };

  return {
    hooks: {
      init: (plot) => plot.over.append(box),
      setCursor: update,
    },
  };
}

interface Found {
  readonly x: number;
  readonly y: number;
  readonly left: number;
  readonly top: number;
  readonly label: string;
}

function nearestPoint(plot: uPlot, spec: ChartSpec, left: number, top: number): Found | undefined {
  let found: Found | undefined;
  let least = REACH ** 2;
  for (const layer of spec.layers) {
    if (layer.kind === 'band') continue;
    layer.x.forEach((x, i) => {
      const y = layer.y[i];
      if (y === null || y === undefined) return;
      const place = { left: plot.valToPos(x, 'x'), top: plot.valToPos(y, 'y') };
      const distance = (place.left - left) ** 2 + (place.top - top) ** 2;
      if (distance < least) {
        least = distance;
        found = { x, y, ...place, label: layer.label };
      }
    });
  }
  return found;
}
