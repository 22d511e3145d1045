// How large the page is, compressed as a web server sends it; fails beyond the limit.
import { readdirSync, readFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { brotliCompressSync, gzipSync } from 'node:zlib';

/** The most that the page may take before it is ready for anything, in bytes. */
const LIMIT = 600_000;
const DIST = new URL('../dist/', import.meta.url).pathname;

/** Decoders come when a file is opened, or when the page has nothing else to do. */
const isLater = (name) => /^assets\/decoders/.test(name);

const files = readdirSync(DIST, { recursive: true, withFileTypes: true })
  .filter((entry) => entry.isFile())
  .map((entry) => join(entry.parentPath ?? entry.path, entry.name))
  .map((path) => {
    const content = readFileSync(path);
    return {
      name: relative(DIST, path),
      plain: content.length,
      gzip: gzipSync(content, { level: 9 }).length,
      brotli: brotliCompressSync(content).length,
    };
  })
  .sort((a, b) => b.gzip - a.gzip);

const sum = (name, some) => {
  const of = (key) => some.reduce((total, file) => total + file[key], 0);
  return { name, plain: of('plain'), gzip: of('gzip'), brotli: of('brotli') };
};
const atOnce = sum(
  'the page',
  files.filter(({ name }) => !isLater(name)),
);
const rows = [
  ...files,
  atOnce,
  sum(
    'and to open files',
    files.filter(({ name }) => isLater(name)),
  ),
];

const kilobytes = (bytes) => `${(bytes / 1000).toFixed(1)} kB`;
const width = Math.max(...rows.map(({ name }) => name.length));
process.stdout.write(`${''.padEnd(width)}      plain       gzip     brotli\n`);
for (const { name, ...sizes } of rows) {
  const cells = Object.values(sizes).map((bytes) => kilobytes(bytes).padStart(11));
  process.stdout.write(`${name.padEnd(width)}${cells.join('')}\n`);
}
if (atOnce.gzip > LIMIT) {
  process.stderr.write(
    `The page takes ${kilobytes(atOnce.gzip)} compressed; the limit is ${kilobytes(LIMIT)}.\n`,
  );
  process.exitCode = 1;
}
