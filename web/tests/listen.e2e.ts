/** Listening: a drop into the microphone, its result, its sound; and all that can go wrong with it. */
import type { Browser, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect, test } from 'vitest';
import { launch, type Microphone, newContext, type Preparation } from './harness/browser.ts';
import { Site } from './harness/site.ts';
import { violationsInBothThemes } from './support/layout.ts';
import { answers, follow, open, savedWav, settled, tryDemo } from './support/page.ts';
import { drop, hearing, samplesOf, TRUTH } from './support/sounds.ts';
import { wordsOf } from './support/words.ts';

let site: Site;
let played: string;
/** It bounces for ten seconds after ten impacts, however late a busy page shows them. */
let long: string;
let browser: Browser | undefined;

beforeAll(async () => {
  site = await Site.open();
  played = drop('microphone');
  long = drop('long', 0.965);
});
afterAll(() => site.close());
afterEach(async () => {
  await browser?.close();
});

async function opened(microphone: Microphone) {
  browser = await launch({ microphone });
  return open(browser, site.url);
}

const listen = (page: Page) => page.getByRole('button', { name: 'Listen' }).click();

/** All blocks that the page wrote to its database, one after the other. */
const stored = (page: Page): Promise<number[]> =>
  page.evaluate(
    () =>
      new Promise<number[]>((resolve, reject) => {
        const request = indexedDB.open('bouncelab');
        request.onerror = () => reject(request.error);
        request.onsuccess = () => {
          const all = request.result.transaction('blocks').objectStore('blocks').getAll();
          all.onsuccess = () =>
            resolve(all.result.flatMap((block: { samples: Float32Array }) => [...block.samples]));
        };
      }),
  );

type Announced = typeof globalThis & { announced: { spoken: string[]; vibrations: number } };

/** Lets the pages of a context hear a drop, and remember what they speak and how often they vibrate. */
const announced: Preparation = async (context) => {
  await hearing(played)(context);
  await context.addInitScript(() => {
    const announced = { spoken: [] as string[], vibrations: 0 };
    class Utterance {
      lang = '';
      constructor(readonly text: string) {}
    }
    const voice = {
      cancel: () => undefined,
      speak: ({ lang, text }: Utterance) => announced.spoken.push(`${lang}: ${text}`),
    };
    const given = { announced, SpeechSynthesisUtterance: Utterance, speechSynthesis: voice };
    for (const [name, value] of Object.entries(given)) {
      Object.defineProperty(globalThis, name, { value });
    }
    Object.defineProperty(navigator, 'vibrate', {
      value: () => {
        announced.vibrations += 1;
        return true;
      },
    });
  });
};

const announcedBy = (page: Page) => page.evaluate(() => (globalThis as Announced).announced);

test('a drop is heard, ends by itself, and its result is true within its uncertainty', async () => {
  browser = await launch();
  const { page, troubles } = await open(browser, site.url, {}, announced);
  await listen(page);
  await page.getByText(/impacts so far/).waitFor();
  expect(await violationsInBothThemes(page)).toEqual([]);
  const { kept, fell } = await answers(page);
  // Three standard deviations, and half of the last digit that is shown.
  expect(Math.abs(kept.value - 100 * TRUTH.restitution)).toBeLessThan(3.5 * kept.sd);
  expect(Math.abs(fell.value - 100 * TRUTH.heightM)).toBeLessThan(3.5 * fell.sd);
  expect(troubles).toEqual([]);
  // Nobody asked for it.
  expect(await announcedBy(page)).toEqual({ spoken: [], vibrations: 0 });

  const wav = await savedWav(page);
  const kepts = await stored(page);
  expect(wav.samples.length).toBe(kepts.length);
  expect(wav.samples.every((sample, i) => sample === kepts[i])).toBe(true);
  expect(likeness(wav, samplesOf(played))).toBeGreaterThan(0.95);
});

test('if it is wanted, the page vibrates when the ball rests and speaks the answer, once', async () => {
  browser = await launch();
  const words = wordsOf('de');
  const { page } = await open(browser, site.url, { locale: 'de-DE' }, announced);
  const choose = async (message: string): Promise<void> => {
    await page.getByText(words('page-rest-title')).press('Enter');
    await page.getByRole('checkbox', { name: words(message) }).press('Space');
  };
  const isChosen = (message: string) =>
    page.getByLabel(words(message)).evaluate((box) => (box as HTMLInputElement).checked);
  await choose('page-rest-speech');
  await page.reload();
  expect(await isChosen('page-rest-speech')).toBe(true);
  expect(await isChosen('page-rest-vibration')).toBe(false);
  await choose('page-rest-vibration');
  await page.getByRole('button', { name: words('page-lab-listen'), exact: true }).click();
  await settled(page);
  const sentences = await page.locator('.summary :is(.first, .second)').allTextContents();
  const answer = sentences.join(' ').replaceAll('\u00a0', ' ');
  expect(answer).toMatch(/±.*±/);
  const once = {
    spoken: [`de-DE: ${answer.replaceAll('±', words('page-rest-plus-minus'))}`],
    vibrations: 1,
  };
  await expect.poll(() => announcedBy(page)).toEqual(once);
  // Another ball has another answer, but it falls no second time.
  await page.locator('.balls label:has(.golf)').click();
  await expect
    .poll(() => page.locator('.summary .second').textContent())
    .not.toBe(sentences.at(-1));
  await settled(page);
  expect(await announcedBy(page)).toEqual(once);
});

/**
 * Correlation of the loudness of what was saved with what was played, where they fit best. Loudness,
 * because a browser resamples its microphone.
 */
function likeness(saved: Sound, played: Sound): number {
  const one = loudness(saved, 0);
  const others = Array.from({ length: STEPS }, (_, step) => loudness(played, step));
  return Math.max(...others.map((other) => best(one, other)));
}

type Sound = ReturnType<typeof samplesOf>;

/** Hundredths of a second, and the parts of one in which the two may be out of step. */
const BIN_S = 0.01;
const STEPS = 10;

function loudness({ rateHz, samples }: Sound, step: number): number[] {
  const size = Math.round(rateHz * BIN_S);
  const first = Math.round((step / STEPS) * size);
  return Array.from({ length: Math.floor((samples.length - first) / size) }, (_, bin) =>
    Math.sqrt(
      samples
        .subarray(first + bin * size, first + (bin + 1) * size)
        .reduce((total, sample) => total + sample * sample, 0),
    ),
  );
}

function best(a: readonly number[], b: readonly number[]): number {
  const loudest = (bins: readonly number[]): number => bins.indexOf(Math.max(...bins));
  const correlation = (lag: number): number => {
    let [both, one, other] = [0, 0, 0];
    a.forEach((x, i) => {
      const y = b[i + lag] ?? 0;
      both += x * y;
      one += x * x;
      other += y * y;
    });
    return both / Math.sqrt(one * other);
  };
  const middle = loudest(b) - loudest(a);
  return Math.max(...[-1, 0, 1].map((by) => correlation(middle + by)));
}

test('a refused microphone says what happened and what to do', async () => {
  const { page } = await opened('refused');
  await listen(page);
  await page.getByText('The browser may not use the microphone.').waitFor();
  await page.getByText(/Allow it in the address bar/).waitFor();
  expect(await page.getByRole('button', { name: 'open a file' }).isEnabled()).toBe(true);
});

test('a computer without a microphone says so', async () => {
  const { page } = await opened('missing');
  await listen(page);
  await page.getByText('No microphone was found.').waitFor();
});

test('a browser whose sound never starts is not waited for', async () => {
  browser = await launch({ microphone: { file: played } });
  const context = await newContext(browser, { locale: 'en-GB' });
  await context.addInitScript(() => {
    AudioContext.prototype.resume = () => new Promise(() => undefined);
  });
  const page = await context.newPage();
  await page.goto(site.url);
  await listen(page);
  await page.getByText('The microphone could not be opened.').waitFor();
  await tryDemo(page);
});

test('a call ends the listening with what was heard; until then nothing comes between', async () => {
  browser = await launch();
  const context = await newContext(browser, { locale: 'en-GB' });
  await hearing(long)(context);
  await context.addInitScript(() => {
    const begin = AudioContext.prototype.createMediaStreamSource;
    AudioContext.prototype.createMediaStreamSource = function (stream) {
      addEventListener('call', () => void this.suspend());
      return begin.call(this, stream);
    };
    // The ball is dropped when the test is ready for it: until then there is silence.
    const start = AudioBufferSourceNode.prototype.start;
    AudioBufferSourceNode.prototype.start = function (...words) {
      addEventListener('dropped', () => start.apply(this, words), { once: true });
    };
  });
  const page = await context.newPage();
  await page.goto(site.url);
  await listen(page);
  await follow(page, 'Simulate');
  expect(await page.getByRole('button', { name: 'Analyse its sound' }).isDisabled()).toBe(true);
  const beside = await context.newPage();
  await beside.goto(site.url);
  await beside.getByRole('button', { name: 'Listen' }).waitFor();
  await page.bringToFront();
  await follow(page, 'Listen');
  await page.getByRole('button', { name: 'Stop' }).focus();
  await page.evaluate(() => dispatchEvent(new Event('dropped')));
  await page.getByText(/(\d\d) impacts so far/).waitFor();
  await page.evaluate(() => dispatchEvent(new Event('call')));
  await page.getByText(/was disconnected/).waitFor();
  await settled(page);
  // The keyboard goes on where the next drop begins.
  await expect.poll(() => page.locator(':focus').innerText()).toBe('Listen again');
  expect(await beside.getByText(/was interrupted|not in the table/).count()).toBe(0);
});

test('a page that is closed while it listens loses nothing', async () => {
  browser = await launch();
  const { page } = await open(browser, site.url, {}, hearing(long));
  await listen(page);
  await page.getByText(/(\d\d) impacts so far/).waitFor();
  await page.reload();
  await page.getByText(/was interrupted/).waitFor();
  expect(await violationsInBothThemes(page)).toEqual([]);
  await page.getByRole('button', { name: 'Open it' }).click();
  await settled(page);
  expect(await page.getByText(/\d+ impacts/).count()).toBeGreaterThan(0);
});

test('a full storage is reported, and the recording can still be saved whole', async () => {
  browser = await launch({ microphone: { file: played } });
  const context = await newContext(browser, { locale: 'en-GB' });
  await context.addInitScript(() => {
    const put = IDBObjectStore.prototype.put;
    IDBObjectStore.prototype.put = function (this: IDBObjectStore, ...words) {
      if (this.name === 'blocks') throw new DOMException('no room', 'QuotaExceededError');
      return put.apply(this, words);
    };
  });
  const page = await context.newPage();
  await page.goto(site.url);
  await listen(page);
  await page.getByText('The storage of the browser is full.').waitFor();
  await settled(page);
  const { samples, rateHz } = await savedWav(page);
  expect(samples.length / rateHz).toBeGreaterThan(5);
});
