import { saveText } from '../../app/save.ts';
import { saveCsv } from '../../app/saveCsv.ts';
import { FORMULA_SIGNS } from '../../lab/engine/types.ts';
import { LIST_FORMAT, LIST_VERSION } from '../../store/archive.ts';
import type { KeptDrop } from '../../store/drops.ts';

const COLUMNS = [
  'recording',
  'kept_at',
  'student',
  'ball',
  'surface',
  'restitution',
  'restitution_sd',
  'drop_height_m',
  'drop_height_sd_m',
  'impacts',
] as const;

/** The table for a spreadsheet: SI, one row for each drop. */
export function csvOf(drops: readonly KeptDrop[]): string {
  const rows = drops.map((drop) => [
    quoted(drop.name),
    new Date(drop.keptAt).toISOString(),
    quoted(drop.student),
    quoted(drop.ball),
    quoted(drop.surface),
    drop.restitution?.value ?? '',
    drop.restitution?.sd ?? '',
    drop.dropHeightM?.value ?? '',
    drop.dropHeightM?.sd ?? '',
    drop.marks.impacts.length,
  ]);
  return [COLUMNS, ...rows].map((row) => `${row.join(',')}\r\n`).join('');
}

/** A name may hold commas and quotes, and must not be taken for a formula. */
function quoted(text: string): string {
  const isFormula = FORMULA_SIGNS.some((sign) => text.startsWith(sign));
  const harmless = isFormula ? `'${text}` : text;
  return `"${harmless.replaceAll('"', '""')}"`;
}

export const saveDropsCsv = (drops: readonly KeptDrop[]): void =>
  saveCsv(csvOf(drops), 'bouncelab-drops.csv');

export const saveDropsJson = (drops: readonly KeptDrop[]): void =>
  saveText(
    JSON.stringify({ schema: `${LIST_FORMAT}/${LIST_VERSION}`, drops }, null, 2),
    'application/json',
    'bouncelab-drops.json',
  );
