import { useEffect, useRef } from 'preact/hooks';
import { texts } from '../../text/language.ts';
import { analysePasted, draft, PASTE, pasting } from './pasting.ts';

/** A box for impact times. */
export function Paste() {
  const words = texts.value.lab;
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
        {words.pasteLabel}
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
        {words.pasteHint}
      </p>
      <div class="row tight">
        <button type="submit" class="button primary">
          {words.pasteDo}
        </button>
        <button
          type="button"
          class="quiet"
          onClick={() => {
            document.getElementById(PASTE)?.focus();
            pasting.value = false;
          }}
        >
          {texts.value.app.cancel}
        </button>
      </div>
    </form>
  );
}
