/** How fast it is: to open, to pan. Printed, not asserted: that is up to the machine. */
import { writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { newContext } from './harness/browser.ts';
import { FIREFOX } from './harness/firefox.ts';
import { fixture } from './harness/fixture.ts';
import { open } from './support/page.ts';

const here = fixture();

const print = (line: string): boolean => process.stdout.write(`${line}\n`);

test('it can be used as soon as it is open', async () => {
  const times: number[] = [];
  // The best of three: what else the machine does is not the page's fault.
  for (let i = 0; i < 3; i += 1) {
    const context = await newContext(here.browser, { locale: 'en-GB' });
    const page = await context.newPage();
    const start = performance.now();
    await page.goto(here.url, { waitUntil: 'commit' });
    await page.getByRole('button', { name: 'Listen' }).waitFor();
    times.push(performance.now() - start);
    await context.close();
  }
  print(`interactive after ${Math.min(...times).toFixed(0)} ms`);
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

test('ten minutes of sound can be panned', async () => {
  const { page } = await open(here.browser, here.url);
  await page.locator('input[type=file]').setInputFiles(tenMinutes());
  await page.locator('.wave-stage').focus();
  for (let i = 0; i < 5; i += 1) await page.keyboard.press('+');
  const picture = () =>
    page.locator('.wave-stage canvas').evaluate((c: HTMLCanvasElement) => c.toDataURL());
  const before = await picture();
  // What a hand would do, one step a frame; the time that each frame takes is the browser's own.
  const frames = await page.evaluate(async () => {
    const stage = document.querySelector('.wave-stage') as HTMLElement;
    const frame = () => new Promise<number>((next) => requestAnimationFrame(next));
    const times: number[] = [];
    for (let i = 0; i < 180; i += 1) {
      times.push(await frame());
      const wheel = { deltaX: 40, bubbles: true, cancelable: true };
      stage.dispatchEvent(new WheelEvent('wheel', wheel));
    }
    return times;
  });
  const meanMs = ((frames.at(-1) ?? 0) - (frames[0] ?? 0)) / (frames.length - 1);
  print(`panning: ${(1000 / meanMs).toFixed(1)} frames a second`);
  await expect.poll(picture).not.toBe(before);
  await page.context().close();
});

/** A slow telephone network and a processor of a quarter of the speed. */
const SLOW = { offline: false, latency: 500, downloadThroughput: 50_000, uploadThroughput: 50_000 };

test.skipIf(FIREFOX)('on a slow phone: bytes, the first paint, and the first number', async () => {
  const context = await newContext(here.browser, { locale: 'en-GB', serviceWorkers: 'block' });
  const page = await context.newPage();
  const client = await context.newCDPSession(page);
  let bytes = 0;
  client.on('Network.loadingFinished', ({ encodedDataLength }) => {
    bytes += encodedDataLength;
  });
  await client.send('Network.enable');
  await client.send('Network.emulateNetworkConditions', SLOW);
  await client.send('Emulation.setCPUThrottlingRate', { rate: 4 });
  const start = performance.now();
  const since = (): string => ((performance.now() - start) / 1000).toFixed(1);
  await page.goto(here.url, { waitUntil: 'commit' });
  await page.getByRole('radio').first().waitFor({ state: 'attached' });
  const [ready, atOnce] = [since(), bytes];
  const paints = await page.evaluate(() =>
    performance.getEntriesByType('paint').map(({ startTime }) => startTime),
  );
  const asked = performance.now();
  await page.getByRole('button', { name: 'try the demo' }).click();
  await page.locator('.summary :is(.first, .second) strong').first().waitFor();
  const number = ((performance.now() - asked) / 1000).toFixed(1);
  print(
    `slow phone: ${(atOnce / 1000).toFixed(0)} kB, painted after ${(Math.min(...paints) / 1000).toFixed(1)} s, engine after ${ready} s, number ${number} s after the tap`,
  );
  await context.close();
});
