/** Drops held against a rule: in the laboratory, and several in the table. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { fixture } from './harness/fixture.ts';
import { bouncelab, folder, synth } from './harness/program.ts';
import { overflow, violations } from './support/layout.ts';
import { open, remembering, saved, settled, still } from './support/page.ts';
import { picture } from './support/pictures.ts';

const here = fixture();
const place = folder();

/** A table-tennis ball that keeps this much, dropped from the height of its rule. */
function drop(restitution: number, seed: number): string {
  const truth = ['--height', '30.5cm', '--restitution', String(restitution)];
  const path = join(place, `${restitution}-${seed}.wav`);
  return synth(path, ...truth, '--snr', '40', '--seed', String(seed)).path;
}

/** Chooses the rule of the ball, and waits for its verdict. */
async function judge(page: Page, title: string): Promise<string> {
  await page.locator('details > summary', { hasText: title }).click();
  const verdict = page.locator('.verdict');
  const rules = verdict.locator('select').first();
  await rules.locator('option').nth(1).waitFor({ state: 'attached' });
  const value = await rules
    .locator('option')
    .evaluateAll((all) =>
      (all as HTMLOptionElement[]).findIndex(({ value }) => value === 'ittf-ball'),
    );
  await rules.selectOption({ index: value });
  return page.locator('.verdict[aria-busy=false] .lead').innerText();
}

test.each([
  ['light', 'en-GB', 'Judge by a rule', 1366],
  ['dark', 'es-ES', 'Evaluar según una regla', 320],
] as const)('a drop is judged by a rule, %s, %s', async (colorScheme, locale, title, width) => {
  const options = { colorScheme, locale, viewport: { width, height: width === 320 ? 568 : 768 } };
  const setUp = remembering('ball=table-tennis-40');
  const { page, troubles } = await open(here.browser, here.url, options, setUp);
  await page.locator('input[type=file]').setInputFiles(drop(0.905, 1));
  await settled(page);
  const before = await judge(page, title);
  const part = page.locator('.verdict').getByRole('checkbox');
  await part.check();
  // What is stated to be kept counts at once.
  await page.locator('.verdict[aria-busy=false] .lead').waitFor();
  expect(before).not.toBe('');
  await page.locator('.verdict .figure-box canvas').first().waitFor();
  await still(page);
  await picture(page, `verdict-${colorScheme}`);
  expect(await overflow(page)).toBeLessThanOrEqual(0);
  expect(await violations(page)).toEqual([]);
  expect(troubles).toEqual([]);
  await page.context().close();
});

/** What the program says of recordings; its exit status is the verdict. */
function told(files: readonly string[]): string {
  const words = ['--rule', 'ittf-ball', '--ball', 'table-tennis-40'];
  try {
    return bouncelab('verdict', ...words, ...files);
  } catch (error) {
    return (error as { stdout: string }).stdout;
  }
}

test('drops of the table are judged together, as the program judges them', async () => {
  const { page, troubles } = await open(
    here.browser,
    `${here.url}#drops`,
    {},
    remembering('ball=table-tennis-40'),
  );
  const files = [1, 2, 3].map((seed) => drop(0.95, seed));
  await page.getByLabel('Files with drops').setInputFiles(files);
  await page.getByText('3 drops were added.').waitFor();
  const [outcome = ''] = (await judge(page, 'Judge by a rule')).split('.');
  const report = readFileSync(await saved(page, 'Save the verdict (HTML)'), 'utf8');
  expect(report).toContain('ittf-ball');
  expect(told(files)).toContain(outcome);
  expect(troubles).toEqual([]);
  await page.context().close();
});
