/** Takes the pictures of the page that the book has, and that of a notebook if it is named. */
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { BrowserContextOptions, Locator, Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { newContext } from '../harness/browser.ts';
import { fixture } from '../harness/fixture.ts';
import { FONT_SETS } from '../harness/fonts.ts';
import { open, still, tryDemo } from '../support/page.ts';

const FOLDER = join(import.meta.dirname, '../../../docs/images');

/** A notebook as HTML. */
const NOTEBOOK = process.env['BOUNCELAB_NOTEBOOK'];

const here = fixture({ fonts: FONT_SETS[0] });

interface Area {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Saves a page as it is on the screen, or an area of it, as WebP, which only the protocol of Chromium makes. */
async function save(page: Page, name: string, area?: Area): Promise<void> {
  await still(page);
  const client = await page.context().newCDPSession(page);
  const all = area && { clip: { ...area, scale: 1 }, captureBeyondViewport: true };
  const options = { format: 'webp', quality: 65, ...all } as const;
  const { data } = await client.send('Page.captureScreenshot', options);
  writeFileSync(join(FOLDER, `${name}.webp`), Buffer.from(data, 'base64'));
}

/** So much is left free around what is shown. */
const MARGIN_PX = 16;

/** The whole width of a page, from the top of an element, or of the page, to the end of another element. */
async function between(page: Page, first: Locator | undefined, last: Locator): Promise<Area> {
  await still(page);
  const edge = (place: Locator, side: 'top' | 'bottom'): Promise<number> =>
    place.evaluate((element, which) => element.getBoundingClientRect()[which] + scrollY, side);
  const { width } = page.viewportSize() ?? { width: 0 };
  const top = first === undefined ? 0 : (await edge(first, 'top')) - MARGIN_PX;
  const height = Math.ceil((await edge(last, 'bottom')) + MARGIN_PX - top);
  expect(height, 'what is shown is not there').toBeGreaterThan(2 * MARGIN_PX);
  return { x: 0, y: top, width, height };
}

const DESKTOP: BrowserContextOptions = {
  viewport: { width: 1100, height: 900 },
  reducedMotion: 'reduce',
};

const PHONE: BrowserContextOptions = {
  viewport: { width: 390, height: 844 },
  colorScheme: 'dark',
  reducedMotion: 'reduce',
};

async function demo(options: BrowserContextOptions): Promise<Page> {
  const { page } = await open(here.browser, here.url, options);
  await tryDemo(page);
  return page;
}

test('a drop', async () => {
  const page = await demo(DESKTOP);
  await save(
    page,
    'laboratory',
    await between(page, undefined, page.getByText('Save this figure')),
  );
});

test('a drop on a phone, in the dark', async () => {
  const page = await demo(PHONE);
  await save(page, 'laboratory-phone');
});

test.each([
  ['narrow', { width: 540, height: 960 }],
  ['wide', { width: 1280, height: 800 }],
] as const)('a drop as the manifest shows it, %s', async (name, viewport) => {
  const page = await demo({ viewport, reducedMotion: 'reduce' });
  await still(page);
  const path = join(import.meta.dirname, `../../public/screenshot-${name}.png`);
  await page.screenshot({ path });
});

test('two simulated drops', async () => {
  const { page } = await open(here.browser, `${here.url}#simulate?e=0.9`, DESKTOP);
  await page.getByText(/It bounces/).waitFor();
  await page.getByRole('button', { name: 'Keep this run' }).click();
  await still(page);
  const figure = page.locator('.uplot canvas').last();
  const drawn = (): Promise<string> =>
    figure.evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL());
  const before = await drawn();
  await page.getByLabel(/^Restitution \(/).fill('0.85');
  await page.getByText(/It bounces 17 times/).waitFor();
  // The figures follow the words.
  await expect.poll(drawn).not.toBe(before);
  await save(
    page,
    'laboratory-simulate',
    await between(page, undefined, page.locator('.uplot').last()),
  );
});

test('the paper', async () => {
  const { page } = await open(here.browser, `${here.url}#paper`, DESKTOP);
  await page.getByRole('button', { name: 'e falls with speed, ten flights' }).click();
  await page.getByText('That is the result of the paper, to its last digit.').waitFor();
  const chapter = page.locator('.article > section', { hasText: 'Does drag explain' });
  await save(page, 'laboratory-paper', await between(page, chapter, chapter));
});

test.skipIf(NOTEBOOK === undefined)('a notebook', async () => {
  const page = await (
    await newContext(here.browser, { viewport: { width: 900, height: 1000 } })
  ).newPage();
  await page.goto(pathToFileURL(NOTEBOOK as string).href);
  const [title, last] = ['h2#With-bouncelab', '.jp-Cell:has-text("flight-times")'];
  await save(page, 'notebook', await between(page, page.locator(title), page.locator(last).last()));
});
