import { analysed, workspace } from '../../state/workspace.ts';
import { touched } from '../../style/media.ts';
import { text } from '../../text/language.ts';

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
    </div>
  );
}
