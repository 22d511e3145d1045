// How large the page is, compressed as a web server sends it; fails beyond the limit.
import { readdirSync, readFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { brotliCompressSync, gzipSync } from 'node:zlib';

/** The most that the whole page may take, in bytes of 1000 to the kilobyte. */
const LIMIT = 600_000;
const DIST = new URL('../dist/', import.meta.url).pathname;

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

const sum = (key) => files.reduce((total, file) => total + file[key], 0);
const total = { name: 'all', plain: sum('plain'), gzip: sum('gzip'), brotli: sum('brotli') };
const kilobytes = (bytes) => `${(bytes / 1000).toFixed(1)} kB`.padStart(11);

const width = Math.max(...files.map((file) => file.name.length));
process.stdout.write(`${''.padEnd(width)}      plain       gzip     brotli\n`);
for (const { name, plain, gzip, brotli } of [...files, total]) {
  process.stdout.write(
    `${name.padEnd(width)}${kilobytes(plain)}${kilobytes(gzip)}${kilobytes(brotli)}\n`,
  );
}
if (total.gzip > LIMIT) {
  process.stderr.write(
    `The page takes ${kilobytes(total.gzip).trim()} compressed; the limit is ${kilobytes(LIMIT).trim()}.\n`,
  );
  process.exitCode = 1;
}
