import { afterEach, beforeAll, expect, test, vi } from 'vitest';
import { preferred, region, speak, text } from './language.ts';

// Whether every language has every message is tested together with the messages of the program.

beforeAll(() => {
  vi.stubGlobal('document', { documentElement: {} });
});
afterEach(() => speak('en'));

test('a message has its plural form and its numbers without groups', async () => {
  expect(text('page-lab-impacts', { count: 1 })).toBe('1 impact');
  expect(text('page-lab-impacts', { count: 12345 })).toBe('12345 impacts');
  await speak('de');
  expect(text('page-lab-impacts', { count: 2 })).toBe('2 Aufpralle');
  await speak('fr');
  expect([0, 1, 2].map((count) => text('page-lab-impacts', { count }))).toEqual([
    '0 impact',
    '1 impact',
    '2 impacts',
  ]);
  await speak('es');
  expect([0, 1, 1_000_000].map((count) => text('page-lab-impacts', { count }))).toEqual([
    '0 impactos',
    '1 impacto',
    '1000000 impactos',
  ]);
});

test.each([
  [['fr-CH', 'en'], 'fr'],
  [['es-419'], 'es'],
  [['pt-BR', 'es-MX', 'en'], 'es'],
  [['frr', 'de'], 'de'],
  [['pt-BR'], 'en'],
])('a browser in %s is spoken to in %s', (wanted, code) => {
  vi.stubGlobal('navigator', { languages: wanted });
  expect(preferred()).toBe(code);
});

test.each([
  [['C'], 'en'],
  [['en_US.UTF-8', 'en-GB'], 'en-GB'],
  [['enm', 'en-US'], 'en-US'],
])('a browser in %s has dates of %s', async (languages, found) => {
  vi.stubGlobal('navigator', { languages });
  await speak('de');
  await speak('en');
  expect(region.value).toBe(found);
  expect(() => new Date(0).toLocaleString(region.value)).not.toThrow();
});

test('a message that does not exist is its id', () => {
  expect(text('page-nothing')).toBe('page-nothing');
});
