/** What most files of tests need: the page, and a browser for it. */
import type { Browser } from 'playwright-core';
import { afterAll, beforeAll } from 'vitest';
import { launch, type Options } from './browser.ts';
import { Site } from './site.ts';

export interface Fixture {
  /** The address of the page. */
  readonly url: string;
  readonly browser: Browser;
}

/** Opens both before the first test of a file, and closes them after its last; they are there in between. */
export function fixture(options: Options = {}): Fixture {
  const opened = {} as { -readonly [Part in keyof Fixture]: Fixture[Part] };
  let site: Site;
  beforeAll(async () => {
    site = await Site.open();
    opened.url = site.url;
    opened.browser = await launch(options);
  });
  afterAll(async () => {
    await opened.browser.close();
    await site.close();
  });
  return opened;
}
