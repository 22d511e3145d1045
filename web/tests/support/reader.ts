/** What those meet who use the page without a mouse or without a screen. */
import type { Page } from 'playwright-core';
import type { Preparation } from '../harness/browser.ts';

/** The role and the name of what has the keyboard, as a screen reader says it, as in `button "Listen"`. */
export async function focused(page: Page): Promise<string> {
  const focus = page.locator(':focus');
  if ((await focus.count()) === 0) return 'nothing';
  // Playwright has no role for the head of a fold, and says of what has no role what is in it.
  const own = await focus.evaluate((element) => {
    const { tagName, innerText } = element as HTMLElement;
    if (tagName === 'SUMMARY') return `summary "${innerText.trim()}"`;
    return element.matches('a, button, input, select, textarea, main, [role], [aria-label]')
      ? null
      : tagName;
  });
  if (own !== null) return own;
  const [, role = '', name = ''] = /^- '?(\w+)( ".*?")?/.exec(await focus.ariaSnapshot()) ?? [];
  return role + name;
}

/** Why a reader does not see what has the keyboard; empty if it is seen. */
export const hiddenFocus = (page: Page): Promise<string[]> =>
  page.evaluate(() => {
    const focused = document.activeElement ?? document.body;
    // What is hidden is drawn by its label.
    const shown = focused.matches('.unseen') ? (focused.closest('label') ?? focused) : focused;
    const { outlineStyle, outlineWidth } = getComputedStyle(shown);
    const hasOutline = outlineStyle !== 'none' && Number.parseFloat(outlineWidth) >= 2;
    const box = shown.getClientRects()[0] ?? shown.getBoundingClientRect();
    const [left, right] = [Math.max(0, box.left), Math.min(innerWidth, box.right)];
    const [top, bottom] = [Math.max(0, box.top), Math.min(innerHeight, box.bottom)];
    const above = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
    const isSeen = above !== null && (shown.contains(above) || above.contains(shown));
    return [
      ...(hasOutline ? [] : ['it has no outline']),
      ...(right > left && bottom > top ? [] : ['it is out of sight']),
      ...(isSeen ? [] : [`it is covered by ${above?.outerHTML.slice(0, 80)}`]),
    ];
  });

type Announced = typeof globalThis & { announced: string[] };

/**
 * Lets the pages of a context remember what a screen reader announces: the text of a live region when it
 * has changed and is not busy, and an alert that appears. Not every screen reader announces another region
 * that appears with its text, so that does not count.
 */
export const announcing: Preparation = async (context) => {
  await context.addInitScript(() => {
    const announced: string[] = [];
    Object.assign(globalThis, { announced });
    const REGION = '[role=status], [role=alert], [aria-live]';
    /** What each region said last. */
    const last = new WeakMap<Element, string>();
    const wordsOf = (region: Element) => (region as HTMLElement).innerText.trim();
    const within = (node: Node): Element[] =>
      node instanceof Element ? [node, ...node.querySelectorAll('*')] : [];
    new MutationObserver((records) => {
      const added = records.flatMap(({ addedNodes }) => [...addedNodes].flatMap(within));
      for (const region of added.filter((element) => element.matches(REGION))) {
        const isAlert = region.matches('[role=alert]');
        if (!last.has(region)) last.set(region, isAlert ? '' : wordsOf(region));
      }
      const changed = [...records.map(({ target }) => target), ...added].map((node) =>
        (node instanceof Element ? node : node.parentElement)?.closest(REGION),
      );
      for (const region of new Set(changed)) {
        if (!region || region.closest('[aria-busy=true]')) continue;
        const words = wordsOf(region);
        if (words !== '' && words !== last.get(region)) announced.push(words);
        last.set(region, words);
      }
    }).observe(document, {
      subtree: true,
      childList: true,
      characterData: true,
      attributes: true,
      attributeFilter: ['aria-busy'],
    });
  });
};

/** What was announced since the page was opened. */
export const announced = (page: Page): Promise<string[]> =>
  page.evaluate(() => (globalThis as Announced).announced);
