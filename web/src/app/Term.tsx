import { useId } from 'preact/hooks';
import { text } from '../text/language.ts';

interface TermProps {
  /** Which message explains it. */
  readonly word: string;
  /** How it is called where it stands. */
  readonly children: string;
}

/** A term that explains itself when it is tapped; Escape, or a tap elsewhere, closes it. */
export function Term({ word, children }: TermProps) {
  const id = useId();
  return (
    <>
      <button type="button" class="term" popovertarget={id}>
        {children}
      </button>
      <span id={id} popover="auto" class="explains" role="note">
        {text(`page-words-${word}`)}
      </span>
    </>
  );
}
