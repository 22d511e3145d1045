/**
 * What the engine says in English, in the language of the page. A language lists templates in which
 * `{}` stands for whatever the engine put there; what no template knows stays English.
 */
import { localised } from '../format/quantity.ts';
import { language, texts } from './language.ts';

export function translated(english: string): string {
  for (const [template, words] of Object.entries(texts.value.engine)) {
    const parts = patternOf(template).exec(english);
    if (parts) return filled(words, parts.slice(1));
  }
  return english.charAt(0).toUpperCase() + english.slice(1);
}

const patterns = new Map<string, RegExp>();

function patternOf(template: string): RegExp {
  const known = patterns.get(template);
  if (known) return known;
  const literal = template.split('{}').map((part) => part.replace(/[\\^$.*+?()[\]{}|]/g, '\\$&'));
  const pattern = new RegExp(`^${literal.join('(.+?)')}$`);
  patterns.set(template, pattern);
  return pattern;
}

/** `{}` takes what the engine put there, in order. */
function filled(words: string, values: readonly string[]): string {
  let next = 0;
  return words.replace(/\{\}/g, () => localised(values[next++] ?? '', language.value));
}
