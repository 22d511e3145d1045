/** A class in the table of drops: files, ZIP files and links at once, groups, what becomes of damaged ones; lesson sheets. */
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { BlobReader, BlobWriter, ZipWriter } from '@zip.js/zip.js/lib/zip-core-custom.js';
import type { Locator, Page } from 'playwright-core';
import { beforeAll, expect, test } from 'vitest';
import { fixture } from './harness/fixture.ts';
import { folder, synth } from './harness/program.ts';
import { overflow, printedPages, violations } from './support/layout.ts';
import { keepAs, open, remembering, saved, savedBy, settled, still } from './support/page.ts';
import { picture } from './support/pictures.ts';

const here = fixture();
let place: string;

beforeAll(() => {
  place = folder();
});

/** A drop of a golf ball. */
function golf(name: string, restitution: number): string {
  const truth = ['--ball', 'golf', '--height', '40cm', '--restitution', String(restitution)];
  return synth(join(place, `${name}.wav`), ...truth, '--seed', String(1000 * restitution)).path;
}

async function zipOf(files: readonly (readonly [string, Blob])[]): Promise<string> {
  const zip = new ZipWriter(new BlobWriter());
  for (const [name, blob] of files) await zip.add(name, new BlobReader(blob));
  const path = join(place, 'class.zip');
  writeFileSync(path, Buffer.from(await (await zip.close()).arrayBuffer()));
  return path;
}

const blobOf = (path: string): Blob => new Blob([readFileSync(path)]);

/** Names, balls, surfaces and students as the table has them. */
const table = (page: Page): Promise<string[][]> =>
  page
    .locator('table.wide tbody tr')
    .evaluateAll((rows) =>
      rows.map((row) =>
        [...row.querySelectorAll<HTMLInputElement>('input.name, select, input.noted')].map(
          ({ value }) => value,
        ),
      ),
    );

const add = (page: Page, files: string | string[]): Promise<void> =>
  page.getByLabel('Files with drops').setInputFiles(files);

test('files, a ZIP with damaged ones, and links: each drop once, with its student', async () => {
  const { page } = await open(here.browser, here.url, {}, remembering('ball=golf'));
  await page.getByLabel('Recording or list of impact times').setInputFiles(golf('1', 0.8));
  await settled(page);
  const document = await saved(page, 'All data (JSON)');
  await page.getByLabel('Name').fill('Anna');
  await page.getByRole('button', { name: 'Share this drop' }).click();
  const link = await page.locator('.shared code').last().innerText();
  await keepAs(page, 'Anna');
  await page.goto(`${here.url}#drops`);
  const list = await saved(page, 'Save all (JSON)');
  const archive = await saved(page, 'Save all with sound (ZIP)');
  await page.context().close();

  const wav = readFileSync(golf('2', 0.81));
  const zip = await zipOf([
    ['up/Ben_12_assignsubmission_file_/drop.wav', new Blob([wav])],
    ['up/Cleo_13_assignsubmission_file_/bouncelab-drops.zip', blobOf(archive)],
    ['up/Dan_14_assignsubmission_file_/essay.pdf', new Blob(['%PDF-1.7 an essay'])],
    ['up/Eve_15_assignsubmission_file_/table.json', new Blob(['{"schema": "bouncelab.kept'])],
    ['up/Gil_17_assignsubmission_file_/data.json', blobOf(document)],
    ['up/Flo_16_assignsubmission_file_/drop.wav', new Blob([wav.subarray(0, 30)])],
  ]);
  const third = golf('3', 0.805);
  const { page: teacher, troubles } = await open(
    here.browser,
    here.url,
    {},
    remembering('ball=golf'),
  );
  await teacher.getByRole('link', { name: 'Drops', exact: true }).click();
  await add(teacher, [zip, list, third]);
  await teacher.getByText('3 drops were added. 2 are in the table already.').waitFor();
  const refused = await teacher.getByRole('alert').allInnerTexts();
  expect(refused.map((words) => words.split(':')[0]).sort()).toEqual([
    'up/Dan_14_assignsubmission_file_/essay.pdf',
    'up/Eve_15_assignsubmission_file_/table.json',
    'up/Flo_16_assignsubmission_file_/drop.wav',
  ]);
  await teacher.getByLabel(/^Links of other/).fill(`Anna ${link}`);
  await teacher.getByRole('button', { name: 'Add to this table' }).click();
  await teacher.getByText('Nothing in it is new. 1 is in the table already.').waitFor();
  expect(await table(teacher)).toEqual([
    ['Anna', 'golf', '', 'Cleo'],
    ['drop', 'golf', '', 'Ben'],
    ['3', 'golf', '', '3'],
  ]);
  expect(troubles).toEqual([]);
  await teacher.context().close();
});

test('a bad drop is refused by its name, and what others state is shown', async () => {
  const { page } = await open(here.browser, here.url, {}, remembering('ball=golf'));
  await page.goto(`${here.url}#drops`);
  await add(page, golf('1', 0.8));
  await page.getByText('1 drop was added.').waitFor();
  const list = JSON.parse(readFileSync(await saved(page, 'Save all (JSON)'), 'utf8'));
  await page.context().close();

  const [drop] = list.drops;
  const times = (s: number) =>
    drop.marks.impacts.map((it: { time_s: number }) => ({ ...it, time_s: it.time_s * s }));
  const marked = (s: number) => ({ ...drop.marks, impacts: times(s) });
  list.drops = [
    { ...drop, id: 'a', name: 'bad', restitution: { value: 0.8, sd: 'x' } },
    {
      ...drop,
      id: 'b',
      name: 'moon',
      settings: { gravity: { gravity_m_s2: 9 } },
      marks: marked(2),
    },
  ];
  const { page: teacher, troubles } = await open(here.browser, `${here.url}#drops`);
  const file = { name: 'class.json', mimeType: 'application/json' };
  const buffer = Buffer.from(JSON.stringify(list));
  await teacher.getByLabel('Files with drops').setInputFiles({ ...file, buffer });
  await teacher.getByText('1 drop was added.').waitFor();
  const refused = await teacher.getByRole('alert').innerText();
  expect(refused).toMatch(/^class\.json: bad: /);
  const row = teacher.locator('table.wide tbody tr');
  expect(await row.count()).toBe(1);
  await row.getByText(/9\sm\/s²/).waitFor();
  await teacher.locator('.groups[aria-busy=false]').waitFor();

  const many = await zipOf(
    Array.from({ length: 500 }, (_, place) => [`${place}.wav`, new Blob(['RIFF'])] as const),
  );
  await add(teacher, many);
  await teacher.getByRole('button', { name: 'Cancel' }).click();
  await teacher.getByText('Nothing in it is new.').waitFor();
  expect(await teacher.getByRole('alert').count()).toBeLessThan(500);
  expect(troubles).toEqual([]);
  await teacher.context().close();
});

test.each([
  ['light', 'en-GB'],
  ['dark', 'de-DE'],
] as const)('groups by what the table says, %s, %s', async (colorScheme, locale) => {
  const options = { colorScheme, locale, viewport: { width: 390, height: 844 } };
  const { page, troubles } = await open(here.browser, here.url, options, remembering('ball=golf'));
  await page.locator('nav a[href="#drops"]').click();
  const files = [0.8, 0.802, 0.805, 0.76, 0.765, 0.762].map((e, i) => golf(`g${i}`, e));
  await page.locator('input[type=file]').setInputFiles(files);
  const rows = page.locator('table.wide tbody tr');
  await expect.poll(() => rows.count()).toBe(6);
  const groups = page.locator('.groups[aria-busy=false]');
  await groups.locator('.notice').waitFor();
  for (const [place, surface] of ['stone', 'stone', 'stone', 'wood', 'wood', 'wood'].entries()) {
    const input = rows.nth(place).locator('input.noted').first();
    await input.pressSequentially(surface);
    await input.press('Enter');
  }
  await groups.locator('p', { hasText: 'golf, wood' }).first().waitFor();
  await still(page);
  await picture(page, `groups-${colorScheme}`);
  expect(await overflow(page)).toBeLessThanOrEqual(0);
  expect(await violations(page)).toEqual([]);

  const report = readFileSync(await savedBy(groups.locator('> div > button')), 'utf8');
  expect(report).toMatch(/golf, stone/i);
  expect(report).toContain('<svg');
  // The keyboard groups too.
  await groups.getByRole('checkbox').nth(1).focus();
  await page.keyboard.press('Space');
  await groups.locator('.notice').waitFor();
  expect(await groups.locator('p', { hasText: 'golf, wood' }).count()).toBe(0);
  expect(troubles).toEqual([]);
  await page.context().close();
});

test.each([
  ['en-GB', 'How bouncy is a ball?'],
  ['de-DE', 'Wie gut springt ein Ball?'],
  ['fr-FR', 'Comment une balle rebondit-elle\u202f?'],
  ['es-ES', '¿Cuánto rebota una pelota?'],
] as const)('lesson sheets print on two pages, %s', async (locale, title) => {
  const { page, troubles } = await open(here.browser, `${here.url}#drops`, { locale });
  await page.locator('.lesson > summary').click();
  await page.locator('.lesson').getByRole('checkbox').first().check();
  const address = await page.locator('.shared code').innerText();
  const code = (path: Locator) => path.getAttribute('d');
  const sheets = page.locator('section[aria-labelledby=sheets] li');
  expect(await sheets.first().innerText()).toContain(title);
  expect(await sheets.count()).toBe(3);
  for (const index of [0, 1, 2]) {
    const [print, edit] = await sheets.nth(index).getByRole('button').all();
    if (!print || !edit) throw new Error('a sheet has two forms');
    const file = await savedBy(print);
    const text = readFileSync(await savedBy(edit), 'utf8');
    const paper = await page.context().newPage();
    await paper.goto(`file://${file}`);
    expect(await printedPages(paper, 'A4'), file).toBe(2);
    expect(await violations(paper), file).toEqual([]);
    const pupils = paper.locator('section').first();
    expect(await pupils.innerText()).toContain(address);
    // The code that `lesson.e2e.ts` reads with a camera.
    expect(await code(pupils.locator('.picture path').last())).toBe(
      await code(page.locator('.shared .qr path')),
    );
    expect(text).toMatch(/^# .+/);
    expect(text.replaceAll('\\', '')).toContain(address);
    expect(text.match(/^!\[.+\]$/gm)?.length).toBe(2);
    await paper.close();
  }
  expect(troubles).toEqual([]);
  await page.context().close();
});

test('another ball of a drop is another analysis', async () => {
  const { page } = await open(here.browser, here.url, {}, remembering('ball=golf'));
  await page.getByRole('link', { name: 'Drops', exact: true }).click();
  await add(page, golf('4', 0.8));
  await page.getByText('1 drop was added.').waitFor();
  const first = page.locator('table.wide tbody td.figure').first();
  const before = await first.innerText();
  await page.getByLabel('Ball of 4').selectOption('table-tennis-40');
  await expect.poll(() => first.innerText()).not.toBe(before);
  await page.context().close();
});
