import { expect, test } from 'vitest';
import { withDecimalCommas } from './csv.ts';

test('fields are separated by semicolons, and numbers have a comma', () => {
  const table =
    'name,e,sd,when\r\n"Anna, ""one"", 1.5",0.95,1.2e-3,2026-01-02T03:04:05.678Z\r\na;b,,-7,1.2.3\r\n';
  expect(withDecimalCommas(table)).toBe(
    'name;e;sd;when\r\n"Anna, ""one"", 1.5";0,95;1,2e-3;2026-01-02T03:04:05.678Z\r\n"a;b";;-7;1.2.3\r\n',
  );
});

test('a table without a last line break keeps its last field', () => {
  expect(withDecimalCommas('a,1.5')).toBe('a;1,5');
  expect(withDecimalCommas('')).toBe('');
});
