import type { ComponentChildren } from 'preact';

interface ToolProps {
  readonly do: () => void;
  readonly disabled?: boolean;
  readonly pressed?: boolean;
  readonly children: ComponentChildren;
}

/** A button of a row of tools. */
export function Tool({ do: act, disabled = false, pressed, children }: ToolProps) {
  return (
    // Not `disabled`: a button that has done its work would drop the keyboard.
    <button
      type="button"
      class="tool"
      aria-disabled={disabled}
      aria-pressed={pressed}
      onClick={() => {
        if (!disabled) act();
      }}
    >
      {children}
    </button>
  );
}
