// The page without a network: kept once it is asked for, used with the server gone, updated as a whole; and a page
// whose program is of another build.
import { execFileSync } from "node:child_process";
import { cpSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { assert, load, ready, start, state, stop } from "./support.mjs";
import { kSite } from "./package_support.mjs";

const kRoot = fileURLToPath(new URL("../../", import.meta.url));
const folder = mkdtempSync(join(tmpdir(), "snug-offline-"));
let site;
before(async () => (site = await start()));
after(async () => {
  await stop();
  rmSync(folder, { recursive: true });
});

/** The site is served with another title, and all that describes it, as a later build would be. */
function update(title) {
  const [copy, page] = [join(folder, "site"), join(folder, "index.html")];
  cpSync(kSite, copy, { recursive: true });
  writeFileSync(join(copy, "course.css"), `${readFileSync(join(copy, "course.css"), "utf8")}\n/* ${title} */\n`);
  const text = readFileSync(join(kRoot, "web/page/index.html"), "utf8");
  writeFileSync(page, text.replace("Bounding volumes, by hand and eye", title));
  const lessons = readdirSync(join(kRoot, "lessons")).filter((name) => /[.]toml$/.test(name) && name !== "course.toml");
  const from = ["course.toml", ...lessons].map((name) => join(kRoot, "lessons", name));
  cpSync(join(kRoot, "web/page"), folder, { recursive: true, filter: (name) => !name.endsWith("index.html") });
  const program = join(kSite, "../snug_check.js");
  execFileSync("python3", ["-B", join(kRoot, "web/describe_site.py"), program, "2", page, copy, ...from]);
  for (const name of ["index.html", "course.json", "cases.json", "sizes.json", "sw.js", "course.css"])
    site.add.set(name, readFileSync(join(copy, name)));
}

const headings = (page) => page.locator("#course-hero h1").textContent();
const cached = (page) => page.evaluate(async () => {
  const [name, ...more] = await caches.keys();
  return [more.length, name ? (await (await caches.open(name)).keys()).length : 0];
});

test("once it works offline it says so; the server gone, a lesson runs; an update takes over whole", async (t) => {
  const page = await load(t, "", { may_complain: /503|ERR_|Failed to load/ });
  await page.locator("#settings").click();
  await page.getByRole("button", { name: "Make it work offline" }).click();
  await page.getByText("Works offline now.").waitFor();
  const files = Object.keys(JSON.parse(/^const files = (.*);$/m.exec(readFileSync(join(kSite, "sw.js"), "utf8"))[1]));
  assert.deepEqual(await cached(page), [0, files.length + 1]);

  for (const name of [...files, "sw.js"]) site.refuse.add(name); // the host is down
  await page.goto(`${site.url}?lesson=sphere-welzl&step=3`);
  await ready(page);
  assert.equal((await state(page)).step, 3);
  await page.locator("#home").click();
  assert.equal(await headings(page), "Bounding volumes, by hand and eye");

  site.refuse.clear(); // it is back, in the middle of an update: what has changed meanwhile is not mixed in
  update("A later build");
  const whole = site.add.get("course.css");
  site.add.set("course.css", "/* not there yet */");
  await page.evaluate(async () => (await navigator.serviceWorker.getRegistration()).update().catch(() => {}));
  await page.waitForFunction(async () => {
    const { installing, waiting } = await navigator.serviceWorker.getRegistration();
    return !installing && !waiting;
  });
  await page.reload();
  assert.equal(await headings(page), "Bounding volumes, by hand and eye");

  site.add.set("course.css", whole);
  const other = await page.context().newPage();
  await other.goto(site.url);
  await page.evaluate(async () => (await navigator.serviceWorker.getRegistration()).update());
  await page.waitForFunction(async () => (await navigator.serviceWorker.getRegistration()).waiting);
  await page.reload();
  assert.equal(await headings(page), "Bounding volumes, by hand and eye", "another page of the old build is open");
  await other.close();
  const is_later = page.locator("#course-hero h1", { hasText: "A later build" });
  for (let tries = 0; tries < 5; ++tries) { // a page that was closed may count for a moment
    await page.reload().catch(() => {}); // or it is loading anew by itself
    if (await is_later.waitFor({ timeout: 3000 }).then(() => true, () => false)) break;
  }
  assert.ok(await is_later.isVisible());
  await page.waitForFunction(async () => (await caches.keys()).length === 1);

  await page.locator("#settings").click();
  await page.getByRole("button", { name: "Keep it no longer" }).click();
  await page.getByRole("button", { name: "Make it work offline" }).waitFor();
  assert.deepEqual(await cached(page), [0, 0]);
  site.add.clear();
});

test("in a frame the browser is not asked to keep the page", async (t) => {
  const page = await load(t, "", { wait: false });
  const html = (sandbox) => `<!doctype html><iframe ${sandbox} src="${site.url}" width="900" height="600"></iframe>`;
  site.add.set("framed.html", html(""));
  await page.goto(`${site.url}framed.html`);
  const frame = page.frameLocator("iframe");
  await frame.locator("#settings").click();
  await page.waitForTimeout(300);
  assert.equal(await frame.getByRole("button", { name: "Make it work offline" }).count(), 0);
  assert.equal(await page.evaluate(async () => (await navigator.serviceWorker.getRegistrations()).length), 0);
  site.add.clear();
});

test("a page whose program is of another build is loaded anew, once, and says so", async (t) => {
  const page = await load(t, "?lesson=sphere-ritter", { wait: false });
  const fresh = await (await fetch(site.url)).text();
  site.add.set("index.html", fresh.replace(/snug-build" content="\w+"/, 'snug-build" content="0000000000000000"'));
  let loads = 0;
  page.on("framenavigated", () => {
    if (++loads === 2) site.add.clear(); // what was an old page in the browser's cache is not on the host
  });
  await page.goto(`${site.url}?lesson=sphere-ritter&step=0`);
  await page.locator(".notice", { hasText: "Snug was updated, so this page was loaded anew." }).waitFor();
  assert.equal((await state(page)).lesson, "sphere-ritter");
  site.add.set("index.html", fresh.replace(/snug-build" content="\w+"/, 'snug-build" content="0000000000000000"'));
  await page.goto(`${site.url}?lesson=sphere-ritter&step=1`);
  await page.locator(".notice", { hasText: "Parts of this page are of two versions" }).waitFor();
  site.add.clear();
});
