/** What becomes of a result: it is kept, shared and exported; and what an address says is in the form. */
import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { fixture } from './harness/fixture.ts';
import { violationsInBothThemes } from './support/layout.ts';
import { answers, follow, keepAs, open, saved, settled, tryDemo } from './support/page.ts';

const here = fixture();

async function demo(page: Page): Promise<void> {
  await page.goto(`${here.url}#lab`);
  await tryDemo(page);
}

test('drops are kept, deleted and brought back with their set-up, and outlive the page', async () => {
  const { page } = await open(here.browser, `${here.url}#lab?height_cm=30.5`);
  await tryDemo(page);
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
  expect(page.url()).toContain('height_cm=30.5');
  await page.context().close();
});

test('a shared set-up arrives: the address says what the form says', async () => {
  const { page } = await open(
    here.browser,
    `${here.url}#lab?ball=tennis&height_cm=100&temperature_c=25`,
  );
  await demo(page);
  await page.goto(`${here.url}#lab?ball=tennis&temperature_c=25`);
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
  const { page } = await open(here.browser, here.url);
  const chosen = (name: string) => page.getByRole('radio', { name, checked: true, exact: true });
  const tap = (name: string) => page.locator('.balls').getByText(name, { exact: true }).click();
  await tap('tennis');
  await chosen('tennis').waitFor();
  await tryDemo(page);
  await chosen('table tennis 40+').waitFor();
  const { fell } = await answers(page);
  await tap('golf');
  await expect.poll(async () => (await answers(page)).fell.value).not.toBe(fell.value);
  expect(page.url()).toContain('ball=golf');
  await page.goto('about:blank');
  await page.goto(here.url);
  await chosen('golf').waitFor();
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
  expect(other.page.url()).toContain('ball=table-tennis-40');
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
  for (const tab of await page.getByRole('tab').all()) {
    await tab.click();
    expect(await content('SVG'), await tab.innerText()).toContain('<svg');
  }
  expect((await content('PNG')).slice(1, 4)).toBe('PNG');
  expect(await content('CSV')).toMatch(/^panel,x_axis,/);
  await page.context().close();
});
