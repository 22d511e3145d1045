/**
 * How many digits a number deserves: an uncertainty has one significant digit, or two when it begins
 * with 1 or 2, and the value ends at the same place. The rule of the command line, so that both say
 * the same.
 */

/** What a quantity is shown in: how large one of it is in SI, and its symbol. */
export interface Unit {
  readonly size: number;
  readonly symbol: string;
}

export const PLAIN: Unit = { size: 1, symbol: '' };
export const PERCENT: Unit = { size: 0.01, symbol: '%' };
export const CENTIMETRE: Unit = { size: 0.01, symbol: 'cm' };
export const METRE: Unit = { size: 1, symbol: 'm' };
export const SECOND: Unit = { size: 1, symbol: 's' };
export const MILLISECOND: Unit = { size: 1e-3, symbol: 'ms' };
export const METRE_PER_SECOND: Unit = { size: 1, symbol: 'm/s' };

/** Narrow no-break space: between a number and its unit. */
const THIN = '\u202f';

/** Decimals that an uncertainty deserves; negative when it is larger than ten. */
export function decimalsFor(uncertainty: number): number {
  if (!(uncertainty > 0) || !Number.isFinite(uncertainty)) return 4;
  const exponent = Math.floor(Math.log10(uncertainty));
  const leading = Math.round((uncertainty / 10 ** exponent) * 100) / 100;
  const digits = leading < 3 ? 2 : 1;
  return Math.min(12, digits - 1 - exponent);
}

/** A number with fixed decimals in the manner of a language. */
export function fixed(value: number, decimals: number, language: string): string {
  const places = Math.max(0, decimals);
  const scale = decimals < 0 ? 10 ** -decimals : 1;
  const rounded = Math.round(value / scale) * scale;
  return new Intl.NumberFormat(language, {
    minimumFractionDigits: places,
    maximumFractionDigits: places,
    useGrouping: false,
  })
    .format(decimals < 0 ? rounded : value)
    .replace('-', '\u2212');
}

/** Numbers that are written with a point already, in the manner of a language; 1.2.3 is none. */
export function localised(written: string, language: string): string {
  const point = (1.5).toLocaleString(language).charAt(1);
  return written.replace(/\d+(?:\.\d+)+/g, (number) =>
    number.split('.').length === 2 ? number.replace('.', point) : number,
  );
}

/** A share of one in per cent. */
export const perCent = (share: number, language: string): string =>
  withUnit(fixed(100 * share, 0, language), PERCENT);

/** A value without an uncertainty, in so many significant digits; zero has none. */
export function plain(value: number, unit: Unit, digits: number, language: string): string {
  const shown = value / unit.size;
  const decimals = shown === 0 ? 0 : digits - 1 - Math.floor(Math.log10(Math.abs(shown)));
  return withUnit(fixed(shown, Math.max(0, decimals), language), unit);
}

/** A value with its uncertainty and unit, as in "94.6 ± 0.2 %". */
export function uncertain(
  value: number,
  sd: number | null | undefined,
  unit: Unit,
  language: string,
): string {
  if (sd === null || sd === undefined || !(sd > 0) || !Number.isFinite(sd)) {
    return plain(value, unit, 3, language);
  }
  const decimals = decimalsFor(sd / unit.size);
  const shown = fixed(value / unit.size, decimals, language);
  return withUnit(`${shown} ± ${fixed(sd / unit.size, decimals, language)}`, unit);
}

/** A range, as in "46.0 to 49.3 cm", with the digits that the uncertainty deserves. */
export function between(
  interval: readonly [number, number],
  sd: number,
  unit: Unit,
  word: string,
  language: string,
): string {
  const decimals = decimalsFor(sd / unit.size);
  const ends = interval.map((end) => fixed(end / unit.size, decimals, language));
  return withUnit(ends.join(` ${word} `), unit);
}

function withUnit(number: string, unit: Unit): string {
  return unit.symbol === '' ? number : `${number}${THIN}${unit.symbol}`;
}

/** Centimetres for what fits on a table, metres for what does not. */
export function lengthUnit(metres: number): Unit {
  return Math.abs(metres) < 1 ? CENTIMETRE : METRE;
}
