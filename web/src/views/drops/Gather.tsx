import { signal } from '@preact/signals';
import { useRef } from 'preact/hooks';
import { Cancel } from '../../app/Cancel.tsx';
import { FaultNotice } from '../../app/FaultNotice.tsx';
import { FileButton } from '../../app/FileButton.tsx';
import { type Gathered, gather } from '../../state/gathering.ts';
import { text } from '../../text/language.ts';
import { Scanner } from './Scanner.tsx';

/** The file that is read now, and the results; files may also be dropped anywhere on the page. */
const reading = signal<string | null>(null);
const gathered = signal<Gathered | null>(null);
/** Ends the reading. */
let reader = new AbortController();

/** Adds the drops of files and links to the table. */
export async function gatherHere(files: readonly File[], pasted = ''): Promise<void> {
  if (reading.peek() !== null) return;
  reading.value = '';
  gathered.value = null;
  reader = new AbortController();
  const show = (name: string): void => {
    reading.value = name;
  };
  try {
    gathered.value = await gather(files, pasted, show, reader.signal);
  } finally {
    reading.value = null;
  }
}

/** Files and links of other people: their drops come into the table. */
export function Gather() {
  const box = useRef<HTMLTextAreaElement>(null);
  const isBusy = reading.value !== null;
  return (
    <form
      class="stack paste"
      aria-busy={isBusy}
      onSubmit={(event) => {
        event.preventDefault();
        void gatherHere([], box.current?.value);
      }}
    >
      <h2>{text('page-class-add')}</h2>
      <p class="small soft">{text('page-class-add-hint')}</p>
      <div class="row">
        <FileButton
          label={text('page-class-files-label')}
          disabled={isBusy}
          multiple
          onFiles={(files) => void gatherHere(files)}
        >
          {text('page-class-files')}
        </FileButton>
        <Scanner onDrop={(link) => gatherHere([], link)} />
      </div>
      <label class="field" for="links">
        {text('page-drops-links')}
      </label>
      <div class="row tight ways">
        <textarea id="links" ref={box} required spellcheck={false} />
        <button type="submit" class="button" disabled={isBusy}>
          {text('page-drops-links-do')}
        </button>
      </div>
      <p role="status" class="small">
        {isBusy ? text('page-drops-adding', { name: reading.value ?? '' }) : <Outcome />}
      </p>
      {isBusy && <Cancel onCancel={() => reader.abort()} />}
      {gathered.value?.refused.map((fault) => (
        <FaultNotice key={fault.about} fault={fault} />
      ))}
    </form>
  );
}

function Outcome() {
  if (!gathered.value) return null;
  const { added, known } = gathered.value;
  return (
    <>
      {text('page-drops-added', { count: added })}{' '}
      {known > 0 && text('page-class-known', { count: known })}
    </>
  );
}
