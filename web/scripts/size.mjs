// How large the page is, compressed as a web server sends it; fails beyond the limit.
import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { join, relative } from 'node:path';
import { gzipSync } from 'node:zlib';

/** Maximum size of what the page loads at once, in bytes after gzip; see `docs/decisions/006-page-size.md`. */
const LIMIT = 750_000;
const DIST_URL = new URL('../dist/', import.meta.url);
const DIST = DIST_URL.pathname;

const files = readdirSync(DIST, { recursive: true, withFileTypes: true })
  // Copies for servers; they are not loaded besides.
  .filter((entry) => entry.isFile() && !entry.name.endsWith('.br'))
  .map((entry) => join(entry.parentPath ?? entry.path, entry.name))
  .map((path) => {
    const content = readFileSync(path);
    return {
      name: relative(DIST, path),
      plain: content.length,
      gzip: gzipSync(content, { level: 9 }).length,
      // The copy that the build made; pictures have none.
      brotli: existsSync(`${path}.br`) ? statSync(`${path}.br`).size : content.length,
    };
  })
  .sort((a, b) => b.gzip - a.gzip);

/**
 * Scripts that are imported on demand (other languages, the drawing of charts), the pictures of the manifest, and the
 * decoders, which come when a file is opened or when the page has nothing else to do.
 */
const onDemand = readdirSync(new URL('assets/', DIST_URL))
  .filter((name) => name.endsWith('.js'))
  .flatMap((name) => [
    ...readFileSync(new URL(`assets/${name}`, DIST_URL), 'utf8').matchAll(
      /import\([`"']\.\/([^`"']+)[`"']\)/g,
    ),
  ])
  .map(([, name]) => name.replace(/-.{8}\.js$/, ''));
const isLater = (name) =>
  /^(assets\/decoders|screenshot-)/.test(name) ||
  onDemand.some((stem) => name.startsWith(`assets/${stem}-`));

const sum = (name, some) => {
  const of = (key) => some.reduce((total, file) => total + file[key], 0);
  return { name, plain: of('plain'), gzip: of('gzip'), brotli: of('brotli') };
};
const atOnce = sum(
  'at once',
  files.filter(({ name }) => !isLater(name)),
);
const later = sum(
  'on demand',
  files.filter(({ name }) => isLater(name)),
);
const whole = sum('the whole page', files);
const rows = [...files, atOnce, later, whole];

const kilobytes = (bytes) => `${(bytes / 1000).toFixed(1)} kB`;
const width = Math.max(...rows.map(({ name }) => name.length));
process.stdout.write(`${''.padEnd(width)}      plain       gzip     brotli\n`);
for (const { name, ...sizes } of rows) {
  const cells = Object.values(sizes).map((bytes) => kilobytes(bytes).padStart(11));
  process.stdout.write(`${name.padEnd(width)}${cells.join('')}\n`);
}
if (atOnce.gzip > LIMIT) {
  process.stderr.write(
    `${kilobytes(atOnce.gzip)} compressed (at once); the limit is ${kilobytes(LIMIT)}.\n`,
  );
  process.exitCode = 1;
}
