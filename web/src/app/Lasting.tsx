import { lasting } from '../state/lasting.ts';
import { text } from '../text/language.ts';

/** Safari forgets what a page keeps after a week, but not what is on the home screen. */
const forgets =
  globalThis.navigator?.vendor?.startsWith('Apple') === true &&
  globalThis.matchMedia?.('(display-mode: standalone)').matches === false;

/** Whether the browser promised to delete nothing by itself, wherever the page says that it keeps. */
export function Lasting() {
  if (lasting.value === null) return null;
  if (lasting.value) return <>{text('page-keep-lasting')}</>;
  return <>{text(forgets ? 'page-keep-for-a-week' : 'page-keep-not-lasting')}</>;
}
