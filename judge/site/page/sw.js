/* Every file is kept as it is fetched, so a second visit needs no network; those of START were fetched before this
   worker was there. VERSION is the hash of the site's files. A person's own history is asked for anew. */
const VERSION = "judge-{{version}}";
const START = ["./", "app.js", "style.css", "icon.svg"];
self.addEventListener("install", event => event.waitUntil((async () => {
  await (await caches.open(VERSION)).addAll(START.map(path => new Request(path, { cache: "reload" })));
  await self.skipWaiting();
})()));
self.addEventListener("activate", event => event.waitUntil((async () => {
  const old = (await caches.keys()).filter(key => key.startsWith("judge-") && key !== VERSION && key !== "judge-memory");
  await Promise.all(old.map(key => caches.delete(key)));
  await clients.claim();
})()));
self.addEventListener("fetch", event => {
  const { request } = event;
  if (request.method !== "GET" || new URL(request.url).origin !== location.origin || request.url.endsWith("/mine.json")) return;
  event.respondWith((async () => {
    const store = await caches.open(VERSION), kept = await store.match(request, { ignoreSearch: true });
    if (kept) return kept;
    const found = await fetch(request.mode === "navigate" ? request : new Request(request, { cache: "no-cache" }));
    if (found.ok) store.put(request, found.clone()).catch(() => {});
    return found;
  })());
});
