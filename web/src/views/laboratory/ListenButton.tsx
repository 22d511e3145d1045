import { useEffect, useRef } from 'preact/hooks';
import { level, listen, stopListening } from '../../state/listening.ts';
import { busy, fault, phase, workspace } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';

interface ListenButtonProps {
  readonly small?: boolean;
  readonly begin?: () => Promise<void>;
}

/** The button to listen. While listening its size follows the level of the sound. */
export function ListenButton({ small = false, begin = listen }: ListenButtonProps) {
  const now = phase.value.kind;
  const listening = now === 'listening';
  const waiting = busy.value && !listening;
  const button = useRef<HTMLButtonElement>(null);
  const loudness = level.value;
  useEffect(() => {
    button.current?.style.setProperty('--level', loudness.toFixed(2));
  }, [loudness]);
  // What was pressed goes away when something begins, ends or fails; the keyboard goes on from here.
  // When the page opens, it begins at its top.
  useEffect(() => {
    const isLost = document.activeElement === document.body;
    if (isLost && (now !== 'empty' || fault.peek())) button.current?.focus({ preventScroll: true });
  }, [now]);
  const label = listening
    ? text('page-lab-stop')
    : workspace.value
      ? text('page-lab-again')
      : text('page-lab-listen');
  return (
    <button
      type="button"
      class={small ? 'listen small' : 'listen'}
      aria-pressed={listening}
      aria-disabled={waiting}
      ref={button}
      onClick={() => void (listening ? stopListening() : begin())}
    >
      {label}
    </button>
  );
}
