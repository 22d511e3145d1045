import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
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
    const parts = template.split('{}').length;
    expect(words.split('{}').length, template).toBe(parts);
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

/** All that the Rust sources say, with strings that go on in the next line made whole. */
function sources(): string {
  const crates = join(import.meta.dirname, '../../../crates');
  return readdirSync(crates, { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.rs'))
    .map((name) => readFileSync(join(crates, name), 'utf8'))
    .join('')
    .replace(/\\\n\s*/g, '');
}

/** Runs of three words, none of them with a gap in it. */
function runs(template: string): string[] {
  return template.split('{}').flatMap((part) => {
    const words = part.trim().split(' ');
    if (words.length < 3) return part.trim() === '' ? [] : [part.trim()];
    return words.slice(2).map((word, i) => `${words[i]} ${words[i + 1]} ${word}`);
  });
}

/**
 * A sentence that was changed in the engine would silently come out in English. Some are put together
 * there of several pieces, so that not every run of words is found as it is.
 */
test('every template is of a sentence that the engine still says', () => {
  const said = sources();
  const stale = Object.keys(deutsch.engine).filter((template) => {
    const all = runs(template);
    return all.filter((run) => said.includes(run)).length < all.length / 2;
  });
  expect(stale).toEqual([]);
});
