/** Draws a panel with uPlot, which is loaded with the first chart. */
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import type { Panel } from '../lab/index.ts';
import { dataOf, optionsOf } from './options.ts';

/** Draws the first panel of a row into an element, whose width it follows until the returned function is called. */
export function plot(row: readonly Panel[], element: HTMLElement, language: string): () => void {
  const panel = row[0] as Panel;
  let drawn: uPlot | undefined;
  const build = (): void => {
    const width = element.clientWidth;
    if (width > 0) drawn = new uPlot(optionsOf(row, width, language), dataOf(panel), element);
  };
  const watcher = new ResizeObserver(() => {
    const width = element.clientWidth;
    if (!drawn) build();
    else if (width > 0 && width !== drawn.width) drawn.setSize({ width, height: drawn.height });
  });
  watcher.observe(element);
  build();
  return () => {
    watcher.disconnect();
    drawn?.destroy();
  };
}
