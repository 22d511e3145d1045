import { chosenDrop, edits, lookAt } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';

/** Which of several drops in a recording is looked at. */
export function DropChoice() {
  const count = edits.value.length;
  if (count < 2) return null;
  return (
    <fieldset class="choice">
      <legend class="unseen">{text('page-lab-drops-heard')}</legend>
      {edits.value.map((_, index) => (
        <button
          // The drops of a recording never change their order.
          key={index}
          type="button"
          class="tool"
          aria-pressed={chosenDrop.value === index}
          onClick={() => lookAt(index)}
        >
          {text('page-lab-drop-of', { index: index + 1, count })}
        </button>
      ))}
    </fieldset>
  );
}
