/** Reports of the command line: valid, silent, whole on paper and on a phone, whatever a name contains. */
import { copyFileSync, existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { HtmlValidate } from 'html-validate';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { launch } from './harness/browser.ts';
import { bouncelab, folder, synth } from './harness/program.ts';

/** Whatever a file system allows in a name and a browser might obey. */
const HOSTILE = `a"><img src=x onerror="alert(1)"> & 'b' \`c\` | $x$.wav`;

/** The width that A4 leaves between the margins of the report, in CSS pixels. */
const PAPER_PX = Math.floor(((210 - 2 * 17) / 25.4) * 96);

let browser: Browser;
let place: string;
let report: string;

beforeAll(async () => {
  place = folder();
  const { path } = synth(join(place, 'drop.wav'), '--height', '40cm', '--snr', '30');
  const hostile = join(place, HOSTILE);
  copyFileSync(path, hostile);
  report = join(place, 'report.html');
  bouncelab('analyze', hostile, '--height', '40cm', '--report', report);
  browser = await launch('missing');
});

afterAll(() => browser.close());

/** Opens the report; everything it says or asks for that nobody sees. */
async function open(options = {}): Promise<{ page: Page; troubles: string[] }> {
  const page = await (await browser.newContext(options)).newPage();
  const troubles: string[] = [];
  page.on('console', (message) => troubles.push(message.text()));
  page.on('pageerror', (error) => troubles.push(String(error)));
  page.on('dialog', (dialog) => troubles.push(`a dialog: ${dialog.message()}`));
  page.on('request', (request) => troubles.push(`a request: ${request.url().slice(0, 80)}`));
  await page.goto(pathToFileURL(report).href);
  return { page, troubles };
}

/** How far the page reaches beyond its window, in pixels. */
function beyond(page: Page): Promise<number> {
  return page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
}

describe('a report', () => {
  test('is valid HTML', async () => {
    const validator = new HtmlValidate({ extends: ['html-validate:standard'] });
    const { results } = await validator.validateFile(report);
    expect(results.flatMap(({ messages }) => messages.map(({ message }) => message))).toEqual([]);
  });

  test('asks for nothing but itself and says nothing', async () => {
    const { page, troubles } = await open();
    await page.waitForTimeout(300);
    expect(troubles.filter((trouble) => !trouble.startsWith('a request: file:'))).toEqual([]);
    expect(troubles.length).toBe(1);
    expect(await page.locator('h1').textContent()).toBe(HOSTILE);
    expect(await page.locator('figure svg').count()).toBeGreaterThan(8);
  });

  test('fits a phone, light and dark', async () => {
    for (const colorScheme of ['light', 'dark'] as const) {
      const viewport = { width: 360, height: 740 };
      const { page } = await open({ viewport, colorScheme });
      expect(await beyond(page)).toBeLessThanOrEqual(0);
    }
  });

  test('loses nothing on paper', async () => {
    const { page } = await open({ viewport: { width: PAPER_PX, height: 1000 } });
    await page.emulateMedia({ media: 'print' });
    expect(await beyond(page)).toBeLessThanOrEqual(0);
    const wide = await page
      .locator('table')
      .evaluateAll(
        (tables, width) => tables.filter((table) => table.scrollWidth > width).length,
        PAPER_PX,
      );
    expect(wide).toBe(0);
    for (const format of ['A4', 'Letter']) {
      const pdf = await page.pdf({ format, preferCSSPageSize: false });
      expect(pdf.subarray(0, 5).toString()).toBe('%PDF-');
    }
  });
});

test('a notebook finds its figures', () => {
  const notebook = join(place, 'drop.md');
  bouncelab('analyze', join(place, 'drop.wav'), '--report', notebook);
  const names = [...readFileSync(notebook, 'utf8').matchAll(/\]\(<(.+?)>\)/g)].map(
    ([, name]) => name,
  );
  expect(names.length).toBeGreaterThan(8);
  for (const name of names) {
    expect(existsSync(join(place, name ?? '')), name).toBe(true);
  }
});
