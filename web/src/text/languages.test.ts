import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { Tongue } from '../format/tongue.ts';
import { texts } from './language.ts';
import deutsch from './languages/de.ts';
import english from './languages/en.ts';
import { sentence, translated } from './remarks.ts';
import type { Texts } from './texts.ts';

/** Every language there is, by the name of its file. */
const LANGUAGES = Object.entries(
  import.meta.glob<Texts>('./languages/*.ts', { import: 'default', eager: true }),
);
const FOREIGN = LANGUAGES.filter(([file]) => !file.endsWith('/en.ts'));

/** An example of everything that the science says: `crates/bouncelab-wasm/tests/said.rs` makes it. */
const said = readFileSync(join(import.meta.dirname, 'said.txt'), 'utf8')
  .trimEnd()
  .split('\n');

/** Names are the same in all languages, and works are cited by theirs. */
const NAMES =
  /WAV|bouncelab|inf\b|\bC_D|Pareto|Student|Nagurka|clift-grace-weber|schiller-naumann|stokes|morrison|table-tennis-\d+/gi;
const CITED = /^([A-Z]\. .+\(\d{4}\)|JCGM .+)\.?$/i;
/** What somebody wrote, and what could have been written. */
const QUOTED = / is called "/;
/** Words, not letters for quantities or units. */
const wordsIn = (text: string): string[] =>
  text
    .replace(NAMES, '')
    .match(/\b(?!(?:cm|mm|ms|µs|kg|mg|mJ|µJ|Pa|dB|kHz|hPa|min)\b)\p{L}{2,}/gu) ?? [];

const gapsIn = (text: string): string[] => text.match(/\{0?\}/g) ?? [];

/** Templates that say nothing but these words, and what is in their gaps. */
function emptied(phrases: Texts['engine'], instead: (index: number) => string): Tongue {
  const templates = Object.keys(phrases).map(
    (template, index) => [template, [instead(index), ...gapsIn(template)].join(' ')] as const,
  );
  return new Tongue({ code: 'de', phrases: Object.fromEntries(templates) });
}

/** Every path of a tree of texts, with the kind of what lies there. */
function shape(tree: object, path = ''): string[] {
  return Object.entries(tree).flatMap(([key, value]) =>
    // What the science says is translated, not repeated, so that there the keys may differ.
    path === '' && key === 'engine'
      ? []
      : value !== null && typeof value === 'object'
        ? shape(value, `${path}.${key}`)
        : [`${path}.${key}: ${typeof value}`],
  );
}

describe.each(FOREIGN)('%s', (_, language) => {
  /** The compiler sees missing keys; names in open lists, as of balls, it does not. */
  test('has all that English has, and no more', () => {
    expect(shape(language)).toEqual(shape(english));
  });

  test('keeps every part that the science put in', () => {
    for (const [template, words] of Object.entries(language.engine)) {
      expect(gapsIn(words).length, template).toBe(gapsIn(template).length);
    }
  });

  /** If templates say nothing, only that is left which none of them knows. */
  test('knows all that the science says', () => {
    const silent = emptied(language.engine, () => '');
    const left = said
      .filter((text) => !QUOTED.test(text))
      .map((text) => silent.say(text).trim())
      .filter((rest) => !CITED.test(rest) && wordsIn(rest).length > 0);
    expect(left).toEqual([]);
  });
});

/** A template that nothing fits, or that another one takes everything from, says nothing. */
test.each(LANGUAGES)('every template of %s is of something that is said', (_, { engine }) => {
  const counting = emptied(engine, (index) => `<${index}>`);
  const all = said.map((text) => counting.say(text)).join('');
  const stale = Object.keys(engine).filter((_, index) => !all.includes(`<${index}>`));
  expect(stale).toEqual([]);
});

test('what the science says is said in the language of the page', () => {
  texts.value = deutsch;
  expect(translated('3 impacts in between were not heard; they are counted')).toBe(
    '3 Aufpralle dazwischen wurden nicht gehört; sie sind mitgezählt.',
  );
  expect(translated('something new')).toBe('Something new');
  expect(sentence('something new')).toBe('Something new.');
  expect(sentence('Something new.')).toBe('Something new.');
  texts.value = english;
});

test('German sentences are put together as German is', () => {
  const german = new Tongue({ code: 'de', phrases: deutsch.engine });
  const examples = {
    'restitution: 0.953 ± 0.002': 'Stoßzahl: 0,953 ± 0,002',
    'There is no inference: an inference needs a flight, and a flight needs two impacts.':
      'Es gibt keine Schätzung: Eine Schätzung braucht einen Flug, und ein Flug braucht zwei Aufpralle.',
    'Report of bouncelab 0.1.0, 2026-01-02': 'Bericht von bouncelab 0.1.0, 2026-01-02',
    '29.8 to 31.0 cm': '29,8 bis 31,0 cm',
  };
  for (const [text, words] of Object.entries(examples)) expect(german.say(text)).toBe(words);
});
