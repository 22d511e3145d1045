import { headline } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';
import { Numbers } from './Numbers.tsx';
import { Remarks } from './Remarks.tsx';
import { Why } from './Why.tsx';

/** What stands behind the answer, folded: its words, the air, what the recording determines, all numbers. */
export function Explained() {
  const answer = headline.value;
  if (!answer) return null;
  return (
    <div class="explained">
      <Words />
      {answer.without_air && <Why sentence={answer.without_air} />}
      <Remarks />
      <Numbers />
    </div>
  );
}

const WORDS = ['restitution', 'energy', 'height', 'uncertainty'];

/** The words of the answer, one sentence each. */
function Words() {
  return (
    <details>
      <summary>{text('page-words-title')}</summary>
      <ul class="remarks small">
        {WORDS.map((word) => (
          <li key={word}>{text(`page-words-${word}`)}</li>
        ))}
      </ul>
    </details>
  );
}
