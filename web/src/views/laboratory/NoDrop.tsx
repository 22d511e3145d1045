import { fixed } from '../../format/quantity.ts';
import { setMarks } from '../../state/editing.ts';
import { analysed, lookAt, workspace } from '../../state/workspace.ts';
import { touched } from '../../style/media.ts';
import { language, text } from '../../text/language.ts';

/** Why there is no drop, and what to do about it. */
export function NoDrop() {
  const reason = analysed.value?.document.no_drop?.message;
  return (
    <div class="notice">
      <p>
        <strong>{text('page-lab-no-drop-title')}</strong>
      </p>
      {reason && <p>{reason}</p>}
      {workspace.value?.pyramid && (
        <p>{text(touched ? 'page-lab-no-drop-hint-touch' : 'page-lab-no-drop-hint')}</p>
      )}
      <Candidates />
    </div>
  );
}

/** What may be a drop: the reader decides. */
function Candidates() {
  const candidates = workspace.value?.recording.result.candidates ?? [];
  return (
    <>
      {candidates.map(({ impacts, probability }) => {
        const startS = impacts[0]?.time_s ?? 0;
        return (
          <p key={startS} class="row tight">
            {text('page-lab-possible-drop', {
              start: fixed(startS, 1, language.value),
              impacts: impacts.length,
              probability: fixed(probability, 2, language.value),
            })}
            <button
              type="button"
              onClick={() => {
                setMarks({ impacts });
                lookAt(0);
              }}
            >
              {text('page-lab-accept')}
            </button>
          </p>
        );
      })}
    </>
  );
}
