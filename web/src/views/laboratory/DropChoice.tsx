import { chosenDrop, edits, lookAt } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';

/** More would fill the screen: they are chosen from a list. */
const MAX_BUTTONS = 20;

/** Which of several drops in a recording is looked at. */
export function DropChoice() {
  const count = edits.value.length;
  if (count < 2) return null;
  const nameOf = (index: number): string => text('page-lab-drop-of', { index: index + 1, count });
  if (count > MAX_BUTTONS) {
    return (
      <select
        class="tool"
        aria-label={text('page-lab-drops-heard')}
        value={chosenDrop.value}
        onChange={(event) => lookAt(Number(event.currentTarget.value))}
      >
        {edits.value.map((_, index) => (
          <option key={index} value={index}>
            {nameOf(index)}
          </option>
        ))}
      </select>
    );
  }
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
          {nameOf(index)}
        </button>
      ))}
    </fieldset>
  );
}
