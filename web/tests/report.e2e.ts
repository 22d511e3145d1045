/** Reports of the command line: valid, silent, whole on paper and on a phone, whatever a name contains. */
import { copyFileSync, existsSync, mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { HtmlValidate } from 'html-validate';
import type { Browser, BrowserContextOptions, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, describe, expect, test } from 'vitest';
import { closeContexts, launch, newContext } from './harness/browser.ts';
import { FONT_SETS, nameOf } from './harness/fonts.ts';
import { bouncelab, folder, synth } from './harness/program.ts';
import { overflow, printed, printedPages, unfold, violations } from './support/layout.ts';
import { LANGUAGES } from './support/words.ts';

/** Whatever a file system allows in a name and a browser might obey. */
const HOSTILE = `a"><img src=x onerror="alert(1)"> & 'b' \`c\` | $x$.wav`;

/** A floor with such a name. */
const WOOD = '<b>wood & co';

/** The width that A4 leaves between the margins of the report, in CSS pixels. */
const PAPER_PX = Math.floor(((210 - 2 * 17) / 25.4) * 96);

/** The reports there are, by the command that writes them. */
const REPORTS = ['analyze', 'session', 'verdict'] as const;

/** What each says to the letter, however it reads to a browser. */
const WRITTEN = { analyze: HOSTILE, session: WOOD, verdict: HOSTILE };

let place: string;

const reportOf = (command: string): string => join(place, `${command}.html`);

beforeAll(async () => {
  place = folder();
  const { path } = synth(join(place, 'drop.wav'), '--height', '40cm', '--snr', '30');
  const hostile = join(place, HOSTILE);
  copyFileSync(path, hostile);
  bouncelab('analyze', hostile, '--height', '40cm', '--report', reportOf('analyze'));
  many();
});

/** Two balls on two floors, two drops each, as a session; a drop that passes a rule. */
function many(): void {
  const recordings = join(place, 'recordings');
  mkdirSync(recordings);
  const kinds = ['old', 'new'].flatMap((ball) => ['steel', WOOD].map((floor) => [ball, floor]));
  for (const [at, [ball, floor]] of [...kinds, ...kinds].entries()) {
    const path = join(recordings, `${ball}_${floor}_${at}.wav`);
    synth(path, '--restitution', String(0.93 - 0.002 * at), '--seed', String(at));
  }
  const pattern = ['--pattern', '{ball}_{surface}_{}', '--ball', 'table-tennis-40'];
  const output = ['--output', join(place, 'session'), '--report', reportOf('session')];
  bouncelab('session', recordings, ...pattern, ...output);
  const passes = join(place, `passes ${HOSTILE}`);
  synth(join(place, 'passes.wav'), '--restitution', '0.93');
  copyFileSync(join(place, 'passes.wav'), passes);
  const kept = ['--height', '30.5cm', '--kept', 'surface'];
  bouncelab('verdict', '--rule', 'ittf-ball', passes, ...kept, '--report', reportOf('verdict'));
}

/** Opens a report; everything it says or asks for that nobody sees. */
async function open(
  browser: Browser,
  report: string,
  options: BrowserContextOptions = {},
): Promise<{ page: Page; troubles: string[] }> {
  const page = await (await newContext(browser, options)).newPage();
  const troubles: string[] = [];
  page.on('console', (message) => troubles.push(message.text()));
  page.on('pageerror', (error) => troubles.push(String(error)));
  page.on('dialog', (dialog) => {
    troubles.push(`a dialog: ${dialog.message()}`);
    void dialog.dismiss();
  });
  page.on('request', (request) => troubles.push(`a request: ${request.url().slice(0, 80)}`));
  await page.goto(pathToFileURL(report).href, { waitUntil: 'networkidle' });
  return { page, troubles };
}

test.each(REPORTS)('the report of %s is valid HTML', async (command) => {
  const validator = new HtmlValidate({ extends: ['html-validate:standard'] });
  const { results } = await validator.validateFile(reportOf(command));
  expect(results.flatMap(({ messages }) => messages.map(({ message }) => message))).toEqual([]);
});

describe.each(FONT_SETS.map((fonts) => [nameOf(fonts), fonts] as const))('with %s', (_, fonts) => {
  let browser: Browser;
  // Another set of fonts has letters of other sizes, and nothing else.
  const rules = fonts === FONT_SETS[0] ? 'all' : 'of size';
  beforeAll(async () => {
    browser = await launch({ microphone: 'missing', fonts });
  });
  afterEach(() => closeContexts(browser));
  afterAll(() => browser.close());

  test.each(REPORTS)(
    'the report of %s asks for nothing but itself and says nothing',
    async (command) => {
      const { page, troubles } = await open(browser, reportOf(command));
      expect(troubles.filter((trouble) => !trouble.startsWith('a request: file:'))).toEqual([]);
      expect(troubles.length).toBe(1);
      expect(await page.locator('figure svg').count()).toBeGreaterThan(0);
      expect(await page.locator('body').textContent()).toContain(WRITTEN[command]);
    },
  );

  test.each(REPORTS)(
    'the report of %s fits a phone, light and dark, and can be used by everyone',
    async (command) => {
      for (const colorScheme of ['light', 'dark'] as const) {
        const viewport = { width: 360, height: 740 };
        const { page } = await open(browser, reportOf(command), { viewport, colorScheme });
        expect(await violations(page, { rules })).toEqual([]);
        await unfold(page);
        expect(await overflow(page)).toBeLessThanOrEqual(0);
        expect(await violations(page, { rules })).toEqual([]);
      }
    },
  );

  test.each(REPORTS)('the report of %s loses nothing on paper', async (command) => {
    const { page } = await open(browser, reportOf(command), {
      viewport: { width: PAPER_PX, height: 1000 },
    });
    await unfold(page);
    await page.emulateMedia({ media: 'print' });
    expect(await overflow(page)).toBeLessThanOrEqual(0);
    const wide = await page
      .locator('table')
      .evaluateAll(
        (tables, width) => tables.filter((table) => table.scrollWidth > width).length,
        PAPER_PX,
      );
    expect(wide).toBe(0);
    for (const format of ['A4', 'Letter'] as const) {
      const pdf = await printed(page, format);
      expect(pdf.subarray(0, 5).toString()).toBe('%PDF-');
    }
  });
});

describe('the report of one drop', () => {
  let browser: Browser;
  beforeAll(async () => {
    browser = await launch({ microphone: 'missing' });
  });
  afterEach(() => closeContexts(browser));
  afterAll(() => browser.close());

  /** How many pages it has on each paper, as written by the command with these options. */
  async function pages(...options: string[]): Promise<number[]> {
    const report = join(place, 'paper.html');
    const ball = ['--ball', 'table-tennis-40', '--height', '40cm'];
    bouncelab('analyze', join(place, 'drop.wav'), ...ball, '--report', report, ...options);
    const { page } = await open(browser, report);
    return [await printedPages(page, 'A4'), await printedPages(page, 'Letter')];
  }

  test.each(LANGUAGES)('is short on paper, in the language %s', async (language) => {
    for (const count of await pages('--language', language)) {
      expect(count).toBeGreaterThanOrEqual(3);
      expect(count).toBeLessThanOrEqual(4);
    }
  });

  test('the program prints it', () => {
    const printed = join(place, 'drop.pdf');
    bouncelab('analyze', join(place, 'drop.wav'), '--report', printed);
    expect(readFileSync(printed).subarray(0, 5).toString()).toBe('%PDF-');
  });

  test('prints its details if asked', async () => {
    for (const count of await pages('--report-details')) expect(count).toBeGreaterThan(8);
  });

  test('prints the details that the reader unfolds', async () => {
    const { page } = await open(browser, reportOf('analyze'));
    const short = await printedPages(page, 'A4');
    await page.getByRole('heading', { name: 'Details' }).click();
    expect(await printedPages(page, 'A4')).toBeGreaterThan(2 * short);
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
