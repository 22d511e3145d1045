/** Once opened, the page needs no network: neither to come back nor to work. */

import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { launch } from './harness/browser.ts';
import { Site } from './harness/site.ts';
import { answers, open, settled, tryDemo } from './support/page.ts';
import { LANGUAGES, wordsOf } from './support/words.ts';

let site: Site;
let browser: Browser;

beforeAll(async () => {
  site = await Site.open();
  browser = await launch();
});
afterAll(() => browser.close());

test('it reloads, speaks every language and analyses without a server', async () => {
  const { page } = await open(browser, site.url);
  await page.evaluate(async () => {
    await navigator.serviceWorker.ready;
  });
  await page.reload();
  await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
  await site.close();
  await page.context().setOffline(true);
  await page.reload();
  for (const language of LANGUAGES) {
    const words = wordsOf(language);
    await page.locator('.head select').selectOption(language);
    await page.getByRole('button', { name: words('page-lab-demo') }).waitFor();
  }
  await page.locator('.head select').selectOption('de');
  await page.getByRole('button', { name: 'Beispiel ansehen' }).click();
  await settled(page);
  await page.getByLabel('Sprache').selectOption('en');
  expect((await answers(page)).kept.value).toBeCloseTo(95.29, 1);
});

test('nothing is asked of another origin', async () => {
  const other = await Site.open();
  const { page } = await open(browser, other.url);
  const asked: string[] = [];
  page.on('request', (request) => asked.push(new URL(request.url()).origin));
  await tryDemo(page);
  await answers(page);
  const strangers = asked.filter((origin) => !other.url.startsWith(origin) && origin !== 'null');
  expect(strangers).toEqual([]);
  await other.close();
});
