/** Names of balls, laws and surfaces that the engine identifies by a key. */
import { localised } from '../format/quantity.ts';
import { catalogue } from '../state/engine.ts';
import { hasText, language, text } from './language.ts';

/** The name for a key; a key without a message, such as one typed into the address, is its own name. */
export const nameIn = (id: string, key: string): string => (hasText(id) ? text(id) : key);

/** Stands for the name of a ball that was not stated. */
export const UNSTATED = 'unstated';

/** A ball in the language of the page. */
export const ballName = (name: string): string => nameIn(`ball-${name}`, name);

/** A drag law for people. */
function lawName(law: string): string {
  const [name, numbers = ''] = law.split(':');
  if (name === 'constant') return `C_D = ${localised(numbers, language.value)}`;
  return nameIn(`page-settings-drag-${name}`, law);
}

/** What a choice of drag laws offers: all that need no table, and the present one. */
export function lawChoices(present: string): (readonly [string, string])[] {
  const offered = (catalogue.value?.drag_laws ?? []).filter((law) => !law.startsWith('table:'));
  return [...new Set([...offered, present])].map((law) => [law, lawName(law)]);
}
