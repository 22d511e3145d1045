/**
 * Keeps the screen on: a phone that falls asleep while a ball is fetched stops listening. Returns what
 * lets it sleep again. Where a browser does not know how, or does not want to, nothing happens.
 */
export function keepAwake(): () => void {
  const asked = (navigator.wakeLock as WakeLock | undefined)?.request('screen');
  return () => void asked?.then((lock) => lock.release()).catch(() => undefined);
}
