/** A lesson: the teacher's link, the page of a pupil, and how a drop is handed in and collected. */
import type { Browser, Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { launch, type Preparation } from './harness/browser.ts';
import { fixture } from './harness/fixture.ts';
import { film, seen } from './support/camera.ts';
import { overflow, violations } from './support/layout.ts';
import { open, settled, still } from './support/page.ts';
import { picture } from './support/pictures.ts';
import { drop, hearing } from './support/sounds.ts';

const here = fixture();

const PHONE = { viewport: { width: 320, height: 568 }, hasTouch: true, isMobile: true } as const;

/** Makes the lesson of tennis balls and marbles, and returns its link. */
async function lesson(teacher: Page): Promise<string> {
  await teacher.getByText('Class: a link for all pupils').click();
  for (const ball of ['tennis', 'glass marble'])
    await teacher.getByRole('checkbox', { name: ball, exact: true }).check();
  await teacher.getByLabel('Surfaces, with commas between them').fill('wood, stone');
  await teacher.getByLabel(/^Drop heights in cm/).fill('30.5; 100');
  const code = teacher.locator('.shared code');
  await code.getByText(/heights_cm=30.5%3B100$/).waitFor();
  await teacher.getByRole('img', { name: 'QR code of the lesson' }).waitFor();
  return code.innerText();
}

/** Keeps what is shared with the share sheet. */
const sharing: Preparation = async (context) => {
  await context.addInitScript(() => {
    const shared: string[] = [];
    Object.assign(globalThis, { shared });
    navigator.share = async ({ url }: ShareData = {}) => {
      shared.push(url ?? '');
    };
  });
};

test('a pupil is asked for name, ball, surface and height, and hands in; the teacher collects', async () => {
  const { page: teacher, troubles } = await open(here.browser, `${here.url}#drops`);
  const address = await lesson(teacher);
  expect(await violations(teacher)).toEqual([]);
  await picture(teacher, 'lesson-teacher');

  const { page: pupil } = await open(here.browser, address, PHONE, async (context) => {
    await sharing(context);
    await hearing(drop('lesson'))(context);
  });
  await pupil.getByRole('radio').nth(1).waitFor();
  expect(await pupil.getByRole('radio').count()).toBe(2);
  for (const gone of ['paste times', 'try the demo', 'Speech and vibration'])
    expect(await pupil.getByText(gone).count(), gone).toBe(0);
  expect(await overflow(pupil)).toBeLessThanOrEqual(0);
  expect(await violations(pupil)).toEqual([]);
  await picture(pupil, 'lesson-pupil');
  await pupil.reload();
  await pupil.getByText('tennis', { exact: true }).click();
  await pupil.getByLabel('Surface').selectOption('stone');
  await pupil.getByRole('button', { name: 'Listen' }).click();
  await settled(pupil);
  await pupil.getByText('Write your name below, then hand the drop in.').waitFor();
  await pupil.getByLabel('Your name').fill('Anna "<b>');
  await pupil.getByRole('button', { name: 'Hand in' }).click();
  await pupil.getByRole('button', { name: 'Share …' }).click();
  await still(pupil);
  await picture(pupil, 'lesson-hand-in');
  expect(await violations(pupil)).toEqual([]);
  const shared = await pupil.evaluate(() => (globalThis as unknown as { shared: string[] }).shared);
  expect(shared).toEqual([await pupil.locator('.shared code').innerText()]);

  await teacher.getByLabel(/^Links of other/).fill(`Look: ${shared[0]} and again ${shared[0]}`);
  await teacher.getByRole('button', { name: 'Add to this table' }).click();
  await teacher.getByText('1 drop was added.').waitFor();
  const row = teacher.locator('table.wide tbody tr');
  expect(await row.locator('.name').inputValue()).toBe('Anna "<b>');
  expect(await row.locator('select').inputValue()).toBe('tennis');
  expect(
    await row
      .locator('.noted')
      .evaluateAll((all) => (all as HTMLInputElement[]).map(({ value }) => value)),
  ).toEqual(['stone', 'Anna "<b>']);
  expect(troubles).toEqual([]);
  for (const page of [teacher, pupil]) await page.context().close();
});

test('the camera of the teacher reads the code of a drop, once', async () => {
  const { page: pupil } = await open(here.browser, here.url);
  const times = Array.from({ length: 12 }, (_, n) => ((0.5 * (1 - 0.9 ** n)) / 0.1).toFixed(4));
  const file = { name: 'own.txt', mimeType: 'text/plain', buffer: Buffer.from(times.join('\n')) };
  await pupil.locator('input[type=file]').setInputFiles(file);
  await settled(pupil);
  await pupil.getByRole('button', { name: 'Share this drop' }).click();
  await pupil.locator('.shared .qr').waitFor();
  const camera = film([await seen(pupil)]);
  const seeing: Browser = await launch({ camera });
  const { page: teacher } = await open(seeing, `${here.url}#drops`);
  await teacher.getByRole('button', { name: 'Scan QR codes' }).click();
  await teacher.getByText('1 drop was added.').waitFor();
  await picture(teacher, 'lesson-scanned');
  await teacher.getByRole('button', { name: 'Stop scanning' }).click();
  expect(await teacher.locator('table.wide tbody tr').count()).toBe(1);
  expect(await teacher.locator('.camera').count()).toBe(0);
  await seeing.close();
  await pupil.context().close();
});

test('the table is sorted and corrected in bulk, and unlike balls have no mean', async () => {
  const { page } = await open(here.browser, `${here.url}#drops`);
  const files = ['b', 'c', 'a'].map((name, place) => ({
    name: `${name}.txt`,
    mimeType: 'text/plain',
    buffer: Buffer.from(
      Array.from({ length: 12 }, (_, n) =>
        ((0.5 * (1 - (0.9 - place / 100) ** n)) / 0.1).toFixed(4),
      ).join('\n'),
    ),
  }));
  await page.getByLabel('Files with drops').setInputFiles(files);
  await page.getByText('3 drops were added.').waitFor();
  const names = () =>
    page
      .locator('tbody input.name')
      .evaluateAll((inputs) => (inputs as HTMLInputElement[]).map(({ value }) => value));
  const sort = page.getByRole('columnheader', { name: 'Name' }).getByRole('button');
  await sort.click();
  await expect.poll(names).toEqual(['a', 'b', 'c']);
  await sort.click();
  await expect.poll(names).toEqual(['c', 'b', 'a']);
  expect(await page.locator('tfoot').count()).toBe(1);
  for (const name of ['a', 'b']) await page.getByLabel(`Compare ${name}`).check();
  await page.getByLabel('Ball of the 2 chosen').selectOption('marble');
  await page.getByLabel('Surface of the 2 chosen').fill('wood');
  await page.getByLabel('Surface of the 2 chosen').press('Enter');
  await expect.poll(() => page.getByLabel('Ball of a').inputValue()).toBe('marble');
  await expect.poll(() => page.getByLabel('Surface of b').inputValue()).toBe('wood');
  for (const name of ['a', 'b']) await page.getByLabel(`Compare ${name}`).uncheck();
  await page.locator('tfoot').waitFor({ state: 'detached' });
  await page.context().close();
});
