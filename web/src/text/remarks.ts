/** What the science says, in the language of the page. */
import { computed } from '@preact/signals';
import { capital, type Phrasebook, Tongue } from '../format/tongue.ts';
import { language, texts } from './language.ts';

const phrasebook = computed<Phrasebook>(() => ({
  code: language.value,
  phrases: texts.value.engine,
}));

const tongue = computed(() => new Tongue(phrasebook.value));

/** What stands by itself, as a name in a list. */
export const translated = (english: string): string => capital(tongue.value.say(english));

/** A whole sentence, with its full stop. */
export function sentence(english: string): string {
  const said = translated(english);
  return /[.?!:]$/.test(said) ? said : `${said}.`;
}
