import { defineConfig } from 'vitest/config';

/** Stories: what a person does, played in a real browser, one file each. */
export default defineConfig({
  test: {
    dir: import.meta.dirname,
    include: ['*.story.ts'],
    // One browser at a time: times are measured, and two cores are soon busy.
    fileParallelism: false,
    testTimeout: 60_000,
    // A busy machine makes a browser miss a moment; what is wrong is wrong twice.
    retry: 1,
    // The program may have to be compiled first.
    hookTimeout: 900_000,
  },
});
