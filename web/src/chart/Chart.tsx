import { useEffect, useMemo, useRef } from 'preact/hooks';
import type { Axis, Chart as Description, Layer, Panel } from '../lab/index.ts';
import { dark } from '../style/colours.ts';
import { media } from '../style/media.ts';
import { language, text } from '../text/language.ts';
import { labelOf, legendOf } from './points.ts';

/** Below this width the panels stand one below the other, as in the style sheet. */
const isNarrow = media('(max-width: 47.99rem)');

/** A panel that does not share the axes of its neighbours. */
function standingAlone(panel: Panel, { panels }: Description): Panel {
  const first = panels.find(({ row }) => row === panel.row)?.y ?? panel.y;
  const x: Axis = panel.x.ticks === 'grid' ? { ...panel.x, ticks: 'labelled' } : panel.x;
  const shared = panel.y.ticks !== 'labelled' && panel.y.scale.high === first.scale.high;
  return { ...panel, x, y: shared ? first : panel.y };
}

/** A chart of the engine that can be zoomed, with its legend; its caption and its numbers stand next to it. */
export function Chart({ chart }: { readonly chart: Description }) {
  const narrow = isNarrow.value && chart.columns.length > 1;
  const panels = useMemo(() => {
    const { panels: all } = chart;
    if (narrow) return all.map((panel) => standingAlone(panel, chart)).map((alone) => [alone]);
    return all.map((panel) => [panel, ...all.filter((it) => it !== panel && it.row === panel.row)]);
  }, [chart, narrow]);
  const columns = chart.columns.map((share) => `minmax(min(100%, 11rem), ${share}fr)`).join(' ');
  return (
    <>
      <Legend layers={chart.panels.flatMap(({ layers }) => layers)} />
      <div class="panels" style={{ '--columns': columns }}>
        {panels.map((row, index) => (
          <Plot key={index} row={row} />
        ))}
      </div>
    </>
  );
}

/** Whether the upright axis has a name. */
const isNamed = ({ y }: Panel): boolean => y.ticks === 'labelled' && y.quantity !== '';

/** The first panel of a row, named by its axes, in line with the others. */
function Plot({ row }: { readonly row: readonly Panel[] }) {
  const panel = row[0] as Panel;
  const box = useRef<HTMLDivElement>(null);
  const isDark = dark.value;
  const spoken = language.value;

  useEffect(() => {
    const element = box.current;
    if (!element) return undefined;
    let current = true;
    let clear = (): void => undefined;
    void import('./plot.ts').then(({ plot }) => {
      if (current) clear = plot(row, element, spoken);
    });
    return () => {
      current = false;
      clear();
    };
  }, [row, isDark, spoken]);
  const name =
    panel.title || text('page-figures-against', { y: labelOf(panel.y), x: labelOf(panel.x) });
  return (
    <div class="panel" style={{ gridColumn: panel.column + 1, gridRow: panel.row + 1 }}>
      {panel.title !== '' && <strong class="small">{panel.title}</strong>}
      {row.some(isNamed) && (
        <div class="small soft" aria-hidden="true">
          {isNamed(panel) ? labelOf(panel.y) : '\u00a0'}
        </div>
      )}
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
