/** What a reader of another language saves: report and figures in it, whole and valid; data as in English. */
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { HtmlValidate } from 'html-validate';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { launch, newContext } from './harness/browser.ts';
import { fixture } from './harness/fixture.ts';
import { FONT_SETS, nameOf } from './harness/fonts.ts';
import { overflow, unfold } from './support/layout.ts';
import { open, saved, settled, tabsOfAll } from './support/page.ts';
import { picture } from './support/pictures.ts';
import { drawings, troublesOf } from './support/texts.ts';
import { LANGUAGES, wordsOf } from './support/words.ts';

/** The width that A4 leaves between the margins of the report, in CSS pixels. */
const PAPER_PX = Math.floor(((210 - 2 * 17) / 25.4) * 96);
/** English words that no text here has in another language. */
const ENGLISH = /\b(the|and|of|which|with|from|flights?|drag|speed|height|law|drop)\b/i;

/** What is said of a ball that floats in air. */
const FLOATS: Readonly<Record<string, RegExp>> = {
  de: /Der Ball wiegt .* er schwebt also/,
  es: /La pelota pesa .* así que flota/,
  fr: /La balle pèse .* elle flotte/,
};

const here = fixture();
/** One for each set of fonts. */
let readers: Browser[];

beforeAll(async () => {
  readers = await Promise.all(FONT_SETS.map((fonts) => launch({ fonts })));
});
afterAll(async () => {
  await Promise.all(readers.map((it) => it.close()));
});

describe.each(LANGUAGES.filter((code) => code !== 'en'))('in the language %s', (language) => {
  const words = wordsOf(language);
  let page: Page;
  let report: string;

  beforeAll(async () => {
    page = (await open(here.browser, here.url, { locale: language })).page;
    await page.getByRole('button', { name: words('page-lab-demo') }).click();
    await settled(page);
    report = await saved(page, words('page-keep-report'));
  });
  afterAll(() => page.context().close());

  const content = async (button: string): Promise<string> =>
    readFileSync(await saved(page, button), 'utf8');

  /** The report as a reader opens it, with its details. */
  async function read(by: Browser): Promise<Page> {
    const shown = await (await newContext(by)).newPage();
    await shown.goto(pathToFileURL(report).href);
    await unfold(shown);
    return shown;
  }

  test('the report speaks it and is valid', async () => {
    const validator = new HtmlValidate({ extends: ['html-validate:standard'] });
    const { results } = await validator.validateFile(report);
    expect(results.flatMap(({ messages }) => messages.map(({ message }) => message))).toEqual([]);
    const shown = await read(here.browser);
    expect(await shown.locator('html').getAttribute('lang')).toBe(language);
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

  describe.each(FONT_SETS.map((fonts, index) => [nameOf(fonts), index] as const))(
    'with %s',
    (set, index) => {
      const reader = (): Browser => readers[index] as Browser;

      test('the report fits a phone and its paper', async () => {
        const shown = await read(reader());
        await picture(shown, `report-${language}-${set}`);
        await shown.setViewportSize({ width: 360, height: 740 });
        expect(await overflow(shown)).toBeLessThanOrEqual(0);
        await shown.setViewportSize({ width: PAPER_PX, height: 1000 });
        await shown.emulateMedia({ media: 'print' });
        await picture(shown, `report-${language}-${set}-paper`);
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
        const found = await drawings(await read(reader()));
        expect(found.length).toBeGreaterThan(10);
        expect(found.flatMap(troublesOf)).toEqual([]);
      });
    },
  );

  test('figures are saved in it, data stay as they are', async () => {
    const tabs = await tabsOfAll(page);
    for (const tab of tabs) {
      await tab.click();
      const svg = await content('SVG');
      const texts = [...svg.matchAll(/<(?:title|desc|text)[^>]*>(?:<tspan[^>]*>)?([^<]+)/g)];
      expect(texts.length).toBeGreaterThan(5);
      for (const [, said] of texts) expect(said).not.toMatch(ENGLISH);
    }
    expect((await content('PNG')).slice(1, 4)).toBe('PNG');
    expect(await content(words('page-keep-csv'))).toMatch(/^recording,drop,/);
    const document = JSON.parse(await content(words('page-keep-json')));
    expect(document.settings.assumptions[0].message).not.toMatch(ENGLISH);
  });

  test('what is refused is said in it, and in English when that is chosen', async () => {
    await page.goto(`${here.url}#lab?drop=AAAA`);
    await page.getByRole('alert').getByText(words('page-reason-link-changed')).waitFor();
    await page.goto(`${here.url}#lab?mass_g=0.01&diameter_mm=100`);
    await page.getByText(FLOATS[language] ?? '').waitFor();
    const choice = page.getByRole('combobox', { name: words('page-app-language') });
    await choice.selectOption('en');
    await page.getByText(/The ball weighs .* so it floats/).waitFor();
  });
});
