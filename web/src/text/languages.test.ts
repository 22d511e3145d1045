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
