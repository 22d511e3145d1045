/** Correcting impacts: with the mouse, and with the keyboard alone. */
import type { Page } from 'playwright-core';
import { afterEach, beforeEach, expect, test } from 'vitest';
import { fixture } from './harness/fixture.ts';
import { answers, open, settled, still, tryDemo } from './support/page.ts';

const here = fixture();
let page: Page;

afterEach(() => page.context().close());
beforeEach(async () => {
  page = (await open(here.browser, here.url)).page;
  await tryDemo(page);
  await answers(page);
});

const impacts = async (): Promise<number> => {
  const words = await page.getByText(/^\d+ impacts/).textContent();
  return Number.parseInt(words ?? '', 10);
};
const waveform = () => page.getByRole('slider', { name: /Waveform/ });
const press = async (...keys: string[]): Promise<void> => {
  for (const key of keys) await page.keyboard.press(key);
};
const counts = (expected: number) => page.getByText(`${expected} impacts`).first().waitFor();

test('with the keyboard alone: find, delete, undo, add, move, snap', async () => {
  const before = await answers(page);
  const all = await impacts();
  await waveform().focus();
  await press('Home', 'PageDown');
  expect(await waveform().getAttribute('aria-valuetext')).toMatch(/^impact 1, /);

  await press('Delete');
  await counts(all - 1);
  const without = await answers(page);
  // The fall is now that before the second impact.
  expect(without.fell.value).toBeLessThan(0.9 * before.fell.value);

  await press('Control+z');
  await counts(all);
  expect(await answers(page)).toEqual(before);

  await press('Control+Shift+z');
  await counts(all - 1);
  // The cursor still stands where the impact was: Enter sets it again, and it snaps to the sound.
  await press('Enter');
  await counts(all);
  const again = await answers(page);
  expect(Math.abs(again.kept.value - before.kept.value)).toBeLessThan(0.05);

  await press('Period', 'Period', 'Period', 'Period');
  await page.getByText(/Impact 1 moved to/).waitFor({ state: 'attached' });
  const nudged = await waveform().getAttribute('aria-valuenow');
  await press('s');
  await expect.poll(() => waveform().getAttribute('aria-valuenow')).not.toBe(nudged);
  expect(Math.abs((await answers(page)).kept.value - before.kept.value)).toBeLessThan(0.05);
});

test('with the mouse: zoom, drag an impact, undo', async () => {
  const before = await answers(page);
  const box = await waveform().boundingBox();
  if (!box) throw new Error('no waveform');
  await waveform().focus();
  await press('Home', 'PageDown', 'PageDown');
  for (let i = 0; i < 6; i += 1) await press('+');
  const value = Number(await waveform().getAttribute('aria-valuenow'));
  const x = await place(value);
  const y = box.y + box.height / 2;
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 150, y, { steps: 8 });
  await page.mouse.up();
  await page.getByText(/Impact \d+ moved to/).waitFor({ state: 'attached' });
  const moved = await answers(page);
  expect(moved).not.toEqual(before);
  await page.getByRole('button', { name: 'Undo' }).click();
  expect(await answers(page)).toEqual(before);
});

/** Where on the screen the cursor stands: the overview shows nothing smaller, so it is asked for. */
async function place(timeS: number): Promise<number> {
  await waveform().focus();
  const box = await waveform().boundingBox();
  if (!box) throw new Error('no waveform');
  // A click somewhere tells the time there; two of them tell the scale.
  const timeAt = async (share: number): Promise<number> => {
    await page.mouse.click(box.x + share * box.width, box.y + box.height * 0.8);
    return Number(await waveform().getAttribute('aria-valuenow'));
  };
  const [early, late] = [await timeAt(0.05), await timeAt(0.95)];
  const share = 0.05 + (0.9 * (timeS - early)) / (late - early);
  return box.x + share * box.width;
}

/** Two clicks of a hand a tenth of a second apart, however long the browser takes to hear of them. */
async function doubleClick(on: Page, x: number, y: number): Promise<void> {
  const client = await on.context().newCDPSession(on);
  const now = Date.now() / 1000;
  for (const clickCount of [1, 2]) {
    for (const type of ['mousePressed', 'mouseReleased'] as const) {
      const timestamp = now + 0.1 * clickCount;
      const click = { type, x, y, button: 'left', clickCount, timestamp } as const;
      await client.send('Input.dispatchMouseEvent', click);
    }
  }
}

test('an impact can be removed from the list, and a double click adds one', async () => {
  const all = await impacts();
  await page.getByText('List of impacts').click();
  await page.getByRole('button', { name: 'Remove impact 5', exact: true }).click();
  await counts(all - 1);
  // What was impact 6 is number 5 now, and the keyboard stands on it.
  const focus = page.locator(':focus');
  await expect.poll(() => focus.getAttribute('aria-label')).toBe('Remove impact 5');
  await settled(page);
  await waveform().scrollIntoViewIfNeeded();
  const box = await waveform().boundingBox();
  if (!box) throw new Error('no waveform');
  await doubleClick(page, box.x + 5, box.y + box.height / 2);
  await counts(all);
  // There is one already: the second is not set.
  await press('Enter');
  await counts(all);
  await page.getByText('edited by hand').waitFor();
  await page.getByRole('button', { name: 'As detected' }).click();
  await counts(all);
  await page.getByText('edited by hand').waitFor({ state: 'detached' });
});

test('the words follow an edit before the inference is done', async () => {
  await waveform().focus();
  await press('Home', 'PageDown', 'PageDown');
  const { took, busy } = await page.evaluate(
    () =>
      new Promise<{ took: number; busy: string | undefined }>((resolve) => {
        const words = document.querySelector('.summary .first') as Element;
        const before = performance.now();
        new MutationObserver((_, observer) => {
          observer.disconnect();
          const busy = words.closest('[aria-busy]')?.getAttribute('aria-busy') ?? undefined;
          resolve({ took: performance.now() - before, busy });
        }).observe(words, { characterData: true, subtree: true, childList: true });
        const stage = document.querySelector('.wave-stage') as HTMLElement;
        stage.dispatchEvent(new KeyboardEvent('keydown', { key: 'Delete', bubbles: true }));
      }),
  );
  process.stdout.write(`words follow an edit after ${took.toFixed(0)} ms\n`);
  expect(busy).toBe('true');
});

test('on a phone the way back is in reach after a change, and faint impacts can be seen', async () => {
  const phone = { viewport: { width: 320, height: 568 }, hasTouch: true, isMobile: true } as const;
  const { page: on } = await open(here.browser, here.url, phone);
  await tryDemo(on);
  const before = await answers(on);
  const stage = on.locator('.wave-stage');
  await stage.scrollIntoViewIfNeeded();
  await stage.focus();
  for (const key of ['Home', 'PageDown', 'PageDown', 'Delete']) await on.keyboard.press(key);
  await on.getByText('Impact 2 removed.').waitFor();
  const [wave, undo] = [
    await stage.boundingBox(),
    await on.getByRole('button', { name: 'Undo' }).boundingBox(),
  ];
  if (!wave || !undo) throw new Error('no waveform, or no way back');
  expect(undo.x).toBeGreaterThanOrEqual(0);
  expect(undo.x + undo.width).toBeLessThanOrEqual(320);
  expect(undo.y - (wave.y + wave.height)).toBeLessThan(120);
  await on.getByRole('button', { name: 'Undo' }).tap();
  expect(await answers(on)).toEqual(before);

  await stage.focus();
  await on.keyboard.press('End');
  for (let i = 0; i < 4; i += 1) await on.keyboard.press('+');
  const drawn = () =>
    stage.locator('canvas').evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL());
  const pictures = new Set<string>();
  for (const height of ['height: recording', 'height: view', 'height: decibels']) {
    await on.getByLabel('Height of the waveform').selectOption({ label: height });
    await still(on);
    pictures.add(await drawn());
  }
  expect(pictures.size).toBe(3);
  await on.getByRole('button', { name: 'Spectrogram' }).click();
  await on
    .locator('.spectrogram')
    .getByText(/^\d+ kHz$/)
    .first()
    .waitFor();
  await on.context().close();
});
