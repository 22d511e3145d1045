/** Tables for spreadsheets of languages that write decimals with a comma. */

/** One field: quoted, or as it is. */
const FIELD = /("(?:[^"]|"")*"|[^",\r\n]*)(,|\r\n|\n|$)/y;
const NUMBER = /^[+-]?\d+\.?\d*(e[+-]?\d+)?$/i;

/** The same table with semicolons between fields, and commas in numbers. */
export function withDecimalCommas(csv: string): string {
  let written = '';
  FIELD.lastIndex = 0;
  while (FIELD.lastIndex < csv.length) {
    const [, field = '', end = ''] = FIELD.exec(csv) ?? [];
    const isNumber = NUMBER.test(field);
    const needsQuotes = !field.startsWith('"') && field.includes(';');
    const text = isNumber ? field.replace('.', ',') : needsQuotes ? `"${field}"` : field;
    written += text + (end === ',' ? ';' : end);
    if (field === '' && end === '') break;
  }
  return written;
}
