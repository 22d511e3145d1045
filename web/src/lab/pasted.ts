/** Impact times as people paste them: from a spreadsheet in any country, a note, a program. */

/** One number, with a point or a comma. */
const NUMBER = /^[+-]?(\d+[.,]?\d*|[.,]\d+)(e[+-]?\d+)?$/i;

/** The same as a list of times of the kind that fits: its name says which. */
export function listOf(text: string): { readonly name: string; readonly text: string } {
  if (/^\s*\[/.test(text)) return { name: 'times.json', text };
  const lines = entriesOf(text.trim());
  const [head = '', ...rest] = lines;
  const isHead = /^[^,;\t\d]+$/.test(head);
  if (rest.every((line) => line === '' || NUMBER.test(line)) && (isHead || NUMBER.test(head))) {
    const times = lines.map((line) => (NUMBER.test(line) ? line.replace(',', '.') : ''));
    return { name: 'times.txt', text: times.join('\n') };
  }
  // With tabs it is a part of a spreadsheet or a label track.
  const isCsv = /[,;]/.test(text) && !text.includes('\t');
  return { name: isCsv ? 'times.csv' : 'times.txt', text };
}

/** Lines; or, if there is only one, what stands in it side by side. */
function entriesOf(text: string): string[] {
  const lines = text.split(/\r?\n/).map((line) => line.trim());
  if (lines.length > 1) return lines;
  // A comma separates values where the decimal sign is a point, or where a space is next to the comma.
  return text.split(text.includes('.') ? /[;,\s]+/ : /,\s+|[;\s]+/);
}
