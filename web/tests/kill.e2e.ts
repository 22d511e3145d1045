/** The browser is killed while it records and keeps: what the page said is kept is there afterwards. */
import { mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { BrowserContext, Page } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { launchMortal, PATIENCE_MS } from './harness/browser.ts';
import { Site } from './harness/site.ts';
import { keepAs } from './support/page.ts';
import { drop, hearing } from './support/sounds.ts';

let site: Site;
let played: string;

beforeAll(async () => {
  site = await Site.open();
  played = drop('killed');
});
afterAll(() => site.close());

/** So many frames after the event of this number: a press of a button, or something that the page says. */
interface Moment {
  readonly event: number;
  readonly frames: number;
}

/** From the press of "Keep this drop" to "3 s are saved": the press of "try the demo" is the first of all. */
const EVENTS = { first: 1, count: 6 };
const MAX_FRAMES = 45;

/** The same moments in every run, from a congruential generator. */
function moments(count: number, seed: number): Moment[] {
  let state = seed;
  const below = (end: number): number => {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
    return Math.floor((state / 2 ** 32) * end);
  };
  return Array.from({ length: count }, () => ({
    event: EVENTS.first + below(EVENTS.count),
    frames: below(MAX_FRAMES),
  }));
}

/** What the page said in one life of the browser. */
interface Life {
  readonly beganAt: number;
  kept?: string;
  savedS: number;
}

/** What the browsers of a profile lived through, one after the other; two profiles at a time. */
const histories: Life[][] = [[], []];

/** Tells what the page says, and when the moment has come. */
async function watch(
  context: BrowserContext,
  moment: Moment,
  life: Life,
  die: () => void,
): Promise<void> {
  await context.exposeFunction('said', (words: string) => {
    const [, name] = /“(.*)”/.exec(words) ?? [];
    if (name !== undefined) life.kept = name;
    else life.savedS = Number.parseInt(words, 10);
  });
  await context.exposeFunction('die', die);
  await context.addInitScript(({ event, frames }) => {
    const { said, die: end } = globalThis as unknown as Record<
      'said' | 'die',
      (w?: string) => void
    >;
    let events = 0;
    let last: string | undefined;
    const count = () => {
      if (events === event) wait(frames);
      events += 1;
    };
    const wait = (left: number) => {
      if (left > 0) requestAnimationFrame(() => wait(left - 1));
      else end();
    };
    addEventListener('click', count, true);
    new MutationObserver(() => {
      const main = document.querySelector('main')?.textContent ?? '';
      const words = /Kept as “[^”]+”|\d+ s are saved/.exec(main)?.[0];
      if (words === undefined || words === last) return;
      last = words;
      said(words);
      count();
    }).observe(document, { subtree: true, childList: true, characterData: true });
  }, moment);
}

/** Keeps a drop and listens, until the end. */
async function use(page: Page, name: string): Promise<void> {
  await page.goto(site.url);
  await page.getByRole('button', { name: 'try the demo' }).click();
  await keepAs(page, name);
  await page.getByRole('button', { name: 'Listen again' }).click();
  await page.getByText('9 s are saved').waitFor();
}

interface Stored {
  readonly drops: { name: string; recording: string }[];
  readonly recordings: { id: string; rateHz: number; finished: boolean; startedAt: number }[];
  readonly blocks: { recording: string; index: number; samples: number }[];
}

const database = (page: Page): Promise<Stored> =>
  page.evaluate(
    () =>
      new Promise<Stored>((resolve, reject) => {
        const request = indexedDB.open('bouncelab');
        request.onerror = () => reject(request.error);
        request.onsuccess = () => {
          const names = ['drops', 'recordings', 'blocks'] as const;
          const transaction = request.result.transaction(names);
          const [drops, recordings, blocks] = names.map((name) =>
            transaction.objectStore(name).getAll(),
          ) as [IDBRequest, IDBRequest, IDBRequest];
          transaction.oncomplete = () =>
            resolve({
              drops: drops.result,
              recordings: recordings.result,
              blocks: blocks.result.map((block: { samples: Float32Array }) => ({
                ...block,
                samples: block.samples.length,
              })),
            });
        };
      }),
  );

/** Opens the page again: everything that was said to be kept must be there, whole. */
async function check(page: Page, lives: readonly Life[]): Promise<void> {
  await page.goto(`${site.url}#drops`);
  await page.getByRole('heading', { name: 'Table of drops' }).waitFor();
  for (const { kept } of lives) {
    if (kept !== undefined) await page.getByLabel(`Open ${kept}`, { exact: true }).waitFor();
  }
  const { drops, recordings, blocks } = await database(page);
  const samples = (id: string): number => {
    const own = blocks.filter(({ recording }) => recording === id);
    expect(own.map(({ index }) => index)).toEqual(own.map((_, index) => index));
    return own.reduce((sum, block) => sum + block.samples, 0);
  };
  const lengths = new Set(drops.map(({ recording }) => samples(recording)));
  // It is the same demo every time.
  expect(lengths.size).toBeLessThanOrEqual(1);
  expect([...lengths]).not.toContain(0);
  lives.forEach(({ beganAt, savedS }, index) => {
    const endedAt = lives[index + 1]?.beganAt ?? Number.POSITIVE_INFINITY;
    const listened = recordings.filter(
      ({ finished, startedAt }) => !finished && startedAt >= beganAt && startedAt < endedAt,
    );
    const seconds = listened.map(({ id, rateHz }) => samples(id) / rateHz);
    expect(Math.max(0, ...seconds), `life ${index}`).toBeGreaterThanOrEqual(savedS);
  });
  await page.goto('about:blank');
}

/** One life more in a profile, which begins with a look at what the earlier ones left. */
async function live(profile: string, moment: Moment, lives: Life[]): Promise<void> {
  const browser = await launchMortal(profile);
  let isKilled = false;
  const die = (): void => {
    isKilled = true;
    browser.kill();
  };
  const context = browser.page.context();
  await hearing(played)(context);
  await check(browser.page, lives);
  const life: Life = { beganAt: Date.now(), savedS: 0 };
  lives.push(life);
  await watch(context, moment, life, die);
  await use(browser.page, `drop ${lives.length}`).catch((error: unknown) => {
    if (!isKilled) throw error;
  });
  await browser.death;
}

const KILLS = moments(20, 16);

/** As long as a test may take for each of its kills. */
const PATIENCE_OF_ALL_MS = (KILLS.length / histories.length) * PATIENCE_MS;

test.concurrent.each(histories.map((lives, number) => ({ lives, number })))(
  'killed in profile $number, again and again: everything is there afterwards',
  async ({ lives, number }) => {
    const profile = mkdtempSync(join(tmpdir(), 'profile-'));
    const own = KILLS.filter((_, index) => index % histories.length === number);
    for (const moment of own) {
      await live(profile, moment, lives).catch((reason: unknown) => {
        const { frames, event } = moment;
        throw new Error(`killed ${frames} frames after event ${event}`, { cause: reason });
      });
    }
    const browser = await launchMortal(profile);
    await check(browser.page, lives);
    browser.kill();
    await browser.death;
  },
  PATIENCE_OF_ALL_MS,
);

test('something was said to be kept before the kills', () => {
  const lives = histories.flat();
  expect(lives.length).toBe(KILLS.length);
  expect(lives.filter(({ kept }) => kept !== undefined).length).toBeGreaterThan(5);
  expect(lives.filter(({ savedS }) => savedS > 0).length).toBeGreaterThan(5);
});
