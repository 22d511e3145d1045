/// <reference lib="webworker" />
/**
 * Keeps every file of the page, so that it opens without a network. A new version is fetched as a
 * whole next to the old one and takes over only when the reader says so: never half of each.
 */
declare const self: ServiceWorkerGlobalScope;
declare const __PRECACHE__: readonly string[];
declare const __VERSION__: string;

/** Caches belong to the origin, which may have other deployments of the page in other folders. */
const OWN = `bouncelab ${self.registration.scope} `;
const CACHE = OWN + __VERSION__;

self.addEventListener('install', (event) => {
  event.waitUntil(
    caches.open(CACHE).then((cache) =>
      // Past the browser's own cache, which might still hold an older file of the same name.
      cache.addAll(__PRECACHE__.map((name) => new Request(name, { cache: 'reload' }))),
    ),
  );
});

self.addEventListener('activate', (event) => {
  event.waitUntil(forgetOld().then(() => self.clients.claim()));
});

/** Other pages that are open, and may listen, still load from older files; the next version forgets those. */
async function forgetOld(): Promise<void> {
  const pages = await self.clients.matchAll({ type: 'window', includeUncontrolled: true });
  if (pages.length > 1) return;
  const names = await caches.keys();
  const old = names.filter((name) => name.startsWith(OWN) && name !== CACHE);
  await Promise.all(old.map((name) => caches.delete(name)));
}

self.addEventListener('message', (event) => {
  if (event.data === 'take over') void self.skipWaiting();
});

self.addEventListener('fetch', (event) => {
  const { request } = event;
  if (request.method !== 'GET' || new URL(request.url).origin !== self.location.origin) return;
  event.respondWith(answer(request));
});

async function answer(request: Request): Promise<Response> {
  const cache = await caches.open(CACHE);
  const kept = await cache.match(request, { ignoreSearch: true });
  return kept ?? (await caches.match(request)) ?? fetch(request);
}
