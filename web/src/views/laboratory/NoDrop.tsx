import { analysed, workspace } from '../../state/workspace.ts';
import { texts } from '../../text/language.ts';

/** Why there is no drop, and what to do about it. */
export function NoDrop() {
  const words = texts.value.lab;
  const reason = analysed.value?.document.no_drop?.message;
  return (
    <div class="notice">
      <p>
        <strong>{words.noDropTitle}</strong>
      </p>
      {reason && <p>{reason}</p>}
      {workspace.value?.pyramid && <p>{words.noDropHint}</p>}
    </div>
  );
}
