import type { ChartSpec, Layer } from '../chart/spec.ts';
import { localised } from '../format/quantity.ts';
import type { DragCurve } from '../lab/index.ts';
import { language } from '../text/language.ts';
import type { Texts } from '../text/texts.ts';

/** Drag over weight against speed, by the law of the settings and by a constant coefficient. */
export function dragChart(
  curves: readonly DragCurve[],
  fastestMS: number | null,
  log: boolean,
  texts: Texts,
): ChartSpec | undefined {
  const words = texts.figures.drag;
  if (curves.length === 0) return undefined;
  return {
    x: { label: words.x, log, fromZero: true },
    y: { label: words.y, log, fromZero: true },
    layers: curves.map((curve): Layer => {
      const points = curve.speed_m_s
        .map((speed, i) => [speed, 100 * (curve.drag_over_weight[i] as number)] as const)
        .filter(([speed, drag]) => !log || (speed > 0 && drag > 0));
      return {
        kind: 'line',
        meaning: curve.chosen ? 'drag' : 'plain',
        label: lawName(curve.law, texts),
        dashed: !curve.chosen,
        x: points.map(([speed]) => speed),
        y: points.map(([, drag]) => drag),
      };
    }),
    levels:
      fastestMS === null
        ? []
        : [{ at: fastestMS, label: words.fastest, meaning: 'measured', upright: true }],
  };
}

/** A drag law for people: the name of its authors, or the constant. */
export function lawName(law: string, texts: Texts): string {
  if (law === 'none') return texts.settings.dragNone;
  const constant = /^constant[: ]*(.*)$/.exec(law);
  if (constant) return `C_D = ${localised(constant[1] ?? '', language.peek())}`;
  return law
    .split('-')
    .map((part) => part.charAt(0).toUpperCase() + part.slice(1))
    .join('–');
}
