/** What a chart shows, free of any chart library. */
import type { Meaning } from '../style/colours.ts';

export interface Axis {
  readonly label: string;
  readonly log?: boolean;
  /** Whole numbers only, as of bounces. */
  readonly counting?: boolean;
  /** Smallest span that is shown, so that noise does not fill the picture. */
  readonly atLeast?: number;
  /** Begins at zero. */
  readonly fromZero?: boolean;
}

interface Named {
  readonly meaning: Meaning;
  /** Written beside the layer, and in the table of its numbers. */
  readonly label: string;
  readonly x: readonly number[];
}

/** A curve; `null` interrupts it. */
export interface Line extends Named {
  readonly kind: 'line';
  readonly y: readonly (number | null)[];
  readonly dashed?: boolean;
  readonly thin?: boolean;
}

/** Single points, with bars of one standard error where they are known. */
export interface Points extends Named {
  readonly kind: 'points';
  readonly y: readonly (number | null)[];
  readonly sd?: readonly (number | null)[] | undefined;
  readonly hollow?: boolean;
}

/** A region of uncertainty between two curves. */
export interface Band extends Named {
  readonly kind: 'band';
  readonly low: readonly number[];
  readonly high: readonly number[];
}

/** Bars from zero, or from the top of another layer. */
export interface Bars extends Named {
  readonly kind: 'bars';
  readonly y: readonly number[];
  readonly from?: readonly number[];
}

export type Layer = Line | Points | Band | Bars;

export interface ChartSpec {
  readonly x: Axis;
  readonly y: Axis;
  readonly layers: readonly Layer[];
  /** A level or a place to compare with. */
  readonly levels?: readonly {
    readonly at: number;
    readonly label: string;
    readonly meaning: Meaning;
    readonly upright?: boolean;
  }[];
  /** In units of the width of text. */
  readonly heightRem?: number;
}

/** Names of what is in a chart, each once, for its key. */
export function keyOf(spec: ChartSpec): readonly Layer[] {
  const seen = new Set<string>();
  return spec.layers.filter((layer) => {
    if (layer.label === '' || seen.has(layer.label)) return false;
    seen.add(layer.label);
    return true;
  });
}

/** All values that must be in sight. */
export function yValues(layers: readonly Layer[]): number[] {
  const values: number[] = [];
  for (const layer of layers) {
    switch (layer.kind) {
      case 'band':
        values.push(...layer.low, ...layer.high);
        break;
      case 'points':
        layer.y.forEach((y, i) => {
          const sd = layer.sd?.[i] ?? 0;
          if (y !== null) values.push(y - sd, y + sd);
        });
        break;
      default:
        for (const y of layer.y) if (y !== null) values.push(y);
    }
  }
  return values.filter(Number.isFinite);
}

/** A range with room around it. */
export function padded(values: readonly number[], axis: Axis): [number, number] {
  let low = Math.min(...values);
  let high = Math.max(...values);
  if (!(low <= high)) return axis.log ? [0.1, 1] : [0, 1];
  if (axis.log) {
    const room = Math.max((high / low) ** 0.06, 1.05);
    return [low / room, high * room];
  }
  const lack = (axis.atLeast ?? 0) - (high - low);
  if (lack > 0) {
    low -= lack / 2;
    high += lack / 2;
  }
  const room = 0.07 * (high - low || Math.abs(high) || 1);
  if (axis.fromZero && low >= 0) return [0, high + room];
  return [low - room, high + room];
}
