/** A test series on the page, from its beginning to the report, and the same job in the program. */
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { beforeAll, expect, test } from 'vitest';
import { fixture } from './harness/fixture.ts';
import { bouncelab, folder } from './harness/program.ts';
import { overflow, violations } from './support/layout.ts';
import { open, saved, still } from './support/page.ts';
import { picture } from './support/pictures.ts';
import { drop, hearing } from './support/sounds.ts';
import { wordsOf } from './support/words.ts';

/** Table-tennis balls that keep this much, dropped from the height of their rule; of the first no other is a copy. */
const RESTITUTIONS = [0.932, 0.9321, 0.9322, 0.9323, 0.9324];
let sounds: string[];

beforeAll(() => {
  sounds = RESTITUTIONS.map((restitution, seed) =>
    drop(`series-${seed}`, restitution, '--seed', String(seed + 1), '--snr', '40'),
  );
});

const sound = (index: number): string => sounds[index] as string;

const here = fixture();

/** What the page says of the next drop. */
const next = (page: Page, words: string): Promise<void> =>
  page.locator('.series .next', { hasText: words }).waitFor();

const button = (page: Page, name: string): Locator =>
  page.getByRole('button', { name, exact: true });

/** Begins a series of two places by two drops, of the rule of table-tennis balls. */
async function begin(page: Page, name: string, words = wordsOf('en')): Promise<void> {
  await page.getByLabel(words('page-series-name')).fill(name);
  const rule = page.getByLabel(words('page-verdict-rule'), { exact: true });
  await rule.locator('option[value=ittf-ball]').waitFor({ state: 'attached' });
  await rule.selectOption('ittf-ball');
  for (const field of ['places', 'drops']) {
    await page.getByLabel(words(`page-series-${field}`), { exact: true }).fill('2');
  }
  await button(page, words('page-series-begin')).click();
  await page.getByRole('heading', { name, level: 1 }).waitFor();
}

const files = (page: Page): Locator => page.locator('.series input[type=file]');

/** Opens the series of this name again, as on another day. */
async function goOn(page: Page, name: string): Promise<void> {
  await page.reload();
  await button(page, `Go on with ${name}`).click();
  await page.getByRole('heading', { name, level: 1 }).waitFor();
}

/** Repeats a drop, for a reason. */
async function repeat(page: Page, number: number, reason: string): Promise<void> {
  const recording = page.locator('.recordings li', { hasText: `Repeat drop ${number}` });
  await recording.locator('summary').click();
  await recording.getByLabel('Why it does not count').fill(reason);
  await recording.getByRole('button').click();
  await page.getByText(`(repeated: ${reason})`).waitFor();
}

/** What the program prints, whatever its verdict. */
function told(...words: string[]): string {
  try {
    return bouncelab(...words);
  } catch (error) {
    return (error as { stdout: string }).stdout;
  }
}

/** The sentences and the cells of all tables of a report, but for those of the day and of the version. */
function contentOf(html: string): string[] {
  const body = html.slice(html.indexOf('<main'), html.indexOf('</main>'));
  const parts = body.replace(/<(style|svg)[\s\S]*?<\/\1>/g, '').split(/<[^>]+>/);
  return parts.map((part) => part.trim()).filter((part) => part !== '');
}

test('a series goes from its first drop to the report, and the program finds the same', async () => {
  const { page, troubles } = await open(here.browser, `${here.url}#series`, {}, hearing(sound(0)));
  await begin(page, 'Ball 7');
  await next(page, 'Place 1 of 2, drop 1 of 2');
  // With the microphone, until the ball rests.
  await button(page, 'Listen').click();
  await next(page, 'Place 1 of 2, drop 2 of 2');
  await page.locator('.so-far', { hasText: 'So far' }).waitFor();
  // With a file; the same once more is refused.
  await files(page).setInputFiles(sound(1));
  await next(page, 'Place 2 of 2, drop 1 of 2');
  await files(page).setInputFiles(sound(1));
  await page.getByText('It is recording 2 of this series.').waitFor();
  await repeat(page, 2, 'a door slammed');
  await next(page, 'Place 1 of 2, drop 2 of 2');
  // In the middle the page is closed.
  await goOn(page, 'Ball 7');
  await next(page, 'Place 1 of 2, drop 2 of 2');
  await files(page).setInputFiles(sounds.slice(2));
  await next(page, 'Every place has its drops.');
  // What the report states.
  await page.getByText('What the report states').click();
  await page.getByLabel('Client', { exact: true }).fill('A club <Grün>');
  await page.getByLabel('Drop height', { exact: true }).fill('30.5');
  await page.locator('.notes').getByRole('checkbox').first().check();
  await button(page, 'Keep what is stated').click();
  await page.locator('.so-far', { hasText: 'CONFORMS. ' }).waitFor();
  const report = readFileSync(await saved(page, 'Save the report (HTML)'), 'utf8');
  for (const words of ['A club &lt;Grün&gt;', 'repeated: a door slammed', 'End of the report']) {
    expect(report).toContain(words);
  }
  const client = readFileSync(await saved(page, 'Page for the client (HTML)'), 'utf8');
  expect(client.length).toBeLessThan(report.length);

  const place = folder();
  execFileSync('unzip', ['-q', await saved(page, 'Save the whole series (ZIP)'), '-d', place]);
  const job = join(place, 'Ball-7');
  // Each sound is as it was given, with its hash in the report, also of the one that was repeated.
  for (const [number, given] of sounds.slice(1).entries()) {
    const kept = readFileSync(join(job, `sounds/00${number + 2}.wav`));
    expect(kept.equals(readFileSync(given))).toBe(true);
    expect(report).toContain(createHash('sha256').update(kept).digest('hex'));
  }
  // The program, which computes every rebound itself, comes to the same.
  const shown = told('job', 'show', job, '--report', join(place, 'program.html'));
  expect(shown).toContain('place 2 of 2, drop 2 of 2');
  expect(shown).toContain('CONFORMS. ');
  const ofProgram = contentOf(readFileSync(join(place, 'program.html'), 'utf8'));
  const others = contentOf(report).filter((part) => !ofProgram.includes(part));
  expect(others).toEqual([]);
  expect(ofProgram.length).toBeGreaterThan(100);
  expect(troubles).toEqual([]);
  await page.context().close();
});

test('a full storage is said, and loses nothing', async () => {
  const { page } = await open(here.browser, `${here.url}#series`, {}, async (context) => {
    await context.addInitScript(() => {
      const put = IDBObjectStore.prototype.put;
      IDBObjectStore.prototype.put = function (this: IDBObjectStore, ...words) {
        if (this.name === 'sounds' && document.title.startsWith('full')) {
          throw new DOMException('no room', 'QuotaExceededError');
        }
        return put.apply(this, words);
      };
    });
  });
  await begin(page, 'Full');
  await files(page).setInputFiles(sound(0));
  await next(page, 'Place 1 of 2, drop 2 of 2');
  await page.evaluate(() => {
    document.title = `full ${document.title}`;
  });
  await files(page).setInputFiles(sound(1));
  await page
    .getByText('The storage of the browser is full: this drop does not count yet.')
    .waitFor();
  await next(page, 'Place 1 of 2, drop 2 of 2');
  const unkept = readFileSync(await saved(page, 'Save the sound as a file'));
  expect(unkept.equals(readFileSync(sound(1)))).toBe(true);
  await page.evaluate(() => {
    document.title = document.title.replace('full ', '');
  });
  await button(page, 'Try again').click();
  await next(page, 'Place 2 of 2, drop 1 of 2');
  await goOn(page, 'Full');
  await next(page, 'Place 2 of 2, drop 1 of 2');
  await page.context().close();
});

test.each([
  ['light', 'en-GB', 1366],
  ['dark', 'de-DE', 320],
  ['light', 'fr-FR', 360],
  ['dark', 'es-ES', 1280],
] as const)('everyone can use a series, %s, %s, %i wide', async (colorScheme, locale, width) => {
  const words = wordsOf(locale.slice(0, 2));
  const options = { colorScheme, locale, viewport: { width, height: 740 } };
  const { page, troubles } = await open(here.browser, `${here.url}#series`, options);
  const look = async (name: string): Promise<void> => {
    await still(page);
    await picture(page, `series-${name}-${colorScheme}-${width}`);
    expect(await overflow(page), name).toBeLessThanOrEqual(0);
    expect(await violations(page), name).toEqual([]);
  };
  await look('begin');
  await begin(page, 'Test 1', words);
  await files(page).setInputFiles(sounds.slice(0, 3));
  await page.locator('.recordings li').nth(2).waitFor();
  await look('job');
  for (const fold of await page.locator('.series summary').all()) await fold.click();
  await page.locator('.verdict .figure-box canvas').first().waitFor();
  await look('unfolded');
  await button(page, words('page-series-all')).click();
  await page.getByRole('heading', { name: words('page-series-new') }).waitFor();
  await look('all');
  expect(troubles).toEqual([]);
  await page.context().close();
});

/** Tab and Enter alone; every element that takes the focus is one of the page. */
test('the keyboard alone repeats a drop', async () => {
  const { page } = await open(here.browser, `${here.url}#series`);
  await begin(page, 'Keys');
  await files(page).setInputFiles(sound(0));
  await next(page, 'Place 1 of 2, drop 2 of 2');
  await page.locator('.recordings summary').focus();
  await page.keyboard.press('Enter');
  await page.keyboard.press('Tab');
  await page.keyboard.type('noise');
  await page.keyboard.press('Enter');
  await next(page, 'Place 1 of 2, drop 1 of 2');
  await page.getByText('(repeated: noise)').waitFor();
  await page.context().close();
});
