import { signal } from '@preact/signals';
import { openTimes } from '../../state/opening.ts';
import { fault } from '../../state/workspace.ts';

/** Whether the box for times is unfolded. */
export const pasting = signal(false);

/** The button that unfolds it, to which the keyboard returns. */
export const PASTE = 'paste';

/** What was typed into it last and made no sense, to be mended. */
export const draft = signal('');

/** Hears the times in a text; if they make no sense the box stays, with the text. */
export async function analysePasted(text: string): Promise<void> {
  draft.value = text;
  await openTimes(text);
  if (fault.peek()) return;
  draft.value = '';
  pasting.value = false;
}
