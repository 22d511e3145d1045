import { join } from 'node:path';
import { defineConfig } from 'vitest/config';
import { BaseSequencer, type TestSpecification } from 'vitest/node';
import { FIREFOX } from './harness/firefox.ts';

const setUp = (name: string): string => join(import.meta.dirname, `harness/${name}.ts`);

/** Begins with the file whose tests wait for each other, so that it is not alone at the end. */
class Sequencer extends BaseSequencer {
  override async sort(files: TestSpecification[]): Promise<TestSpecification[]> {
    const isFirst = ({ moduleId }: TestSpecification) => moduleId.endsWith('/kill.e2e.ts');
    return (await super.sort(files)).toSorted((a, b) => Number(isFirst(b)) - Number(isFirst(a)));
  }
}

/** End-to-end tests: what a person does, in a real browser: Chromium, or the Firefox that is named. */
export default defineConfig({
  test: {
    dir: import.meta.dirname,
    include: ['*.e2e.ts'],
    globalSetup: [setUp('temporary'), ...(FIREFOX ? [setUp('sound-server')] : [])],
    ...(FIREFOX && { setupFiles: setUp('exceptions') }),
    sequence: { sequencer: Sequencer },
    // One more than the cores of the usual machine, because a test waits for its browser now and then.
    maxWorkers: 3,
    // Of the files whose tests do not wait for each other.
    maxConcurrency: 2,
    // Tests wait for states, so this is only for what hangs: busy machines take long.
    testTimeout: 300_000,
    expect: { poll: { timeout: 240_000 } },
    // The program may have to be compiled first.
    hookTimeout: 900_000,
  },
});
