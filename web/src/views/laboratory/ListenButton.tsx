import { useEffect, useRef } from 'preact/hooks';
import { onBench, phase } from '../../state/bench.ts';
import { level, listen, stopListening } from '../../state/listening.ts';
import { texts } from '../../text/language.ts';

/** The one button that matters. While listening it breathes with the sound. */
export function ListenButton({ small = false }: { readonly small?: boolean }) {
  const words = texts.value.lab;
  const listening = phase.value.kind === 'listening';
  const waiting = phase.value.kind === 'starting' || phase.value.kind === 'reading';
  const button = useRef<HTMLButtonElement>(null);
  const loudness = level.value;
  useEffect(() => {
    button.current?.style.setProperty('--level', loudness.toFixed(2));
  }, [loudness]);
  // The button moves when listening begins; the keyboard must not lose it.
  useEffect(() => {
    if (listening) button.current?.focus({ preventScroll: true });
  }, [listening]);
  const label = listening ? words.stop : onBench.value ? words.again : words.listen;
  return (
    <button
      type="button"
      class={small ? 'listen small' : 'listen'}
      aria-pressed={listening}
      disabled={waiting}
      ref={button}
      onClick={() => void (listening ? stopListening() : listen())}
    >
      {label}
    </button>
  );
}
