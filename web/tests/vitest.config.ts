import { defineConfig } from 'vitest/config';

/** End-to-end tests: what a person does, in a real browser. */
export default defineConfig({
  test: {
    dir: import.meta.dirname,
    include: ['*.e2e.ts'],
    // A test mostly waits for its browser: one for each core leaves the cores idle for half of the time.
    maxWorkers: 3,
    // Of the longest files, which would otherwise be alone at the end.
    maxConcurrency: 2,
    // Tests wait for states, so this is only for what hangs: busy machines take long.
    testTimeout: 300_000,
    expect: { poll: { timeout: 240_000 } },
    // The program may have to be compiled first.
    hookTimeout: 900_000,
  },
});
