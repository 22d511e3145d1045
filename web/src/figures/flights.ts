import type { ChartSpec, Layer } from '../chart/spec.ts';
import type { DocumentDrop, StraightLine } from '../lab/index.ts';
import type { Texts } from '../text/texts.ts';

/** Time of a flight by the straight line: log10 T = intercept + slope n. */
const timeByLine = (line: StraightLine, number: number): number =>
  10 ** (line.intercept + line.slope * number);

/** Flight times on a logarithmic scale with the straight line through those it was fitted to. */
export function flightsChart(drop: DocumentDrop, texts: Texts): ChartSpec {
  const words = texts.figures;
  const layers: Layer[] = [];
  const line = drop.regression;
  if (line) {
    const numbers = drop.flights.map((flight) => flight.number);
    layers.push({
      kind: 'line',
      meaning: 'plain',
      label: words.straightLine,
      x: numbers,
      y: numbers.map((number) => timeByLine(line, number)),
    });
  }
  layers.push(...flightPoints(drop, texts, (flight) => flight.time_s));
  return {
    x: { label: words.flights.x, counting: true },
    y: { label: words.flights.y, log: true },
    layers,
  };
}

/** How far each flight lies off the line, in per cent. */
export function residualsChart(drop: DocumentDrop, texts: Texts): ChartSpec | undefined {
  const line = drop.regression;
  if (!line) return undefined;
  const words = texts.figures;
  return {
    x: { label: words.flights.x, counting: true },
    y: { label: words.residuals.y, atLeast: 0.5 },
    layers: flightPoints(
      drop,
      texts,
      (flight) => 100 * (flight.time_s / timeByLine(line, flight.number) - 1),
    ),
    levels: [{ at: 0, label: '', meaning: 'plain' }],
    heightRem: 10,
  };
}

type Flight = DocumentDrop['flights'][number];

function flightPoints(
  drop: DocumentDrop,
  texts: Texts,
  value: (flight: Flight) => number,
): Layer[] {
  const layer = (used: boolean): Layer => {
    const flights = drop.flights.filter((flight) => flight.in_regression === used);
    return {
      kind: 'points',
      meaning: 'measured',
      label: used ? texts.figures.measured : texts.figures.notUsed,
      hollow: !used,
      x: flights.map((flight) => flight.number),
      y: flights.map(value),
    };
  };
  return [layer(true), layer(false)].filter(({ x }) => x.length > 0);
}
