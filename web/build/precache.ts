import { createHash } from 'node:crypto';
import { existsSync, readdirSync } from 'node:fs';
import { resolve } from 'node:path';
import type { Plugin } from 'vite';

/** The name under which the service worker is served: its scope is the folder it lies in. */
const WORKER = 'sw.js';

/**
 * Builds the service worker and tells it what to keep: in its code, `__PRECACHE__` becomes the list
 * of all files of the page, and `__VERSION__` a name that changes whenever one of them does.
 */
export function precache({ source }: { source: string }): Plugin {
  let publicFolder = '';
  return {
    name: 'bouncelab:precache',
    apply: 'build',
    enforce: 'post',
    configResolved({ publicDir }) {
      publicFolder = publicDir;
    },
    buildStart() {
      if (existsSync(resolve(source))) {
        this.emitFile({ type: 'chunk', id: resolve(source), fileName: WORKER });
      }
    },
    generateBundle(_, bundle) {
      const worker = bundle[WORKER];
      if (worker?.type !== 'chunk') {
        return;
      }
      const files = Object.values(bundle).filter((file) => file.fileName !== WORKER);
      const hash = createHash('sha256');
      for (const file of files.sort((a, b) => a.fileName.localeCompare(b.fileName))) {
        hash.update(file.fileName);
        hash.update(file.type === 'chunk' ? file.code : file.source);
      }
      const names = files
        .map((file) => (file.fileName === 'index.html' ? './' : file.fileName))
        .filter((name) => !name.endsWith('.map'))
        // Copied as they are, so they are not in the bundle.
        .concat(existsSync(publicFolder) ? readdirSync(publicFolder) : [])
        // Only the browser shows them, before the page is installed.
        .filter((name) => !name.startsWith('screenshot-'));
      worker.code = worker.code
        .replace('__PRECACHE__', JSON.stringify(names))
        .replace('__VERSION__', JSON.stringify(hash.digest('hex').slice(0, 12)));
    },
  };
}
