import { FileButton } from '../../app/FileButton.tsx';
import { ENDINGS } from '../../lab/engine/types.ts';
import { lesson } from '../../state/lesson.ts';
import { openDemo, openFile } from '../../state/opening.ts';
import { busy } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';
import { PASTE, pasting } from './pasting.ts';

/** Telephones go by the kind of a file, other systems by the ending of its name. */
const ACCEPT = ['audio/*', 'video/*', ...ENDINGS.map((ending) => `.${ending}`)].join();

/** A file, a list of times, the demo: three quiet links; in a lesson a file only. */
export function OtherWays() {
  return (
    <div class="links">
      <FileButton
        label={text('page-lab-open-label')}
        accept={ACCEPT}
        disabled={busy.value}
        onFiles={([file]) => {
          if (file) void openFile(file);
        }}
      >
        {text('page-lab-open')}
      </FileButton>
      {!lesson.value && <Others />}
    </div>
  );
}

function Others() {
  return (
    <>
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
    </>
  );
}
