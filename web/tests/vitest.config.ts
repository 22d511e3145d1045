import { defineConfig } from 'vitest/config';

/** End-to-end tests: what a person does, in a real browser. */
export default defineConfig({
  test: {
    dir: import.meta.dirname,
    include: ['*.e2e.ts'],
    // One browser at a time: two cores are soon busy.
    fileParallelism: false,
    // Tests wait for states, so this is only for what hangs: busy machines take long.
    testTimeout: 300_000,
    expect: { poll: { timeout: 240_000 } },
    // The program may have to be compiled first.
    hookTimeout: 900_000,
  },
});
