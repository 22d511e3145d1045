import { headline } from '../../state/workspace.ts';
import { Numbers } from './Numbers.tsx';
import { Remarks } from './Remarks.tsx';
import { Why } from './Why.tsx';

/** What stands behind the answer, folded: the air, what the recording determines, all numbers. */
export function Explained() {
  const answer = headline.value;
  if (!answer) return null;
  return (
    <div class="explained">
      {answer.without_air && <Why sentence={answer.without_air} />}
      <Remarks />
      <Numbers />
    </div>
  );
}
