import { readdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { brotliCompress } from 'node:zlib';
import type { Plugin } from 'vite';

const brotli = promisify(brotliCompress);

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
    async closeBundle() {
      const names = await readdir(folder, { recursive: true });
      const compress = async (name: string): Promise<void> => {
        const path = join(folder, name);
        await writeFile(`${path}.br`, await brotli(await readFile(path)));
      };
      await Promise.all(names.filter((name) => COMPRESSIBLE.test(name)).map(compress));
    },
  };
}
