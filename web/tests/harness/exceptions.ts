/** Skips the tests that cannot run in Firefox, and says why. */
import { basename } from 'node:path';
import { beforeEach } from 'vitest';
import { reasonAgainst } from './firefox.ts';

beforeEach(({ task, skip }) => {
  const reason = reasonAgainst(basename(task.file.filepath), task.name);
  if (reason !== undefined) skip(reason);
});
