/** What becomes of a result: it is kept, shared and exported; and what an address says is in the form. */
import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { fixture } from './harness/fixture.ts';
import { violationsInBothThemes } from './support/layout.ts';
import {
  answers,
  follow,
  keepAs,
  open,
  remembering,
  saved,
  settled,
  tabsOfAll,
  tryDemo,
} from './support/page.ts';

const here = fixture();

async function demo(page: Page): Promise<void> {
  await page.goto(`${here.url}#lab`);
  await tryDemo(page);
}

/** States a height in the form. */
async function stateHeight(page: Page, cm: string): Promise<void> {
  await page.locator('.settings summary').click();
  // Typed, because Firefox takes the Enter as a change only of what was typed.
  await page.getByLabel('Drop height', { exact: true }).pressSequentially(cm);
  await page.getByLabel('Drop height', { exact: true }).press('Enter');
}

test('drops are kept, deleted and brought back with their set-up, and outlive the page', async () => {
  const { page } = await open(here.browser, here.url);
  await tryDemo(page);
  await stateHeight(page, '30.5');
  await page.getByText(/^Analysed with: Drop height: 30.5.cm\.$/).waitFor();
  await settled(page);
  for (const name of ['Anna', 'Ben']) await keepAs(page, name);
  await page.goto(`${here.url}#drops`);
  await page.reload();
  const rows = page.locator('table.wide tbody tr');
  await rows.nth(1).waitFor();
  await page.getByRole('button', { name: 'Delete Ben' }).click();
  await page.getByText('“Ben” was deleted.').waitFor();
  await expect.poll(() => rows.count()).toBe(1);
  await page.getByRole('button', { name: 'Undo' }).click();
  await rows.nth(1).waitFor();
  await page.getByRole('button', { name: 'Open Ben' }).click();
  expect((await answers(page)).kept.value).toBeCloseTo(95.29, 1);
  await expect.poll(() => page.url()).toContain('height_cm=30.5');
  await page.context().close();
});

test('what is being typed stays when another window changes the drop', async () => {
  const { page } = await open(here.browser, here.url);
  await tryDemo(page);
  await keepAs(page, 'Anna');
  await page.goto(`${here.url}#drops`);
  await page.getByLabel('Surface of Anna').pressSequentially('sto');
  const other = await page.context().newPage();
  await other.goto(`${here.url}#drops`);
  await other.getByLabel('Name of Anna').fill('Bella');
  await other.getByLabel('Name of Anna').press('Enter');
  await other.getByLabel('Name of Bella').waitFor();
  // As if the reader came back; in front, the page would lose the field that is typed in.
  await page.evaluate(() => dispatchEvent(new Event('visibilitychange')));
  const surface = page.getByLabel('Surface of Bella');
  await surface.pressSequentially('ne');
  await surface.press('Enter');
  await other.reload();
  await expect.poll(() => other.getByLabel('Surface of Bella').inputValue()).toBe('stone');
  await page.context().close();
});

const tennis = 'ball=tennis&temperature_c=25';
const line = (page: Page, words: RegExp) => page.locator('.settings .line', { hasText: words });

test('a shared set-up arrives if the reader wants it, and outlives the page', async () => {
  const { page } = await open(here.browser, `${here.url}#lab?${tennis}`);
  await page
    .getByText(/^This link states: Ball: tennis · Air: 25\s°C, 1013\shPa\. Your own/)
    .waitFor();
  await page.getByRole('button', { name: 'use it for my drops' }).click();
  await page.getByRole('radio', { name: 'tennis', checked: true, exact: true }).waitFor();
  await openTimes(page);
  await line(page, /Ball: tennis · Air: 25\s°C/).waitFor();
  await page.locator('.settings summary').click();
  // Typed, because Firefox takes the Enter as a change only of what was typed.
  await page.getByLabel('Temperature').fill('');
  await page.getByLabel('Temperature').pressSequentially('10,5');
  await page.getByLabel('Temperature').press('Enter');
  await page.waitForFunction(() => location.hash.includes('temperature_c=10.5'));
  await page.goto('about:blank');
  await page.goto(here.url);
  await openTimes(page);
  await line(page, /Ball: tennis · Air: 10.5\s°C/).waitFor();
  await page.context().close();
});

/** A drop of the reader's own: 12 impacts without air. */
async function openTimes(page: Page): Promise<void> {
  const times = Array.from({ length: 12 }, (_, n) => ((0.5 * (1 - 0.9 ** n)) / 0.1).toFixed(6));
  const file = { name: 'own.txt', mimeType: 'text/plain', buffer: Buffer.from(times.join('\n')) };
  await page.getByLabel('Recording or list of impact times').setInputFiles(file);
  await page.locator('#drop-name[placeholder]').and(page.locator('[value="own.txt"]')).waitFor();
  await settled(page);
}

const LEAKS: readonly [string, (page: Page) => Promise<void>][] = [
  [
    'a simulation on the Moon',
    async (page) => {
      await page.goto(`${here.url}#simulate?body=moon`);
      await page.getByRole('button', { name: 'Analyse its sound' }).click();
      await page.getByText(/^Analysed with: vacuum · g.1.62.m\/s²\.$/).waitFor();
    },
  ],
  ['the demo', tryDemo],
  [
    'a link with a height',
    async (page) => {
      await page.goto(`${here.url}#lab?ball=tennis&height_cm=100`);
      await page.getByText(/^This link states: Ball: tennis · Drop height: 100.cm/).waitFor();
    },
  ],
  [
    'a link with a height, for the drop that is there',
    async (page) => {
      await tryDemo(page);
      await page.goto(`${here.url}#lab?ball=tennis&height_cm=100`);
      await page.getByText(/^Analysed with: Drop height: 100.cm\.$/).waitFor();
    },
  ],
  [
    'a drop of the table',
    async (page) => {
      await tryDemo(page);
      await stateHeight(page, '30.5');
      await settled(page);
      await keepAs(page, 'Anna');
      await follow(page, 'Drops');
      // With an empty workspace: what is seen then is the drop that was opened.
      await page.reload();
      await page.getByRole('button', { name: 'Open Anna' }).click();
      await page.getByText(/^Analysed with: Drop height/).waitFor();
    },
  ],
];

test.each(LEAKS)('%s changes nothing of the next drop', async (_, before) => {
  const { page } = await open(here.browser, here.url, {}, remembering('ball=golf'));
  await openTimes(page);
  const expected = await answers(page);
  const own = page.url();
  await page.reload();
  await before(page);
  await openTimes(page);
  expect(await answers(page)).toEqual(expected);
  await expect.poll(() => page.url()).toBe(own);
  expect(await page.getByText(/^Analysed with|^This link states/).count()).toBe(0);
  await page.getByRole('radio', { name: 'golf', checked: true }).waitFor();
  await page.context().close();
});

test('what is unusual is reset beside the answer', async () => {
  const { page } = await open(here.browser, here.url, {}, remembering('gravity=1.62&drag=none'));
  await openTimes(page);
  await page.getByText(/^Analysed with: no air · g.1.62.m\/s²\.$/).waitFor();
  await page.getByRole('button', { name: 'Reset', exact: true }).click();
  await line(page, /20\s°C.*9.807/).waitFor();
  expect(await page.getByText(/^Analysed with/).count()).toBe(0);
  await page.context().close();
});

test('g is measured with a stated height, and stands in the answer', async () => {
  const { page } = await open(here.browser, here.url);
  await tryDemo(page);
  await stateHeight(page, '30.5');
  await page.getByRole('checkbox', { name: /^measure g/ }).check();
  const answer = page.locator('.summary .second', { hasText: /^g = [\d.]+.±.[\d.]+.m\/s²$/ });
  await answer.waitFor();
  await settled(page);
  const [, value = 0, sd = 0] = (/([\d.]+).±.([\d.]+)/.exec(await answer.innerText()) ?? []).map(
    Number,
  );
  expect(Math.abs(value - 9.80665)).toBeLessThan(3.5 * sd);
  expect(sd).toBeLessThan(0.3);
  await expect.poll(() => page.url()).toContain('infer=gravity');
  await page.context().close();
});

test('a ball is asked for, chosen in the row or by its size and weight, and remembered', async () => {
  const { page } = await open(here.browser, here.url);
  const chosen = (name: string) => page.getByRole('radio', { name, checked: true, exact: true });
  const tap = (name: string) => page.locator('.balls').getByText(name, { exact: true }).click();
  await chosen('not stated').waitFor();
  await tap('tennis');
  await openTimes(page);
  const { fell } = await answers(page);
  await tap('steel ball');
  await expect.poll(async () => (await answers(page)).fell.value).not.toBe(fell.value);
  await page.locator('.balls').getByLabel('Diameter').pressSequentially('20');
  await page.locator('.balls').getByLabel('Diameter').press('Enter');
  await line(page, /Ball: steel ball, 20\smm/).waitFor();
  await tap('other: size and weight');
  await page.locator('.balls').getByLabel('Diameter').pressSequentially('38');
  await page.locator('.balls').getByLabel('Mass').pressSequentially('2.5');
  await page.locator('.balls').getByLabel('Mass').press('Enter');
  await line(page, /Ball: 2.5\sg, 38\smm/).waitFor();
  await settled(page);
  await page.goto('about:blank');
  await page.goto(here.url);
  await chosen('other: size and weight').waitFor();
  await page.context().close();
});

test('a part of the address that makes no sense is named', async () => {
  const { page } = await open(here.browser, `${here.url}#lab?height_cm=tall`);
  await page.getByText(/are not valid and were ignored: height_cm/).waitFor();
  await page.context().close();
});

test('a drop travels as a link', async () => {
  const { page } = await open(here.browser, here.url);
  await demo(page);
  const sent = await answers(page);
  await page.getByRole('button', { name: 'Share this drop' }).click();
  await page.getByRole('img', { name: /QR code/ }).waitFor();
  expect(await violationsInBothThemes(page)).toEqual([]);
  const address = await page.locator('.shared code').last().innerText();
  expect(address.length).toBeLessThanOrEqual(1500);
  const other = await open(here.browser, address);
  const { kept, fell } = await answers(other.page);
  expect(kept.value).toBeCloseTo(sent.kept.value, 1);
  expect(fell.value).toBeCloseTo(sent.fell.value, 0);
  await expect.poll(() => other.page.url()).toContain('ball=table-tennis-40');
  await other.page.getByRole('button', { name: 'Keep this drop' }).click();
  await other.page.getByText(/Kept as/).waitFor();
  const changed = address.replace(/.$/, (last) => (last === 'A' ? 'Q' : 'A'));
  const third = await open(here.browser, changed);
  await third.page.getByText('This link of a drop cannot be used.').waitFor();
  expect(await violationsInBothThemes(third.page)).toEqual([]);
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
  const { page } = await open(here.browser, here.url);
  await demo(page);
  const content = async (button: string): Promise<string> =>
    readFileSync(await saved(page, button), 'utf8');
  expect(await content('Table (CSV)')).toMatch(/^recording,drop,/);
  const document = JSON.parse(await content('All data (JSON)'));
  expect(document.schema).toBe('bouncelab.analysis/3');
  const { value, sd } = document.drops[0].posterior.restitution;
  expect(Math.abs(value - 0.9529)).toBeLessThan(3.5 * sd);
  expect(sd).toBeLessThan(2e-3);
  expect(await content('Report (HTML)')).toMatch(/^<!DOCTYPE html>/i);
  for (const tab of await tabsOfAll(page)) {
    await tab.click();
    expect(await content('SVG'), await tab.innerText()).toContain('<svg');
  }
  expect((await content('PNG')).slice(1, 4)).toBe('PNG');
  expect(await content('CSV')).toMatch(/^panel,x_axis,/);
  await page.context().close();
});
