import { computed, signal } from '@preact/signals';
import { useRef } from 'preact/hooks';
import { Term } from '../../app/Term.tsx';
import { Chart } from '../../chart/Chart.tsx';
import { NumbersOf } from '../../chart/NumbersOf.tsx';
import { figure, figures, show, shown } from '../../state/figures.ts';
import { text } from '../../text/language.ts';
import { SaveFigure } from './SaveFigure.tsx';

/** The figures of a lesson; the others are there for those who want more. */
const SCHOOL = ['restitution', 'height', 'bounce-energies', 'flight-times'];

const more = signal(false);
const offered = computed(() => {
  const isOfSchool = ({ name }: { readonly name: string }): boolean => SCHOOL.includes(name);
  const placeOf = ({ name }: { readonly name: string }): number => SCHOOL.indexOf(name);
  const school = figures.value.filter(isOfSchool).sort((a, b) => placeOf(a) - placeOf(b));
  // What is compared with a simulation was asked for.
  const isShown = (figure: { readonly name: string }): boolean =>
    !isOfSchool(figure) && (more.value || figure.name === shown.value);
  return [...school, ...figures.value.filter(isShown)];
});

/** One figure at a time, each with one sentence on what to see in it. */
export function FigureTabs() {
  if (figures.value.length === 0) return null;
  return (
    <section class="figures" aria-label={text('page-figures-title')}>
      <div class="choose">
        <Tabs />
        <button
          type="button"
          class="quiet"
          aria-expanded={more.value}
          onClick={() => {
            more.value = !more.value;
          }}
        >
          {more.value ? text('page-figures-fewer') : text('page-figures-more')}
        </button>
      </div>
      <Panel />
    </section>
  );
}

function Tabs() {
  const list = useRef<HTMLDivElement>(null);
  const all = offered.value;
  const step = (by: number): void => {
    const at = all.findIndex(({ name }) => name === shown.peek());
    const next = all[(at + by + all.length) % all.length];
    if (!next) return;
    show(next.name);
    list.current?.querySelector<HTMLElement>(`#tab-${next.name}`)?.focus();
  };
  return (
    <div
      ref={list}
      class="tabs"
      role="tablist"
      aria-label={text('page-figures-title')}
      onKeyDown={(event) => {
        if (event.key === 'ArrowRight') step(1);
        else if (event.key === 'ArrowLeft') step(-1);
        else return;
        event.preventDefault();
      }}
    >
      {all.map(({ name, tab }) => (
        <button
          key={name}
          id={`tab-${name}`}
          type="button"
          role="tab"
          aria-selected={shown.value === name}
          aria-controls="figure"
          tabIndex={shown.value === name ? 0 : -1}
          onClick={() => {
            show(name);
          }}
        >
          {tab}
        </button>
      ))}
    </div>
  );
}

function Panel() {
  const chart = figure.value;
  const some = chart !== null && chart.panels.length > 0;
  const term = figures.value.find(({ name }) => name === shown.value)?.tab ?? '';
  return (
    <div id="figure" role="tabpanel" aria-labelledby={`tab-${shown.value}`}>
      <figure class="figure-box" aria-busy={chart === null}>
        <div>
          <Term word={shown.value}>{term}</Term>
        </div>
        <figcaption>{chart?.caption}</figcaption>
        {some ? <Chart chart={chart} /> : <div class="chart waiting" />}
        {some && (
          <div class="row no-print">
            <SaveFigure name={shown.value} />
            <span class="small soft mouse">{text('page-figures-reset')}</span>
          </div>
        )}
        {some && <NumbersOf chart={chart} />}
      </figure>
    </div>
  );
}
