// node first_view.mjs [VIEWS]: how long a lesson's first frame takes by its link, over 10 Mbit/s and 40 ms: as built, and
// without what index.html and boot.js ask for ahead. In turns, so that both meet the same machine.
import { readFileSync } from "node:fs";
import { chromium } from "../browser/node_modules/playwright-core/index.mjs";
import { ready, serve_site } from "../browser/support.mjs";

const kSite = process.env.SNUG_SITE ?? new URL("../../build/wasm/site/", import.meta.url).pathname;
const kNetwork = { offline: false, latency: 40, downloadThroughput: 10e6 / 8, uploadThroughput: 10e6 / 8 };
const kLesson = "?lesson=sphere-ritter";

const text_of = (name) => readFileSync(`${kSite}/${name}`, "utf8");
const when_found = {
  "index.html": text_of("index.html").replace(/<link rel="(module)?preload"[^>]*>/g, ""),
  "boot.js": text_of("boot.js").replaceAll("document.head.append(", "void ("),
};

async function view(browser, changed) {
  const site = await serve_site();
  for (const [name, text] of Object.entries(changed)) site.add.set(name, text);
  const page = await (await browser.newContext({ viewport: { width: 1280, height: 800 } })).newPage();
  const session = await page.context().newCDPSession(page);
  await session.send("Network.enable");
  await session.send("Network.emulateNetworkConditions", kNetwork);
  await page.addInitScript(() => {
    const look = () => {
      if (window.snug?.state()?.framesDrawn > 0) window.first = performance.now();
      else requestAnimationFrame(look);
    };
    addEventListener("DOMContentLoaded", look);
  });
  await page.goto(site.url + kLesson);
  await ready(page);
  const seen = await page.evaluate(() => ({
    first: window.first,
    sizes: performance.getEntriesByType("resource").concat(performance.getEntriesByType("navigation"))
      .filter(({ startTime }) => startTime < window.first)
      .map(({ encodedBodySize }) => encodedBodySize),
  }));
  await page.context().close();
  site.close();
  return { first: seen.first, bytes: seen.sizes.reduce((sum, size) => sum + size, 0), files: seen.sizes.length };
}

const executablePath = process.env.SNUG_CHROMIUM ?? "/usr/bin/chromium";
const browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
const ways = { "as built": {}, "each file when it is found": when_found };
const views = Object.fromEntries(Object.keys(ways).map((name) => [name, []]));
for (let i = 0; i < Number(process.argv[2] ?? 5); ++i)
  for (const [name, changed] of Object.entries(ways)) views[name].push(await view(browser, changed));
for (const [name, all] of Object.entries(views)) {
  const [{ bytes, files }] = all;
  const times = all.map(({ first }) => first).sort((a, b) => a - b);
  const shown = times.map((time) => (time / 1000).toFixed(2)).join(" ");
  console.log(`${name}: ${files} files, ${bytes} bytes; first frame after ${shown} s`);
}
await browser.close();
