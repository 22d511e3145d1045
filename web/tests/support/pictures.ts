/** Pictures of what the tests see, for people. */
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';

/** Where they go, with `cargo xtask web e2e --pictures`. No test looks at them, and they take a fifth of its time. */
const FOLDER =
  process.env['BOUNCELAB_PICTURES'] === undefined
    ? undefined
    : join(import.meta.dirname, '../screenshots');

/** Takes a picture of the whole page if pictures are wanted. */
export async function picture(page: Page, name: string): Promise<void> {
  if (FOLDER === undefined) return;
  mkdirSync(FOLDER, { recursive: true });
  await page.screenshot({ path: join(FOLDER, `${name}.png`), fullPage: true });
}
