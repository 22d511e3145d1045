import { useEffect, useRef } from 'preact/hooks';
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { dark } from '../style/colours.ts';
import { language, texts } from '../text/language.ts';
import { optionsOf } from './options.ts';
import type { ChartSpec } from './spec.ts';
import { dataOf } from './table.ts';

/** A chart of the page, named by its axes; its sentence and its numbers stand beside it. */
export function Chart({ spec }: { readonly spec: ChartSpec }) {
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

  const label = texts.value.figures.against(spec.y.label, spec.x.label);
  return <div ref={box} class="chart" role="img" aria-label={label} />;
}
