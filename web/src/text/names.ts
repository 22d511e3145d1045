/** Names of things that the engine knows by a key. */
import { localised } from '../format/quantity.ts';
import { language, texts } from './language.ts';

/** The name of a thing; one that has none is called by its key, as one that an address made up. */
export const nameIn = (names: Readonly<Record<string, string>>, key: string): string =>
  (Object.hasOwn(names, key) ? names[key] : undefined) ?? key;

/** A ball in the language of the page. */
export const ballName = (name: string): string => nameIn(texts.value.settings.balls, name);

/** A drag law for people: the name of its authors, or the constant. */
export function lawName(law: string): string {
  if (law === 'none') return texts.value.settings.dragNone;
  const constant = /^constant[: ]*(.*)$/.exec(law);
  if (constant) return `C_D = ${localised(constant[1] ?? '', language.value)}`;
  return law
    .split('-')
    .map((part) => part.charAt(0).toUpperCase() + part.slice(1))
    .join('–');
}
