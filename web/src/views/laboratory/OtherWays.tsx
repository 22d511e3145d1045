import { useRef } from 'preact/hooks';
import { openDemo, openFile } from '../../state/opening.ts';
import { busy } from '../../state/workspace.ts';
import { texts } from '../../text/language.ts';
import { PASTE, pasting } from './pasting.ts';

/** A file, a list of times, the demo: three quiet links. */
export function OtherWays() {
  const words = texts.value.lab;
  const input = useRef<HTMLInputElement>(null);
  return (
    <div class="links">
      <input
        ref={input}
        type="file"
        hidden
        aria-label={words.openLabel}
        accept="audio/*,video/*,.txt,.csv,.json,.wav,.flac,.aiff,.m4a,.ogg,.opus,.webm,.mov,.mp4"
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
        {words.open}
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
        {words.paste}
      </button>
      <button type="button" class="quiet" disabled={busy.value} onClick={() => void openDemo()}>
        {words.demo}
      </button>
    </div>
  );
}
