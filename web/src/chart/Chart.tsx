import { useEffect, useRef } from 'preact/hooks';
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { dark } from '../style/colours.ts';
import { language } from '../text/language.ts';
import { optionsOf } from './options.ts';
import type { ChartSpec } from './spec.ts';
import { dataOf } from './table.ts';

/** A chart of the page; its sentence and its numbers stand beside it. */
export function Chart({ spec, label }: { readonly spec: ChartSpec; readonly label: string }) {
  const box = useRef<HTMLDivElement>(null);
  const isDark = dark.value;
  const spoken = language.value;

  useEffect(() => {
    const element = box.current;
    if (!element) return undefined;
    let plot: uPlot | undefined;
    const build = (): void => {
      plot?.destroy();
      plot = undefined;
      const width = element.clientWidth;
      if (width > 0) plot = new uPlot(optionsOf(spec, width, spoken), dataOf(spec), element);
    };
    const watcher = new ResizeObserver(() => {
      const width = element.clientWidth;
      if (!plot) build();
      else if (width > 0 && width !== plot.width) plot.setSize({ width, height: plot.height });
    });
    watcher.observe(element);
    build();
    return () => {
      watcher.disconnect();
      plot?.destroy();
    };
  }, [spec, isDark, spoken]);

  return <div ref={box} class="chart" role="img" aria-label={label} />;
}
