import { signal } from '@preact/signals';
import { fixed, PLAIN, plain } from '../format/quantity.ts';
import { language, texts } from '../text/language.ts';
import type { Axis, ChartSpec, Layer } from './spec.ts';

const open = signal(false);
/** A curve of hundreds of points is better seen than read. */
const MOST_ROWS = 60;

/** The numbers behind charts, for those who do not see them and those who want digits. */
export function NumbersOf({ charts }: { readonly charts: readonly ChartSpec[] }) {
  const words = texts.value.figures;
  return (
    <details
      class="no-print"
      open={open.value}
      onToggle={(event) => {
        open.value = event.currentTarget.open;
      }}
    >
      <summary>{words.numbers}</summary>
      {open.value && charts.map((spec, index) => <Table key={index} spec={spec} />)}
    </details>
  );
}

function Table({ spec }: { readonly spec: ChartSpec }) {
  const rows = spec.layers.flatMap(rowsOf);
  const number = (value: number, { counting = false }: Axis): string =>
    counting ? fixed(value, 0, language.value) : plain(value, PLAIN, 4, language.value);
  return (
    <section class="scroll impacts" tabIndex={0} aria-label={spec.y.label}>
      <table>
        <thead>
          <tr>
            <th class="figure">{spec.x.label}</th>
            <th class="figure">{spec.y.label}</th>
            <td />
          </tr>
        </thead>
        <tbody>
          {rows.map((row, index) => (
            <tr key={index}>
              <td class="figure">{number(row.x, spec.x)}</td>
              <td class="figure">{number(row.y, spec.y)}</td>
              <td>{row.label}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}

function rowsOf(layer: Layer): { x: number; y: number; label: string }[] {
  if (layer.kind === 'band') return [];
  const every = Math.max(1, Math.ceil(layer.x.length / MOST_ROWS));
  return layer.x.flatMap((x, i) => {
    const y = layer.y[i];
    return y === null || y === undefined || i % every !== 0 ? [] : [{ x, y, label: layer.label }];
  });
}
