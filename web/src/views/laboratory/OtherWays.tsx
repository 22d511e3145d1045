import { useRef } from 'preact/hooks';
import { openDemo, openFile } from '../../state/opening.ts';
import { busy } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';
import { PASTE, pasting } from './pasting.ts';

/** A file, a list of times, the demo: three quiet links. */
export function OtherWays() {
  const input = useRef<HTMLInputElement>(null);
  return (
    <div class="links">
      <input
        ref={input}
        type="file"
        hidden
        aria-label={text('page-lab-open-label')}
        accept="audio/*,video/*,.txt,.csv,.json,.TextGrid,.wav,.flac,.aiff,.caf,.m4a,.ogg,.opus,.webm,.mov,.mp4"
        onChange={(event) => {
          const file = event.currentTarget.files?.[0];
          // The same file may be chosen again after it was changed.
          event.currentTarget.value = '';
          if (file) void openFile(file);
        }}
      />
      <button
        type="button"
        class="quiet"
        disabled={busy.value}
        onClick={() => input.current?.click()}
      >
        {text('page-lab-open')}
      </button>
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
