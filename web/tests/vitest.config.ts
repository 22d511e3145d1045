import { join } from 'node:path';
import { defineConfig } from 'vitest/config';
import { FIREFOX } from './harness/firefox.ts';

const setUp = (name: string): string => join(import.meta.dirname, `harness/${name}.ts`);

/** End-to-end tests: what a person does, in a real browser: Chromium, or the Firefox that is named. */
export default defineConfig({
  test: {
    dir: import.meta.dirname,
    include: ['*.e2e.ts'],
    ...(FIREFOX && { globalSetup: setUp('sound-server'), setupFiles: setUp('exceptions') }),
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
