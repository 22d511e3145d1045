/** Whether a page fits its window, and whether everyone can use it. */
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { inflateSync } from 'node:zlib';
import type { Page } from 'playwright-core';
import { FIREFOX } from '../harness/firefox.ts';

const AXE = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

interface Axe {
  getRules(tags: string[]): { ruleId: string }[];
  run(
    place: Document | string,
    options: object,
  ): Promise<{
    violations: { id: string; nodes: { html: string; failureSummary: string }[] }[];
  }>;
}

/** The rules of axe whose answer depends on how large letters and boxes are. */
const OF_SIZE = ['target-size', 'scrollable-region-focusable'];

/** What axe looks at. */
export interface Looked {
  /** Only the part of the page that this selector names. */
  readonly part?: string | undefined;
  /** All rules, unless only those of the size of letters and boxes are asked for. */
  readonly rules?: 'all' | 'of size';
}

/**
 * What axe finds wrong by its usual rules, and by those of WCAG 2.2 AA, which are off unless they are named. Of what
 * is right nothing is told, and style sheets are not read again, which no rule that is on asks for: both take time.
 */
export async function violations(
  page: Page,
  { part, rules = 'all' }: Looked = {},
): Promise<string[]> {
  const only = rules === 'all' ? undefined : OF_SIZE;
  if (!(await page.evaluate(() => 'axe' in globalThis))) await page.evaluate(AXE);
  return page.evaluate(
    async ({ part, only }) => {
      const { axe } = globalThis as unknown as { axe: Axe };
      const named = axe.getRules(['wcag22aa']).map(({ ruleId }) => [ruleId, { enabled: true }]);
      const chosen = only ? { runOnly: only } : { rules: Object.fromEntries(named) };
      const options = { ...chosen, resultTypes: ['violations'], preload: false };
      const { violations: found } = await axe.run(part ?? document, options);
      return found.flatMap(({ id, nodes }) =>
        nodes.map(({ html, failureSummary }) => `${id}: ${html.slice(0, 120)} ${failureSummary}`),
      );
    },
    { part, only },
  );
}

/** What axe finds wrong by day and by night. */
export async function violationsInBothThemes(page: Page): Promise<string[]> {
  const found: string[] = [];
  for (const colorScheme of ['dark', 'light'] as const) {
    await page.emulateMedia({ colorScheme });
    found.push(...(await violations(page)).map((words) => `${colorScheme}: ${words}`));
  }
  return found;
}

/** By how many pixels a page is wider than its window: it may scroll down, never sideways. */
export const overflow = (page: Page): Promise<number> =>
  page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);

/** Opens everything that is folded. */
export function unfold(page: Page): Promise<void> {
  return page.locator('details').evaluateAll((folded) => {
    for (const details of folded as HTMLDetailsElement[]) details.open = true;
  });
}

/** The width and height of paper in centimetres. */
const PAPERS_CM = {
  A4: { width: 21, height: 29.7 },
  Letter: { width: 21.59, height: 27.94 },
};

/** The PDF that a page prints to. */
export function printed(page: Page, format: keyof typeof PAPERS_CM): Promise<Buffer> {
  // Playwright hands inches to Firefox, which takes them for the centimetres of WebDriver BiDi.
  const unit = FIREFOX ? 'in' : 'cm';
  const { width, height } = PAPERS_CM[format];
  const size = { width: `${width}${unit}`, height: `${height}${unit}` };
  return page.pdf({ ...size, preferCSSPageSize: false });
}

/** On how many sheets a page prints. */
export async function printedPages(page: Page, format: keyof typeof PAPERS_CM): Promise<number> {
  const pdf = await printed(page, format);
  return plain(pdf.toString('latin1')).match(/\/Type ?\/Page\b/g)?.length ?? 0;
}

/** A PDF and what is in its compressed streams of objects, where some browsers write of the pages. */
function plain(pdf: string): string {
  const streams = [...pdf.matchAll(/\/ObjStm\b.*?stream\r?\n(.*?)endstream/gs)];
  const content = streams.map(([, bytes = '']) => inflateSync(Buffer.from(bytes, 'latin1')));
  return [pdf, ...content.map(String)].join('\n');
}
