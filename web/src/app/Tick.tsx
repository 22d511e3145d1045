import type { Option } from '../state/option.ts';
import { language, text } from '../text/language.ts';
import { commas } from './saveCsv.ts';

/** A choice that the browser remembers, where it can be made. */
export function Tick({ option, label }: { readonly option: Option; readonly label: string }) {
  if (!option.offered) return null;
  return (
    <label class="check">
      <input
        type="checkbox"
        checked={option.isOn}
        onChange={(event) => option.choose(event.currentTarget.checked)}
      />
      {label}
    </label>
  );
}

/** Offers tables with decimal commas where the language has them. */
export function CommaTick() {
  if (!(1.5).toLocaleString(language.value).includes(',')) return null;
  return <Tick option={commas} label={text('page-keep-commas')} />;
}
