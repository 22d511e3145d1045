/** The service worker: after the first visit the page needs no network. */
import { signal } from '@preact/signals';

/** Whether a newer page waits. */
export const newer = signal(false);

let waiting: ServiceWorker | null = null;

export async function workOffline(): Promise<void> {
  if (!import.meta.env.PROD || !('serviceWorker' in navigator)) return;
  try {
    const registration = await navigator.serviceWorker.register('sw.js');
    const notice = (): void => {
      if (!registration.waiting || !navigator.serviceWorker.controller) return;
      waiting = registration.waiting;
      newer.value = true;
    };
    notice();
    registration.addEventListener('updatefound', () => {
      registration.installing?.addEventListener('statechange', notice);
    });
  } catch {
    // Without it (a private window, a plain http server) the page works as long as it is loaded.
  }
}

/** How long the older service worker may take to end what it does, in milliseconds: browsers give it minutes. */
const PATIENCE_MS = 3_000;

/** Lets the newer page take over; another tab may have done so already. */
export async function takeOver(): Promise<void> {
  if (waiting?.state === 'installed') {
    const changed = new Promise<boolean>((resolve) => {
      const done = () => resolve(true);
      navigator.serviceWorker.addEventListener('controllerchange', done, { once: true });
    });
    waiting.postMessage('take over');
    const late = new Promise<boolean>((resolve) => setTimeout(resolve, PATIENCE_MS, false));
    const isDone =
      (await Promise.race([changed, late])) || (await Promise.race([changed, unregistered()]));
    // What is open stays until the newer page can take over.
    if (!isDone) await changed;
  }
  location.reload();
}

/**
 * Unregisters the service worker, so that the browser loads the whole page from the network; false, and it stays,
 * where there is no network.
 */
async function unregistered(): Promise<boolean> {
  const signal = AbortSignal.timeout(PATIENCE_MS);
  const canLoad = await fetch('sw.js', { cache: 'no-store', signal }).then(
    ({ ok }) => ok,
    // A service worker that does not answer gives no page either.
    () => signal.aborted,
  );
  if (canLoad) await (await navigator.serviceWorker.getRegistration())?.unregister();
  return canLoad;
}
