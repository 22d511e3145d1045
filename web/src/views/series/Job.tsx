import { useState } from 'preact/hooks';
import { Reported } from '../../app/Blocks.tsx';
import { FileButton } from '../../app/FileButton.tsx';
import { fileName, save, saveText } from '../../app/save.ts';
import { useLatest } from '../../chart/Figure.tsx';
import type { JobRecording, JobShown } from '../../lab/index.ts';
import { engine } from '../../state/engine.ts';
import {
  addFiles,
  closeJob,
  type open,
  operator,
  recordDrop,
  repeat,
  reportOf,
  zipOf,
} from '../../state/series.ts';
import { busy } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';
import { ListenButton } from '../laboratory/ListenButton.tsx';
import { LiveStrip } from '../laboratory/LiveStrip.tsx';
import { Field } from './Field.tsx';
import { Notes } from './Notes.tsx';
import { Trouble } from './Trouble.tsx';

type OpenJob = NonNullable<typeof open.value>;

/** A test series: where it is, the next drop, the result so far, and what the report states. */
export function Job({ job }: { readonly job: OpenJob }) {
  // In the language that was chosen meanwhile.
  const { answer } = useLatest(() => engine().job(job.stored.files), job.stored.revision);
  const shown = answer ?? job.shown;
  const { name, title, next, so_far, damaged, judged } = shown;
  return (
    <div class="stack wide series">
      <div>
        <button type="button" class="quiet" disabled={busy.value} onClick={closeJob}>
          {text('page-series-all')}
        </button>
      </div>
      <h1>{name}</h1>
      <p class="soft">{title}</p>
      <Trouble />
      {damaged > 0 && <p class="notice">{text('page-series-damaged', { count: damaged })}</p>}
      <p class="lead next" role="status">
        {next ?? text('page-series-complete')}
      </p>
      {busy.value && <LiveStrip />}
      <NextDrop isDone={next === null} />
      {so_far !== null && (
        <p class="lead so-far" role="status">
          {so_far}
        </p>
      )}
      <Places shown={shown} />
      <Recordings recordings={shown.recordings} />
      <Notes shown={shown} />
      {judged && (
        <section class="stack wide verdict" aria-label={text('page-verdict-title')}>
          <Reported
            {...judged}
            label={text('page-series-report')}
            name={fileName(name)}
            report={() => reportOf(job, false)}
          />
        </section>
      )}
      <Whole job={job} />
    </div>
  );
}

/** The way to the next drop. */
function NextDrop({ isDone }: { readonly isDone: boolean }) {
  return (
    <div class="stack">
      <div class="again">
        {(!isDone || busy.value) && <ListenButton small begin={recordDrop} />}
        {!busy.value && (
          <FileButton
            label={text('page-series-files-label')}
            disabled={busy.value || isDone}
            multiple
            onFiles={(files) => void addFiles(files)}
          >
            {text('page-series-files')}
          </FileButton>
        )}
      </div>
      {!busy.value && !isDone && (
        <div class="measures">
          <Field
            label={text('page-series-operator')}
            value={operator.value}
            onChange={(name) => {
              operator.value = name;
            }}
          />
        </div>
      )}
    </div>
  );
}

function Places({ shown: { places, checks } }: { readonly shown: JobShown }) {
  return (
    <details>
      <summary>
        {text('page-series-places-done', {
          done: places.filter(({ is_done }) => is_done).length,
          all: places.length,
        })}
      </summary>
      <ul>
        {places.map(({ place, words, is_done }) => (
          <li key={place}>
            {words}
            {is_done && ` ${text('page-series-place-done')}`}
          </li>
        ))}
      </ul>
      {checks.map((check) => (
        <p key={check} class="small soft">
          {check}
        </p>
      ))}
    </details>
  );
}

/** Every recording, the last first: each may be repeated, with a reason. */
function Recordings({ recordings }: { readonly recordings: readonly JobRecording[] }) {
  if (recordings.length === 0) return null;
  return (
    <section class="stack" aria-labelledby="recordings">
      <h2 id="recordings">{text('page-series-recordings')}</h2>
      <ul class="plain recordings">
        {recordings.toReversed().map((recording) => (
          <li key={recording.number} class={recording.counts ? undefined : 'soft'}>
            <span>
              <strong>{recording.number}</strong> {recording.words}
            </span>
            {recording.counts && <Repeat number={recording.number} />}
          </li>
        ))}
      </ul>
    </section>
  );
}

function Repeat({ number }: { readonly number: number }) {
  const [reason, setReason] = useState('');
  return (
    <details>
      <summary>{text('page-series-repeat', { number })}</summary>
      <form
        class="row tight"
        onSubmit={(event) => {
          event.preventDefault();
          if (reason.trim() !== '' && !busy.peek()) void repeat(number, reason.trim());
        }}
      >
        <Field label={text('page-series-reason')} value={reason} onChange={setReason} />
        <button type="submit" class="button" disabled={reason.trim() === '' || busy.value}>
          {text('page-series-repeat-do', { number })}
        </button>
      </form>
    </details>
  );
}

/** The whole as files. */
function Whole({ job }: { readonly job: OpenJob }) {
  const name = fileName(job.shown.name);
  const [isPacking, setPacking] = useState(false);
  const [failed, setFailed] = useState<string>();
  const guarded = async (work: () => Promise<void>): Promise<void> => {
    setPacking(true);
    setFailed(undefined);
    await work().catch((error: unknown) => setFailed(String(error)));
    setPacking(false);
  };
  return (
    <div class="stack">
      <div class="row">
        {job.shown.judged && (
          <button
            type="button"
            class="quiet"
            disabled={isPacking}
            onClick={() =>
              void guarded(async () =>
                saveText(await reportOf(job, true), 'text/html', `${name}-client.html`),
              )
            }
          >
            {text('page-series-one-page')}
          </button>
        )}
        <button
          type="button"
          class="quiet"
          disabled={isPacking}
          onClick={() => void guarded(async () => save(await zipOf(job, name), `${name}.zip`))}
        >
          {text('page-series-zip')}
        </button>
      </div>
      <p class="small soft">{text('page-series-zip-hint')}</p>
      {failed !== undefined && (
        <p class="notice" role="alert" lang="en">
          {failed}
        </p>
      )}
    </div>
  );
}
