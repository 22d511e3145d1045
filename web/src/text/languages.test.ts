import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { Tongue } from '../format/tongue.ts';
import { texts } from './language.ts';
import deutsch from './languages/de.ts';
import english from './languages/en.ts';
import { translated } from './remarks.ts';

/** Every path of a tree of texts, with the kind of what lies there. */
function shape(tree: object, path = ''): string[] {
  return Object.entries(tree).flatMap(([key, value]) =>
    // What the engine says is translated, not repeated, so that there the keys may differ.
    path === '' && key === 'engine'
      ? []
      : value !== null && typeof value === 'object'
        ? shape(value, `${path}.${key}`)
        : [`${path}.${key}: ${typeof value}`],
  );
}

/** The compiler sees missing keys; names in open lists, as of balls, it does not. */
test('German has all that English has, and no more', () => {
  expect(shape(deutsch)).toEqual(shape(english));
});

test('templates keep every part that the engine put in', () => {
  for (const [template, words] of Object.entries(deutsch.engine)) {
    const gaps = (text: string) => text.split(/\{0?\}/).length - 1;
    expect(gaps(words), template).toBe(gaps(template));
  }
});

test('what the engine says is said in the language of the page', () => {
  texts.value = deutsch;
  expect(translated('3 impacts in between were not heard; they are counted')).toBe(
    '3 Aufpralle dazwischen wurden nicht gehört; sie sind mitgezählt.',
  );
  expect(translated('something new')).toBe('Something new');
  texts.value = english;
});

const german = new Tongue({ code: 'de', phrases: deutsch.engine });

test('what a template holds is said in the same language, numbers as well', () => {
  const said = {
    'restitution: 0.953 ± 0.002': 'Stoßzahl: 0,953 ± 0,002',
    // A sentence in English is one in German, a piece of one remains a piece.
    'There is no inference: an inference needs a flight, and a flight needs two impacts.':
      'Es gibt keine Schätzung: Eine Schätzung braucht einen Flug, und ein Flug braucht zwei Aufpralle.',
    'Report of bouncelab 0.1.0, 2026-01-02': 'Bericht von bouncelab 0.1.0, 2026-01-02',
    '29.8 to 31.0 cm': '29,8 bis 31,0 cm',
    '0.5': '0,5',
  };
  for (const [text, words] of Object.entries(said)) expect(german.say(text)).toBe(words);
});

/** An example of everything that the engine says: `crates/bouncelab-wasm/tests/said.rs` makes it. */
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
const words = (text: string): string[] =>
  text
    .replace(NAMES, '')
    .match(/\b(?!(?:cm|mm|ms|µs|kg|mg|mJ|µJ|Pa|dB|kHz|hPa|min)\b)\p{L}{2,}/gu) ?? [];

/** Every template with these words around its gaps. */
function emptied(phrases: object, around: (index: number) => string): Tongue {
  const templates = Object.keys(phrases).map((template, index) => {
    const gaps = template.match(/\{0?\}/g) ?? [];
    return [template, [around(index), ...gaps].join(' ')] as const;
  });
  return new Tongue({ code: 'de', phrases: Object.fromEntries(templates) });
}

/** If templates say nothing, only that is left which none of them knows. */
test('all that the engine says is known in German', () => {
  const silent = emptied(deutsch.engine, () => '');
  const left = said
    .filter((text) => !QUOTED.test(text))
    .map((text) => silent.say(text).trim())
    .filter((rest) => !CITED.test(rest) && words(rest).length > 0);
  expect(left).toEqual([]);
});

/** A template that nothing fits, or that another one takes everything from, says nothing. */
test.each([
  ['en', english.engine],
  ['de', deutsch.engine],
] as const)('every template of %s is of something that the engine says', (_, phrases) => {
  const counting = emptied(phrases, (index) => `<${index}>`);
  const all = said.map((text) => counting.say(text)).join('');
  const stale = Object.keys(phrases).filter((_, index) => !all.includes(`<${index}>`));
  expect(stale).toEqual([]);
});
