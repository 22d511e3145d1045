import { defineConfig } from 'vitest/config';
import { compressed } from './build/compress.ts';
import { OUTPUT, WORKER } from './build/output.ts';
import { contentSecurityPolicy } from './build/policy.ts';
import { precache } from './build/precache.ts';

export default defineConfig({
  // Static files that work in any folder of any web server.
  base: './',
  plugins: [contentSecurityPolicy(), precache({ source: 'src/sw.ts' }), compressed()],
  build: {
    ...OUTPUT,
    rolldownOptions: {
      output: {
        codeSplitting: {
          // One script for all that the first view needs: on a slow network each request costs more than its bytes.
          groups: [
            { name: 'first', tags: ['$initial'], test: (id: string) => !id.endsWith('/sw.ts') },
          ],
        },
      },
    },
  },
  worker: WORKER,
  test: {
    include: ['src/**/*.test.ts', 'src/**/*.test.tsx'],
    environment: 'node',
  },
});
