import { expect, test } from 'vitest';
import { studentsOf } from './students.ts';

test('a student is the first folder that not all files share', () => {
  expect(studentsOf(['class/Anna/1.wav', 'class/Anna/2.wav', 'class/Ben/drop.json'])).toEqual([
    'Anna',
    'Anna',
    'Ben',
  ]);
});

test('what a learning platform adds to a name is left out', () => {
  const paths = [
    'Anna Berger_12_assignsubmission_file_/a.wav',
    'Ben_13_assignsubmission_file_/b.wav',
  ];
  expect(studentsOf(paths)).toEqual(['Anna Berger', 'Ben']);
});

test('without folders it is the name of the file, if that says something', () => {
  expect(studentsOf(['anna_golf.m4a', 'upload/ben.txt'])).toEqual(['anna_golf', 'upload']);
  expect(studentsOf(['upload/anna.wav', 'upload/ben.wav'])).toEqual(['anna', 'ben']);
  expect(studentsOf(['bouncelab-drops.json', 'bouncelab-drops (1).zip'])).toEqual(['', '']);
  expect(studentsOf(['anna.wav'])).toEqual(['anna']);
  expect(studentsOf([])).toEqual([]);
});
