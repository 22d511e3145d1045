import { useState } from 'preact/hooks';
import { NumberField } from '../../app/NumberField.tsx';
import { openFile, withoutRate } from '../../state/opening.ts';
import { text } from '../../text/language.ts';

/** The rates that are read, in hertz. */
const [MIN_HZ, MAX_HZ] = [4000, 10_000_000];

/** Asks for the rate of samples whose file does not state it, and opens the file with it. */
export function RateForm() {
  const [rateHz, setRateHz] = useState<number>();
  const file = withoutRate.value;
  if (!file) return null;
  return (
    <form
      class="stack"
      onSubmit={(event) => {
        event.preventDefault();
        if (rateHz !== undefined) void openFile(file, Math.round(rateHz));
      }}
    >
      <NumberField
        label={text('page-lab-rate')}
        unit="Hz"
        value={rateHz}
        min={MIN_HZ}
        max={MAX_HZ}
        onChange={setRateHz}
      />
      <div>
        <button type="submit" class="button">
          {text('page-lab-rate-open')}
        </button>
      </div>
    </form>
  );
}
