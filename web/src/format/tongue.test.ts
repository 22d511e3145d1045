import { expect, test } from 'vitest';
import { Tongue } from './tongue.ts';

const tongue = new Tongue({
  code: 'de',
  phrases: {
    'drop {0}': '{}. Versuch',
    'drop height: {}': 'Fallhöhe: {}',
    '{0} to {0}': '{} bis {}',
    '{} is {}; it must be {}': '{} ist {}; erlaubt ist: {}',
    'there is none: {}': 'Es gibt keine: {}',
    'flight time': 'Flugzeit',
    'above 0': 'größer als 0',
    'it must be (so)': 'Es muss (so) sein.',
  },
});

test('the template that begins with most of a text says it', () => {
  expect(tongue.say('drop 3')).toBe('3. Versuch');
  expect(tongue.say('drop height: 30.5 to 31.0 cm')).toBe('Fallhöhe: 30,5 bis 31,0 cm');
  expect(tongue.say('There is none: flight time is 0; it must be above 0.')).toBe(
    'Es gibt keine: Flugzeit ist 0; erlaubt ist: größer als 0.',
  );
});

test('a gap for numbers holds no words', () => {
  expect(tongue.say('Guide to 3 balls')).toBe('Guide to 3 balls');
  expect(tongue.say('−1.5 to 2.5')).toBe('−1,5 bis 2,5');
});

test('a sentence stays one, a piece of one stays a piece, and signs stand for themselves', () => {
  expect(tongue.say('flight time')).toBe('Flugzeit');
  expect(tongue.say('Flight time.')).toBe('Flugzeit.');
  expect(tongue.say('It must be (so).')).toBe('Es muss (so) sein.');
  expect(tongue.find('it must be so')).toBeUndefined();
});

test('what no template knows keeps its words, but not the point in its numbers', () => {
  expect(tongue.say('1.5 apples of version 0.1.0')).toBe('1,5 apples of version 0.1.0');
});
