import { Rich } from '../../app/Rich.tsx';
import { fixed, LENGTH, rounded } from '../../format/quantity.ts';
import type { Drop } from '../../lab/index.ts';
import { drop, edited, marks, refining, workspace } from '../../state/workspace.ts';
import { answerOf } from '../../text/answer.ts';
import { language, parts, text } from '../../text/language.ts';
import { CERTAIN } from '../../wave/mark.ts';
import { listed } from './ImpactTable.tsx';
import { NoDrop } from './NoDrop.tsx';
import { Numbers } from './Numbers.tsx';
import { Remarks } from './Remarks.tsx';
import { Why } from './Why.tsx';

/** The answer, a sentence first. */
export function ResultSummary() {
  const result = drop.value;
  return (
    <section
      class="summary"
      aria-label={text('page-lab-result')}
      aria-live="polite"
      aria-busy={refining.value}
    >
      {workspace.value?.recording.result.drops.length === 0 && marks.value.length < 3 && <NoDrop />}
      {marks.value.length > 0 && !result?.log_linear_fit && !result?.posterior && (
        <p class="second">{text('page-lab-cannot-tell')}</p>
      )}
      {result && <Sentences result={result} />}
      {marks.value.length > 0 && <Count />}
      {result && (
        <>
          <Air result={result} />
          <Remarks />
          <Numbers />
        </>
      )}
    </section>
  );
}

/** Restitution and height with their uncertainties. */
function Sentences({ result }: { readonly result: Drop }) {
  const { share, height, heightSentence } = answerOf(result);
  return (
    <>
      {share !== undefined && (
        <p class="first" title={text('page-words-restitution')}>
          <Rich parts={parts('page-lab-kept', { share })} />
        </p>
      )}
      {height !== undefined && (
        <p class="second">
          <Rich parts={parts(heightSentence, { height })} />
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

/** The part of the loss by the log-linear fit that is due to the air. */
function Air({ result }: { readonly result: Drop }) {
  const { posterior, per_impact, log_linear_fit } = result;
  // Until the inference is ready the quick answer is shown, so that the layout does not change.
  const withoutAir = (posterior ?? per_impact)?.restitution;
  if (!withoutAir || !log_linear_fit) return null;
  const spoken = language.value;
  const height = log_linear_fit.drop_height_m.value;
  const points = 100 * (withoutAir.value - log_linear_fit.restitution.value);
  return (
    <div class="stack">
      <p>
        {points > 0.05
          ? text('page-lab-air-explains', { points: fixed(points, 1, spoken) })
          : text('page-lab-air-nothing')}{' '}
        {text('page-lab-line-height', { height: rounded(height, 3, LENGTH, spoken) })}
      </p>
      <Why />
    </div>
  );
}
