/**
 * Numbers in as many digits as they deserve, for what only the page computes or keeps; the engine sends its
 * results as text. The rule is that of `bouncelab_report::quantity`, and `tests/quantity.json` of that crate holds
 * both to the same texts: an uncertainty has one significant digit, or two when it begins with 1 or 2, the value
 * ends at the same place, and the unit is the largest that is not larger than the quantity.
 */

/** The units that a quantity is shown in: the size of each in SI and its symbol, the smallest first. */
export type Unit = readonly (readonly [size: number, symbol: string])[];

export const NUMBER: Unit = [[1, '']];
export const PERCENT: Unit = [[0.01, '%']];
export const LENGTH: Unit = [
  [1e-6, 'µm'],
  [1e-3, 'mm'],
  [1e-2, 'cm'],
  [1, 'm'],
];
export const TIME: Unit = [
  [1e-6, 'µs'],
  [1e-3, 'ms'],
  [1, 's'],
];
export const SPEED: Unit = [[1, 'm/s']];

/** Digits beyond which a number says nothing. */
const MAX_DIGITS = 12;

/** A text that no line break divides. */
export const unbroken = (text: string): string => text.replaceAll(' ', '\u00a0');

/** An estimate: with its standard uncertainty, as in "94.6 ± 0.2 %", or with four digits if it has none. */
export function estimated(
  value: number,
  sd: number | null | undefined,
  unit: Unit,
  language: string,
): string {
  if (sd === null || sd === undefined || !Number.isFinite(sd) || sd === 0) {
    return rounded(value, 4, unit, language);
  }
  const [size, symbol] = stepFor(unit, Math.max(Math.abs(value), sd));
  return withUnit(withError(value / size, sd / size), symbol, language);
}

/** A value with a given number of significant digits. */
export function rounded(value: number, digits: number, unit: Unit, language: string): string {
  const [size, symbol] = stepFor(unit, Math.abs(value));
  return withUnit(withDigits(value / size, digits), symbol, language);
}

/** A number with fixed decimals. */
export const fixed = (value: number, decimals: number, language: string): string =>
  localised(withMinus(withDecimals(value, decimals)), language);

/** A share of one in per cent. */
export const perCent = (share: number, language: string): string =>
  withUnit(withMinus(withDecimals(100 * share, 0)), '%', language);

/** Numbers written with a decimal point, in the form of a language; 1.2.3 is no number. */
export function localised(written: string, language: string): string {
  const point = (1.5).toLocaleString(language).charAt(1);
  return written.replace(/\d+(?:\.\d+)+/g, (number) =>
    number.split('.').length === 2 ? number.replace('.', point) : number,
  );
}

function withUnit(number: string, symbol: string, language: string): string {
  return unbroken(`${localised(number, language)} ${symbol}`.trimEnd());
}

/** The largest unit that is not larger than the quantity; zero is in SI. */
function stepFor(unit: Unit, size: number): readonly [number, string] {
  const fitting = unit.findLast(([step]) => size >= step);
  return fitting ?? unit.at(size > 0 ? 0 : -1) ?? [1, ''];
}

function withError(value: number, error: number): string {
  if (!isVisible(error, value)) return withDigits(value, MAX_DIGITS, true);
  const place = errorPlace(error);
  const power = leadingPlace(Math.max(Math.abs(value), error));
  if (isPlain(power)) return `${atPlace(value, place)} ± ${atPlace(error, place)}`;
  const [a, b] = [value, error].map((number) => atPlace(shifted(number, power), place - power));
  return `(${a} ± ${b})×10${superscript(power)}`;
}

/** The value with significant digits; if it is `exact`, without zeros at its end. */
function withDigits(value: number, digits: number, exact = false): string {
  const [mantissa, power] = split(value.toExponential(digits - 1));
  const shown = exact ? String(Number(mantissa)) : mantissa;
  if (!isPlain(power)) return `${withMinus(shown)}×10${superscript(power)}`;
  return exact
    ? withMinus(String(Number(value.toPrecision(digits))))
    : atPlace(value, power + 1 - digits);
}

/** Whether an error reaches the digits of the value that mean something. */
const isVisible = (error: number, value: number): boolean =>
  value === 0 || errorPlace(error) > leadingPlace(value) - MAX_DIGITS;

/** The decimal place, a power of ten, to which an error above zero is rounded. */
function errorPlace(error: number): number {
  const [mantissa, power] = split(error.toExponential());
  return /^[12]/.test(mantissa) ? power - 1 : power;
}

/** The power of ten of the first significant digit; 0 for zero. */
const leadingPlace = (value: number): number => split(value.toExponential())[1];

/** Whether a number whose first digit is at this power of ten is written out. */
const isPlain = (power: number): boolean => power >= -5 && power <= 8;

/** The value divided by a power of ten. */
function shifted(value: number, power: number): number {
  const [mantissa, own] = split(value.toExponential());
  return Number(`${mantissa}e${own - power}`);
}

/** "-1.5e-7" in two. */
function split(scientific: string): [string, number] {
  const [mantissa = '', power = '0'] = scientific.split('e');
  return [mantissa, Number(power)];
}

/** The value with digits down to a decimal place. */
function atPlace(value: number, place: number): string {
  if (place < 0) return withMinus(withDecimals(value, -place));
  const unit = 10 ** place;
  const steps = Math.sign(value) * Math.round(Math.abs(value) / unit);
  return withMinus(withDecimals(steps * unit, 0));
}

/** As `toFixed`, but what lies exactly between two numbers goes to the even one, as in Rust. */
function withDecimals(value: number, decimals: number): string {
  const longer = value.toFixed(Math.min(100, decimals + 30));
  const end = longer.length - 30;
  const isBetween = /^50*$/.test(longer.slice(end));
  const isEven = /[02468]\.?$/.test(longer.slice(0, end));
  return isBetween && isEven ? longer.slice(0, end).replace(/\.$/, '') : value.toFixed(decimals);
}

/** With a true minus sign, and none before zero. */
const withMinus = (number: string): string =>
  number.replace('-', /^-[0.]*$/.test(number) ? '' : '\u2212');

const superscript = (power: number): string =>
  String(power).replace(/./g, (sign) => (sign === '-' ? '⁻' : ('⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(sign)] ?? '')));

/** In degrees Celsius. */
export const ABSOLUTE_ZERO_C = -273.15;

/** A number in another unit, if there is one: of what is not stated the engine writes `null`. */
export const scaled = (
  value: number | null | undefined,
  factor: number,
  offset = 0,
): number | undefined =>
  value === undefined || value === null ? undefined : value * factor + offset;
