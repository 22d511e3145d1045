/** Files, dropped and chosen, pasted times, the demo; and files that are none. */
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterEach, beforeAll, expect, test } from 'vitest';
import { closeContexts, newContext } from './harness/browser.ts';
import { fixture } from './harness/fixture.ts';
import { bouncelab, folder as scratch, synth } from './harness/program.ts';
import { violationsInBothThemes } from './support/layout.ts';
import { answers, dropFile, open, remembering, settled, tryDemo } from './support/page.ts';
import { cafOf, drop, samplesOf, TRUTH } from './support/sounds.ts';

const here = fixture();
let recording: string;

beforeAll(() => {
  recording = drop('file');
});
afterEach(() => closeContexts(here.browser));

const page = async (): Promise<Page> => (await open(here.browser, here.url)).page;

/** The impacts of the recording in the format of another program. */
const labels = (format: string): Buffer =>
  Buffer.from(bouncelab('analyze', recording, '--no-inference', '--format', format));

async function isTrue(on: Page): Promise<void> {
  const { kept, fell } = await answers(on);
  expect(Math.abs(kept.value - 100 * TRUTH.restitution)).toBeLessThan(3.5 * kept.sd);
  expect(Math.abs(fell.value - 100 * TRUTH.heightM)).toBeLessThan(3.5 * fell.sd);
}

test('a file that is chosen', async () => {
  const on = await page();
  await on.locator('input[type=file]').setInputFiles(recording);
  await isTrue(on);
});

test.each([
  ['CAF', 'drop.caf', () => cafOf(samplesOf(recording))],
  ['a TextGrid of Praat', 'drop.TextGrid', () => labels('textgrid')],
  ['labels of Audacity', 'labels.txt', () => labels('audacity')],
])('%s', async (_, name, content) => {
  const on = await page();
  const file = { name, mimeType: '', buffer: content() };
  await on.locator('input[type=file]').setInputFiles(file);
  await isTrue(on);
});

test('a file that is dropped anywhere', async () => {
  const on = await page();
  await dropFile(on, basename(recording), readFileSync(recording));
  await isTrue(on);
});

test('another ball than was stated is noticed, and chosen where the warning says', async () => {
  const words = ['--ball', 'tennis', '--height', '2.5m', '--restitution', '0.75'];
  const { path } = synth(join(scratch(), 'tennis.wav'), ...words);
  const { page: on } = await open(here.browser, here.url, {}, remembering('ball=table-tennis-40'));
  await on.locator('input[type=file]').setInputFiles(path);
  const warning = on.getByText(/probably another one.*Choose it in the row “Which ball\?”/);
  await warning.waitFor();
  const row = on.getByRole('group', { name: 'Which ball?' });
  await row.getByText('tennis', { exact: true }).click();
  await warning.waitFor({ state: 'detached' });
  await settled(on);
  expect(await warning.count()).toBe(0);
});

test('times that are pasted', async () => {
  const on = await page();
  await on.getByRole('button', { name: 'paste times' }).click();
  // Without air: e = 0.9 and flights that begin with 0.5 s.
  const times = Array.from({ length: 12 }, (_, n) => (0.5 * (1 - 0.9 ** n)) / 0.1);
  const written = times.map((time) => time.toFixed(6).replace('.', ','));
  await on.getByRole('textbox').fill(written.join('\n'));
  expect(await violationsInBothThemes(on)).toEqual([]);
  await on.getByRole('button', { name: 'Analyse' }).click();
  const { kept } = await answers(on);
  expect(kept.value).toBeGreaterThan(89);
  expect(kept.value).toBeLessThan(93);
  await on.getByText('12 impacts').waitFor();
});

test('a browser that may keep nothing opens the page too', async () => {
  const context = await newContext(here.browser, { locale: 'en-GB' });
  await context.addInitScript(() => {
    const denied = () => {
      throw new DOMException('denied', 'SecurityError');
    };
    Object.defineProperty(globalThis, 'localStorage', { get: denied });
    Object.defineProperty(globalThis, 'indexedDB', { get: denied });
  });
  const on = await context.newPage();
  await on.goto(`${here.url}#drops`);
  await on.getByText(/stores nothing|cannot keep/).waitFor();
});

test('the demo', async () => {
  const on = await page();
  await tryDemo(on);
  const { kept } = await answers(on);
  expect(kept.value).toBeCloseTo(95.29, 1);
});

test.each([
  ['an empty file', 'drop.wav', Buffer.alloc(0), 'The file is empty.'],
  [
    'a text',
    'letter.wav',
    Buffer.from('Dear all, this is no sound.'),
    'This is neither a recording nor a list of times.',
  ],
  [
    'a corrupt file',
    'broken.flac',
    Buffer.concat([Buffer.from('fLaC'), Buffer.alloc(4000, 0x5a)]),
    /damaged|neither a recording/,
  ],
])('%s says what happened and what to do', async (_, name, content, words) => {
  const on = await page();
  await dropFile(on, name, content);
  await on.getByRole('alert').getByText(words).first().waitFor();
  expect(await violationsInBothThemes(on)).toEqual([]);
});

test('what is wrong with a file is said in the language of the page', async () => {
  const { page: on } = await open(here.browser, here.url, { locale: 'de-DE' });
  const notice = on.getByRole('alert');
  await dropFile(on, 'brief.wav', Buffer.from('Dear all, this is no sound.'));
  await notice.getByText('Sie sieht aus wie Text.').waitFor();
  await dropFile(on, 'zeiten.csv', Buffer.from('time_s\n0.5\nzwei\n'));
  await notice.getByText('Zeile 3: „zwei“ ist keine Zeit in Sekunden wie 0.125.').waitFor();
});

test('samples without times are sound at the rate that is stated', async () => {
  const on = await page();
  const { rateHz, samples } = samplesOf(recording);
  const column = Buffer.from(Array.from(samples, (sample) => sample.toFixed(5)).join('\n'));
  await on
    .locator('input[type=file]')
    .setInputFiles({ name: 'samples.txt', mimeType: 'text/plain', buffer: column });
  await on.getByText('The table does not state when its samples were taken.').waitFor();
  await on.getByLabel('Sampling rate').fill(String(rateHz));
  await on.getByRole('button', { name: 'Read as sound' }).click();
  await isTrue(on);
  expect(await on.getByRole('alert').count()).toBe(0);
});

/** The beginning of five hours of sound, which its header states. */
function day(): Buffer {
  const [rate, bytes] = [48_000, 5 * 3600 * 48_000];
  const file = Buffer.alloc(6e6);
  file.write('RIFF', 0);
  file.writeUInt32LE(36 + bytes, 4);
  file.write('WAVEfmt ', 8);
  for (const [at, value] of [
    [16, 16],
    [24, rate],
    [28, rate],
    [40, bytes],
  ] as const) {
    file.writeUInt32LE(value, at);
  }
  for (const [at, value] of [
    [20, 1],
    [22, 1],
    [32, 1],
    [34, 8],
  ] as const) {
    file.writeUInt16LE(value, at);
  }
  file.write('data', 36);
  return file;
}

test('a huge file is refused, and what lay in the workspace stays', async () => {
  const on = await page();
  await tryDemo(on);
  const before = await answers(on);
  await dropFile(on, 'day.wav', day());
  await on.getByText('The file is too large for a browser.').waitFor();
  expect(await answers(on)).toEqual(before);
});

const folder = process.env['BOUNCELAB_RECORDINGS'] ?? '';
const recordings = existsSync(folder)
  ? readdirSync(folder).filter((name) => /\.(wav|mp3|mov|webm)$/.test(name))
  : [];

if (recordings.length === 0) {
  process.stdout.write('SKIPPED: real recordings, of which BOUNCELAB_RECORDINGS names no folder\n');
}

/** Recordings without a drop: their names begin with `not-`, and one has too few hits. */
test.each(recordings)('the recording %s', async (name) => {
  const on = await page();
  await on.locator('input[type=file]').setInputFiles(join(folder, name));
  const found = /^(not-|few-hits)/.test(name)
    ? on.getByText('No drop found.')
    : on.locator('.summary .first', { hasText: ' keeps ' });
  await found.waitFor();
});
