import type { StatedPart } from '../../lab/index.ts';
import { text } from '../../text/language.ts';

interface KeptProps {
  readonly parts: readonly StatedPart[];
  readonly kept: readonly string[];
  readonly onChange: (kept: readonly string[]) => void;
}

/** The parts of a procedure that only a person can state to have been kept. */
export function Kept({ parts, kept, onChange }: KeptProps) {
  if (parts.length === 0) return null;
  return (
    <fieldset class="ticks">
      <legend class="small">{text('page-verdict-kept')}</legend>
      {parts.map(({ name, label }) => (
        <label key={name} class="check">
          <input
            type="checkbox"
            checked={kept.includes(name)}
            onChange={({ currentTarget: { checked } }) =>
              onChange(checked ? [...kept, name] : kept.filter((other) => other !== name))
            }
          />{' '}
          {label}
        </label>
      ))}
    </fieldset>
  );
}
