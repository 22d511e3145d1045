import { defineConfig } from 'vitest/config';
import { compressed } from './build/compress.ts';
import { lessons } from './build/lessons.ts';
import { contentSecurityPolicy } from './build/policy.ts';
import { precache } from './build/precache.ts';

export default defineConfig({
  // Static files that work in any folder of any web server.
  base: './',
  plugins: [
    contentSecurityPolicy(),
    lessons({ folder: '../docs/lessons' }),
    precache({ source: 'src/sw.ts' }),
    compressed(),
  ],
  build: {
    target: 'es2022',
    outDir: 'dist',
    emptyOutDir: true,
    // Nothing inline: the content security policy allows no data: scripts or styles.
    assetsInlineLimit: 0,
    // The size that counts is printed, and checked, by scripts/size.mjs.
    reportCompressedSize: false,
  },
  worker: { format: 'es' },
  test: {
    include: ['src/**/*.test.ts', 'src/**/*.test.tsx'],
    environment: 'node',
  },
});
