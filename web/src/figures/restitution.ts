import type { ChartSpec, Layer } from '../chart/spec.ts';
import type { DocumentDrop } from '../lab/index.ts';
import type { Texts } from '../text/texts.ts';

/** Restitution of each impact against its speed: as if there were no air, and with the air taken out. */
export function restitutionChart(drop: DocumentDrop, texts: Texts): ChartSpec {
  const words = texts.figures;
  const seen = drop.impacts.filter(
    (impact) => impact.restitution !== null && impact.impact_speed_m_s !== null,
  );
  const speeds = seen.map((impact) => impact.impact_speed_m_s as number);
  const band = drop.estimate?.band ?? [];
  const layers: Layer[] = [];
  if (band.length > 0) {
    layers.push({
      kind: 'band',
      meaning: 'measured',
      label: words.line95,
      x: band.map((point) => point.speed_m_s),
      low: band.map((point) => point.restitution.interval95[0]),
      high: band.map((point) => point.restitution.interval95[1]),
    });
  }
  layers.push(
    {
      kind: 'points',
      meaning: 'plain',
      label: words.noAir,
      hollow: true,
      x: speeds,
      y: seen.map((impact) => impact.plain_restitution),
    },
    {
      kind: 'points',
      meaning: 'measured',
      label: words.withAir,
      x: speeds,
      y: seen.map((impact) => impact.restitution),
      sd: seen.map((impact) => impact.restitution_sd),
    },
  );
  return {
    x: { label: words.restitution.x, fromZero: true },
    y: { label: words.restitution.y, atLeast: 0.02 },
    layers,
  };
}
