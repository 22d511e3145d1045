import { expect, test } from 'vitest';
import { csvOf } from './export.ts';

test('names are quoted, and none is taken for a formula', () => {
  const drop = {
    id: '1',
    name: '=1+"1", or so',
    keptAt: 0,
    ball: 'tennis',
    restitution: { value: 0.75, sd: null },
    dropHeightM: null,
    restitutions: [],
    settings: {},
    marks: { edited: false, probability: 1, impacts: [] },
    recording: null,
    student: '@Anna',
    surface: '\uff1d1+1',
  };
  const [head, row] = csvOf([drop]).split('\r\n');
  expect(head?.split(',')).toHaveLength(10);
  expect(row).toBe(
    `"'=1+""1"", or so",1970-01-01T00:00:00.000Z,"'@Anna","tennis","'\uff1d1+1",0.75,,,,0`,
  );
});
