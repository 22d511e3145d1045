import type { ChartSpec } from '../chart/spec.ts';
import type { DocumentDrop } from '../lab/index.ts';
import type { Texts } from '../text/texts.ts';

/** The apex after each bounce: by the flight time alone, which drag hardly touches. */
export function heightsChart(drop: DocumentDrop, texts: Texts): ChartSpec {
  const words = texts.figures;
  const flights = drop.flights;
  return {
    x: { label: words.heights.x, counting: true },
    y: { label: words.heights.y, log: true },
    layers: [
      {
        kind: 'points',
        meaning: 'measured',
        label: '',
        x: flights.map((flight) => flight.number),
        y: flights.map((flight) => 100 * (flight.apex_m ?? flight.plain_height_m)),
        sd: flights.map((flight) => flight.apex_sd_m && 100 * flight.apex_sd_m),
      },
    ],
  };
}
