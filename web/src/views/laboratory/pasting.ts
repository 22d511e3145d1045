import { signal } from '@preact/signals';
import { openTimes } from '../../state/opening.ts';
import { fault } from '../../state/workspace.ts';

/** Whether the box for times is unfolded. */
export const pasting = signal(false);

/** The button that unfolds it, to which the keyboard returns. */
export const PASTE = 'paste';

/** The last text of the box that could not be read, for correction. */
export const draft = signal('');

/** Reads the times in a text; if it cannot, the box stays open with the text. */
export async function analysePasted(text: string): Promise<void> {
  draft.value = text;
  await openTimes(text);
  if (fault.peek()) return;
  draft.value = '';
  pasting.value = false;
}
