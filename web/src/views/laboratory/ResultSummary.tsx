import { Fragment } from 'preact';
import { Rich } from '../../app/Rich.tsx';
import type { Headline, Sentence } from '../../lab/index.ts';
import { edited, headline, marks, refining, workspace } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';
import { CERTAIN } from '../../wave/mark.ts';
import { listed } from './ImpactTable.tsx';
import { NoDrop } from './NoDrop.tsx';
import { Numbers } from './Numbers.tsx';
import { Remarks } from './Remarks.tsx';
import { Why } from './Why.tsx';

/** The answer, a sentence first. */
export function ResultSummary() {
  const answer = headline.value;
  return (
    <section
      class="summary"
      aria-label={text('page-lab-result')}
      aria-live="polite"
      aria-busy={refining.value}
    >
      {workspace.value?.recording.result.drops.length === 0 && marks.value.length < 3 && <NoDrop />}
      {marks.value.length > 0 && !answer && <p class="second">{text('page-lab-cannot-tell')}</p>}
      {answer && <Sentences headline={answer} />}
      {marks.value.length > 0 && <Count />}
      {answer && (
        <>
          {answer.without_air && <Air sentence={answer.without_air} />}
          <Remarks />
          <Numbers />
        </>
      )}
    </section>
  );
}

/** The answer with its speed and ball, or why there is none. */
function Sentences({ headline: { is_answer, sentences } }: { readonly headline: Headline }) {
  const [first, ...others] = sentences;
  return (
    <>
      {first && (
        <p class={is_answer ? 'first' : 'second'} title={text('page-words-restitution')}>
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

/** What the log-linear fit gives, and why it differs. */
function Air({ sentence }: { readonly sentence: Sentence }) {
  return (
    <div class="stack">
      <p>
        <Rich parts={sentence} />
      </p>
      <Why />
    </div>
  );
}
