/** How fast it is: to open, to hear, to pan. Printed, and held to what was promised. */
import { writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { launch } from './harness/browser.ts';
import { Site } from './harness/site.ts';
import { open } from './support/page.ts';

let site: Site;
let browser: Browser;

beforeAll(async () => {
  site = await Site.open();
  browser = await launch();
});
afterAll(async () => {
  await browser.close();
  await site.close();
});

const tell = (words: string): boolean => process.stdout.write(`${words}\n`);

test('it can be used within a second', async () => {
  const times: number[] = [];
  // The best of three: what else the machine does is not the page's fault.
  for (let i = 0; i < 3; i += 1) {
    const context = await browser.newContext({ locale: 'en-GB' });
    const page = await context.newPage();
    const start = performance.now();
    await page.goto(site.url, { waitUntil: 'commit' });
    await page.getByRole('button', { name: 'Listen' }).waitFor();
    times.push(performance.now() - start);
    await context.close();
  }
  const best = Math.min(...times);
  tell(`interactive after ${best.toFixed(0)} ms`);
  expect(best).toBeLessThan(1000);
});

/** Ten minutes of noise at 48 kHz, 16 bits. */
function tenMinutes(): string {
  const rate = 48_000;
  const samples = 600 * rate;
  const file = Buffer.alloc(44 + 2 * samples);
  file.write('RIFF', 0);
  file.writeUInt32LE(36 + 2 * samples, 4);
  file.write('WAVEfmt ', 8);
  file.writeUInt32LE(16, 16);
  file.writeUInt16LE(1, 20);
  file.writeUInt16LE(1, 22);
  file.writeUInt32LE(rate, 24);
  file.writeUInt32LE(2 * rate, 28);
  file.writeUInt16LE(2, 32);
  file.writeUInt16LE(16, 34);
  file.write('data', 36);
  file.writeUInt32LE(2 * samples, 40);
  let state = 1;
  for (let i = 0; i < samples; i += 1) {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
    file.writeInt16LE((state >>> 20) - 2048, 44 + 2 * i);
  }
  const path = join(tmpdir(), 'bouncelab-ten-minutes.wav');
  writeFileSync(path, file);
  return path;
}

test('ten minutes of sound pan at 60 frames a second', async () => {
  const { page } = await open(browser, site.url);
  await page.locator('input[type=file]').setInputFiles(tenMinutes());
  await page.locator('.wave-stage').waitFor({ timeout: 120_000 });
  await page.locator('.wave-stage').focus();
  for (let i = 0; i < 5; i += 1) await page.keyboard.press('+');
  // What a hand would do, one step a frame; the time that each frame takes is the browser's own.
  const { frames, busy } = await page.evaluate(async () => {
    const stage = document.querySelector('.wave-stage') as HTMLElement;
    const frame = () => new Promise<number>((next) => requestAnimationFrame(next));
    const times: number[] = [];
    const work: number[] = [];
    for (let i = 0; i < 180; i += 1) {
      times.push(await frame());
      const before = performance.now();
      const deltaX = i % 60 < 30 ? 40 : -40;
      stage.dispatchEvent(new WheelEvent('wheel', { deltaX, bubbles: true, cancelable: true }));
      await new Promise((done) => setTimeout(done));
      work.push(performance.now() - before);
    }
    return { frames: times, busy: work };
  });
  const steps = frames.slice(1).map((time, i) => time - (frames[i] ?? 0));
  const mean = steps.reduce((sum, step) => sum + step, 0) / steps.length;
  const slowest = busy.toSorted((a, b) => a - b)[Math.floor(0.95 * busy.length)] ?? 0;
  tell(
    `panning: ${(1000 / mean).toFixed(1)} frames a second, work a frame ${slowest.toFixed(1)} ms`,
  );
  expect(1000 / mean).toBeGreaterThan(55);
  await page.context().close();
}, 180_000);
