/** Names of balls, laws and surfaces that the engine identifies by a key. */
import { localised } from '../format/quantity.ts';
import { hasText, language, text } from './language.ts';

/** The name for a key; a key without a message, such as one typed into the address, is its own name. */
export const nameIn = (id: string, key: string): string => (hasText(id) ? text(id) : key);

/** Stands for the name of a ball that was not stated. */
export const UNSTATED = 'unstated';

/** A ball in the language of the page. */
export const ballName = (name: string): string => nameIn(`ball-${name}`, name);

/** A drag law for people: the name of its authors, or the constant. */
export function lawName(law: string): string {
  if (law === 'none') return text('page-settings-drag-none');
  const constant = /^constant[: ]*(.*)$/.exec(law);
  if (constant) return `C_D = ${localised(constant[1] ?? '', language.value)}`;
  return law
    .split('-')
    .map((part) => part.charAt(0).toUpperCase() + part.slice(1))
    .join('–');
}
