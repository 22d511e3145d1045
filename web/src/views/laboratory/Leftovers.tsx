import { leftovers, openLeftover, throwAway } from '../../state/leftovers.ts';
import { region, texts } from '../../text/language.ts';

/** Recordings that were cut short, and the last one if it was not kept: to open or to throw away. */
export function Leftovers() {
  const words = texts.value.lab;
  return (
    <>
      {leftovers.value.map((recording) => {
        const date = new Date(recording.startedAt).toLocaleString(region.value);
        return (
          <div class={recording.finished ? 'leftover' : 'notice'} key={recording.id}>
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
              <button type="button" class="quiet" onClick={() => void openLeftover(recording)}>
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
