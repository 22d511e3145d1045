import { openOrphan, orphans, throwAway } from '../../state/orphans.ts';
import { region, texts } from '../../text/language.ts';

/** Recordings that were cut short, and the last one if it was not kept: to open or to throw away. */
export function Orphans() {
  const words = texts.value.lab;
  return (
    <>
      {orphans.value.map((recording) => {
        const date = new Date(recording.startedAt).toLocaleString(region.value);
        return (
          <div class={recording.finished ? 'orphan' : 'notice'} key={recording.id}>
            <p>
              {recording.finished ? (
                words.unkeptTitle(date)
              ) : (
                <>
                  <strong>{words.interruptedTitle(date)}</strong> {words.interruptedHint}
                </>
              )}
            </p>
            <div class="row">
              <button type="button" class="quiet" onClick={() => void openOrphan(recording)}>
                {words.interruptedOpen}
              </button>
              <button type="button" class="quiet" onClick={() => void throwAway(recording)}>
                {words.interruptedDrop}
              </button>
            </div>
          </div>
        );
      })}
    </>
  );
}
