import { join } from 'node:path';
import { defineConfig } from 'vitest/config';

/** The pictures of the page in the book: `cargo xtask book`. */
export default defineConfig({
  test: {
    dir: import.meta.dirname,
    include: ['*.e2e.ts'],
    globalSetup: join(import.meta.dirname, '../harness/temporary.ts'),
    testTimeout: 300_000,
    hookTimeout: 900_000,
  },
});
