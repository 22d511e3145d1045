/** The package for pages of others: packed, unpacked, and embedded with two lines. */

import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, readdirSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { launch, PATIENCE_MS } from './harness/browser.ts';
import { folder } from './harness/program.ts';
import { Site } from './harness/site.ts';
import { drop, TRUTH } from './support/sounds.ts';

const PACKAGE = join(import.meta.dirname, '../package');

const EMBEDDED = `<!doctype html><html lang="en"><title>Lesson</title><body>
<script type="module" src="bouncelab/dist/bouncelab.js"></script>
<bounce-lab ball="table-tennis-40"></bounce-lab>
</body></html>`;

let place: string;
let site: Site;
let browser: Browser;

beforeAll(async () => {
  place = folder();
  const packed = execFileSync('npm', ['pack', PACKAGE, '--silent', '--pack-destination', place]);
  execFileSync('tar', ['-xzf', packed.toString().trim()], { cwd: place });
  cpSync(join(place, 'package'), join(place, 'bouncelab'), { recursive: true });
  writeFileSync(join(place, 'index.html'), EMBEDDED);
  cpSync(drop('embedded'), join(place, 'drop.wav'));
  site = await Site.open(place);
  browser = await launch();
});
afterAll(async () => {
  await browser.close();
  await site.close();
});

interface Result {
  readonly document: {
    readonly drops: {
      readonly posterior: { readonly restitution: { value: number; sd: number } };
    }[];
  };
}

/** What the element sends once it has this recording. */
const resultOf = (page: Page, source: string): Promise<Result> =>
  page.evaluate(
    (source) =>
      new Promise<Result>((resolve, reject) => {
        const element = document.querySelector('bounce-lab');
        element?.addEventListener('bouncelab-result', (event) =>
          resolve((event as CustomEvent<Result>).detail),
        );
        element?.addEventListener('bouncelab-error', (event) =>
          reject(new Error(String((event as CustomEvent).detail))),
        );
        element?.setAttribute('src', source);
      }),
    source,
  );

const embedded = async (): Promise<Page> => {
  const page = await browser.newPage();
  page.setDefaultTimeout(PATIENCE_MS);
  await page.goto(site.url);
  return page;
};

test('two lines embed the laboratory', async () => {
  const page = await embedded();
  await page.getByText('Recording or list of impact times').waitFor();
  const found = await resultOf(page, 'drop.wav');
  const restitution = found.document.drops[0]?.posterior.restitution;
  expect(Math.abs((restitution?.value ?? 0) - TRUTH.restitution)).toBeLessThan(
    4 * (restitution?.sd ?? 0),
  );
  await page.locator('bounce-lab svg').waitFor();
  expect(await page.locator('bounce-lab [role=status] p').first().textContent()).toContain(
    'The ball keeps 9',
  );
  await page.close();
});

test('a reader chooses a file, and reads why nothing was found in it', async () => {
  const page = await embedded();
  const input = page.locator('bounce-lab input');
  const choose = (name: string, content: string) =>
    input.setInputFiles({ name, mimeType: 'text/csv', buffer: Buffer.from(content) });
  await choose('times.csv', '0\n0.4605\n0.8877\n1.2854\n1.6568\n2.0045\n');
  await page.locator('bounce-lab [role=status] p').getByText('The ball keeps 9').first().waitFor();
  await choose('empty.wav', '');
  await page.locator('bounce-lab [role=status] p').getByText('empty').waitFor();
  await page.close();
});

test('its types are complete', () => {
  const modules = join(place, 'node_modules');
  mkdirSync(modules);
  symlinkSync(join(place, 'package'), join(modules, 'bouncelab'));
  const use = `import { BounceLab, Lab, type Analysed, type Settings } from 'bouncelab';
export const settings: Settings = { ball: { kind: 'tennis' } };
export const value = (it: Analysed): number | undefined => it.document.drops[0]?.posterior?.restitution.value;
export const element: BounceLab = new BounceLab();
export const lab: Lab = new Lab();
// @ts-expect-error a ball has a name
export const wrong: Settings = { ball: { kind: 1 } };
`;
  writeFileSync(join(place, 'use.ts'), use);
  const options = ['--strict', '--noEmit', '--module', 'esnext', '--moduleResolution', 'bundler'];
  const target = ['--target', 'es2022', '--lib', 'es2023,dom,dom.iterable', '--types', ''];
  const compiler = join(import.meta.dirname, '../node_modules/.bin/tsc');
  execFileSync(compiler, [...options, ...target, join(place, 'use.ts')], {
    cwd: place,
    stdio: 'pipe',
  });
  expect(readdirSync(join(place, 'package', 'dist', 'assets')).length).toBeGreaterThan(10);
});
