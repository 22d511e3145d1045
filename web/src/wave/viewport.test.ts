import { expect, test } from 'vitest';
import {
  clamped,
  framing,
  panned,
  revealing,
  roundStep,
  tickDecimals,
  ticks,
  widthS,
  zoomed,
} from './viewport.ts';

const view = { startS: 2, endS: 4 };

test('zooming keeps the moment under the pointer where it is', () => {
  const closer = zoomed(view, 4, 2.5, 10);
  expect(widthS(closer)).toBeCloseTo(0.5);
  expect((2.5 - closer.startS) / widthS(closer)).toBeCloseTo(0.25);
});

test('no view is wider than the recording, none reaches beyond it', () => {
  expect(zoomed(view, 1e-6, 3, 10)).toEqual({ startS: 0, endS: 10 });
  expect(panned(view, -5, 10)).toEqual({ startS: 0, endS: 2 });
  expect(panned(view, 50, 10)).toEqual({ startS: 8, endS: 10 });
  expect(clamped({ startS: -1, endS: 99 }, 10)).toEqual({ startS: 0, endS: 10 });
});

test('zooming in ends at a few hundred samples', () => {
  expect(widthS(zoomed(view, 1e9, 3, 10))).toBeCloseTo(0.004);
});

test('a visible time moves nothing; one outside becomes visible with a margin', () => {
  expect(revealing(view, 3, 10)).toBe(view);
  const moved = revealing(view, 5, 10);
  expect(moved.startS).toBeLessThan(5);
  expect(moved.endS).toBeGreaterThan(5);
});

test('a drop is framed with margins around it', () => {
  const framed = framing(1, 3, 10);
  expect(framed.startS).toBeLessThan(1);
  expect(framed.endS).toBeGreaterThan(3);
});

test('ticks are round, in sight, and apart', () => {
  expect(ticks({ startS: 0.05, endS: 1 }, 800, 80).map((t) => Number(t.toFixed(6)))).toEqual([
    0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1,
  ]);
  expect(tickDecimals({ startS: 0, endS: 1 }, 800, 80)).toBe(1);
  expect([0.03, 0.2, 7, 100].map(roundStep).map((s) => Number(s.toPrecision(6)))).toEqual([
    0.05, 0.2, 10, 100,
  ]);
});
