import { expect, test } from 'vitest';
import { listOf } from './pasted.ts';

test.each([
  ['0.1\n0.5\n0.9'],
  ['0,1\r\n0,5\r\n0,9\r\n'],
  ['0.1 0.5 0.9'],
  ['0,1 0,5 0,9'],
  ['0,1; 0,5; 0,9'],
  ['0.1, 0.5, 0.9'],
  ['0.1,0.5,0.9'],
  ['0,1, 0,5, 0,9'],
])('times as people write them: %j', (text) => {
  expect(listOf(text)).toEqual({ name: 'times.txt', text: '0.1\n0.5\n0.9' });
});

test('a heading over one column keeps its line, so that errors name the right one', () => {
  expect(listOf('time (s)\n0,1\n0,5')).toEqual({ name: 'times.txt', text: '\n0.1\n0.5' });
});

test('tables and arrays are left to those who read them', () => {
  expect(listOf('n,time_s\n1,0.1').name).toBe('times.csv');
  for (const text of ['n\ttime_s\n1\t0,1', '0.1\t0.1\t1\n0.5\t0.5\t2, loud']) {
    expect(listOf(text)).toEqual({ name: 'times.txt', text });
  }
  expect(listOf(' [0.1, 0.5]').name).toBe('times.json');
});

test('text that is no number is passed on as it was written', () => {
  expect(listOf('0.1\nzwei')).toEqual({ name: 'times.txt', text: '0.1\nzwei' });
  expect(listOf('hello world').text).toBe('hello world');
});
