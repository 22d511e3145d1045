/** A browser that is given a set of fonts writes with these and no others. */
import { expect, test } from 'vitest';
import { launch } from './harness/browser.ts';
import { FONT_SETS } from './harness/fonts.ts';

test.for(FONT_SETS.filter((fonts) => fonts !== undefined))('with $name', async (fonts) => {
  const browser = await launch({ fonts });
  const page = await browser.newPage();
  const client = await page.context().newCDPSession(page);
  await client.send('DOM.enable');
  await client.send('CSS.enable');
  for (const [kind, families] of Object.entries({
    ...fonts.families,
    'system-ui': fonts.families['sans-serif'],
  })) {
    await page.setContent(`<p style="font-family: ${kind}">log Tₙ = ½ h₀ ± 3 µs</p>`);
    const { root } = await client.send('DOM.getDocument');
    const nodes = await client.send('DOM.querySelector', { ...root, selector: 'p' });
    const { fonts: used } = await client.send('CSS.getPlatformFontsForNode', nodes);
    const names = used.toSorted((a, b) => b.glyphCount - a.glyphCount);
    expect(names[0]?.familyName, kind).toBe(families[0]);
    const all = Object.values(fonts.families).flat();
    expect(all, kind).toEqual(expect.arrayContaining(names.map((font) => font.familyName)));
  }
  await browser.close();
});
