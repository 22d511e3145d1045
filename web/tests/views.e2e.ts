/** Every view: reachable, readable by everyone, in two languages, on any screen. */
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { launch } from './harness/browser.ts';
import { FONT_SETS, type FontSet, nameOf } from './harness/fonts.ts';
import { Site } from './harness/site.ts';
import { type Looked, overflow, violations } from './support/layout.ts';
import { open, settled, still, tabsOfAll } from './support/page.ts';
import { picture } from './support/pictures.ts';
import { charts, crampedButtons, rememberTexts, troublesOf } from './support/texts.ts';

let site: Site;
let browser: Browser;

beforeAll(async () => {
  site = await Site.open();
});
afterAll(() => site.close());

/** The tests of a block have a browser of their own. */
function browse(fonts?: FontSet): void {
  beforeAll(async () => {
    browser = await launch({ fonts });
  });
  afterAll(() => browser.close());
}

async function demo(page: Page): Promise<void> {
  await page.goto(`${site.url}#lab`);
  await page.locator('.links button').nth(2).click();
  await settled(page);
}

/** A simulation beside another one. */
async function simulate(page: Page): Promise<void> {
  await page.goto(`${site.url}#simulate`);
  await page.locator('.uplot').first().waitFor();
  await page.locator('.button.primary').click();
  await page.getByRole('slider').nth(1).fill('0.9');
}

/** The paper with all its chapters. */
async function openPaper(page: Page): Promise<void> {
  await page.goto(`${site.url}#paper`);
  await page.locator('.article caption').waitFor();
  for (const chapter of await page.locator('.article summary').all()) await chapter.click();
}

async function unfoldAll(page: Page): Promise<void> {
  for (const fold of await page.locator('main summary').all()) await fold.click();
}

/** Keeps the drop in the workspace three times, and goes to the table. */
async function keepThree(page: Page): Promise<void> {
  for (const drop of ['Anna', 'Ben', 'Chris']) {
    await page.locator('.keep form input').fill(drop);
    await page.locator('.keep form button').click();
    await page.locator('.keep [role=status]', { hasText: drop }).waitFor();
  }
  await page.goto(`${site.url}#drops`);
  await page.locator('table.wide tbody tr').nth(2).waitFor();
}

/** Notes other surfaces of the drops in the table, so that there are two groups. */
async function group(page: Page): Promise<void> {
  for (const [place, surface] of ['stone', 'wood', 'wood'].entries()) {
    const row = page.locator('table.wide tbody tr').nth(place);
    const input = row.locator('input.noted').first();
    // Typed, because Firefox takes the Enter as a change only of what was typed.
    await input.pressSequentially(surface);
    await input.press('Enter');
  }
  const groups = page.locator('.groups[aria-busy=false]');
  for (const surface of ['stone', 'wood']) {
    await groups.locator('p', { hasText: surface }).first().waitFor();
  }
}

/** Nothing is wider than the screen. */
async function fits(page: Page, name: string): Promise<void> {
  await still(page);
  await picture(page, name);
  expect(await overflow(page), `${name} is wider than the screen`).toBeLessThanOrEqual(0);
}

/** The same, and everyone can read it. */
async function look(page: Page, name: string, looked?: Looked): Promise<void> {
  await fits(page, name);
  expect(await violations(page, looked), name).toEqual([]);
}

const SCREENS = [
  { screen: 'phone', width: 360, height: 740 },
  { screen: 'desktop', width: 1440, height: 900 },
  { screen: '4k', width: 3840, height: 2160 },
] as const;
type Screen = (typeof SCREENS)[number];

const [, DESKTOP] = SCREENS;

const READERS = [
  ['light', 'en-GB'],
  ['dark', 'de-DE'],
] as const;

/** Each reader uses the page on another screen, and looks at it on all. */
const USES = FONT_SETS.flatMap((fonts) => READERS.map((reader) => ({ fonts, reader }))).map(
  ({ fonts, reader: [colorScheme, locale] }, index) => {
    const used = SCREENS[index % SCREENS.length] as Screen;
    return { set: nameOf(fonts), fonts, used, screen: used.screen, colorScheme, locale };
  },
);

/** As long as a test may take that sees all there is; tests wait for states, so this is only for what hangs. */
const MAX_TOUR_MS = 900_000;

describe.each(USES)(
  'on a $screen, $colorScheme, $locale, with $set',
  ({ set, fonts, used, colorScheme, locale }) => {
    browse(fonts);

    test(
      'every view can be read by everyone on every screen',
      async () => {
        const options = { viewport: used, colorScheme, locale, reducedMotion: 'reduce' } as const;
        const { page, troubles } = await open(browser, site.url, options);
        // Another set of fonts has letters of other sizes, and nothing else.
        const rules = fonts === FONT_SETS[0] ? 'all' : 'of size';

        /** On a 4K screen the page is what it is on a desktop, only larger. */
        async function lookOn(on: Screen, view: string, part?: string): Promise<void> {
          await page.setViewportSize(on);
          const name = `${on.screen}-${colorScheme}-${set}-${view}`;
          await (on.screen === '4k' ? fits(page, name) : look(page, name, { part, rules }));
        }
        async function lookOnAll(view: string): Promise<void> {
          const others = SCREENS.filter((screen) => screen !== used);
          for (const screen of [used, ...others]) await lookOn(screen, view);
          await page.setViewportSize(used);
        }

        await lookOnAll('welcome');
        await simulate(page);
        await lookOnAll('simulate');
        await openPaper(page);
        await lookOnAll('paper');
        await demo(page);
        await lookOnAll('lab');
        await unfoldAll(page);
        await lookOnAll('lab-unfolded');
        // The figures differ less from screen to screen than they take to look at.
        await page.setViewportSize(DESKTOP);
        for (const tab of await tabsOfAll(page)) {
          await tab.click();
          await lookOn(DESKTOP, `figure-${await tab.getAttribute('id')}`, '[role=tabpanel]');
        }
        await page.setViewportSize(used);
        await keepThree(page);
        await lookOnAll('drops');
        expect(troubles).toEqual([]);
        await page.context().close();
      },
      MAX_TOUR_MS,
    );
  },
);

/** What eases seeing: the colours of the system, and a screen of 1280 by 1024 at 200 %. */
const AIDS = [
  {
    aid: 'contrast-light',
    forcedColors: 'active',
    colorScheme: 'light',
    viewport: { width: 1440, height: 900 },
  },
  {
    aid: 'contrast-dark',
    forcedColors: 'active',
    colorScheme: 'dark',
    viewport: { width: 360, height: 740 },
  },
  { aid: 'zoom', viewport: { width: 640, height: 512 }, deviceScaleFactor: 2, locale: 'de-DE' },
] as const;

/** Another ball than the first, whose choice is seen without the keyboard or the mouse on it. */
async function chooseAnother(page: Page): Promise<void> {
  const row = page.locator('.balls');
  const before = await row.screenshot();
  await page.evaluate(() => localStorage.setItem('bouncelab.set-up', 'ball=football'));
  await page.reload();
  await row.locator(':checked + .football').waitFor();
  await still(page);
  expect((await row.screenshot()).equals(before), 'the choice is not seen').toBe(false);
}

describe('whatever the fonts', () => {
  browse();

  test.concurrent.each(AIDS)('with the aid of $aid', async ({ aid, ...options }) => {
    const usual = { reducedMotion: 'reduce' } as const;
    const { page } = await open(browser, site.url, { ...usual, ...options }, rememberTexts);
    const lookAt = async (view: string, part?: string): Promise<void> => {
      await look(page, `${aid}-${view}`, { part });
      const cramped = await crampedButtons(page);
      expect([...(await charts(page)).flatMap(troublesOf), ...cramped], view).toEqual([]);
    };
    await lookAt('welcome');
    await chooseAnother(page);
    await simulate(page);
    await lookAt('simulate');
    await openPaper(page);
    await lookAt('paper');
    await demo(page);
    await unfoldAll(page);
    await lookAt('lab');
    for (const tab of await tabsOfAll(page)) {
      await tab.click();
      await lookAt(`figure-${await tab.getAttribute('id')}`, '[role=tabpanel]');
    }
    await keepThree(page);
    await group(page);
    await lookAt('drops');
    await page.context().close();
  });

  test('where the system states the colours, the page has no theme of its own', async () => {
    const options = { forcedColors: 'active', colorScheme: 'dark' } as const;
    const { page } = await open(browser, site.url, options, async (context) => {
      await context.addInitScript(() => localStorage.setItem('bouncelab.theme', 'light'));
    });
    expect(await page.locator('[data-theme]').count()).toBe(0);
    expect(await page.getByRole('button', { name: /^(Light|Dark)$/ }).count()).toBe(0);
    await page.context().close();
  });
});
