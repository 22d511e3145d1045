import { join } from 'node:path';
import { defineConfig } from 'vitest/config';

/** The page in WebKitGTK; what drives it is a check of its own: `cargo xtask test webkit`. */
export default defineConfig({
  test: {
    dir: import.meta.dirname,
    include: ['*.e2e.ts'],
    globalSetup: join(import.meta.dirname, '../harness/temporary.ts'),
    // Tests wait for states, so this is only for what hangs: busy machines take long.
    testTimeout: 300_000,
    expect: { poll: { timeout: 240_000 } },
    hookTimeout: 900_000,
  },
});
