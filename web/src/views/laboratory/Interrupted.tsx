import { signal } from '@preact/signals';
import { openStored } from '../../state/opening.ts';
import {
  deleteRecording,
  interrupted,
  putRecording,
  type StoredRecording,
} from '../../store/recordings.ts';
import { language, texts } from '../../text/language.ts';

const found = signal<readonly StoredRecording[]>([]);

/** Looks once, at the start, for recordings that a crash cut short. */
export async function findInterrupted(): Promise<void> {
  found.value = await interrupted().catch(() => []);
}

const forget = (id: string): void => {
  found.value = found.value.filter((recording) => recording.id !== id);
};

/** Recordings that a crash or a closed page cut short: whole up to the last second. */
export function Interrupted() {
  const words = texts.value.lab;
  return (
    <>
      {found.value.map((recording) => (
        <div class="notice" key={recording.id}>
          <p>
            <strong>
              {words.interruptedTitle(new Date(recording.startedAt).toLocaleString(language.value))}
            </strong>{' '}
            {words.interruptedHint}
          </p>
          <div class="row">
            <button
              type="button"
              class="quiet"
              onClick={async () => {
                forget(recording.id);
                await putRecording({ ...recording, finished: true });
                await openStored(recording.id);
              }}
            >
              {words.interruptedOpen}
            </button>
            <button
              type="button"
              class="quiet"
              onClick={async () => {
                forget(recording.id);
                await deleteRecording(recording.id);
              }}
            >
              {words.interruptedDrop}
            </button>
          </div>
        </div>
      ))}
    </>
  );
}
