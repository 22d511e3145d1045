/** The page in WebKit, which is the browser of every iPhone: it opens, analyses the demo, and reads files. */
import { afterAll, beforeAll, expect, test } from 'vitest';
import { fixture as recording } from '../harness/program.ts';
import { Site } from '../harness/site.ts';
import { WebKit } from './driver.ts';

let site: Site;
let browser: WebKit;

beforeAll(async () => {
  site = await Site.open();
  browser = await WebKit.start();
});
afterAll(async () => {
  await browser.close();
  await site.close();
});

/** The answer in words, once the inference is done. */
const answer = (): string =>
  document.querySelector('.summary[aria-busy="false"] .said')?.textContent ?? '';

/** Opens the page anew, until its engine runs. */
async function fresh(name: string): Promise<void> {
  await browser.open(`${site.url}?${name}`);
  const balls = () => browser.run(() => document.querySelectorAll('.balls label').length);
  await expect.poll(balls).toBeGreaterThan(5);
}

test('without a locale the page opens in English, and the demo has an answer', async () => {
  await fresh('demo');
  expect(await browser.run(() => document.documentElement.lang)).toBe('en');
  await browser.click('.links > button:last-child');
  await expect.poll(() => browser.run(answer)).toMatch(/of its speed.*It fell from/);
  const drawn = () => browser.run(() => document.querySelectorAll('.figures canvas').length);
  await expect.poll(drawn).toBeGreaterThan(0);
});

test.each(['pcm16.wav', 'id3.mp3', 'video.mov', 'browser.webm'])('it reads %s', async (name) => {
  await fresh(name);
  await browser.type('.links input[type=file]', recording(name));
  await expect.poll(() => browser.run(answer)).toContain('5 impacts');
});
