import { workspace } from '../../state/workspace.ts';
import { texts } from '../../text/language.ts';
import { sentence } from '../../text/remarks.ts';

/** Why there is no drop, and what to do about it. */
export function NoDrop() {
  const words = texts.value.lab;
  const reason = workspace.value?.recording.heard.no_drop;
  return (
    <div class="notice">
      <p>
        <strong>{words.noDropTitle}</strong>
      </p>
      {reason && <p>{sentence(reason)}</p>}
      {workspace.value?.pyramid && <p>{words.noDropHint}</p>}
    </div>
  );
}
