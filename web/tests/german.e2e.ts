/** What a German reader saves: report and figures in German, whole and valid; data as in English. */
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { HtmlValidate } from 'html-validate';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { launch, newContext } from './harness/browser.ts';
import { FONT_SETS, nameOf } from './harness/fonts.ts';
import { folder } from './harness/program.ts';
import { Site } from './harness/site.ts';
import { overflow, unfold } from './support/layout.ts';
import { open, settled } from './support/page.ts';

const SHOTS = join(import.meta.dirname, 'screenshots');
/** The width that A4 leaves between the margins of the report, in CSS pixels. */
const PAPER_PX = Math.floor(((210 - 2 * 17) / 25.4) * 96);

let site: Site;
let browser: Browser;
let page: Page;
let report: string;

beforeAll(async () => {
  site = await Site.open();
  browser = await launch();
  mkdirSync(SHOTS, { recursive: true });
  page = (await open(browser, site.url, { locale: 'de-DE' })).page;
  await page.getByRole('button', { name: 'Beispiel ansehen' }).click();
  await settled(page);
  report = join(folder(), 'bericht.html');
  writeFileSync(report, await saved('Bericht (HTML)'));
});
afterAll(async () => {
  await browser.close();
  await site.close();
});

async function saved(button: string): Promise<string> {
  const coming = page.waitForEvent('download');
  await page.getByRole('button', { name: button, exact: true }).click();
  return readFileSync(await (await coming).path(), 'utf8');
}

/** The report as a reader opens it, with its details. */
async function read(by: Browser): Promise<Page> {
  const shown = await (await newContext(by)).newPage();
  await shown.goto(pathToFileURL(report).href);
  await unfold(shown);
  return shown;
}

/** English words that no German text here has. */
const ENGLISH = /\b(the|and|of|which|with|from|impacts?|flights?|drag|speed|height|law|drop)\b/i;

/** What drawings show, each text with its box; boxes within their drawing in its own units. */
function textsOf(shown: Page) {
  return shown.locator('svg[role=img]').evaluateAll((drawings) =>
    (drawings as SVGSVGElement[]).map((drawing) => ({
      title: drawing.querySelector('title')?.textContent ?? '',
      width: drawing.viewBox.baseVal.width,
      height: drawing.viewBox.baseVal.height,
      texts: [...drawing.querySelectorAll('text')].map((text) => {
        const { x, y, width, height } = text.getBBox();
        return { words: text.textContent ?? '', x, y, width, height };
      }),
    })),
  );
}

type Box = { x: number; y: number; width: number; height: number };

/** Whether two texts lie over each other by more than the air around letters. */
const overlap = (a: Box, b: Box): boolean =>
  Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x) > 1 &&
  Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y) > 5;

test('the report is German and valid', async () => {
  const validator = new HtmlValidate({ extends: ['html-validate:standard'] });
  const { results } = await validator.validateFile(report);
  expect(results.flatMap(({ messages }) => messages.map(({ message }) => message))).toEqual([]);
  const shown = await read(browser);
  expect(await shown.locator('html').getAttribute('lang')).toBe('de');
  const said = await shown
    .locator(
      'main p, main li, main dt, main dd, main th, main td, main h2, main h3, caption, figcaption, text',
    )
    .allTextContents();
  // Works are cited by their names.
  const english = said.filter((text) => ENGLISH.test(text) && !/\(\d{4}\)|^JCGM/.test(text));
  expect(english).toEqual([]);
  expect(said.filter((text) => /\d\.\d/.test(text) && !/bouncelab/.test(text))).toEqual([]);
});

describe.each(FONT_SETS.map((fonts) => [nameOf(fonts), fonts] as const))(
  'with %s',
  (set, fonts) => {
    let reader: Browser;
    beforeAll(async () => {
      reader = await launch({ fonts });
    });
    afterAll(() => reader.close());

    test('the report fits a phone and its paper', async () => {
      const shown = await read(reader);
      await shown.screenshot({ path: join(SHOTS, `report-german-${set}.png`), fullPage: true });
      await shown.setViewportSize({ width: 360, height: 740 });
      expect(await overflow(shown)).toBeLessThanOrEqual(0);
      await shown.setViewportSize({ width: PAPER_PX, height: 1000 });
      await shown.emulateMedia({ media: 'print' });
      await shown.screenshot({
        path: join(SHOTS, `report-german-${set}-paper.png`),
        fullPage: true,
      });
      const wide = await shown.evaluate(
        (width) =>
          [...document.querySelectorAll('table')]
            .filter((table) => table.scrollWidth > width)
            .map((table) => `${table.caption?.textContent}: ${table.scrollWidth} px`),
        PAPER_PX,
      );
      expect(wide).toEqual([]);
    });

    test('no words of its figures leave the sheet or lie over each other', async () => {
      const shown = await read(reader);
      const drawings = await textsOf(shown);
      expect(drawings.length).toBeGreaterThan(10);
      for (const { title, width, height, texts } of drawings) {
        const outside = texts.filter(
          (t) => t.x < 0 || t.y < 0 || t.x + t.width > width || t.y + t.height > height,
        );
        expect(outside, title).toEqual([]);
        const over = texts.flatMap((a, i) =>
          texts
            .slice(i + 1)
            .filter((b) => overlap(a, b))
            .map((b) => `${a.words} / ${b.words}`),
        );
        expect(over, title).toEqual([]);
        expect(texts.map(({ words }) => words).filter((words) => words.includes('…'))).toEqual([]);
      }
    });
  },
);

test('a figure is saved in German, data stay as they are', async () => {
  const tabs = await page.getByRole('tab').all();
  for (const tab of tabs) {
    await tab.click();
    const svg = await saved('SVG');
    const texts = [...svg.matchAll(/<(?:title|desc|text)[^>]*>(?:<tspan[^>]*>)?([^<]+)/g)];
    expect(texts.length).toBeGreaterThan(5);
    for (const [, words] of texts) expect(words).not.toMatch(ENGLISH);
  }
  expect((await saved('PNG')).slice(1, 4)).toBe('PNG');
  expect(await saved('Tabelle (CSV)')).toMatch(/^file,drop,/);
  const document = JSON.parse(await saved('Alle Daten (JSON)'));
  expect(document.drops[0].diagnostics[0].message).not.toMatch(ENGLISH);
});

test('what is refused is said in German, and in English when that is chosen', async () => {
  await page.goto(`${site.url}#lab?mass_g=0.01&diameter_mm=100`);
  await page.getByText(/Der Ball wiegt .* er schwebt also/).waitFor();
  await page.getByRole('combobox', { name: 'Sprache' }).selectOption('en');
  await page.getByText(/The ball weighs .* so it floats/).waitFor();
});
