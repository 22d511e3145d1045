import { useId, useState } from 'preact/hooks';
import { readNumber, tidy } from '../address/settings.ts';
import { localised } from '../format/quantity.ts';
import { language, text } from '../text/language.ts';
import { useTyped } from './typed.ts';

interface Props {
  readonly label: string;
  readonly unit: string;
  /** In the unit shown; nothing if it is assumed. */
  readonly value: number | undefined;
  /** What is assumed, shown faintly. */
  readonly usual?: number | undefined;
  readonly min?: number;
  readonly max?: number | undefined;
  /** What to ask of the value: it is used as it is. */
  readonly question?: string | undefined;
  readonly onChange: (value: number | undefined) => void;
}

/** A number with its unit; empty means: what is assumed. A comma is as good as a point. */
export function NumberField({ label, unit, value, usual, min, max, question, onChange }: Props) {
  const id = useId();
  /** What was typed and is no such number: it stays, to be mended. */
  const [wrong, setWrong] = useState<string>();
  const written = (number: number | undefined): string =>
    number === undefined ? '' : localised(tidy(number), language.value).replace('-', '\u2212');
  const take = (typed: string): void => {
    const read = readNumber(typed);
    const fine = read !== undefined && read >= (min ?? read) && read <= (max ?? read);
    const isEmpty = typed.trim() === '';
    setWrong(fine || isEmpty ? undefined : typed);
    if (fine || isEmpty) onChange(read);
  };
  const typed = useTyped(wrong ?? written(value), take);
  return (
    <div class="field">
      <label for={id}>{label}</label>
      <span class="pair">
        <input
          id={id}
          type="text"
          inputMode="decimal"
          autocomplete="off"
          {...typed}
          placeholder={written(usual)}
          aria-invalid={wrong !== undefined}
          aria-describedby={`${id}-hint`}
        />
        <span class="unit">{unit}</span>
      </span>
      <span id={`${id}-hint`} class="hint" role="status">
        {wrong === undefined
          ? question
          : text('page-app-number-wanted', {
              least: written(min) || 'none',
              most: written(max) || 'none',
            })}
      </span>
    </div>
  );
}
