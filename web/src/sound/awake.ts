/**
 * Keeps the screen on: a phone whose screen turns off while a ball is fetched stops listening. A browser takes the lock
 * back when the page is hidden, so it is asked for again when the page returns. Returns a function that releases it.
 * Where a browser lacks or refuses the lock, nothing happens.
 */
export function keepAwake(): () => void {
  const over = new AbortController();
  let lock: WakeLockSentinel | undefined;
  const ask = async (): Promise<void> => {
    if (document.hidden) return;
    lock = await (navigator.wakeLock as WakeLock | undefined)
      ?.request('screen')
      .catch(() => undefined);
    if (over.signal.aborted) await release();
  };
  const release = async (): Promise<void> => lock?.release().catch(() => undefined);
  document.addEventListener('visibilitychange', () => void ask(), { signal: over.signal });
  void ask();
  return () => {
    over.abort();
    void release();
  };
}
