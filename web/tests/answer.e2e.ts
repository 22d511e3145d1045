/** The answer comes first: in view on the smallest phone and at 200 %, and again after the next drop. */

import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { fixture } from './harness/fixture.ts';
import { answers, dropFile, open, settled, still, tryDemo } from './support/page.ts';
import { picture } from './support/pictures.ts';
import { drop, hearing, TRUTH } from './support/sounds.ts';
import { LANGUAGES, wordsOf } from './support/words.ts';

const here = fixture();

const SMALLEST = {
  viewport: { width: 320, height: 568 },
  hasTouch: true,
  isMobile: true,
  deviceScaleFactor: 2,
} as const;
const ZOOMED = { viewport: { width: 640, height: 450 }, deviceScaleFactor: 2 } as const;

/** What of the answer is out of sight: above or below the window, or under the strip with the button. */
const hidden = (page: Page): Promise<string[]> =>
  page.evaluate(() => {
    const button = document.querySelector('.again .listen') as HTMLElement;
    const isFixed = getComputedStyle(button).position === 'fixed';
    const bottom = isFixed ? button.getBoundingClientRect().top : innerHeight;
    return ['.summary .first', '.summary .second', '.summary .curve'].filter((place) => {
      const box = document.querySelector(place)?.getBoundingClientRect();
      return !box || box.top < 0 || box.bottom > bottom + 1;
    });
  });

for (const [name, options] of [
  ['the smallest phone', SMALLEST],
  ['200 per cent', ZOOMED],
] as const) {
  test.concurrent.each(LANGUAGES)(`on ${name} the answer is seen at once, %s`, async (locale) => {
    const words = wordsOf(locale);
    const { page } = await open(here.browser, here.url, { ...options, locale });
    await page.getByRole('button', { name: words('page-lab-demo') }).click();
    await settled(page);
    await still(page);
    await picture(page, `answer-${locale}-${options.viewport.width}`);
    expect(await hidden(page)).toEqual([]);
    await page.context().close();
  });
}

test('the next answer is scrolled to', async () => {
  const { page } = await open(here.browser, here.url, SMALLEST);
  await tryDemo(page);
  await page.getByText('All numbers').scrollIntoViewIfNeeded();
  expect((await hidden(page)).length).toBe(3);
  const next = drop('next');
  await dropFile(page, 'next.wav', readFileSync(next));
  await page.locator('#drop-name[value="next.wav"]').waitFor();
  await settled(page);
  await expect.poll(() => hidden(page)).toEqual([]);
  await page.context().close();
});

test('while it bounces, the height curve grows hop by hop', async () => {
  const { page } = await open(here.browser, here.url, SMALLEST, hearing(drop('live', 0.965)));
  await page.getByRole('button', { name: 'Listen' }).click();
  const hops = async (): Promise<number> => {
    const path = page.locator('.curve path:not(.floor)');
    if ((await path.count()) === 0) return 0;
    return ((await path.getAttribute('d')) ?? '').match(/Q/g)?.length ?? 0;
  };
  await expect.poll(hops).toBeGreaterThan(3);
  const some = await hops();
  await expect.poll(hops).toBeGreaterThan(some);
  await picture(page, 'answer-live');
  await settled(page);
  await page.context().close();
});

test('where a ball should have been heard, the page says what helps', async () => {
  const { page } = await open(here.browser, here.url);
  await page.getByRole('button', { name: 'Listen' }).click();
  await page.getByText(/Nothing loud was heard yet|There are sounds, but no bounces/).waitFor();
  await page.getByRole('button', { name: 'Stop' }).click();
  await page.getByText('No drop found.').waitFor();
  const notice = page.locator('.summary .notice');
  const box = await notice.boundingBox();
  expect((box?.y ?? 0) + (box?.height ?? 1e4)).toBeLessThan(900);
  await page.context().close();
});

test('what may be a drop is offered, and is one once a reader says so', async () => {
  const { page } = await open(here.browser, here.url);
  const few = drop('few', TRUTH.restitution, '--bounces', '3');
  await dropFile(page, 'few.wav', readFileSync(few));
  await page.getByText(/Possibly a drop from \d+\.\d s: 4 impacts/).waitFor();
  await page.getByRole('button', { name: 'It is a drop' }).click();
  await settled(page);
  const { kept } = await answers(page);
  expect(Math.abs(kept.value - 100 * TRUTH.restitution)).toBeLessThan(3.5 * kept.sd);
  await page.getByRole('button', { name: 'Undo', exact: true }).first().click();
  await page.getByRole('button', { name: 'It is a drop' }).waitFor();
  await page.context().close();
});

test('too few impacts are never claimed of a good file', async () => {
  const { page } = await open(here.browser, here.url, {}, async (context) => {
    await context.addInitScript(() => {
      const said: string[] = [];
      Object.assign(globalThis, { said });
      new MutationObserver(() => {
        const words = document.querySelector('.summary')?.textContent ?? '';
        if (/too few impacts/.test(words)) said.push(words);
      }).observe(document, { subtree: true, childList: true, characterData: true });
    });
  });
  await tryDemo(page);
  expect(await page.evaluate(() => (globalThis as unknown as { said: string[] }).said)).toEqual([]);
  await page.context().close();
});

test('a lesson sees four figures, and the words of science only when it asks', async () => {
  const { page } = await open(here.browser, here.url);
  await tryDemo(page);
  const tabs = await page.getByRole('tab').allInnerTexts();
  expect(tabs).toEqual(['Restitution', 'Height', 'Energy', 'With and without air']);
  const seen = await page.locator('.summary, .explained, .choose').allInnerTexts();
  expect(seen.join(' ')).not.toMatch(/posterior|residual|truncation|log-linear|clift|morrison/i);
  await page.getByRole('button', { name: 'More figures' }).click();
  await page.getByRole('tab', { name: 'Posterior' }).waitFor();
  await page.context().close();
});

test('a simulated ball is seen moving, but not where motion is unwanted', async () => {
  const place = (page: Page) => page.locator('.curve .moving').getAttribute('style');
  const { page } = await open(here.browser, `${here.url}#simulate`);
  await page.locator('.curve .moving').waitFor();
  const first = await place(page);
  await expect.poll(() => place(page)).not.toBe(first);
  const { page: calm } = await open(here.browser, `${here.url}#simulate`, {
    reducedMotion: 'reduce',
  });
  await calm.locator('.curve').waitFor();
  expect(await calm.locator('.curve .moving').count()).toBe(0);
  for (const on of [page, calm]) await on.context().close();
});
