/** What is kept stays: sounds while the storage fails, all of it as one file, and other deployments. */
import { readFileSync, writeFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { beforeAll, expect, test } from 'vitest';
import { newContext, type Preparation } from './harness/browser.ts';
import { fixture } from './harness/fixture.ts';
import { answers, keepAs, open, saved, savedWav, settled, tryDemo } from './support/page.ts';
import { drop, hearing, lagOf, samplesOf } from './support/sounds.ts';

const here = fixture();
/** It bounces for ten seconds after the first are saved, however late a busy page shows that. */
let long: string;

beforeAll(() => {
  long = drop('long', 0.965);
});

/** Adds a file to the table of drops. */
const add = (page: Page, file: string) => page.getByLabel('Files with drops').setInputFiles(file);

const names = (page: Page) =>
  page
    .locator('tbody input.name')
    .evaluateAll((inputs) => (inputs as HTMLInputElement[]).map(({ value }) => value));

const archived = (page: Page): Promise<string> => saved(page, 'Save all with sound (ZIP)');

test('all drops are saved with their sounds as one file, and added in another browser', async () => {
  const { page, troubles } = await open(here.browser, here.url);
  await tryDemo(page);
  const before = await answers(page);
  const sound = await savedWav(page);
  for (const name of ['Anna', 'Ben']) await keepAs(page, name);
  await page.goto(`${here.url}#drops`);
  const file = await archived(page);
  await page.getByLabel('Name of Anna').press('End');
  await page.getByLabel('Name of Anna').pressSequentially(', renamed');
  await page.getByLabel('Name of Anna').press('Enter');
  await add(page, file);
  await page.getByText('Nothing in it is new.').waitFor();
  expect(await names(page)).toEqual(['Anna, renamed', 'Ben']);
  await page.context().close();

  const { page: elsewhere } = await open(here.browser, `${here.url}#drops`);
  await add(elsewhere, file);
  await elsewhere.getByText('2 drops were added.').waitFor();
  await elsewhere.reload();
  await elsewhere.getByRole('button', { name: 'Open Anna' }).click();
  expect(await answers(elsewhere)).toEqual(before);
  expect(await savedWav(elsewhere)).toEqual(sound);
  await elsewhere.context().close();
  expect(troubles).toEqual([]);
});

test('the opening of a kept sound can be cancelled: what was open stays as it was', async () => {
  const { page, troubles } = await open(here.browser, here.url);
  await tryDemo(page);
  const demo = await answers(page);
  await keepAs(page, 'Anna');
  await page.locator('input[type=file]').setInputFiles(drop('other'));
  await page.locator('#drop-name[value="other.wav"]').waitFor();
  const other = await answers(page);
  // The next worker never answers.
  await page.evaluate(() => {
    const usual = globalThis.Worker;
    class Silent extends EventTarget {
      postMessage() {}
      terminate() {
        globalThis.Worker = usual;
      }
    }
    globalThis.Worker = Silent as unknown as typeof Worker;
  });
  await page.locator('nav a[href="#drops"]').click();
  await page.getByRole('button', { name: 'Open Anna' }).click();
  await page.getByRole('button', { name: 'Cancel' }).click();
  await page.locator('#drop-name[value="other.wav"]').waitFor();
  expect(await answers(page)).toEqual(other);
  expect(await page.getByRole('alert').count()).toBe(0);

  await page.locator('nav a[href="#drops"]').click();
  await page.getByRole('button', { name: 'Open Anna' }).click();
  await page.locator('#drop-name[value="other.wav"]').waitFor({ state: 'detached' });
  expect(await answers(page)).toEqual(demo);
  expect(troubles).toEqual([]);
  await page.context().close();
});

test('a damaged file is refused, and what is kept stays', async () => {
  const { page } = await open(here.browser, here.url);
  await tryDemo(page);
  await keepAs(page, 'Anna');
  await page.goto(`${here.url}#drops`);
  const file = await archived(page);
  const bytes = readFileSync(file);
  writeFileSync(file, bytes.subarray(0, bytes.length / 2));
  await add(page, file);
  const notice = page.getByRole('alert');
  await notice.getByText('This is no whole file of kept drops.').waitFor();
  await notice.getByText(/Copy or download it again/).waitFor();
  expect(await names(page)).toEqual(['Anna']);
  writeFileSync(file, bytes);
  await add(page, file);
  await page.getByText('Nothing in it is new.').waitFor();
  expect(await notice.count()).toBe(0);
  await page.context().close();
});

test.each([
  [true, /keeps what is here until you delete it/],
  [false, /may delete what is kept here/],
])('when the browser promises to keep (%s), the page says so', async (promise, words) => {
  const prepare: Preparation = async (context) => {
    await context.addInitScript((answer) => {
      let asked = false;
      navigator.storage.persisted = async () => asked && answer;
      navigator.storage.persist = async () => {
        asked = true;
        return answer;
      };
    }, promise);
  };
  const { page } = await open(here.browser, here.url, {}, prepare);
  await tryDemo(page);
  expect(await page.getByText(words).count()).toBe(0);
  await keepAs(page, 'Anna');
  await page.getByText(words).waitFor();
  await page.getByRole('link', { name: 'Table of drops' }).click();
  await page.getByText(words).waitFor();
  await page.context().close();
});

const clearings: [string, (page: Page) => Promise<unknown>][] = [
  [
    'the reader',
    (page) =>
      page.evaluate(
        () =>
          new Promise((resolve, reject) => {
            const request = indexedDB.deleteDatabase('bouncelab');
            request.onsuccess = resolve;
            request.onerror = reject;
          }),
      ),
  ],
  [
    'the browser',
    async (page) => {
      const session = await page.context().newCDPSession(page);
      const origin = new URL(here.url).origin;
      await session.send('Storage.clearDataForOrigin', { origin, storageTypes: 'indexeddb' });
    },
  ],
];

test.each(clearings)(
  '%s clears the storage: listening goes on, and all is kept',
  async (_, clear) => {
    const { page } = await open(here.browser, here.url, {}, hearing(long));
    await page.getByRole('button', { name: 'Listen' }).click();
    // A busy page does not show each second.
    await page.getByText(/[1-9]\d* s are saved\./).waitFor();
    await clear(page);
    const before = await answers(page);
    expect(await page.getByRole('alert').count()).toBe(0);
    await keepAs(page, 'Anna');
    await page.goto(`${here.url}#drops`);
    await page.reload();
    await page.getByRole('button', { name: 'Open Anna' }).click();
    expect(await answers(page)).toEqual(before);
    await page.context().close();
  },
);

/** Where the database says that sound was lost. */
const gapsOf = (page: Page): Promise<{ start_s: number; duration_s: number }[]> =>
  page.evaluate(
    () =>
      new Promise((resolve, reject) => {
        const request = indexedDB.open('bouncelab');
        request.onerror = () => reject(request.error);
        request.onsuccess = () => {
          const all = request.result.transaction('recordings').objectStore('recordings').getAll();
          all.onsuccess = () => resolve(all.result.flatMap(({ gaps = [] }) => gaps));
        };
      }),
  );

test('sound that the browser does not deliver is a gap, and later times hold', async () => {
  // Longer than a ball may be silent before it is said to rest.
  const unplugged = hearing(long, { afterS: 5, forS: 2 });
  const { page } = await open(here.browser, here.url, {}, unplugged);
  await page.getByRole('button', { name: 'Listen' }).click();
  await settled(page);
  await page.getByText(/Sound was lost at/).waitFor();
  const [{ rateHz, samples }, played] = [await savedWav(page), samplesOf(long)];
  const gaps = (await gapsOf(page)).map(
    (gap) => [gap.start_s, gap.start_s + gap.duration_s] as const,
  );
  const [from, to] = gaps.toSorted((a, b) => b[1] - b[0] - (a[1] - a[0]))[0] ?? [0, 0];
  const part = (fromS: number, toS: number) => ({
    rateHz,
    samples: samples.subarray(Math.round(fromS * rateHz), Math.round(toS * rateHz)),
  });
  expect(to - from).toBeGreaterThan(0.25);
  expect(part(from, to).samples.every((sample) => sample === 0)).toBe(true);

  // A busy machine loses sound of its own: what lies between two gaps, and has most of the ball in it, tells the time.
  const edges = [0, ...gaps.flat(), samples.length / rateHz].toSorted((a, b) => a - b);
  const whole = Array.from({ length: edges.length / 2 }, (_, n) => {
    const [start = 0, end = 0] = edges.slice(2 * n, 2 * n + 2);
    const sound = part(start, end);
    return { start, end, sound, energy: sound.samples.reduce((sum, x) => sum + x * x, 0) };
  });
  const lag = (pieces: typeof whole): number => {
    const loudest = pieces.toSorted((a, b) => b.energy - a.energy)[0];
    if (!loudest) throw new Error('the gap has no sound on both sides of it');
    return lagOf(loudest.sound, played) - loudest.start;
  };
  const before = lag(whole.filter(({ end }) => end <= from));
  const after = lag(whole.filter(({ start }) => start >= to));
  expect(Math.abs(after - before)).toBeLessThan(0.003);

  // A kept recording knows its gaps.
  const then = await answers(page);
  await keepAs(page, 'Anna');
  await page.goto(`${here.url}#drops`);
  await page.reload();
  await page.getByRole('button', { name: 'Open Anna' }).click();
  expect(await answers(page)).toEqual(then);
  await page.getByText(/Sound was lost at/).waitFor();
  await page.context().close();
});

test('the service worker deletes its own old caches only', async () => {
  const context = await newContext(here.browser);
  const page = await context.newPage();
  await page.goto(`${here.url}icon.svg`);
  const foreign = [`bouncelab ${here.url}elsewhere/ 0123`, 'bouncelab-0123', 'others'];
  const old = `bouncelab ${here.url} 0123`;
  await page.evaluate(
    (caches_) => Promise.all(caches_.map((name) => caches.open(name))),
    [...foreign, old],
  );
  await page.goto(here.url);
  await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
  const left = await page.evaluate(() => caches.keys());
  expect(left).toEqual(expect.arrayContaining(foreign));
  expect(left).not.toContain(old);
  await context.close();
});
