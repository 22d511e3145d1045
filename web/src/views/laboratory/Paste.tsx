import { useEffect, useRef } from 'preact/hooks';
import { text } from '../../text/language.ts';
import { analysePasted, draft, PASTE, pasting } from './pasting.ts';

/** A box for impact times. */
export function Paste() {
  const box = useRef<HTMLTextAreaElement>(null);
  useEffect(() => box.current?.focus(), []);
  return (
    <form
      class="stack paste"
      onSubmit={(event) => {
        event.preventDefault();
        void analysePasted(box.current?.value ?? '');
      }}
    >
      <label class="field" for="times">
        {text('page-lab-paste-label')}
      </label>
      <textarea
        id="times"
        ref={box}
        required
        defaultValue={draft.value}
        spellcheck={false}
        placeholder={'0.000\n0.461\n0.888\n1.285'}
        aria-describedby="times-hint"
      />
      <p id="times-hint" class="small soft">
        {text('page-lab-paste-hint')}
      </p>
      <div class="row tight">
        <button type="submit" class="button primary">
          {text('page-lab-paste-do')}
        </button>
        <button
          type="button"
          class="quiet"
          onClick={() => {
            document.getElementById(PASTE)?.focus();
            pasting.value = false;
          }}
        >
          {text('page-app-cancel')}
        </button>
      </div>
    </form>
  );
}
