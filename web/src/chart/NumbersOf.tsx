import { signal } from '@preact/signals';
import { fixed, NUMBER, rounded } from '../format/quantity.ts';
import type { Axis, Chart, Layer, Panel } from '../lab/index.ts';
import { language, text } from '../text/language.ts';
import { labelOf, type Point, pointsOf } from './points.ts';

const open = signal(false);
/** A curve of hundreds of points is better seen than read. */
const MAX_ROWS = 60;

/** The numbers behind a chart, for those who do not see it and those who want digits. */
export function NumbersOf({ chart }: { readonly chart: Chart }) {
  return (
    <details
      class="no-print"
      open={open.value}
      onToggle={(event) => {
        open.value = event.currentTarget.open;
      }}
    >
      <summary>{text('page-figures-numbers')}</summary>
      {open.value &&
        chart.panels.map((panel, index) => (
          <Table
            key={index}
            panel={panel}
            place={chart.panels.length > 1 ? index + 1 : undefined}
          />
        ))}
    </details>
  );
}

/** The heading of a column; an axis without a name has none. */
function Heading({ axis }: { readonly axis: Axis }) {
  const label = labelOf(axis);
  return label === '' ? <td /> : <th class="figure">{label}</th>;
}

/** The numbers of a panel; its place among several is part of its name. */
function Table({
  panel: { x, y, layers },
  place,
}: {
  readonly panel: Panel;
  readonly place: number | undefined;
}) {
  const label = [place, labelOf(y) || labelOf(x)].filter((part) => part !== undefined).join(' ');
  const number = (value: number, axis: Axis): string => {
    if (axis.names.length > 0) return axis.names.at(-Math.ceil(value)) ?? '';
    return axis.scale.kind === 'counting'
      ? fixed(value, 0, language.value)
      : rounded(value, 4, NUMBER, language.value);
  };
  return (
    <section class="scroll impacts" tabIndex={0} aria-label={label}>
      <table>
        <thead>
          <tr>
            <Heading axis={x} />
            <Heading axis={y} />
            <td />
          </tr>
        </thead>
        <tbody>
          {layers.flatMap(rowsOf).map((row, index) => (
            <tr key={index}>
              <td class="figure">{number(row.x, x)}</td>
              <td class="figure">{number(row.y, y)}</td>
              <td>{row.name}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}

function rowsOf(layer: Layer): readonly Point[] {
  const points = pointsOf(layer);
  const every = Math.max(1, Math.ceil(points.length / MAX_ROWS));
  return points.filter((_, index) => index % every === 0);
}
