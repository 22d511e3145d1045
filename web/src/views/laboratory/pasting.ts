import { signal } from '@preact/signals';

/** Whether the box for times is unfolded. */
export const pasting = signal(false);
