/** From the start to the table of drops, by the keyboard alone and as a screen reader says it. */
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { fixture } from './harness/fixture.ts';
import { dropFile, follow, keepAs, open, settled, tryDemo } from './support/page.ts';
import { announced, announcing, focused, hiddenFocus } from './support/reader.ts';

const here = fixture();

/** Nothing that can be reached is further away than this. */
const MAX_STEPS = 80;

/** Presses a key, after which this has the keyboard, and is seen. */
async function press(page: Page, key: string, expected: string): Promise<void> {
  await page.keyboard.press(key);
  await expect.poll(() => focused(page), { message: `after ${key}` }).toBe(expected);
  await isSeen(page, expected);
}

/** What has the keyboard is seen, once the page has come to rest. */
async function isSeen(page: Page, focus: string): Promise<void> {
  await expect.poll(() => hiddenFocus(page), { message: focus }).toEqual([]);
}

/** Goes on to this with the tab key; whatever has the keyboard on the way is seen, and has a name. */
async function tabTo(page: Page, expected: string): Promise<void> {
  const passed: string[] = [];
  while (passed.at(-1) !== expected) {
    expect(passed.length, `${expected} was not found: ${passed}`).toBeLessThan(MAX_STEPS);
    await page.keyboard.press('Tab');
    const now = await focused(page);
    expect(now, `after ${passed.at(-1)}`).toMatch(/^\w+ ".+"$/);
    await isSeen(page, now);
    passed.push(now);
  }
}

/** Waits for the figure of this tab: what saves it comes with it. */
const drawn = (page: Page, tab: string): Promise<void> =>
  page.getByRole('tabpanel', { name: tab }).getByRole('img').first().waitFor();

test.for([
  ['desktop', { width: 1280, height: 900 }],
  ['phone', { width: 390, height: 700 }],
] as const)(
  'the keyboard alone leads from the start to the table of drops, on a %s',
  async ([, viewport]) => {
    const { page, troubles } = await open(here.browser, here.url, { viewport });
    await press(page, 'Tab', 'button "Skip to the content"');
    await page.keyboard.press('Enter');
    await press(page, 'Tab', 'button "Listen"');
    await press(page, 'Tab', 'radio "not stated"');
    await press(page, 'ArrowRight', 'radio "table tennis 40+"');
    await press(page, 'ArrowRight', 'radio "tennis"');
    await expect.poll(() => page.url()).toContain('ball=tennis');
    await press(page, 'ArrowRight', 'radio "rubber ball"');
    await tabTo(page, 'textbox "Diameter"');
    await tabTo(page, 'button "try the demo"');

    await page.keyboard.press('Enter');
    await settled(page);
    // What was pressed went away for a while.
    await expect.poll(() => focused(page)).toBe('button "Listen again"');
    await page.getByRole('radio', { name: 'table tennis 40+', checked: true }).waitFor();

    for (const fold of [
      'With and without air',
      'What this recording determines, and what not',
      'All numbers',
    ]) {
      const details = page.locator('details', { has: page.getByText(fold, { exact: true }) });
      await tabTo(page, `summary "${fold}"`);
      expect(await details.getAttribute('open'), fold).toBeNull();
      await page.keyboard.press('Enter');
      await expect.poll(() => details.getAttribute('open'), { message: fold }).not.toBeNull();
    }

    await tabTo(page, 'tab "Restitution"');
    await press(page, 'ArrowRight', 'tab "Height"');
    await drawn(page, 'Height');
    await press(page, 'ArrowLeft', 'tab "Restitution"');
    await press(page, 'ArrowLeft', 'tab "With and without air"');
    await drawn(page, 'With and without air');
    // A term explains itself.
    await tabTo(page, 'button "With and without air"');
    await page.keyboard.press('Enter');
    await page.getByText('A flight is the time from one impact to the next.').waitFor();
    await page.keyboard.press('Escape');
    await page.getByText('A flight is the time from').waitFor({ state: 'hidden' });
    await expect.poll(() => focused(page)).toBe('button "With and without air"');
    await tabTo(page, 'button "SVG"');

    await tabTo(page, 'textbox "Name"');
    await page.keyboard.type('Anna');
    await press(page, 'Tab', 'button "Keep this drop"');
    await page.keyboard.press('Enter');
    await page.getByText('Kept as “Anna”.').waitFor();
    await expect.poll(() => focused(page)).toBe('button "Keep this drop"');
    await press(page, 'Tab', 'link "Table of drops"');
    await page.keyboard.press('Enter');
    await page.getByRole('heading', { name: 'Table of drops' }).waitFor();
    await tabTo(page, 'button "Open Anna"');
    expect(troubles).toEqual([]);
    await page.context().close();
  },
);

/** What can be pressed, typed into or looked at, and has no name. */
const nameless = (snapshot: string): string[] =>
  snapshot.match(
    /^ *- (button|link|checkbox|radio|textbox|combobox|slider|tab|img)\b(?! ["/]).*$/gm,
  ) ?? [];

test('a screen reader finds its way at the start by roles and names', async () => {
  const { page } = await open(here.browser, here.url);
  await page.getByRole('radio').last().waitFor();
  const outline = await page.locator('body').ariaSnapshot();
  expect(nameless(outline)).toEqual([]);
  for (const said of [
    'banner',
    'navigation "Pages"',
    'combobox "Language"',
    'main',
    'heading "Drop a ball near your microphone." [level=1]',
    'button "Listen"',
    'group "Which ball?"',
    'radio "not stated" [checked]',
    'radio "table tennis 40+"',
    'radio "tennis"',
    'button "try the demo"',
    'contentinfo',
  ]) {
    expect(outline).toContain(`- ${said}`);
  }
  await page.context().close();
});

test('a screen reader reads the result, and is told of what changes', async () => {
  const { page } = await open(here.browser, here.url, {}, announcing);
  const outline = (role: 'main' | 'region' | 'tabpanel', name?: string): Promise<string> =>
    page.getByRole(role, name === undefined ? {} : { name }).ariaSnapshot();
  const told = async (what: RegExp): Promise<number> =>
    (await announced(page)).filter((words) => what.test(words)).length;

  await tryDemo(page);
  await expect.poll(() => told(/keeps [\d.]+.±.[\d.]+.% of its speed/)).toBe(1);
  expect(await told(/It fell from [\d.]+.±.[\d.]+.cm/)).toBe(1);

  await page.locator('#figure .uplot').first().waitFor();
  const main = await outline('main');
  expect(nameless(main)).toEqual([]);
  for (const said of ['region "Waveform"', 'group "Which ball?"', 'region "Known quantities"']) {
    expect(main).toContain(`- ${said}`);
  }
  expect(await outline('region', 'Result')).toMatch(/keeps.*±.*It fell from.*±/s);
  expect(await outline('region', 'Figures')).toMatch(
    /tablist "Figures".*tab "Restitution" \[selected\]/s,
  );
  // A figure has a sentence, and each of its panels a name.
  expect(await outline('tabpanel', 'Restitution')).toMatch(
    /figure "Restitution is .*img "restitution: /s,
  );
  expect(await outline('region', 'Keep')).toMatch(/textbox "Name".*button "Keep this drop"/s);

  await keepAs(page, 'Anna');
  expect(await told(/^Kept as “Anna”\./)).toBe(1);
  await dropFile(page, 'letter.wav', Buffer.from('Dear all, this is no sound.'));
  await expect.poll(() => told(/^letter\.wav: This is neither a recording nor/)).toBe(1);
  await follow(page, 'Drops');
  await page.getByRole('button', { name: 'Delete Anna' }).click();
  await expect.poll(() => told(/^“Anna” was deleted\./)).toBe(1);
  await page.context().close();
});
