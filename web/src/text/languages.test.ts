import { describe, expect, test } from 'vitest';
import english from './languages/en.ts';
import type { Texts } from './texts.ts';

/** Every language there is, by the name of its file. */
const LANGUAGES = Object.entries(
  import.meta.glob<Texts>('./languages/*.ts', { import: 'default', eager: true }),
);
const FOREIGN = LANGUAGES.filter(([file]) => !file.endsWith('/en.ts'));

/** Every path of a tree of texts, with the kind of what lies there. */
function shape(tree: object, path = ''): string[] {
  return Object.entries(tree).flatMap(([key, value]) =>
    value !== null && typeof value === 'object'
      ? shape(value, `${path}.${key}`)
      : [`${path}.${key}: ${typeof value}`],
  );
}

describe.each(FOREIGN)('%s', (_, language) => {
  /** The compiler sees missing keys; names in open lists, as of balls, it does not. */
  test('has all that English has, and no more', () => {
    expect(shape(language)).toEqual(shape(english));
  });
});
