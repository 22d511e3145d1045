/**
 * A language, for what the science says in English: templates in which `{}` stands for whatever was
 * put there, which may fit a template itself, and `{0}` for what begins with a number.
 */
import { localised } from './quantity.ts';

/** The code of a language, and its words for each template in English. */
export interface Phrasebook {
  readonly code: string;
  readonly phrases: Readonly<Record<string, string>>;
}

export const ENGLISH: Phrasebook = { code: 'en', phrases: {} };

const GAP = /\{0?\}/g;

interface Template {
  /** What stands between the gaps. */
  readonly parts: readonly string[];
  readonly pattern: RegExp;
  readonly words: string;
}

export class Tongue {
  readonly code: string;
  /** Texts without a gap. */
  readonly #whole = new Map<string, string>();
  /** The others; of those that fit, the one that begins with most of its own, else has most. */
  readonly #templates: Template[] = [];

  constructor({ code, phrases }: Phrasebook) {
    this.code = code;
    for (const [english, words] of Object.entries(phrases)) {
      const parts = bare(english).split(GAP);
      if (parts.length === 1) this.#whole.set(bare(english), words);
      else this.#templates.push({ parts, pattern: patternOf(bare(english)), words });
    }
    this.#templates.sort((a, b) => begins(b) - begins(a) || length(b) - length(a));
  }

  /** The words for a text; one that no template knows keeps its own. */
  say(english: string): string {
    const words = this.find(english);
    if (words === undefined) return localised(english, this.code);
    const begun = /^\p{Lu}/u.test(english) ? capital(words) : words;
    return english.endsWith('.') && !/[.?!:]$/.test(begun) ? `${begun}.` : begun;
  }

  /** The words that a template has for a text; `undefined` if none knows it. */
  find(english: string): string | undefined {
    const text = bare(english);
    const whole = this.#whole.get(text);
    if (whole !== undefined) return whole;
    for (const { pattern, words } of this.#templates) {
      const found = pattern.exec(text);
      if (found) return this.#filled(words, found.slice(1));
    }
    return undefined;
  }

  #filled(words: string, values: readonly string[]): string {
    let next = 0;
    return words.replace(GAP, () => {
      const value = values[next++] ?? '';
      return this.find(value)?.replace(/\.$/, '') ?? localised(value, this.code);
    });
  }
}

export const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** A text as it stands within a sentence. */
const bare = (text: string): string =>
  text.charAt(0).toLowerCase() + text.slice(1).replace(/\.$/, '');

const begins = ({ parts }: Template): number => parts[0]?.length ?? 0;
const length = ({ parts }: Template): number => parts.join('').length;

function patternOf(template: string): RegExp {
  const literal = template.replace(/[\\^$.*+?()[\]{}|]/g, '\\$&');
  const gaps = literal.replaceAll('\\{\\}', '(.+?)').replaceAll('\\{0\\}', '([-−(\\d].*?)');
  return new RegExp(`^${gaps}$`, 'u');
}
