import { useEffect, useRef } from 'preact/hooks';
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import type { Chart as Description, Layer, Panel } from '../lab/index.ts';
import { dark } from '../style/colours.ts';
import { language, text } from '../text/language.ts';
import { dataOf, optionsOf } from './options.ts';
import { labelOf, legendOf } from './points.ts';

/** A chart of the engine that can be zoomed, with its legend; its sentence and its numbers stand beside it. */
export function Chart({ chart }: { readonly chart: Description }) {
  const columns = chart.columns.map((share) => `minmax(min(100%, 11rem), ${share}fr)`).join(' ');
  return (
    <>
      <Legend layers={chart.panels.flatMap(({ layers }) => layers)} />
      <div class="panels" style={{ '--columns': columns }}>
        {chart.panels.map((panel, index) => (
          <Plot key={index} panel={panel} />
        ))}
      </div>
    </>
  );
}

/** A panel, named by its axes. */
function Plot({ panel }: { readonly panel: Panel }) {
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
      if (width > 0) plot = new uPlot(optionsOf(panel, width, spoken), dataOf(panel), element);
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
  }, [panel, isDark, spoken]);
  const name =
    panel.title || text('page-figures-against', { y: labelOf(panel.y), x: labelOf(panel.x) });
  return (
    <div class="panel" style={{ gridColumn: panel.column + 1, gridRow: panel.row + 1 }}>
      {panel.title !== '' && <strong class="small">{panel.title}</strong>}
      <div ref={box} class="chart" role="img" aria-label={name} />
    </div>
  );
}

function Legend({ layers }: { readonly layers: readonly Layer[] }) {
  const named = legendOf(layers).filter((layer) => !(layer.kind === 'rule' && layer.upright));
  if (named.length < 2) return null;
  return (
    <ul class="legend">
      {named.map((layer) => (
        <li key={layer.name}>
          <span
            class={`marker ${shapeOf(layer)}`}
            style={{ color: `var(--${layer.meaning})`, opacity: Math.max(0.3, layer.strength) }}
            aria-hidden="true"
          />
          {layer.name}
        </li>
      ))}
    </ul>
  );
}

function shapeOf(layer: Layer): string {
  if (layer.kind === 'points') return layer.marker;
  return layer.kind === 'line' || layer.kind === 'rule' ? `stroke ${layer.dashes}` : 'patch';
}
