/** Names of things that the engine knows by a key. */
import { texts } from './language.ts';

/** The name of a thing; one that has none is called by its key, as one that an address made up. */
export const nameIn = (names: Readonly<Record<string, string>>, key: string): string =>
  (Object.hasOwn(names, key) ? names[key] : undefined) ?? key;

/** A ball in the language of the page. */
export const ballName = (name: string): string => nameIn(texts.value.settings.balls, name);
