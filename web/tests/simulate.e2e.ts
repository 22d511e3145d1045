/** Simulated drops, and the interactive part of the paper. */
import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { afterEach, beforeEach, expect, test } from 'vitest';
import { fixture } from './harness/fixture.ts';
import { answers, follow, open, saved, settled, still, tryDemo } from './support/page.ts';
import { drop, TRUTH } from './support/sounds.ts';

const here = fixture();
let page: Page;
let troubles: string[];

beforeEach(async () => {
  ({ page, troubles } = await open(here.browser, `${here.url}#simulate?e=0.9`));
});
afterEach(async () => {
  await page.context().close();
  expect(troubles).toEqual([]);
});

test('a slider changes the words and the address, and the address the sliders', async () => {
  await page.getByText(/It bounces 25 times in 4.10/).waitFor();
  await page.getByLabel('Drop height').fill('1');
  await page.waitForURL(/height_cm=100/);
  await page.getByText(/It bounces 29 times/).waitFor();
  await page.getByLabel('Where').selectOption('moon');
  await page.getByText('There is no air, so there is no terminal speed.').waitFor();
  expect(await page.getByLabel('Air pressure').isDisabled()).toBe(true);
  await page.goto(`${here.url}#simulate?e=0.8&body=mars`);
  await expect.poll(() => page.getByLabel(/^Restitution \(/).inputValue()).toBe('0.8');
  await expect.poll(() => page.getByLabel('Where').inputValue()).toBe('mars');
});

test('runs are kept, compared and removed', async () => {
  for (const restitution of ['0.8', '0.85', '0.9', '0.95']) {
    await page.getByLabel(/^Restitution \(/).fill(restitution);
    await page.getByRole('button', { name: 'Keep this run' }).click();
  }
  // Three at most: more lines than that nobody tells apart.
  const runs = page.getByRole('list', { name: 'Runs' }).getByRole('listitem');
  await expect.poll(() => runs.count()).toBe(3);
  await page.getByRole('button', { name: 'Remove run 3' }).click();
  await expect.poll(() => runs.count()).toBe(2);
});

test('a simulated drop is analysed as if it were real, and says what was put in', async () => {
  await page.getByText(/It bounces/).waitFor();
  await page.getByRole('button', { name: 'Analyse its sound' }).click();
  const { kept, fell } = await answers(page);
  expect(Math.abs(kept.value - 90)).toBeLessThan(3.5 * kept.sd);
  expect(Math.abs(fell.value - 30.5)).toBeLessThan(3.5 * fell.sd);

  await follow(page, 'Simulate');
  await page.getByLabel(/^Restitution \(/).fill('0.85');
  await page.getByRole('button', { name: 'Compare with the measurement' }).click();
  await page.getByText(/It is compared with the measurement now/).click();
  await page.getByRole('tab', { name: 'Compare' }).click();
  await page.getByText('The same as numbers').click();
  await page.getByRole('cell', { name: 'your simulation' }).first().waitFor();
  // What is saved shows what is seen.
  const drawing = readFileSync(await saved(page, 'SVG'), 'utf8');
  expect(drawing).toContain('>your simulation<');

  // It says nothing of another recording.
  await tryDemo(page);
  await page.getByRole('tab', { name: 'Compare' }).click();
  await page.getByRole('cell', { name: 'simulated, with 95 %' }).first().waitFor();
  expect(await page.getByRole('cell', { name: 'your simulation' }).count()).toBe(0);
});

test('a ball that floats is refused in words, and forgetting the settings helps', async () => {
  await page.goto(`${here.url}#lab`);
  await page.locator('input[type=file]').setInputFiles(drop('floating'));
  await settled(page);
  await page.goto(`${here.url}#lab?mass_g=0.01&diameter_mm=40`);
  await page.getByText(/so it floats/).waitFor();
  await page.locator('.settings summary').click();
  await page.getByRole('button', { name: 'Reset all settings' }).click();
  const { kept } = await answers(page);
  expect(Math.abs(kept.value - 100 * TRUTH.restitution)).toBeLessThan(3.5 * kept.sd);
});

test('the discrepancy of the paper: drag alone does not explain the height, a falling restitution does', async () => {
  await page.goto(`${here.url}#paper`);
  const constant = page.getByRole('button', { name: 'constant e, ten flights' });
  await constant.waitFor();
  // While the figures above it are drawn, the button moves, and a press that ends beside it does nothing.
  await still(page);
  await constant.click();
  await page.getByText(/The fit gives e = 0.9375 and h₀ = 28.8.cm/).waitFor();
  const hit = page.getByText('That is the result of the paper, to its last digit.');
  expect(await hit.count()).toBe(0);
  await page.getByRole('button', { name: 'e falls with speed, ten flights' }).click();
  await page.getByText(/The fit gives e = 0.9375 and h₀ = 26.7.cm/).waitFor();
  await hit.waitFor();
  const met = page.getByRole('row').filter({ hasText: 'yes' });
  await expect.poll(() => met.count()).toBe(6);
});
