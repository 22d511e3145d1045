import { useId } from 'preact/hooks';

interface Props {
  readonly label: string;
  readonly value: number;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  /** The value in words, with its unit. */
  readonly shown: string;
  readonly hint?: string;
  readonly disabled?: boolean;
  readonly onInput: (value: number) => void;
}

/** A slider that says where it stands. */
export function Slider({ label, value, shown, hint, disabled, onInput, ...range }: Props) {
  const id = useId();
  return (
    <div class="field">
      <span>
        <label for={id}>{label}</label>
        {/* A screen reader takes it from the slider itself. */}
        <strong aria-hidden="true">{shown}</strong>
      </span>
      <input
        id={id}
        type="range"
        {...range}
        value={value}
        disabled={disabled}
        aria-valuetext={shown}
        onInput={(event) => onInput(event.currentTarget.valueAsNumber)}
      />
      {hint !== undefined && <span class="hint">{hint}</span>}
    </div>
  );
}
