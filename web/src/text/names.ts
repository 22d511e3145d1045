/** Names of things that the engine knows by a key. */
import { texts } from './language.ts';

/** A ball in the language of the page; one that has no name there is called as the engine calls it. */
export const ballName = (name: string): string => texts.value.settings.balls[name] ?? name;
