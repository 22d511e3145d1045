import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Plugin } from 'vite';

/** Puts the lesson sheets, which the program makes, beside the page. */
export function lessons({ folder }: { folder: string }): Plugin {
  return {
    name: 'bouncelab:lessons',
    apply: 'build',
    buildStart() {
      for (const name of readdirSync(folder)) {
        const source = readFileSync(join(folder, name));
        this.emitFile({ type: 'asset', fileName: `lessons/${name}`, source });
      }
    },
  };
}
