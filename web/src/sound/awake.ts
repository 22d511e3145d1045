/**
 * Keeps the screen on: a phone whose screen turns off while a ball is fetched stops listening. Returns a function
 * that releases the lock. Where a browser lacks or refuses the lock, nothing happens.
 */
export function keepAwake(): () => void {
  const asked = (navigator.wakeLock as WakeLock | undefined)?.request('screen');
  return () => void asked?.then((lock) => lock.release()).catch(() => undefined);
}
