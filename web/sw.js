// Keeps the whole page for use without a network, once somebody asks for it (page/offline.js): every file of one build,
// or none. Each is checked by its hash, so that an update on the host in the middle of fetching mixes nothing; and a
// newer build takes over only when no page of the older one is open.
const files = {}; // each with its hash: written when the site is made, or a package of it

const kList = "sw-files"; // the same list, in each cache
const kAtOnce = 6;
const kOwn = `snug ${registration.scope} `;
const name = kOwn + Object.values(files).join("");

const hex = (bytes) => Array.from(new Uint8Array(bytes), (byte) => byte.toString(16).padStart(2, "0")).join("");
const hash_of = async (bytes) => hex(await crypto.subtle.digest("SHA-256", bytes)).slice(0, 16);
const own_caches = async () => (await caches.keys()).filter((each) => each.startsWith(kOwn));

/** The caches of older builds, each with its list. */
async function older() {
  const names = (await own_caches()).filter((each) => each !== name);
  return Promise.all(names.map(async (each) => {
    const cache = await caches.open(each);
    return { cache, list: (await (await cache.match(kList))?.json()) ?? {} };
  }));
}

/** A file of this build, from an older one that has the same, or from the host. Throws if the host has another. */
async function bring(path, caches_before) {
  const same = caches_before.find(({ list }) => list[path] === files[path]);
  const kept = same && (await same.cache.match(path));
  if (kept) return kept;
  const answer = await fetch(path, { cache: "no-cache" });
  const bytes = await answer.arrayBuffer();
  if (!answer.ok || (await hash_of(bytes)) !== files[path]) throw new Error(`${path} is of another build`);
  return new Response(bytes, { headers: { "Content-Type": answer.headers.get("Content-Type") ?? "" } });
}

async function bring_all() {
  const cache = await caches.open(name);
  const before = await older();
  const paths = Object.keys(files);
  const one_after_another = async () => {
    for (let path = paths.pop(); path !== undefined; path = paths.pop())
      await cache.put(path, await bring(path, before));
  };
  await Promise.all(Array.from({ length: kAtOnce }, one_after_another));
  await cache.put(kList, new Response(JSON.stringify(files)));
}

async function answer(event, path) {
  // A page that is opened while no other is open gets the newer build, if one waits.
  if (event.request.mode === "navigate" && registration.waiting && (await clients.matchAll()).length < 2) {
    registration.waiting.postMessage("take over");
    return new Response("", { headers: { Refresh: "0" } });
  }
  const kept = await (await caches.open(name)).match(path);
  return kept ?? fetch(event.request); // the browser may have thrown it away
}

addEventListener("install", (event) =>
  event.waitUntil(bring_all().catch(async (error) => (await caches.delete(name), Promise.reject(error)))));
async function leave_older() {
  const all = await own_caches();
  await Promise.all(all.filter((each) => each !== name).map((each) => caches.delete(each)));
}

addEventListener("activate", (event) => event.waitUntil(leave_older()));
addEventListener("message", ({ data }) => data === "take over" && skipWaiting());
addEventListener("fetch", (event) => {
  const { origin, pathname } = new URL(event.request.url);
  if (event.request.method !== "GET" || !(origin + pathname).startsWith(registration.scope)) return;
  const path = decodeURIComponent((origin + pathname).slice(registration.scope.length)) || "index.html";
  if (Object.hasOwn(files, path)) event.respondWith(answer(event, path));
});
