/** The answer of a drop for a voice. */
import type { Headline } from '../lab/index.ts';
import { text } from './language.ts';

/** Without signs that a voice leaves out and spaces that do not break, over which it stumbles. */
export const spokenAnswer = ({ sentences }: Headline): string =>
  sentences
    .map((parts) => parts.join(''))
    .join(' ')
    .replaceAll('±', text('page-rest-plus-minus'))
    .replaceAll('\u00a0', ' ');
