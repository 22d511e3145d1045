/** The package for pages of others: `npm run package`. */
import { defineConfig } from 'vite';
import { OUTPUT, WORKER } from '../build/output.ts';

export default defineConfig({
  root: import.meta.dirname,
  // Wherever the package lies, its parts lie beside it.
  base: './',
  build: {
    ...OUTPUT,
    modulePreload: false,
    rollupOptions: {
      input: 'src/index.ts',
      // A page imports what it exports.
      preserveEntrySignatures: 'strict',
      output: { entryFileNames: 'bouncelab.js' },
    },
  },
  worker: WORKER,
  logLevel: 'warn',
});
