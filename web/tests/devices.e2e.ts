/** Phones and browsers as they are: what the page says of them, and what it keeps in spite of them. */
import { appendFileSync, cpSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import type { Preparation } from './harness/browser.ts';
import { fixture } from './harness/fixture.ts';
import { folder } from './harness/program.ts';
import { Site } from './harness/site.ts';
import { answers, keepAs, open, saved, settled, tryDemo } from './support/page.ts';
import { drop } from './support/sounds.ts';
import { wordsOf } from './support/words.ts';

const here = fixture();

test('a microphone that goes on changing the sound is told of', async () => {
  const { page } = await open(here.browser, here.url, {}, async (context) => {
    await context.addInitScript(() => {
      const settings = MediaStreamTrack.prototype.getSettings;
      MediaStreamTrack.prototype.getSettings = function () {
        return { ...settings.call(this), echoCancellation: true, autoGainControl: true };
      };
    });
  });
  await page.getByRole('button', { name: 'Listen' }).click();
  const notice = page.getByText(
    /although it was asked not to: echo cancellation, automatic gain\./,
  );
  await notice.waitFor();
  await page.getByRole('button', { name: 'Stop' }).click();
  await page.getByText('No drop found.').waitFor();
  expect(await notice.count()).toBe(1);
  await tryDemo(page);
  expect(await notice.count()).toBe(0);
  await page.context().close();
});

type Locked = typeof globalThis & { asked: number; released: number };

/** A browser that grants or refuses to keep its screen on, and counts how often it is asked. */
const lock =
  (isGranted: boolean): Preparation =>
  async (context) => {
    await context.addInitScript((granted) => {
      const counts = Object.assign(globalThis, { asked: 0, released: 0 });
      const request = async () => {
        counts.asked += 1;
        if (!granted) throw new DOMException('saving the battery', 'NotAllowedError');
        return {
          release: async () => {
            counts.released += 1;
          },
        };
      };
      Object.defineProperty(navigator, 'wakeLock', { value: { request } });
    }, isGranted);
  };

test.each([
  [true, 1],
  [false, 0],
])('the screen is kept on, also after the page was away (%s)', async (isGranted, released) => {
  const { page, troubles } = await open(here.browser, here.url, {}, lock(isGranted));
  await page.getByRole('button', { name: 'Listen' }).click();
  await page.getByText('Listening. Drop the ball.').waitFor();
  const counted = (): Promise<[number, number]> =>
    page.evaluate(() => [(globalThis as Locked).asked, (globalThis as Locked).released]);
  await expect.poll(counted).toEqual([1, 0]);
  await page.evaluate(() => document.dispatchEvent(new Event('visibilitychange')));
  await expect.poll(counted).toEqual([2, 0]);
  await page.getByRole('button', { name: 'Stop' }).click();
  await expect.poll(counted).toEqual([2, released]);
  await page.evaluate(() => document.dispatchEvent(new Event('visibilitychange')));
  expect(await counted()).toEqual([2, released]);
  expect(troubles).toEqual([]);
  await page.context().close();
});

test('a browser whose language is none is spoken to in English, and answers', async () => {
  const { page, troubles } = await open(here.browser, here.url, {}, async (context) => {
    await context.addInitScript(() => {
      const own = { language: 'C', languages: ['C', 'en_US.UTF-8'] };
      for (const [name, value] of Object.entries(own))
        Object.defineProperty(Navigator.prototype, name, { get: () => value, configurable: true });
    });
  });
  await tryDemo(page);
  expect((await answers(page)).kept.value).toBeCloseTo(95.29, 1);
  await keepAs(page, 'Anna');
  await page.goto(`${here.url}#drops`);
  await page.locator('tbody tr').first().waitFor();
  expect(troubles).toEqual([]);
  await page.context().close();
});

test('a browser that forgets after a week says so where something is kept', async () => {
  const { page } = await open(here.browser, here.url, {}, async (context) => {
    await context.addInitScript(() => {
      Object.defineProperty(Navigator.prototype, 'vendor', { value: 'Apple Computer, Inc.' });
      navigator.storage.persist = async () => false;
      navigator.storage.persisted = async () => false;
    });
  });
  await tryDemo(page);
  await keepAs(page, 'Anna');
  await page.getByText(/after seven days without a visit/).waitFor();
  await page.context().close();
});

/** A page whose files come from its service worker. */
async function openOffline(site: Site): Promise<Page> {
  const { page } = await open(here.browser, site.url);
  await page.evaluate(async () => {
    await navigator.serviceWorker.ready;
  });
  await page.reload();
  await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
  return page;
}

/** Opens a list of times, which has no sound; its answers. */
async function openTimes(page: Page) {
  const times = Array.from({ length: 12 }, (_, n) => ((0.5 * (1 - 0.9 ** n)) / 0.1).toFixed(5));
  const file = { name: 'own.txt', mimeType: 'text/plain', buffer: Buffer.from(times.join('\n')) };
  await page.locator('input[type=file]').setInputFiles(file);
  await page.locator('#drop-name[value="own.txt"]').waitFor();
  return answers(page);
}

test('a newer page does not throw away what is open', async () => {
  const copy = join(folder(), 'dist');
  cpSync(join(import.meta.dirname, '../dist'), copy, { recursive: true });
  // Its compressed copy would be sent in place of what is written below.
  rmSync(join(copy, 'sw.js.br'));
  const site = await Site.open(copy);
  const page = await openOffline(site);
  await page.locator('input[type=file]').setInputFiles(drop('unkept'));
  const before = await answers(page);
  appendFileSync(join(copy, 'sw.js'), '\n// newer');
  await page.evaluate(async () => {
    await (await navigator.serviceWorker.ready).update();
  });
  await page.getByRole('button', { name: 'Reload' }).click();
  await page.getByText(/^The recording of .* is not in the table of drops\.$/).waitFor();
  await page.getByRole('button', { name: 'Open it' }).click();
  expect(await answers(page)).toEqual(before);

  // Times come back with the address.
  const listed = await openTimes(page);
  appendFileSync(join(copy, 'sw.js'), '\n// newest');
  await page.evaluate(async () => {
    await (await navigator.serviceWorker.ready).update();
  });
  const loaded = page.waitForEvent('load');
  await page.getByRole('button', { name: 'Reload' }).click();
  await loaded;
  await page.waitForFunction(() => location.hash.includes('drop=') === false);
  await page.locator('#drop-name[value="own.txt"]').waitFor();
  expect(await answers(page)).toEqual(listed);
  await page.context().close();
  await site.close();
});

test('a newer page does not wait for what the older one has not ended', async () => {
  const copy = join(folder(), 'busy');
  cpSync(join(import.meta.dirname, '../dist'), copy, { recursive: true });
  rmSync(join(copy, 'sw.js.br'));
  appendFileSync(
    join(copy, 'sw.js'),
    "\nself.addEventListener('message', (event) => event.waitUntil(new Promise(() => {})));",
  );
  const site = await Site.open(copy);
  const page = await openOffline(site);
  const before = await openTimes(page);
  appendFileSync(join(copy, 'sw.js'), '\n// newer');
  await page.evaluate(async () => {
    navigator.serviceWorker.controller?.postMessage('never ends');
    await (await navigator.serviceWorker.ready).update();
  });
  const loaded = page.waitForEvent('load');
  await page.getByRole('button', { name: 'Reload' }).click();
  await loaded;
  await page.locator('#drop-name[value="own.txt"]').waitFor();
  expect(await answers(page)).toEqual(before);
  await page.context().close();
  await site.close();
});

test('a page beside the book links to it, and no other does', async () => {
  const { page } = await open(here.browser, here.url);
  expect(await page.getByRole('link', { name: 'Tutorial and documents' }).count()).toBe(0);
  const copy = join(folder(), 'with-book');
  cpSync(join(import.meta.dirname, '../dist'), copy, { recursive: true });
  rmSync(join(copy, 'index.html.br'));
  const index = join(copy, 'index.html');
  const link = '<link rel="help" href="./book/" /></head>';
  writeFileSync(index, readFileSync(index, 'utf8').replace('</head>', link));
  const site = await Site.open(copy);
  await page.goto(site.url);
  const book = page.getByRole('link', { name: 'Tutorial and documents' });
  expect(await book.evaluate((it) => (it as HTMLAnchorElement).href)).toBe(`${site.url}book/`);
  await page.context().close();
  await site.close();
});

test('tables have semicolons and decimal commas if the reader wants them', async () => {
  const words = wordsOf('de');
  const { page } = await open(here.browser, here.url, { locale: 'de-DE' });
  await page.getByRole('button', { name: words('page-lab-demo') }).click();
  await settled(page);
  const table = async () => readFileSync(await saved(page, words('page-keep-csv')), 'utf8');
  expect(await table()).toMatch(/^recording,drop,.*\r?\nBeispiel,1,1,0\.75/);
  await page.getByLabel(words('page-keep-commas')).check();
  expect(await table()).toMatch(/^recording;drop;.*\r?\nBeispiel;1;1;0,75/);
  await page.locator('.head select').selectOption('en');
  await page.getByRole('button', { name: 'Table (CSV)' }).waitFor();
  expect(await page.getByText('tables with semicolons').count()).toBe(0);
  await page.context().close();
});

test('the page can be installed: its manifest has what browsers ask for', async () => {
  const place = join(import.meta.dirname, '../dist');
  const manifest = JSON.parse(readFileSync(join(place, 'manifest.webmanifest'), 'utf8'));
  expect(manifest.id).toBe('./');
  const sizeOf = (name: string): string => {
    const png = readFileSync(join(place, name));
    return `${png.readUInt32BE(16)}x${png.readUInt32BE(20)}`;
  };
  const pictures = [...manifest.icons, ...manifest.screenshots];
  for (const { src, sizes, type } of pictures) {
    if (type === 'image/png') expect(sizeOf(src), src).toBe(sizes);
  }
  const purposes = manifest.icons.map(({ purpose = 'any' }) => purpose);
  expect(purposes).toEqual(['any', 'any', 'any', 'maskable']);
  expect(
    manifest.screenshots.map(({ form_factor }: { form_factor: string }) => form_factor),
  ).toEqual(['narrow', 'wide']);
});
