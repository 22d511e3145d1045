/** On a phone of 390 pixels no words of a chart or a button are cut off, in any language. */
import type { Page } from 'playwright-core';
import { describe, expect, test } from 'vitest';
import { fixture } from './harness/fixture.ts';
import { FONT_SETS, nameOf } from './harness/fonts.ts';
import { overflow, unfold } from './support/layout.ts';
import { open, settled, still, tabsOfAll } from './support/page.ts';
import { picture } from './support/pictures.ts';
import { charts, crampedButtons, rememberTexts, troublesOf } from './support/texts.ts';
import { LANGUAGES, wordsOf } from './support/words.ts';

const PHONE = { width: 390, height: 844 };

describe.each(FONT_SETS.map((fonts) => [nameOf(fonts), fonts] as const))(
  'with %s',
  (set, fonts) => {
    const here = fixture({ fonts });

    test.concurrent.each(LANGUAGES)('in the language %s', async (language) => {
      const words = wordsOf(language);
      const options = { viewport: PHONE, locale: language, reducedMotion: 'reduce' } as const;
      const { page } = await open(here.browser, here.url, options, rememberTexts);
      const troubles: string[] = [];

      /** Looks at the page as it is, and keeps a picture of it. */
      async function look(name: string): Promise<void> {
        await still(page);
        await picture(page, `narrow-${language}-${set}-${name}`);
        if ((await overflow(page)) > 0) troubles.push('the page is wider than the screen');
        const found = [
          ...(await charts(page)).flatMap(troublesOf),
          ...(await crampedButtons(page)),
        ];
        troubles.push(...found.map((trouble) => `${name}: ${trouble}`));
      }

      await look('welcome');
      await page.goto(`${here.url}#simulate`);
      await page.locator('.uplot').first().waitFor();
      await page.locator('.button.primary').click();
      await look('simulate');
      await page.goto(`${here.url}#paper`);
      await page.locator('.article caption').waitFor();
      await unfold(page);
      await look('paper');
      await page.goto(`${here.url}#lab`);
      await page.getByRole('button', { name: words('page-lab-demo') }).click();
      await settled(page);
      await unfold(page);
      for (const tab of await tabsOfAll(page)) {
        await tab.click();
        await page.locator('.uplot').first().waitFor();
        await look(`lab-${await tab.getAttribute('id')}`);
      }
      await keep(page, ['Anna', 'Ben']);
      await page.goto(`${here.url}#drops`);
      await page.locator('tbody tr').nth(1).waitFor();
      await look('drops');
      expect(troubles).toEqual([]);
      await page.context().close();
    });
  },
);

async function keep(page: Page, names: readonly string[]): Promise<void> {
  for (const name of names) {
    await page.locator('.keep form input').fill(name);
    await page.locator('.keep form button').click();
    await page.locator('.keep [role=status]', { hasText: name }).waitFor();
  }
}
