import { join } from 'node:path';
import { defineConfig } from 'vitest/config';

/** A whole class; it takes minutes, so it is a check of its own: `cargo xtask test class`. */
export default defineConfig({
  test: {
    dir: import.meta.dirname,
    include: ['*.e2e.ts'],
    globalSetup: join(import.meta.dirname, '../harness/temporary.ts'),
    // Tests wait for states, so this is only for what hangs: busy machines take long.
    testTimeout: 3_600_000,
    hookTimeout: 900_000,
  },
});
