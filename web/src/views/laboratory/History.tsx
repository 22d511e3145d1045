import { Back, Forth } from '../../app/icons.tsx';
import { Tool } from '../../app/Tool.tsx';
import * as editing from '../../state/editing.ts';
import { canRedo, canUndo } from '../../state/history.ts';
import { edited, present } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';

/** What was changed last, and the way back: under the waveform as soon as a hand has changed something. */
export function History() {
  const history = present.value;
  const isChanged = history !== undefined && (canUndo(history) || canRedo(history));
  return (
    <div class="history small">
      <span role="status">{editing.announced.value}</span>
      {isChanged && (
        <>
          <Tool disabled={!canUndo(history)} do={editing.undo}>
            <Back />
            {text('page-app-undo')}
          </Tool>
          <Tool disabled={!canRedo(history)} do={editing.redo}>
            <Forth />
            {text('page-app-redo')}
          </Tool>
          <Tool disabled={!edited.value} do={editing.restore}>
            {text('page-wave-restore')}
          </Tool>
        </>
      )}
    </div>
  );
}
