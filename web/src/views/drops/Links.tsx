import { useRef, useState } from 'preact/hooks';
import { keepLinks } from '../../state/linking.ts';
import { text } from '../../text/language.ts';

/** A box for the links of others: their drops come into the table. */
export function Links() {
  const box = useRef<HTMLTextAreaElement>(null);
  const [done, setDone] = useState<{ readonly kept: number; readonly refused: number }>();
  const [working, setWorking] = useState(false);
  const keep = async (): Promise<void> => {
    setWorking(true);
    setDone(await keepLinks(box.current?.value ?? ''));
    setWorking(false);
  };
  return (
    <form
      class="stack paste"
      aria-busy={working}
      onSubmit={(event) => {
        event.preventDefault();
        void keep();
      }}
    >
      <label class="field" for="links">
        {text('page-drops-links')}
      </label>
      <textarea id="links" ref={box} required spellcheck={false} />
      <div>
        <button type="submit" class="button" disabled={working}>
          {text('page-drops-links-do')}
        </button>
      </div>
      <p role="status" class="small">
        {done && text('page-drops-links-done', { ...done })}
      </p>
    </form>
  );
}
