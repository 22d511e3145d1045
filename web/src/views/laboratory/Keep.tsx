import { signal } from '@preact/signals';
import { useRef } from 'preact/hooks';
import { addressOf, hashOf } from '../../address/route.ts';
import { settingsToParameters } from '../../address/settings.ts';
import { FaultNotice } from '../../app/FaultNotice.tsx';
import { fileName, saveText } from '../../app/save.ts';
import { request } from '../../state/analysing.ts';
import { analysed, drop, onBench } from '../../state/bench.ts';
import { engine } from '../../state/engine.ts';
import { keepDrop } from '../../state/keeping.ts';
import { settings } from '../../state/settings.ts';
import { texts } from '../../text/language.ts';
import { phrasebook } from '../../text/remarks.ts';
import { SaveSound } from './SaveSound.tsx';

const kept = signal<string | null>(null);
const failed = signal(false);
const shared = signal<{ readonly address: string; readonly copied: boolean } | null>(null);

/** Keep the drop here, save its numbers, share the set-up, print a report. */
export function Keep() {
  const words = texts.value.keep;
  const recording = onBench.value;
  if (!recording) return null;
  const stem = fileName(recording.name);
  return (
    <section class="stack keep no-print" aria-label={words.title}>
      {drop.value && <KeepForm key={recording.name} />}
      <div class="row">
        <SaveSound />
        {analysed.value && (
          <>
            <button type="button" class="quiet" onClick={() => void saveCsv(stem)}>
              {words.csv}
            </button>
            <button type="button" class="quiet" onClick={() => saveJson(stem)}>
              {words.json}
            </button>
            <button type="button" class="quiet" onClick={() => void saveReport(stem)}>
              {words.report}
            </button>
          </>
        )}
        <Share />
      </div>
    </section>
  );
}

async function saveCsv(stem: string): Promise<void> {
  const asked = request();
  if (asked) saveText(await engine().rows(asked), 'text/csv', `${stem}.csv`);
}

/** One file to print, send or hand in: as the command line writes it, in the language of the page. */
async function saveReport(stem: string): Promise<void> {
  const [asked, bench] = [request(), onBench.peek()];
  if (!asked || !bench) return;
  const html = await engine().report(bench.recording, asked, new Date(), phrasebook.peek());
  saveText(html, 'text/html', `${stem}.html`);
}

/** The document of the command line, as it is. */
function saveJson(stem: string): void {
  const text = JSON.stringify(analysed.peek()?.document, null, 2);
  saveText(text, 'application/json', `${stem}.json`);
}

function KeepForm() {
  const words = texts.value.keep;
  const input = useRef<HTMLInputElement>(null);
  const name = onBench.value?.name ?? '';
  return (
    <form
      class="stack"
      onSubmit={async (event) => {
        event.preventDefault();
        const given = input.current?.value.trim() || name;
        failed.value = !(await keepDrop(given));
        kept.value = failed.value ? null : given;
      }}
    >
      <label class="field">
        <span>{words.name}</span>
        <span class="pair">
          <input ref={input} defaultValue={name} placeholder={words.nameHint} maxLength={120} />
          <button type="submit" class="button">
            {words.keep}
          </button>
        </span>
      </label>
      <p role="status" class="small">
        {kept.value !== null && (
          <>
            {words.kept(kept.value)} <a href={hashOf('drops')}>{words.seeAll}</a>
          </>
        )}
      </p>
      {failed.value && <FaultNotice fault={{ key: 'keep' }} />}
    </form>
  );
}

function Share() {
  const words = texts.value.keep;
  const share = async (): Promise<void> => {
    const address = addressOf('lab', settingsToParameters(settings.peek()));
    const copied = await navigator.clipboard?.writeText(address).then(
      () => true,
      () => false,
    );
    shared.value = { address, copied: copied ?? false };
  };
  return (
    <>
      <button type="button" class="quiet" onClick={() => void share()}>
        {words.share}
      </button>
      <p role="status" class="small shared">
        {shared.value && (
          <>
            {shared.value.copied ? words.shared : words.shareByHand}{' '}
            <code>{shared.value.address}</code>
          </>
        )}
      </p>
    </>
  );
}
