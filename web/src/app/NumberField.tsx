import { useId, useState } from 'preact/hooks';
import { readNumber, tidy } from '../address/settings.ts';
import { localised } from '../format/quantity.ts';
import { language } from '../text/language.ts';

interface Props {
  readonly label: string;
  readonly unit: string;
  /** In the unit shown; nothing if it is assumed. */
  readonly value: number | undefined;
  /** What is assumed, shown faintly. */
  readonly usual?: number | undefined;
  readonly min?: number;
  readonly max?: number;
  readonly onChange: (value: number | undefined) => void;
}

/** A number with its unit; empty means: what is assumed. A comma is as good as a point. */
export function NumberField({ label, unit, value, usual, min, max, onChange }: Props) {
  const id = useId();
  const [wrong, setWrong] = useState(false);
  const written = (number: number | undefined): string =>
    number === undefined ? '' : localised(tidy(number), language.value);
  const take = (typed: string): void => {
    if (typed.trim() === '') {
      setWrong(false);
      onChange(undefined);
      return;
    }
    const read = readNumber(typed);
    const fine = read !== undefined && read >= (min ?? read) && read <= (max ?? read);
    setWrong(!fine);
    if (fine) onChange(read);
  };
  return (
    <div class="field">
      <label for={id}>{label}</label>
      <span class="pair">
        <input
          id={id}
          type="text"
          inputMode="decimal"
          autocomplete="off"
          value={written(value)}
          placeholder={written(usual)}
          aria-invalid={wrong}
          onChange={(event) => take(event.currentTarget.value)}
        />
        <span class="unit">{unit}</span>
      </span>
    </div>
  );
}
