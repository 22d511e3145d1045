import { fileName, save } from '../../app/save.ts';
import { onBench } from '../../state/bench.ts';
import { texts } from '../../text/language.ts';

/** Saves the sound on the bench. */
export function SaveSound() {
  const bench = onBench.value;
  if (!bench?.pyramid) return null;
  return (
    <button
      type="button"
      class="quiet"
      onClick={async () => {
        const file = await bench.recording.wav();
        if (file) save(file, `${fileName(bench.name)}.wav`);
      }}
    >
      {texts.value.keep.wav}
    </button>
  );
}
