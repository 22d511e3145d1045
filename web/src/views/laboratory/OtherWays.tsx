import { FileButton } from '../../app/FileButton.tsx';
import { openDemo, openFile } from '../../state/opening.ts';
import { busy } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';
import { PASTE, pasting } from './pasting.ts';

/** A file, a list of times, the demo: three quiet links. */
export function OtherWays() {
  return (
    <div class="links">
      <FileButton
        label={text('page-lab-open-label')}
        accept="audio/*,video/*,.txt,.csv,.json,.TextGrid,.wav,.flac,.aiff,.caf,.m4a,.ogg,.opus,.webm,.mov,.mp4"
        disabled={busy.value}
        onFiles={([file]) => {
          if (file) void openFile(file);
        }}
      >
        {text('page-lab-open')}
      </FileButton>
      <button
        type="button"
        id={PASTE}
        class="quiet"
        disabled={busy.value}
        aria-expanded={pasting.value}
        onClick={() => {
          pasting.value = !pasting.value;
        }}
      >
        {text('page-lab-paste')}
      </button>
      <button type="button" class="quiet" disabled={busy.value} onClick={() => void openDemo()}>
        {text('page-lab-demo')}
      </button>
    </div>
  );
}
