/** Tables as files, in the form that the reader's spreadsheet reads. */
import { withDecimalCommas } from '../format/csv.ts';
import { Option } from '../state/option.ts';
import { saveText } from './save.ts';

/** Semicolons and decimal commas, if the reader wants them. */
export const commas = new Option('csv-commas', true);

export const saveCsv = (table: string, name: string): void =>
  saveText(commas.isOn ? withDecimalCommas(table) : table, 'text/csv', name);
