import { Fragment } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { HeightCurve, hopsOf } from '../../app/HeightCurve.tsx';
import { Rich } from '../../app/Rich.tsx';
import { unbroken } from '../../format/quantity.ts';
import type { Headline } from '../../lab/index.ts';
import {
  analysed,
  drop,
  edited,
  headline,
  marks,
  quantities,
  refining,
  workspace,
} from '../../state/workspace.ts';
import { text } from '../../text/language.ts';
import { CERTAIN } from '../../wave/mark.ts';
import { listed } from './ImpactTable.tsx';
import { NoDrop } from './NoDrop.tsx';
import { Warnings } from './Remarks.tsx';
import { SetUp } from './SetUp.tsx';

/** The answer: a sentence, and the height of the ball against time. */
export function Answer() {
  const place = useRef<HTMLElement>(null);
  const { recording } = workspace.value ?? {};
  // The answer to a new drop is what the reader sees, wherever the last one was left.
  useEffect(() => {
    if ((place.current?.getBoundingClientRect().top ?? 0) < 0) place.current?.scrollIntoView();
  }, [recording]);
  const answer = headline.value;
  return (
    <section
      ref={place}
      class="summary"
      aria-label={text('page-lab-result')}
      aria-live="polite"
      aria-busy={refining.value}
    >
      <div class="said">
        {recording?.result.drops.length === 0 && marks.value.length < 3 && <NoDrop />}
        {marks.value.length > 0 && analysed.value && !answer && (
          <p class="second">{text('page-lab-cannot-tell')}</p>
        )}
        {answer && <Sentences headline={answer} />}
        <Gravity />
        {marks.value.length > 0 && <Count />}
        <SetUp />
        <Warnings />
      </div>
      {drop.value && <HeightCurve hops={hopsOf(drop.value)} />}
    </section>
  );
}

/** The answer with its speed and ball, or why the recording gives no answer. */
function Sentences({ headline: { is_answer, sentences } }: { readonly headline: Headline }) {
  const [first, ...others] = sentences;
  return (
    <>
      {first && (
        <p class={is_answer ? 'first' : 'second'}>
          <Rich parts={first} />
        </p>
      )}
      {others.length > 0 && (
        <p class="second">
          {others.map((parts, index) => (
            <Fragment key={index}>
              {index > 0 && ' '}
              <Rich parts={parts} />
            </Fragment>
          ))}
        </p>
      )}
    </>
  );
}

/** Gravity, where it is what is measured. */
function Gravity() {
  const rows = quantities.value.flatMap((list) => list.rows);
  const measured = rows.find(({ id }) => id === 'gravity_m_s2');
  if (!measured) return null;
  return (
    <p class="second">
      {measured.symbol} = <strong>{unbroken(measured.value)}</strong>
    </p>
  );
}

function Count() {
  const count = marks.value.length;
  const uncertainCount = marks.value.filter((mark) => mark.probability < CERTAIN).length;
  return (
    <p>
      <button
        type="button"
        class="quiet slim"
        aria-expanded={listed.value}
        onClick={() => {
          listed.value = !listed.value;
        }}
      >
        {text('page-lab-impacts', { count })}
        {uncertainCount > 0 && `, ${text('page-lab-uncertain', { count: uncertainCount })}`}
      </button>
      {edited.value && <span class="soft"> · {text('page-lab-edited')}</span>}
      {refining.value && <span class="soft"> · {text('page-lab-refining')}</span>}
    </p>
  );
}
