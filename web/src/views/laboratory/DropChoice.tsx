import { chosenDrop, edits, lookAt } from '../../state/workspace.ts';
import { texts } from '../../text/language.ts';

/** Which of several drops in a recording is looked at. */
export function DropChoice() {
  const words = texts.value.lab;
  const count = edits.value.length;
  if (count < 2) return null;
  return (
    <fieldset class="choice">
      <legend class="unseen">{words.dropsHeard}</legend>
      {edits.value.map((_, index) => (
        <button
          // The drops of a recording never change their order.
          key={index}
          type="button"
          class="tool"
          aria-pressed={chosenDrop.value === index}
          onClick={() => lookAt(index)}
        >
          {words.dropOf(index + 1, count)}
        </button>
      ))}
    </fieldset>
  );
}
