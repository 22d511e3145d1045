/** Where the keyboard goes before what it stands on goes away. */

/** To the page: the next step is from its top. */
export const focusPage = (): void =>
  document.getElementById('main')?.focus({ preventScroll: true });

/** Moves the focus to the same control of the next or previous entry of a list, or to the page without one. */
export function handFocusOn(button: HTMLElement, entry: string): void {
  const going = button.closest(entry);
  const next = going?.nextElementSibling ?? going?.previousElementSibling;
  const heir = [...(next?.querySelectorAll('button') ?? [])].at(-1);
  if (heir) heir.focus({ preventScroll: true });
  else focusPage();
}
