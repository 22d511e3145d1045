import { signal } from '@preact/signals';
import { useMemo, useRef } from 'preact/hooks';
import { Chart } from '../../chart/Chart.tsx';
import { Key } from '../../chart/Key.tsx';
import { NumbersOf } from '../../chart/NumbersOf.tsx';
import { chartsOf, FIGURES, type FigureId } from '../../figures/all.ts';
import { analysed, drop, series } from '../../state/bench.ts';
import { overlay } from '../../state/simulating.ts';
import { texts } from '../../text/language.ts';
import { SaveFigure } from './SaveFigure.tsx';

export const shown = signal<FigureId>('restitution');
export const logDrag = signal(false);

/** One figure at a time, each with one sentence on what to see in it. */
export function FigureTabs() {
  if (!drop.value) return null;
  return (
    <section class="figures" aria-label={texts.value.figures.title}>
      <Tabs />
      <Panel />
    </section>
  );
}

function Tabs() {
  const list = useRef<HTMLDivElement>(null);
  const step = (by: number): void => {
    const next = FIGURES[(FIGURES.indexOf(shown.peek()) + by + FIGURES.length) % FIGURES.length];
    if (!next) return;
    shown.value = next;
    list.current?.querySelector<HTMLElement>(`#tab-${next}`)?.focus();
  };
  return (
    <div
      ref={list}
      class="tabs"
      role="tablist"
      aria-label={texts.value.figures.title}
      onKeyDown={(event) => {
        if (event.key === 'ArrowRight') step(1);
        else if (event.key === 'ArrowLeft') step(-1);
        else return;
        event.preventDefault();
      }}
    >
      {FIGURES.map((id) => (
        <button
          key={id}
          id={`tab-${id}`}
          type="button"
          role="tab"
          aria-selected={shown.value === id}
          aria-controls="figure"
          tabIndex={shown.value === id ? 0 : -1}
          onClick={() => {
            shown.value = id;
          }}
        >
          {texts.value.figures[id].tab}
        </button>
      ))}
    </div>
  );
}

function Panel() {
  const words = texts.value;
  const id = shown.value;
  const [all, said, points, laid, log] = [
    analysed.value,
    drop.value,
    series.value,
    overlay.value,
    logDrag.value,
  ];
  const charts = useMemo(
    () =>
      all && said
        ? chartsOf(
            id,
            { analysed: all, drop: said, series: points, overlay: laid, logDrag: log },
            words,
          )
        : [],
    [id, all, said, points, laid, log, words],
  );
  const sentence = words.figures[id].see;
  return (
    <div id="figure" role="tabpanel" aria-labelledby={`tab-${id}`}>
      <figure class="figure-box">
        <figcaption>{charts.length > 0 ? sentence : words.figures.nothing}</figcaption>
        {charts[0] && <Key spec={charts[0]} />}
        {charts.map((spec, index) => (
          <Chart key={index} spec={spec} />
        ))}
        {charts.length > 0 && (
          <div class="row no-print">
            {id === 'drag' && <DragScale />}
            <SaveFigure id={id} log={log} />
            <span class="small soft mouse">{words.figures.reset}</span>
          </div>
        )}
        {charts.length > 0 && <NumbersOf charts={charts} />}
      </figure>
    </div>
  );
}

function DragScale() {
  const words = texts.value.figures.drag;
  return (
    <button
      type="button"
      class="quiet"
      onClick={() => {
        logDrag.value = !logDrag.value;
      }}
    >
      {logDrag.value ? words.linear : words.log}
    </button>
  );
}
