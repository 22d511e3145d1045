/** The package for pages of others: `npm run package`. */
import { defineConfig } from 'vite';

export default defineConfig({
  root: import.meta.dirname,
  // Wherever the package lies, its parts lie beside it.
  base: './',
  build: {
    target: 'es2022',
    outDir: 'dist',
    emptyOutDir: true,
    assetsInlineLimit: 0,
    reportCompressedSize: false,
    modulePreload: false,
    rollupOptions: {
      input: 'src/index.ts',
      // A page imports what it exports.
      preserveEntrySignatures: 'strict',
      output: { entryFileNames: 'bouncelab.js' },
    },
  },
  worker: { format: 'es' },
  logLevel: 'warn',
});
