import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { brotliCompressSync } from 'node:zlib';
import type { Plugin } from 'vite';

/** Pictures are compressed already. */
const COMPRESSIBLE = /\.(css|html|js|svg|wasm|webmanifest)$/;

/**
 * Lays a compressed copy beside each file, `NAME.br`, for servers that send such copies: `bouncelab
 * serve` does, others can be told to. They are not part of the page: browsers ask for the plain name.
 */
export function compressed(): Plugin {
  let folder = '';
  return {
    name: 'bouncelab:compressed',
    apply: 'build',
    enforce: 'post',
    configResolved({ root, build }) {
      folder = join(root, build.outDir);
    },
    closeBundle() {
      for (const name of readdirSync(folder, { recursive: true, encoding: 'utf8' })) {
        if (COMPRESSIBLE.test(name)) {
          const path = join(folder, name);
          writeFileSync(`${path}.br`, brotliCompressSync(readFileSync(path)));
        }
      }
    },
  };
}
