import { openOrphan, orphans, throwAway } from '../../state/orphans.ts';
import { region, text } from '../../text/language.ts';

/** Recordings that were cut short, and the last one if it was not kept: to open or to throw away. */
export function Orphans() {
  return (
    <>
      {orphans.value.map((recording) => {
        const date = new Date(recording.startedAt).toLocaleString(region.value);
        return (
          <div class={recording.finished ? 'orphan' : 'notice'} key={recording.id}>
            <p>
              {recording.finished ? (
                text('page-lab-unkept-title', { date })
              ) : (
                <>
                  <strong>{text('page-lab-interrupted-title', { date })}</strong>{' '}
                  {text('page-lab-interrupted-hint')}
                </>
              )}
            </p>
            <div class="row">
              <button type="button" class="quiet" onClick={() => void openOrphan(recording)}>
                {text('page-lab-interrupted-open')}
              </button>
              <button type="button" class="quiet" onClick={() => void throwAway(recording)}>
                {text('page-lab-interrupted-drop')}
              </button>
            </div>
          </div>
        );
      })}
    </>
  );
}
