// From lesson to lesson within one page: nothing is loaded but the lesson's own files, nothing of the last one stays,
// and what is the page's or the student's does.
import { after, before, test } from "node:test";
import {
  assert, choose, handles, lessons, load, pixels_of, ready, start_for_pictures, state, still, stop, text_of,
  until,
} from "./support.mjs";

let site;
before(async () => (site = await start_for_pictures()));
after(stop);

const mesh_of = (toml) => /^mesh = "(\w+)"/m.exec(toml)?.[1];

/** The paths that the page asks for from now on. Its icon the browser itself asks for, with each new address. */
function watch_requests(page) {
  const asked = [];
  page.on("request", (request) => {
    const path = request.url().slice(site.url.length);
    if (path !== "icon.svg") asked.push(path);
  });
  return asked;
}

/** What is on the page, as far as it is the lesson's: words, fields, names, handles' places. */
async function shown(page) {
  await still(page);
  // The address follows, and meanwhile a long text is scrolled smoothly.
  const scrolled = page.waitForFunction(() => new Promise((resolve) => {
    const from = document.getElementById("read").scrollTop;
    setTimeout(() => resolve(document.getElementById("read").scrollTop === from), 150);
  }));
  await Promise.all([scrolled, page.waitForTimeout(300)]);
  const places = (await handles(page)).map(({ id, x, y }) => `${id} ${Math.round(x)} ${Math.round(y)}`);
  return {
    places,
    ...(await page.evaluate(() => {
      const seen = (selector) => [...document.querySelectorAll(selector)];
      const { framesDrawn, ...now } = window.snug.state();
      const effects = now.effects?.map(({ microseconds, ...effect }) => effect); // a time is another one each time
      // The rows hold times as well, so only their names are compared.
      const panels = now.panels.map(({ title, head, rows }) => [title, head, rows.map(([name]) => name)]);
      return {
        now: { ...now, effects, panels },
        search: location.search,
        title: document.title,
        stage: document.getElementById("canvas").getAttribute("aria-label"),
        words: seen(
          "#picker, #read, #points, #ask, #told, #code, #caption, #figures, #tabs, .cover, #selected-says, #notices",
        ).map((node) => `${node.id}${node.hidden}: ${node.hidden ? "" : node.textContent}`),
        hidden: seen("#column [hidden], #stage [hidden]").filter((node) => !node.closest(".cover")).length,
        fields: seen("input:not([type=file]), select")
          .filter((node) => node.offsetParent)
          .map((node) => `${node.type} ${node.checked} ${node.value} ${node.disabled} ${node.max}`),
        lines: seen(".lines li").map((line) => `${line.style.cssText} ${line.getAttribute("aria-current")}`),
        scrolled: ["read", "points", "column"].map((part) => document.getElementById(part).scrollTop),
      };
    })),
  };
}

/** Leaves traces of every kind in the lesson that is open. */
async function use(page) {
  await page.evaluate(() => document.activeElement.blur());
  for (const key of ["Home", "PageDown", "PageDown", "PageDown", "]", "ArrowUp", "+", " "])
    await page.keyboard.press(key);
  await page.locator("#read").evaluate((node) => (node.scrollTop = 40));
}

async function erase_answers(page) {
  await page.locator("#settings").click();
  await page.locator("#erase").click();
  await page.locator("#erase").click();
  await page.keyboard.press("Escape");
}

/** One lesson of each sort of stage: points, two bodies, a frustum, a field, a tree, updates, a scene, the charts. */
const kStages = [
  "sphere-ritter", "obb-sat", "frustum-2d", "frustum-field", "bvh-build", "aabb-updates", "scene-broad", "which-volume",
  "cost-chart", "lecture-claims",
];

test("a lesson of every sort opens in place of another as it would by itself, for its own file alone", async (t) => {
  const all = kStages;
  const alone = new Map();
  const page = await load(t, `?lesson=${all[0]}`);
  for (const id of [...all].reverse()) { // the first is open then
    await page.goto(`${site.url}?lesson=${id}&step=0`); // who has not begun it begins there
    await ready(page);
    alone.set(id, await shown(page));
  }
  await page.evaluate(() => {
    window.mark = 1;
    window.context = document.getElementById("canvas").getContext("webgl2");
  });
  const asked = watch_requests(page);
  // There and, in steps of four, back: those are come to from two sides, and the second time nothing is fetched.
  for (const id of [...all.slice(1), ...all.slice(0, -1).filter((_, i) => i % 4 === 0).reverse()]) {
    await use(page);
    const fresh = id !== all[0] && !asked.includes(`lessons/${id}.toml`);
    if (!fresh) await erase_answers(page); // it would open where it was left
    const before = asked.length;
    await choose(page, id);
    const mesh = mesh_of(await text_of(id));
    const may = fresh ? [`lessons/${id}.toml`, ...(mesh ? [`meshes/${mesh}.ply`] : [])] : [];
    assert.deepEqual(
      asked.slice(before).filter((path) => !may.includes(path)),
      [],
      `${id} fetches no more than it needs`,
    );
    if (!fresh) await page.evaluate(() => document.activeElement.blur());
    const now = await shown(page);
    const own = alone.get(id);
    // What was answered stays so.
    if (!fresh) Object.assign(now.now, { outcomes: own.now.outcomes, asked: own.now.asked });
    assert.deepEqual(now.now, own.now, id);
    if (fresh) assert.deepEqual(now, own, id);
  }
  assert.ok(
    await page.evaluate(
      () =>
        window.mark === 1 &&
        window.context === document.getElementById("canvas").getContext("webgl2") &&
        !window.context.isContextLost(),
    ),
  );
});

test("the stage shows a lesson's own points, wherever one comes from", async (t) => {
  /** @type {Opened} */
  const still_page = { reducedMotion: "reduce" };
  const stage_of = async (page) => {
    await page.evaluate(() => document.activeElement.blur());
    await still(page);
    return new Uint32Array((await pixels_of(page, await page.locator("#stage").boundingBox())).buffer);
  };
  const own = await stage_of(await load(t, "?lesson=obb-pca&step=0", still_page));
  const page = await load(t, "?lesson=scene-broad", still_page);
  await choose(page, "obb-pca");
  const now = await stage_of(page);
  const differ = now.filter((pixel, i) => pixel !== own[i]).length;
  assert.ok(differ < 50, `${differ} pixels of ${own.length} are not as they are in a page that opens with the lesson`);
});

test("Back and Forward lead through lessons and steps without loading anything", async (t) => {
  const [a, b, c] = (await lessons()).map(({ id }) => id);
  const page = await load(t, `?lesson=${a}&step=1`);
  await choose(page, b);
  await page.keyboard.press("Escape");
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press("Home");
  await page.waitForTimeout(400);
  await choose(page, c);
  await page.waitForTimeout(400);
  const asked = watch_requests(page);
  const there = (id, step) =>
    until(page, (now, lesson, at) => now.lesson === lesson && (at === null || now.step === at), id, step);
  await page.goBack();
  await there(b, 0);
  await page.goBack();
  await there(a, 1);
  await page.goForward();
  await there(b, 0);
  await page.goForward();
  await there(c, null);
  assert.deepEqual(asked, []);
  assert.equal(new URL(page.url()).searchParams.get("lesson"), c);
});

test("answers, theme and text size stay as one goes from lesson to lesson", async (t) => {
  const page = await load(t, "?lesson=sphere-ritter&step=0");
  await page.getByRole("button", { name: /^Theme/ }).click();
  await page.getByRole("button", { name: /^Text size/ }).click();
  await page.evaluate(() => document.activeElement.blur());
  let now = await state(page);
  for (let i = 0; i < 9 && !now.asked; ++i) {
    await page.keyboard.press("ArrowRight");
    now = await until(page, (it, step) => it.step > step || it.asked, now.step);
  }
  const { asked } = now;
  await page.getByRole("button", { name: "Skip" }).click();
  const given = (await until(page, (it) => it.outcomes.length === 1)).outcomes;
  await choose(page, "obb-sat");
  assert.deepEqual((await state(page)).outcomes, []);
  await choose(page, "sphere-ritter");
  const back = await state(page);
  assert.deepEqual(back.outcomes, given);
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press("Home");
  await page.keyboard.press("End");
  const on = await until(page, (it) => it.step > 0);
  assert.notEqual(on.asked?.id, asked.id, "it is not asked again");
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), "dark");
  assert.equal(await page.getByRole("button", { name: "Text size: 115 %" }).count(), 1);
});

test("a measurement that runs ends with its lesson", async (t) => {
  const page = await load(t, "?lesson=cost-chart");
  await page.getByRole("button", { name: "Measure", exact: true }).click(); // it asks first
  for (let i = 0; i < 3; ++i) {
    await page.getByRole("button", { name: "Skip" }).click();
    await until(page, (now, before) => now.outcomes.length > before, i);
  }
  await page.getByRole("button", { name: "Measure", exact: true }).click();
  await until(page, (now) => now.cover.running);
  await choose(page, "sphere-ritter");
  assert.equal((await state(page)).cover, null);
  assert.equal(await page.getByRole("button", { name: "Measure", exact: true }).isVisible(), false);
  await still(page);
  await choose(page, "cost-chart");
  const { cover } = await state(page);
  // The empty chart, as at first.
  assert.deepEqual([cover.running, cover.table.rows.length, cover.shown], [false, 0, true]);
});

test("of two lessons asked for at once the later one opens, however late the first one's file comes", async (t) => {
  const [, slow, quick] = (await lessons()).map(({ id }) => id);
  const page = await load(t);
  let let_go;
  const waits = new Promise((resolve) => (let_go = resolve));
  await page.route(`**/lessons/${slow}.toml`, async (route) => {
    await waits;
    await route.continue();
  });
  await page.locator("#picker").click();
  await page.locator(`#lessons a[href="?lesson=${slow}"]`).click();
  await page.locator("#veil").getByText("Loading").waitFor(); // it says so after a while
  assert.equal(
    new URL(page.url()).search,
    `?lesson=${slow}&step=0`,
    "the address is not that of the lesson which still stands",
  );
  await page.goBack();
  await page.locator("#veil").waitFor({ state: "hidden" });
  await choose(page, quick);
  let_go();
  await page.waitForTimeout(500);
  assert.equal((await state(page)).lesson, quick);
  assert.match(page.url(), new RegExp(`lesson=${quick}&`));
});

test("the link to the stage keeps the lesson as it stands", async (t) => {
  const page = await load(t, "?lesson=sphere-ritter&step=0");
  await page.keyboard.press("ArrowRight");
  const { step } = await until(page, (now) => now.step > 0 || now.asked);
  const asked = watch_requests(page);
  await page.locator(".skip").focus();
  await page.keyboard.press("Enter");
  await page.waitForTimeout(400);
  assert.equal((await state(page)).step, step);
  assert.deepEqual(asked, []);
});
