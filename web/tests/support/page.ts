/** What tests do with the page, and read from it. */
import { readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser, BrowserContextOptions, Locator, Page } from 'playwright-core';
import { vi } from 'vitest';
import { openPage, PATIENCE_MS, type Preparation } from '../harness/browser.ts';
import { FIREFOX } from '../harness/firefox.ts';
import { folder } from '../harness/program.ts';
import { samplesOf } from './sounds.ts';

/** The page in English on a desktop, unless other options are given, ready to be used. */
export async function open(
  browser: Browser,
  url: string,
  options: BrowserContextOptions = {},
  prepare?: Preparation,
): Promise<{ page: Page; troubles: string[] }> {
  const usual = { locale: 'en-GB', viewport: { width: 1280, height: 900 } };
  const opened = await openPage(browser, url, { ...usual, ...options }, prepare);
  await opened.page.getByRole('navigation').waitFor();
  return opened;
}

/** A context in which the reader stated a set-up on an earlier visit, as the address writes it. */
export const remembering =
  (setup: string): Preparation =>
  async (context) => {
    await context.addInitScript((known) => {
      if (localStorage.getItem('bouncelab.set-up') === null)
        localStorage.setItem('bouncelab.set-up', known);
    }, setup);
  };

/** Follows a link of the head until its view is there: the address changes before the page does. */
export async function follow(page: Page, name: string): Promise<void> {
  const link = page.getByRole('navigation').getByRole('link', { name, exact: true });
  await link.click();
  await page.locator('nav a[aria-current=page]', { hasText: name }).waitFor();
}

/** A value and its uncertainty as the page writes them, in the unit that it shows. */
export interface Answer {
  readonly value: number;
  readonly sd: number;
}

/** The numbers of the answer: restitution at its first speed in per cent, drop height in centimetres. */
export async function answers(page: Page): Promise<{ kept: Answer; fell: Answer }> {
  await settled(page);
  const read = async (place: string, unit: string): Promise<Answer> => {
    const words = ((await page.locator(place).first().textContent()) ?? '').replace(/\u2212/g, '-');
    const found = new RegExp(`(\\d[\\d.]*)\\s±\\s(\\d[\\d.]*)\\s${unit}`).exec(words);
    if (!found) throw new Error(`no number with its uncertainty in "${words}"`);
    return { value: Number(found[1]), sd: Number(found[2]) };
  };
  return {
    kept: await read('.summary .first', '%'),
    fell: await read('.summary .second', 'cm'),
  };
}

/** Waits until the inference is done. */
export async function settled(page: Page): Promise<void> {
  await page.locator('.summary[aria-busy="false"] :is(.first, .second)').first().waitFor();
}

/** Analyses the demo. */
export async function tryDemo(page: Page): Promise<void> {
  await page.getByRole('button', { name: 'try the demo' }).click();
  await settled(page);
}

/** The tabs of all figures: a lesson needs four of them. */
export async function tabsOfAll(page: Page): Promise<readonly Locator[]> {
  await page.locator('.figures .choose > button[aria-expanded="false"]').click();
  await page.getByRole('tab').nth(4).waitFor();
  return page.getByRole('tab').all();
}

/** Keeps the drop in the workspace, until the page says so. */
export async function keepAs(page: Page, name: string): Promise<void> {
  await page.getByLabel('Name').fill(name);
  await page.getByRole('button', { name: 'Keep this drop' }).click();
  await page.getByText(`Kept as “${name}”.`).waitFor();
}

/** The file that the page saves after the button of this name. */
export const saved = (page: Page, name: string): Promise<string> =>
  savedBy(page.getByRole('button', { name, exact: true }).first());

/** The file that the page saves after a button, with the name that the page gives it. */
export async function savedBy(button: Locator): Promise<string> {
  if (FIREFOX) return savedByFirefox(button, FIREFOX.downloads);
  const coming = button.page().waitForEvent('download');
  await button.click();
  const download = await coming;
  const path = join(folder(), download.suggestedFilename());
  await download.saveAs(path);
  return path;
}

/** Its file is complete when it is not empty and no part of it is beside it. */
async function savedByFirefox(button: Locator, place: string): Promise<string> {
  const before = new Set(readdirSync(place));
  await button.click();
  const added = (): string[] => readdirSync(place).filter((name) => !before.has(name));
  const path = (): string => join(place, added()[0] as string);
  const isComplete = (): boolean => added().length === 1 && statSync(path()).size > 0;
  await vi.waitUntil(isComplete, { timeout: PATIENCE_MS });
  return path();
}

/** Saves the sound in the workspace. */
export async function savedWav(page: Page) {
  return samplesOf(await saved(page, 'Sound (WAV)'));
}

/**
 * Waits until the page stands still: nothing is computed for it, nothing moves, and two frames in a
 * row leave it as it is.
 *
 * @throws After ten thousand frames, with what still moves.
 */
export async function still(page: Page): Promise<void> {
  await page.waitForFunction(() => !document.querySelector('[aria-busy="true"], .waiting'));
  await page.evaluate(async () => {
    await document.fonts.ready;
    const frame = () => new Promise((next) => requestAnimationFrame(next));
    let changes = ['not looked yet'];
    const watcher = new MutationObserver((records) => {
      changes = records.map(
        ({ type, attributeName, target }) =>
          `${type} ${attributeName ?? ''} of ${(target as Element).outerHTML.slice(0, 200)}`,
      );
    });
    watcher.observe(document, { subtree: true, childList: true, attributes: true });
    const running = () =>
      document.getAnimations().filter(({ playState }) => playState === 'running');
    for (let pair = 0; changes.length > 0 || running().length > 0; pair += 1) {
      if (pair > 5_000) {
        throw new Error(`the page moves on: ${changes.join('; ')}, ${running().length} animations`);
      }
      changes = [];
      await frame();
      await frame();
    }
    watcher.disconnect();
  });
}

/** Drops a file onto the page, as a hand would. */
export async function dropFile(
  page: Page,
  name: string,
  content: Buffer,
  claimedSize?: number,
): Promise<void> {
  await page.evaluate(
    ({ fileName, base64, size }) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const file = new File([bytes], fileName);
      if (size !== undefined) Object.defineProperty(file, 'size', { value: size });
      const transfer = new DataTransfer();
      transfer.items.add(file);
      // A transfer hands out copies, which would lose the claimed size.
      const event = new DragEvent('drop', { bubbles: true, cancelable: true });
      const carried = { types: ['Files'], files: size === undefined ? transfer.files : [file] };
      Object.defineProperty(event, 'dataTransfer', { value: carried });
      document.body.dispatchEvent(event);
    },
    { fileName: name, base64: content.toString('base64'), size: claimedSize },
  );
}
