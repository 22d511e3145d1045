import { useEffect } from 'preact/hooks';
import { jobs, loadJobs, open, openJob, removeJob } from '../../state/series.ts';
import { busy, fault } from '../../state/workspace.ts';
import { region, text } from '../../text/language.ts';
import { Begin } from './Begin.tsx';
import { Job } from './Job.tsx';
import { Trouble } from './Trouble.tsx';

/** Tests by a rule, drop after drop: those that this browser keeps, and the one that is open. */
export function Series() {
  useEffect(() => {
    fault.value = null;
    if (!open.peek()) void loadJobs();
  }, []);
  if (open.value) return <Job job={open.value} />;
  return (
    <div class="stack wide series">
      <h1>{text('page-series-title')}</h1>
      <p class="lead soft">{text('page-series-lead')}</p>
      <Trouble />
      <Known />
      <Begin />
    </div>
  );
}

function Known() {
  if (jobs.value.length === 0) return null;
  return (
    <section class="stack" aria-labelledby="known-series">
      <h2 id="known-series">{text('page-series-known')}</h2>
      <ul class="plain">
        {jobs.value.map(({ id, name, title, changedAt }) => (
          <li key={id} class="row">
            <button
              type="button"
              class="quiet"
              disabled={busy.value}
              onClick={() => void openJob(id)}
            >
              {text('page-series-open', { name })}
            </button>
            <span class="small soft">
              {title}, {new Date(changedAt).toLocaleString(region.value)}
            </span>
            <details>
              <summary>{text('page-series-delete')}</summary>
              <p>{text('page-series-delete-hint')}</p>
              <button
                type="button"
                class="quiet"
                aria-label={text('page-series-delete-really', { name })}
                onClick={() => void removeJob(id)}
              >
                {text('page-series-delete-really', { name })}
              </button>
            </details>
          </li>
        ))}
      </ul>
    </section>
  );
}
