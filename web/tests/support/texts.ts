/** Where the texts of charts and buttons are: whether they can be read. */
import type { BrowserContext, Page } from 'playwright-core';

/** A text in its drawing, whose size is in the same unit. */
export interface Text {
  readonly words: string;
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

export interface Drawing {
  readonly title: string;
  readonly width: number;
  readonly height: number;
  readonly texts: readonly Text[];
}

/** Texts that leave their drawing, are shortened, or lie over each other by more than the air around letters. */
export function troublesOf({ title, width, height, texts }: Drawing): string[] {
  const leaves = (t: Text) => t.left < 0 || t.top < 0 || t.right > width || t.bottom > height;
  const over = (a: Text, b: Text) =>
    Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 &&
    Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 5;
  const covered = texts.flatMap((a, index) =>
    texts
      .slice(index + 1)
      .filter((b) => over(a, b))
      .map((b) => `${a.words} / ${b.words} overlap`),
  );
  const outside = texts.filter(leaves).map(({ words }) => `${words} is cut off`);
  const shortened = texts.filter(({ words }) => words.includes('…'));
  return [...outside, ...covered, ...shortened.map(({ words }) => `${words} is shortened`)].map(
    (trouble) => `${title}: ${trouble}`,
  );
}

/** The drawings of a report, as they are on the screen. */
export const drawings = (page: Page): Promise<Drawing[]> =>
  page.locator('svg[role=img]').evaluateAll((found) =>
    (found as SVGSVGElement[]).map((drawing) => ({
      title: drawing.querySelector('title')?.textContent ?? '',
      width: drawing.viewBox.baseVal.width,
      height: drawing.viewBox.baseVal.height,
      texts: [...drawing.querySelectorAll('text')].map((text) => {
        const { x, y, width, height } = text.getBBox();
        const words = text.textContent ?? '';
        return { words, left: x, top: y, right: x + width, bottom: y + height };
      }),
    })),
  );

type Watched = HTMLCanvasElement & { texts?: Text[] };

/** Prepares a browser to remember what is written on canvases. */
export async function rememberTexts(context: BrowserContext): Promise<void> {
  await context.addInitScript(() => {
    const drawing = CanvasRenderingContext2D.prototype;
    const { fillText, clearRect } = drawing;
    drawing.clearRect = function clear(...area) {
      (this.canvas as Watched).texts = [];
      clearRect.apply(this, area);
    };
    drawing.fillText = function write(words, x, y, ...most) {
      const size = this.measureText(words);
      const [left, right] = [x - size.actualBoundingBoxLeft, x + size.actualBoundingBoxRight];
      const [top, bottom] = [y - size.actualBoundingBoxAscent, y + size.actualBoundingBoxDescent];
      const seen = this.getTransform();
      const corners = [left, right].flatMap((across) =>
        [top, bottom].map((down) => seen.transformPoint({ x: across, y: down })),
      );
      const [xs, ys] = [corners.map((corner) => corner.x), corners.map((corner) => corner.y)];
      const canvas = this.canvas as Watched;
      canvas.texts ??= [];
      canvas.texts.push({
        words,
        left: Math.min(...xs),
        top: Math.min(...ys),
        right: Math.max(...xs),
        bottom: Math.max(...ys),
      });
      fillText.call(this, words, x, y, ...most);
    };
  });
}

/** The charts of a page, in a browser that remembers texts. */
export const charts = (page: Page): Promise<Drawing[]> =>
  page.locator('.uplot canvas').evaluateAll((found) =>
    (found as Watched[]).map((canvas) => ({
      title: canvas.closest('[aria-label]')?.getAttribute('aria-label') ?? '',
      width: canvas.width,
      height: canvas.height,
      texts: (canvas.texts ?? []).filter(({ words }) => words.trim() !== ''),
    })),
  );

/** What can be pressed and does not hold its text, or is out of reach. */
export const crampedButtons = (page: Page): Promise<string[]> =>
  page.locator('button:visible, a:visible, summary:visible').evaluateAll((found) =>
    found.flatMap((button) => {
      const box = button.getBoundingClientRect();
      const range = document.createRange();
      range.selectNodeContents(button);
      const sticksOut = [...range.getClientRects()].some(
        ({ left, top, right, bottom }) =>
          left < box.left - 1 ||
          right > box.right + 1 ||
          top < box.top - 1 ||
          bottom > box.bottom + 1,
      );
      const scrolls = (element: Element | null): boolean =>
        element !== null &&
        (/auto|scroll/.test(getComputedStyle(element).overflowX) || scrolls(element.parentElement));
      const hidden = box.right > innerWidth + 1 && !scrolls(button.parentElement);
      return sticksOut || hidden ? [`${button.textContent} does not fit`] : [];
    }),
  );
