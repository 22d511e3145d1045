import { expect, test } from 'vitest';
import { codesIn } from './drop.ts';

test('links are found in whatever was pasted, each once', () => {
  const pasted = `Anna: https://lab.example/#lab?drop=AQ-_x9 \nBob\thttps://lab.example/#lab?ball=golf&drop=B0\n
    again https://lab.example/#lab?drop=AQ-_x9, and https://lab.example/#lab?ball=golf`;
  expect(codesIn(pasted)).toEqual(['AQ-_x9', 'B0']);
  expect(codesIn('no link')).toEqual([]);
});
