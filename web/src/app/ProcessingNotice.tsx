import { processing } from '../state/workspace.ts';
import { text } from '../text/language.ts';

/** Which processing of the sound the microphone did not turn off. */
export function ProcessingNotice() {
  const names = processing.value;
  if (names.length === 0) return null;
  const what = names.map((name) => text(`page-lab-processed-${name}`)).join(', ');
  return <p class="notice">{text('page-lab-processed', { what })}</p>;
}
