import { fileName, save } from '../../app/save.ts';
import { isWhole } from '../../state/sound.ts';
import { workspace } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';

/** Saves the loaded sound; a longer one is a file already. */
export function SaveSound() {
  const loaded = workspace.value;
  if (!loaded?.pyramid || !isWhole.value) return null;
  return (
    <button
      type="button"
      class="quiet"
      onClick={async () => {
        const file = await loaded.recording.wav();
        if (file) save(file, `${fileName(loaded.name)}.wav`);
      }}
    >
      {text('page-keep-wav')}
    </button>
  );
}
