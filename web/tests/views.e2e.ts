/** Every view: reachable, readable by everyone, in two languages, on any screen; and what is kept. */
import { mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { launch } from './harness/browser.ts';
import { FONT_SETS, type FontSet, nameOf } from './harness/fonts.ts';
import { Site } from './harness/site.ts';
import { overflow, violations } from './support/layout.ts';
import { follow, keepAs, open, said, saved, settled, still } from './support/page.ts';
import { charts, crampedButtons, rememberTexts, troublesOf } from './support/texts.ts';

const SHOTS = join(import.meta.dirname, 'screenshots');

let site: Site;
let browser: Browser;

beforeAll(async () => {
  site = await Site.open();
  mkdirSync(SHOTS, { recursive: true });
});
afterAll(() => site.close());

/** The tests of a block have a browser of their own. */
function browse(fonts?: FontSet): void {
  beforeAll(async () => {
    browser = await launch({ fonts });
  });
  afterAll(() => browser.close());
}

async function demo(page: Page): Promise<void> {
  await page.goto(`${site.url}#lab`);
  await page.locator('.links button').nth(2).click();
  await settled(page);
}

/** A simulation beside another one. */
async function simulate(page: Page): Promise<void> {
  await page.goto(`${site.url}#simulate`);
  await page.locator('.uplot').first().waitFor();
  await page.locator('.button.primary').click();
  await page.getByRole('slider').nth(1).fill('0.9');
}

async function unfoldAll(page: Page): Promise<void> {
  for (const fold of await page.locator('main summary').all()) await fold.click();
}

/** Keeps the drop in the workspace three times, and goes to the table. */
async function keepThree(page: Page): Promise<void> {
  for (const drop of ['Anna', 'Ben', 'Chris']) {
    await page.locator('.keep form input').fill(drop);
    await page.locator('.keep form button').click();
    await page.locator('.keep [role=status]', { hasText: drop }).waitFor();
  }
  await page.goto(`${site.url}#drops`);
  await page.locator('table.wide tbody tr').nth(2).waitFor();
}

async function look(page: Page, name: string): Promise<void> {
  await still(page);
  await page.screenshot({ path: join(SHOTS, `${name}.png`), fullPage: true });
  expect(await overflow(page), `${name} is wider than the screen`).toBeLessThanOrEqual(0);
  // On a 4K screen the page is what it is on a desktop, only larger.
  if (!name.startsWith('4k')) expect(await violations(page), name).toEqual([]);
}

const SCREENS = [
  ['phone', { width: 360, height: 740 }],
  ['desktop', { width: 1440, height: 900 }],
  ['4k', { width: 3840, height: 2160 }],
] as const;
const READERS = [
  ['light', 'en-GB'],
  ['dark', 'de-DE'],
] as const;

describe.each(FONT_SETS.map((fonts) => [nameOf(fonts), fonts] as const))(
  'with %s',
  (set, fonts) => {
    browse(fonts);
    test.concurrent.each(
      SCREENS.flatMap(([screen, viewport]) =>
        READERS.map(([colorScheme, locale]) => ({ screen, viewport, colorScheme, locale })),
      ),
    )('on a $screen, $colorScheme, $locale', async ({ screen, ...options }) => {
      const { page, troubles } = await open(browser, site.url, {
        ...options,
        reducedMotion: 'reduce',
      });
      const name = (view: string): string => `${screen}-${options.colorScheme}-${set}-${view}`;
      await look(page, name('welcome'));
      await simulate(page);
      await look(page, name('simulate'));
      await page.goto(`${site.url}#paper`);
      await page.locator('.article caption').waitFor();
      for (const chapter of await page.locator('.article summary').all()) await chapter.click();
      await look(page, name('paper'));
      await demo(page);
      await look(page, name('lab'));
      await unfoldAll(page);
      await look(page, name('lab-unfolded'));
      // The figures differ less from screen to screen than they take to look at.
      for (const tab of screen === 'desktop' ? await page.getByRole('tab').all() : []) {
        await tab.click();
        await look(page, name(`figure-${await tab.getAttribute('id')}`));
      }
      await keepThree(page);
      await look(page, name('drops'));
      expect(troubles).toEqual([]);
      await page.context().close();
    });
  },
);

/** What eases seeing: the colours of the system, and a screen of 1280 by 1024 at 200 %. */
const AIDS = [
  {
    aid: 'contrast-light',
    forcedColors: 'active',
    colorScheme: 'light',
    viewport: { width: 1440, height: 900 },
  },
  {
    aid: 'contrast-dark',
    forcedColors: 'active',
    colorScheme: 'dark',
    viewport: { width: 360, height: 740 },
  },
  { aid: 'zoom', viewport: { width: 640, height: 512 }, deviceScaleFactor: 2, locale: 'de-DE' },
] as const;

/** Another ball than the first, whose choice is seen without the keyboard or the mouse on it. */
async function chooseAnother(page: Page): Promise<void> {
  const row = page.locator('.balls');
  const before = await row.screenshot();
  await page.goto(`${site.url}#lab?ball=football`);
  await page
    .getByRole('radio')
    .nth(3)
    .and(page.getByRole('radio', { checked: true }))
    .waitFor();
  await still(page);
  expect((await row.screenshot()).equals(before), 'the choice is not seen').toBe(false);
}

describe('whatever the fonts', () => {
  browse();

  test.concurrent.each(AIDS)('with the aid of $aid', async ({ aid, ...options }) => {
    const usual = { reducedMotion: 'reduce' } as const;
    const { page } = await open(browser, site.url, { ...usual, ...options }, rememberTexts);
    const lookAt = async (view: string): Promise<void> => {
      await look(page, `${aid}-${view}`);
      const cramped = await crampedButtons(page);
      expect([...(await charts(page)).flatMap(troublesOf), ...cramped], view).toEqual([]);
    };
    await lookAt('welcome');
    await chooseAnother(page);
    await simulate(page);
    await lookAt('simulate');
    await demo(page);
    await unfoldAll(page);
    await lookAt('lab');
    await keepThree(page);
    await lookAt('drops');
    await page.context().close();
  });

  test('where the system states the colours, the page has no theme of its own', async () => {
    const options = { forcedColors: 'active', colorScheme: 'dark' } as const;
    const { page } = await open(browser, site.url, options, async (context) => {
      await context.addInitScript(() => localStorage.setItem('bouncelab.theme', 'light'));
    });
    expect(await page.locator('[data-theme]').count()).toBe(0);
    expect(await page.getByRole('button', { name: /^(Light|Dark)$/ }).count()).toBe(0);
    await page.context().close();
  });

  test('drops are kept, deleted and brought back with their set-up, and outlive the page', async () => {
    const { page } = await open(browser, `${site.url}#lab?height_cm=30.5`);
    await page.getByRole('button', { name: 'try the demo' }).click();
    await settled(page);
    for (const name of ['Anna', 'Ben']) await keepAs(page, name);
    await page.goto(`${site.url}#drops`);
    await page.reload();
    const rows = page.locator('table.wide tbody tr');
    await rows.nth(1).waitFor();
    await page.getByRole('button', { name: 'Delete Ben' }).click();
    await page.getByText('“Ben” was deleted.').waitFor();
    await expect.poll(() => rows.count()).toBe(1);
    await page.getByRole('button', { name: 'Undo' }).click();
    await rows.nth(1).waitFor();
    await page.getByRole('button', { name: 'Open Ben' }).click();
    expect((await said(page)).kept.value).toBeCloseTo(95.29, 1);
    expect(page.url()).toContain('height_cm=30.5');
    await page.context().close();
  });

  test('a shared set-up arrives: the address says what the form says', async () => {
    const { page } = await open(
      browser,
      `${site.url}#lab?ball=tennis&height_cm=100&temperature_c=25`,
    );
    await demo(page);
    await page.goto(`${site.url}#lab?ball=tennis&temperature_c=25`);
    await settled(page);
    await page.getByText(/Ball: tennis · Air: 25 °C/).waitFor();
    await page.locator('.settings summary').click();
    // Typed, because Firefox takes the Enter as a change only of what was typed.
    await page.getByLabel('Temperature').fill('');
    await page.getByLabel('Temperature').pressSequentially('10,5');
    await page.getByLabel('Temperature').press('Enter');
    await page.waitForFunction(() => location.hash.includes('temperature_c=10.5'));
    await settled(page);
    await page.context().close();
  });

  test('a ball is chosen in the row, changes the result at once and is remembered; the demo has its own', async () => {
    const { page } = await open(browser, site.url);
    const chosen = (name: string) => page.getByRole('radio', { name, checked: true, exact: true });
    const tap = (name: string) => page.locator('.balls').getByText(name, { exact: true }).click();
    await tap('tennis');
    await chosen('tennis').waitFor();
    await page.getByRole('button', { name: 'try the demo' }).click();
    await chosen('table tennis 40+').waitFor();
    const { fell } = await said(page);
    await tap('golf');
    await expect.poll(async () => (await said(page)).fell.value).not.toBe(fell.value);
    expect(page.url()).toContain('ball=golf');
    await page.goto('about:blank');
    await page.goto(site.url);
    await chosen('golf').waitFor();
    await page.context().close();
  });

  test('a part of the address that makes no sense is named', async () => {
    const { page } = await open(browser, `${site.url}#lab?height_cm=tall`);
    await page.getByText(/are not valid and were ignored: height_cm/).waitFor();
    await page.context().close();
  });

  test('a drop travels as a link', async () => {
    const { page } = await open(browser, site.url);
    await demo(page);
    const sent = await said(page);
    await page.getByRole('button', { name: 'Share this drop' }).click();
    await page.getByRole('img', { name: /QR code/ }).waitFor();
    const address = await page.locator('.shared code').last().innerText();
    expect(address.length).toBeLessThanOrEqual(1500);
    const other = await open(browser, address);
    const { kept, fell } = await said(other.page);
    expect(kept.value).toBeCloseTo(sent.kept.value, 1);
    expect(fell.value).toBeCloseTo(sent.fell.value, 0);
    expect(other.page.url()).toContain('ball=table-tennis-40');
    await other.page.getByRole('button', { name: 'Keep this drop' }).click();
    await other.page.getByText(/Kept as/).waitFor();
    const changed = address.replace(/.$/, (last) => (last === 'A' ? 'Q' : 'A'));
    const third = await open(browser, changed);
    await third.page.getByText('This link of a drop cannot be used.').waitFor();
    await follow(third.page, 'Drops');
    await third.page.getByLabel(/^Links of other/).fill(`Anna ${address}\nBob ${changed}`);
    await third.page.getByRole('button', { name: 'Add to this table' }).click();
    await third.page.getByText('1 drop was added.').waitFor();
    await third.page.getByRole('alert').getByText('This link of a drop cannot be used.').waitFor();
    expect(await third.page.getByLabel(/^Name of /).count()).toBe(1);
    for (const { page } of [{ page: third.page }, other]) await page.context().close();
    await page.context().close();
  });

  test('exports: table, document and figures', async () => {
    const { page } = await open(browser, site.url);
    await demo(page);
    const content = async (button: string): Promise<string> =>
      readFileSync(await saved(page, button), 'utf8');
    expect(await content('Table (CSV)')).toMatch(/^file,drop,/);
    const document = JSON.parse(await content('All data (JSON)'));
    expect(document.schema).toBe('bouncelab.analysis/2');
    expect(document.drops[0].posterior.restitution.value).toBeCloseTo(0.9529, 3);
    expect(await content('Report (HTML)')).toMatch(/^<!DOCTYPE html>/i);
    for (const tab of await page.getByRole('tab').all()) {
      await tab.click();
      expect(await content('SVG'), await tab.innerText()).toContain('<svg');
    }
    expect((await content('PNG')).slice(1, 4)).toBe('PNG');
    expect(await content('CSV')).toMatch(/^panel,x_axis,/);
    await page.context().close();
  });
});
