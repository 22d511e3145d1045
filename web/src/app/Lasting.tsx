import { lasting } from '../state/lasting.ts';
import { text } from '../text/language.ts';

/** Whether the browser promised to delete nothing by itself, wherever the page says that it keeps. */
export function Lasting() {
  if (lasting.value === null) return null;
  return <>{text(lasting.value ? 'page-keep-lasting' : 'page-keep-not-lasting')}</>;
}
