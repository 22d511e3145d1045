import { signal } from '@preact/signals';
import { fault } from '../../state/bench.ts';
import { openTimes } from '../../state/opening.ts';

/** Whether the box for times is unfolded. */
export const pasting = signal(false);

/** What was typed into it last and made no sense, to be mended. */
export const draft = signal('');

/** Hears the times in a text; if they make no sense the box stays, with the text. */
export async function analysePasted(text: string): Promise<void> {
  await openTimes(text);
  const isRefused = fault.peek() !== null;
  draft.value = isRefused ? text : '';
  pasting.value = isRefused;
}
