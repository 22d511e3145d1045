import { defineConfig } from 'vitest/config';

/** Stories played in a real Chromium, one after the other: they measure times. */
export default defineConfig({
  test: {
    root: import.meta.dirname,
    include: ['*.story.ts'],
    fileParallelism: false,
    testTimeout: 60_000,
    hookTimeout: 120_000,
  },
});
