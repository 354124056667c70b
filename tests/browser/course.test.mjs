// The course, the page's first view: there without the program, leads into lessons and back, finds, tells how far one
// is.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { assert, course, kPhone, kWide, lessons, load, ready, start, state, stop, until } from "./support.mjs";

let site;
before(async () => (site = await start()));
after(stop);

const kAxe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** What axe finds wrong. One chapter is made like another: unless every is true, the first stands for all. */
async function violations(page, every) {
  await page.evaluate(kAxe);
  return page.evaluate(
    async (exclude) =>
      (await window.axe.run({ exclude }, { resultTypes: ["violations"] })).violations.flatMap(({ id, nodes }) =>
        nodes.map(({ target }) => `${id} at ${target}`),
      ),
    every ? [] : [".chapter:not(:first-child)"],
  );
}

const shown = async (page) =>
  (await page.locator(".lesson-card:visible .card-title b").allTextContents()).map((title) =>
    title.replaceAll("\u2060", ""),
  );

test("the bare address opens the course; the program follows when idle, unless data are saved", async (t) => {
  site.sent.clear();
  const page = await load(t, "", {
    init: () => Object.defineProperty(navigator, "connection", { value: { saveData: true } }),
  });
  await page.waitForLoadState("networkidle");
  const total = [...site.sent.values()].reduce((sum, size) => sum + size, 0);
  t.diagnostic(`${total} bytes in ${site.sent.size} files`);
  assert.ok(!site.sent.has("snug.wasm") && !site.sent.has("snug.js"));
  assert.ok(total <= 450_000, `${total} bytes`);
  const now = await page.evaluate(() => window.snug.state());
  assert.equal(now.lesson, null);
  const all = await lessons();
  assert.deepEqual(
    now.course,
    all.map(({ id, title, chapter }, i) => ({ id, number: i + 1, title, chapter, done: false })),
  );
  assert.deepEqual(
    await shown(page),
    all.map(({ title }) => title),
  );
  assert.deepEqual(
    await page.locator(".chapter h2").allTextContents(),
    (await course()).chapters.map(({ title }) => title),
  );
  assert.equal(await page.locator(".card-foot > :first-child").first().textContent(), `${all[0].minutes} min`);
  assert.equal(await page.locator(".progress").first().textContent(), "Not begun");
  assert.equal(await page.locator("main:visible").count(), 1);
  await page.waitForTimeout(2000);
  assert.ok(!site.sent.has("snug.wasm"));
  await load(t, "");
  for (let i = 0; i < 100 && !site.sent.has("snug.wasm"); ++i) await page.waitForTimeout(100);
  assert.ok(site.sent.has("snug.wasm") && site.sent.has("snug.js"));
});

test("a pointer leads from the course to a lesson and back, and nothing is loaded again", async (t) => {
  const page = await load(t, "");
  await page.evaluate(() => (window.same = true));
  await page.locator("#start").click();
  await ready(page);
  const first = (await lessons())[0].id;
  const opened = await state(page);
  assert.equal(opened.lesson, first);
  assert.equal(opened.step, 0);
  assert.ok(opened.steps > 0);
  await page.locator("#home").click();
  assert.equal((await state(page)).lesson, null);
  assert.equal(new URL(page.url()).search, "");
  site.sent.clear();
  await page.locator(".lesson-card").nth(3).click();
  const { lesson } = await until(page, (now) => now.lesson !== null);
  assert.equal(lesson, (await lessons())[3].id);
  assert.ok(!site.sent.has("snug.wasm"));
  await page.goBack();
  assert.equal((await state(page)).lesson, null);
  await page.goBack();
  assert.equal((await until(page, (now) => now.lesson !== null)).lesson, first);
  await page.goForward();
  await until(page, (now) => now.lesson === null);
  await page.waitForTimeout(600); // the lesson's address does not come after
  assert.equal(new URL(page.url()).search, "");
  assert.equal(await page.evaluate(() => window.same), true);
});

test("Start here stands first, and after a lesson was begun Continue leads to its place", async (t) => {
  const page = await load(t, "");
  assert.equal(await page.locator("#start").textContent(), "Start here");
  await page.locator(".lesson-card").nth(2).click();
  await ready(page);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  await until(page, (now) => now.step > 0);
  const { step, lesson } = await state(page);
  await page.locator("#home").click();
  assert.equal(await page.locator("#start").textContent(), "Continue");
  assert.match(await page.locator(".progress").nth(2).textContent(), /^At step \d+ of \d+$/);
  await page.reload();
  await ready(page);
  await page.locator("#start").click();
  await ready(page);
  const now = await state(page);
  assert.deepEqual([now.lesson, now.step], [lesson, step]);
});

test("the search finds by title, topic and words, and says how many", async (t) => {
  const page = await load(t, "");
  const search = page.getByRole("searchbox");
  for (const [words, found] of [
    ["welzl support", "Welzl's algorithm and the support set"],
    ["COVARIANCE", "Mean, variance and covariance in numbers"],
    ["frustum six", "Box and frustum in space: six planes"],
  ]) {
    await search.fill(words);
    assert.ok((await shown(page)).includes(found), words);
    assert.ok((await shown(page)).length < (await lessons()).length);
    assert.match(await page.locator("#search-says").textContent(), /^\d+ lessons?(, \d+ exercises?)?$/);
  }
  await search.fill("zzz");
  assert.deepEqual(await shown(page), []);
  assert.equal(await page.locator("#search-says").textContent(), "No lesson or exercise has “zzz”.");
  assert.deepEqual(await violations(page, true), []);
  await search.fill("exercise price split");
  assert.deepEqual(await page.locator(".set-list b:visible").allTextContents(), ["Price a split"]);
  assert.equal(await page.locator("#search-says").textContent(), "1 exercise");
  assert.equal(await page.locator(".chapter:visible, .set-foot:visible").count(), 0);
  await page.getByRole("button", { name: "Show all lessons" }).click();
  assert.equal((await shown(page)).length, (await lessons()).length);
  await search.fill("welzl");
  await search.press("Escape");
  assert.equal((await shown(page)).length, (await lessons()).length);
});

test("the keyboard alone goes from the course into a lesson and back", async (t) => {
  const page = await load(t, "");
  const names = [];
  for (let i = 0; i < 10; ++i) {
    await page.keyboard.press("Tab");
    names.push(await page.evaluate(() => document.activeElement.id || document.activeElement.className));
    if (names.at(-1) === "start") break;
  }
  assert.ok(names.includes("home") && names.includes("search") && names.at(-1) === "start", names.join(", "));
  for (let i = 0; i < 3; ++i) await page.keyboard.press("Tab"); // the way to the exercises, then two lessons
  await page.keyboard.press("Enter");
  await ready(page);
  assert.equal((await state(page)).lesson, (await lessons())[1].id);
  await page.locator("#home").focus();
  await page.keyboard.press("Enter");
  await until(page, (now) => now.lesson === null);
});

for (const [name, size] of Object.entries({ laptop: kWide, phone: { ...kPhone, deviceScaleFactor: 1 } })) {
  test(`on a ${name} the course is clean in every theme, and needs no sideways scroll`, async (t) => {
    const page = await load(t, "", size);
    for (const theme of ["light", "dark", "contrast", "projector"]) {
      await page.waitForFunction((now) => document.documentElement.dataset.theme === now, theme);
      await page.waitForTimeout(200); // colours ease
      assert.deepEqual(await violations(page, theme === "light"), [], theme);
      await page.locator("#settings").click();
      assert.deepEqual(await violations(page, false), [], `${theme}, settings`);
      await page.keyboard.press("Escape");
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0);
      await page.locator("#theme").click();
    }
    for (const card of await page.locator(".lesson-card").all()) {
      await card.scrollIntoViewIfNeeded();
      await card.locator("img").evaluate((image) => image.decode());
    }
  });
}
