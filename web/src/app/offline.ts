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

/** Lets the newer page take over; another tab may have done so already. */
export function takeOver(): void {
  const reload = (): void => location.reload();
  if (waiting?.state === 'installed') {
    navigator.serviceWorker.addEventListener('controllerchange', reload, { once: true });
    waiting.postMessage('take over');
  } else reload();
}
