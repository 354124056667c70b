// What every browser test needs: the built site on a static server under a sub-path, Chromium, and a page that must
// neither complain on its console nor ask anything of another host.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { createReadStream, existsSync, readFileSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { chromium } from "playwright-core";
/** @import { Page } from "playwright-core"
 *  @import { TestContext } from "node:test" */

const kSite = process.env.SNUG_SITE ?? fileURLToPath(new URL("../../build/wasm/site", import.meta.url));
const kSubPath = "/course/week-3/snug/";
const kTypes = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".mjs": "text/javascript",
  ".css": "text/css",
  ".svg": "image/svg+xml",
  ".json": "application/json",
  ".png": "image/png",
  ".toml": "text/plain",
  ".otf": "font/otf",
  ".ttf": "font/ttf",
};
const kPacked = new Set([".png"]);
// Mesa draws the stage and the processor the page: less work than SwiftShader.
const kPictureFlags = [
  "--no-sandbox",
  "--use-gl=angle",
  "--use-angle=gl-egl",
  "--ignore-gpu-blocklist",
  "--disable-gpu-rasterization",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--no-first-run",
];
// The processor also puts the stage into the page. That takes nearly half off what a frame costs, but pictures of the
// page then lack parts of the canvas.
const kFlags = [...kPictureFlags, "--disable-gpu-compositing"];

/** A plain static host: no type for .wasm, no listing, gzip where asked for. refuse: paths that answer 503; add: texts
 *  by the paths that they stand at, in place of files. */
export async function serve_site() {
  const refuse = new Set();
  const add = new Map();
  const sent = new Map();
  const packed = new Map();
  const server = createServer((request, answer) => {
    const path = decodeURIComponent(new URL(request.url, "http://localhost").pathname);
    const name = path.startsWith(kSubPath) ? normalize(path.slice(kSubPath.length) || "index.html") : "..";
    const file = join(kSite, name);
    if (refuse.has(name)) return answer.writeHead(503).end();
    if (add.has(name)) return answer.writeHead(200, { "Content-Type": kTypes[extname(file)] }).end(add.get(name));
    if (name.startsWith("..") || !existsSync(file) || !statSync(file).isFile()) return answer.writeHead(404).end();
    const headers = { "Content-Type": kTypes[extname(file)] ?? "application/octet-stream" };
    if (kPacked.has(extname(file)) || !/gzip/.test(request.headers["accept-encoding"] ?? "")) {
      sent.set(name, statSync(file).size);
      return createReadStream(file).pipe(answer.writeHead(200, headers));
    }
    if (!packed.has(file)) packed.set(file, gzipSync(readFileSync(file)));
    const body = packed.get(file);
    sent.set(name, body.length);
    answer.writeHead(200, { ...headers, "Content-Encoding": "gzip" }).end(body);
  });
  server.keepAliveTimeout = 2 * kPatience; // no browser asks over a connection that is just being closed
  await once(server.listen(0, "127.0.0.1"), "listening");
  const { port } = /** @type {import("node:net").AddressInfo} */ (server.address());
  const url = `http://127.0.0.1:${port}${kSubPath}`;
  return { url, refuse, add, sent, close: () => (server.close(), server.closeAllConnections()) };
}

/** How long is waited for what must come, milliseconds: machines that do other work as well may be very slow. */
export const kPatience = 60_000;

let browser;
let site;

/** The site as ./run --lessons serves it: with the lessons of a folder, which may change. */
export async function serve_drafts(lessons) {
  const serve = spawn("python3", [
    fileURLToPath(new URL("../../web/serve.py", import.meta.url)),
    kSite,
    "--port",
    "0",
    "--lessons",
    lessons,
  ]);
  const [said] = await once(serve.stdout, "data");
  const [url] = /http:[^ ,]+/.exec(said);
  return { url, close: () => serve.kill() };
}

/** For a file's before and after hooks. */
export const start = () => start_on(serve_site);

/** The same for a file whose tests look at pictures of the page. */
export const start_for_pictures = () => start_on(serve_site, kPictureFlags);

/** The same where the browser has no graphics card, nor Mesa in its place. */
export const start_without_card = () =>
  start_on(serve_site, ["--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader"]);

/** The same for a site that is served otherwise. */
export async function start_on(serve, flags = kFlags) {
  site = await serve();
  browser = await chromium.launch({ executablePath: process.env.SNUG_CHROMIUM ?? "/usr/bin/chromium", args: flags });
  return site;
}

export async function stop() {
  kept.clear();
  await browser.close();
  site.close();
}

/** What the program may take for a frame, ms: 8, and three times that on the shared machines of CI. */
export const frame_limit = () => (process.env.CI ? 24 : 8);

/** @type {Opened} */
export const kWide = { viewport: { width: 1280, height: 800 } };
/** @type {Opened} */
export const kPhone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

/** The course's first lesson, which most tests are about. */
export const kFirst = "?lesson=sphere-ritter";

/** A page in a context of its own, of one who has seen the invitations on the stage. options: of Playwright's
 *  newContext.
 *  @param {Opened} options */
async function open_page({ newcomer = false, ...options } = {}) {
  const context = await browser.newContext(options);
  if (!newcomer)
    await context.addInitScript(() => {
      if (window.origin !== "null" && !localStorage.getItem("snug-course"))
        localStorage.setItem("snug-course", JSON.stringify({ version: 1, last: null, invited: 3, lessons: {} }));
    });
  const page = await context.newPage();
  page.setDefaultTimeout(kPatience);
  const complaints = [];
  page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
  page.on("pageerror", (error) => complaints.push(error.stack));
  page.on("request", (request) => {
    if (!request.url().startsWith(site.url) && !/^(data|blob):/.test(request.url()))
      complaints.push(`asked for ${request.url()}`);
  });
  return { page, complaints };
}

/** A page on an address of the site, loaded for this test alone. options: of Playwright's newContext, and init: a
 *  function run in the page before anything of it; wait: false where the page is not expected to become ready;
 *  may_complain: of what the test provokes.
 *  @param {TestContext} t @param {Opened} options */
export async function load(t, query = kFirst, options = kWide) {
  const { init, wait = true, may_complain = /^$/, ...screen } = options;
  const { page, complaints } = await open_page({ ...kWide, ...screen });
  if (init) await page.addInitScript(init);
  t.after(async () => {
    await page.context().close();
    assert.deepEqual(complaints.filter((complaint) => !may_complain.test(complaint)), []);
  });
  await page.goto(site.url + query);
  if (wait) await ready(page);
  return page;
}

/** The test fails if the page complains of anything from now on. */
function expect_silence(t, complaints) {
  complaints.length = 0;
  t.after(() => assert.deepEqual(complaints, []));
}

const kept = new Map(); // by their kind of screen: pages that the tests of a file share

/** A page on an address of the site, to one who has answered nothing yet. It may be one that earlier tests have used,
 *  and the same as another visit's in this test: loading a page takes ten times as long as going on in one. Where that
 *  is what is tested, or settings are, use load. options: kWide, kPhone, another viewport, and reducedMotion, which is
 *  "reduce" unless asked for: whatever eases is drawn over and over until it rests.
 *  @param {TestContext} t @param {Opened} options */
export async function visit(t, query = kFirst, options = kWide) {
  const { viewport = kWide.viewport, reducedMotion = "reduce", ...screen } = options;
  const kind = JSON.stringify(screen);
  let own = kept.get(kind);
  if (!own || own.page.isClosed()) kept.set(kind, own = await open_page({ viewport, reducedMotion, ...screen }));
  const { page, complaints } = own;
  expect_silence(t, complaints);
  await page.setViewportSize(viewport);
  await page.emulateMedia({ reducedMotion });
  if (page.url() === "about:blank") {
    await page.goto(site.url + query);
    await ready(page);
    return page;
  }
  await page.mouse.move(0, 0);
  await page.evaluate(async (search) => {
    await window.snug.restart(search);
    document.getElementById("tab-read").click();
    document.activeElement.blur();
    scrollTo(0, 0);
  }, query);
  await still(page);
  return page;
}

/** A page that an earlier test of the file has visited, as that test left it. */
export function revisit(t, page) {
  expect_silence(t, [...kept.values()].find((own) => own.page === page).complaints);
  return page;
}

/** Until the lesson is open and has been drawn, after a load. */
export async function ready(page) {
  await page.waitForFunction(() => Boolean(window.snug?.state()));
  await page.evaluate(() => window.snug.ready);
  await page.waitForFunction(
    () =>
      document.documentElement.classList.contains("no-stage") ||
      window.snug.state().lesson === null ||
      window.snug.state().framesDrawn > 0,
  );
  await still(page);
}

// As texts: Playwright's own way to hand over objects takes three times as long.
/** @param {Page} page @returns {Promise<PageState>} */
export const state = async (page) => JSON.parse(await page.evaluate(() => JSON.stringify(window.snug.state())));
/** @param {Page} page @returns {Promise<Handle[]>} */
export const handles = async (page) => JSON.parse(await page.evaluate(() => JSON.stringify(window.snug.handles())));
export const course = async (of = site) => (await fetch(`${of.url}course.json`)).json();
export const lessons = async (of = site) =>
  (await course(of)).chapters.flatMap(({ title, lessons }) => lessons.map((lesson) => ({ ...lesson, chapter: title })));

/** The text of a lesson's file. */
export const text_of = async (id, of = site) => (await fetch(`${of.url}lessons/${id}.toml`)).text();

/** One lesson of each kind: the first of those whose files name the same volume and the same chart. What the page makes
 *  of a kind is tested on it alone; what depends on a lesson's own words is tested on every lesson. With
 *  SNUG_EVERY_LESSON=1 all lessons are returned, which takes three times as long. */
export async function kinds(of = site) {
  if (process.env.SNUG_EVERY_LESSON) return lessons(of);
  const first = new Map();
  for (const lesson of await lessons(of)) {
    const text = await text_of(lesson.id, of);
    const kind = ["volume", "chart"].map((key) => new RegExp(`^${key} = .*`, "m").exec(text)?.[0]).join();
    if (!first.has(kind)) first.set(kind, lesson);
  }
  return [...first.values()];
}

/** Goes to a lesson by a link in the menu or, by = "back" or "forward", in the history; the milliseconds until it has
 *  been drawn. */
export async function choose(page, id, by = "menu") {
  if (by === "menu") await page.locator("#picker").click();
  return page.evaluate(([to, by]) => new Promise((resolve) => {
    /** @type {HTMLElement} */
    const link = document.querySelector(`#lessons a[href="?lesson=${to}"]`);
    const { framesDrawn } = window.snug.state();
    const from = performance.now();
    if (by === "menu") link.click();
    else history[by]();
    const look = () => {
      const now = window.snug.state();
      if (now.lesson === to && now.framesDrawn > framesDrawn) resolve(performance.now() - from);
      else requestAnimationFrame(look);
    };
    look();
  }), [id, by]);
}

/** Until no frame is drawn any more. */
export async function still(page) {
  await page.evaluate((patience) => new Promise((/** @type {(value?: unknown) => void} */ resolve, reject) => {
    let last = -1;
    let same = 0;
    setTimeout(() => reject(new Error(`frames are drawn for ${patience / 1000} seconds on end`)), patience);
    const look = () => {
      const now = window.snug.frameTimes().at(-1)?.at ?? 0;
      same = now === last ? same + 1 : 0;
      last = now;
      if (same > 4) resolve();
      else requestAnimationFrame(look);
    };
    look();
  }), kPatience);
}

/** What the panels beside the stage tell, as the page has it in HTML: of each its title, its head and its rows. */
export const panel_tables = (page) =>
  page.locator("#panel-words table").evaluateAll((tables) =>
    tables.map((table) => ({
      title: table.caption.textContent,
      head: [...(table.tHead?.rows[0].cells ?? [])].map((cell) => cell.textContent),
      rows: [...table.tBodies[0].rows].map((row) => [...row.cells].map((cell) => cell.textContent)),
    })),
  );

/** Pastes a text, as from a spreadsheet. */
export const paste = (page, text) => page.evaluate((rows) => {
  const clipboardData = new DataTransfer();
  clipboardData.setData("text/plain", rows);
  document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
}, text);

/** Clicks on a handle, once the view stands still. */
export async function tap(page, id) {
  await still(page);
  const { x, y } = (await handles(page)).find((handle) => handle.id === id);
  await page.mouse.click(x, y);
}

/** Drags what is at a handle by so many CSS pixels with the mouse, once the view stands still: it eases after every
 *  edit. */
export async function drag(page, id, dx, dy) {
  await still(page);
  const { x, y } = (await handles(page)).find((handle) => handle.id === id);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + dx, y + dy, { steps: 8 });
  await page.mouse.up();
  await still(page);
}

/** The same with a finger. */
export async function drag_by_finger(page, id, dx, dy) {
  await still(page);
  const { x, y } = (await handles(page)).find((handle) => handle.id === id);
  const touch = await page.context().newCDPSession(page);
  const send = (type, ...points) =>
    touch.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([px, py]) => ({ x: px, y: py })) });
  await send("touchStart", [x, y]);
  for (let i = 1; i <= 6; ++i) await send("touchMove", [x + dx * i / 6, y + dy * i / 6]);
  await send("touchEnd");
  await still(page);
}

/** The first lesson that says yes to test(its file's text). */
export async function lesson_with(test) {
  for (const { id } of await lessons()) if (test(await text_of(id))) return id;
  throw new Error("no lesson is like that");
}

/** What of the column's words is cut off: names in selectors too narrow for them, a question or its outcome that has to
 *  be scrolled. */
export const cut_off = (page) => page.evaluate(find_cut_off);
/** The same, in the page. */
export function find_cut_off() {
  const probe = document.createElement("canvas").getContext("2d");
  const narrow = [...document.querySelectorAll("select")].filter((select) => {
    const style = getComputedStyle(select);
    probe.font = style.font;
    const room = select.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight);
    return select.checkVisibility() && [...select.options].some(({ text }) => probe.measureText(text).width > room);
  });
  const ask = document.getElementById("ask");
  const beyond = ask.scrollHeight - ask.clientHeight;
  return [...narrow.map((select) => `${select.id || select.parentElement.textContent}: ${select.value}`),
    ...(beyond > 1 ? [`${beyond} pixels of ${ask.textContent}`] : [])];
}

/** The words of the page's HTML that are lower than a fortieth of the screen's height. */
export const low_words = (page) => page.evaluate(() => {
  const low = [], all = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = all.nextNode(); node; node = all.nextNode()) {
    const parent = node.parentElement, range = document.createRange();
    range.selectNodeContents(node);
    const { width, height, top } = range.getBoundingClientRect();
    const seen = parent.checkVisibility({ visibilityProperty: true }) && width > 2 && height > 2 && top < innerHeight;
    const size = Number.parseFloat(getComputedStyle(parent).fontSize);
    if (node.textContent.trim() && seen && size < innerHeight / 40 - 0.01) low.push(`${node.textContent}: ${size}`);
  }
  return low;
});

/** Shows the points' tools, which share their place with the lesson's text. */
export const to_points = (page) => page.getByRole("tab", { name: "Points" }).click();

const kLook = 20; // milliseconds

/** Until `test`, a function of window.snug.state(), holds; the state then. patience: in milliseconds. It is not given
 *  to waitForFunction as text, which the page's policy would not let it evaluate.
 *  @param {Page} page @param {(now: PageState, ...given: any[]) => unknown} test @param {...any} given */
export async function until(page, test, ...given) {
  return until_within(kPatience, page, test, ...given);
}

/** @param {number} patience @param {Page} page @param {(now: PageState, ...given: any[]) => unknown} test
 *  @param {...any} given */
export async function until_within(patience, page, test, ...given) {
  for (const end = Date.now() + patience; Date.now() < end; await new Promise((go_on) => setTimeout(go_on, kLook))) {
    const now = await state(page);
    if (now && test(now, ...given)) return now;
  }
  throw new Error(`waited ${patience / 1000} seconds for ${test}`);
}

/** Adds a lesson to those of the site, for pages loaded from now on: its file's text, under an id of its own. */
export async function add_lesson(id, toml) {
  const { chapters } = await course();
  const others = chapters.map((chapter) => ({
    ...chapter,
    lessons: chapter.lessons.filter((lesson) => lesson.id !== id),
  }));
  const lesson = { id, title: id, summary: "", minutes: 1, questions: 0, task: false, words: "" };
  site.add.set(`lessons/${id}.toml`, toml);
  site.add.set(
    "course.json",
    JSON.stringify({
      chapters: [
        ...others.filter(({ title }) => title !== "Tests"),
        { title: "Tests", lessons: [...(others.find(({ title }) => title === "Tests")?.lessons ?? []), lesson] },
      ],
    }),
  );
}

export { assert };

/** The pixels of a part of what is seen, four bytes each. */
export async function pixels_of(page, clip) {
  const picture = await page.screenshot({ clip });
  const text = await page.evaluate(async (base64) => {
    const png = Uint8Array.from(atob(base64), (byte) => byte.charCodeAt(0));
    const image = await createImageBitmap(new Blob([png], { type: "image/png" }));
    const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    let bytes = "";
    for (const byte of data) bytes += String.fromCharCode(byte);
    return btoa(bytes);
  }, picture.toString("base64"));
  return new Uint8Array(Buffer.from(text, "base64"));
}

/** How many pixels of the stage have the colour that volumes are drawn in. */
export async function pixels_of_volume(page) {
  const data = await pixels_of(page, await page.locator("#stage").boundingBox());
  let count = 0;
  for (let i = 0; i < data.length; i += 4)
    if (Math.abs(data[i] - 0x0a) < 12 && Math.abs(data[i + 1] - 0x5f) < 12 && Math.abs(data[i + 2] - 0xbf) < 12)
      ++count;
  return count;
}

/** Gives an answer to what is asked, as a hand would: chooses it, sees it said, chooses it again. One that is wrong at
 *  the first try is followed by another, if there is a second.
 *  what: a choice by its words or its number from 0, or a handle by its name (null: the first that can be the answer);
 *  by: "pointer" (on the stage, or the choice's button) or "keyboard" (digits, or the name typed, and Enter).
 *  Returns the state with its outcome, which is told until go_on. */
export async function answer(page, what = null, by = "pointer") {
  const { asked } = await until(page, (now) => now.asked);
  const now = await answer_once(page, asked, what, by);
  if (!now.asked?.tried || now.asked.id !== asked.id) return now;
  const wrong = now.asked.tried;
  if (asked.choices.length > 0) return answer_once(page, asked, (wrong.choices[0] + 1) % asked.choices.length, by);
  return answer_once(page, asked, asked.targets.find((name) => name !== wrong.handle), by);
}

async function answer_once(page, asked, what, by) {
  const choice = typeof what === "number" ? what : asked.choices.indexOf(what ?? asked.choices[0]);
  const tried = (await state(page)).asked.tried;
  if (by === "keyboard") {
    await answer_by_keys(page, choice >= 0 ? choice : what ?? asked.targets[0], asked);
  } else if (choice >= 0) {
    const chosen = page.locator(".predict .choices .button").nth(choice);
    await chosen.click();
    await page.waitForFunction(() => window.snug.state().asked?.picked);
    await (asked.many ? page.locator(".predict .commit .button") : chosen).click();
  } else {
    await still(page);
    const places = await handles(page);
    const at = places.find(
      ({ id }) => id === (what ?? asked.targets.find((name) => places.some((place) => place.id === name))),
    );
    await page.mouse.click(at.x, at.y);
    const { asked: now } = await until(page, (it) => it.asked?.picked);
    assert.equal(now.picked.handle, at.id);
    await page.waitForTimeout(400); // two taps, no double click
    await page.mouse.click(at.x, at.y);
  }
  const given = (it, id, before) =>
    it.outcome?.question === id ||
    (it.asked?.id === id && !before && it.asked.tried && !it.asked.picked) ||
    (!it.deciding && it.asked?.id !== id && it.outcomes.some(({ question, passed }) => question === id && !passed));
  return until(page, given, asked.id, Boolean(tried));
}

/** Continues where an outcome is told: to what comes next, which may be the outcome of another question. */
export async function go_on(page) {
  const { outcome } = await state(page);
  await page.getByRole("button", { name: "Continue", exact: true }).click();
  return until(page, (now, told) => now.outcome?.question !== told, outcome.question);
}

/** Until the lesson stands elsewhere than before: at another step, question or outcome. */
export const moved = (page, before) =>
  until(
    page,
    (now, step, asked, told) =>
      now.step !== step || (now.asked?.id ?? null) !== asked || (now.outcome?.question ?? null) !== told,
    before.step,
    before.asked?.id ?? null,
    before.outcome?.question ?? null,
  );

async function answer_by_keys(page, what, asked) {
  if (asked.ordered) { // in the order in which they stand, or, at the second try, from the second on
    const from = (await state(page)).asked.tried ? 1 : 0;
    for (const i of asked.choices.keys()) await page.keyboard.press(String((i + from) % asked.choices.length + 1));
    await page.waitForFunction(() => window.snug.state().asked?.ready);
    return page.keyboard.press("Enter");
  }
  if (typeof what === "number") {
    await page.keyboard.press(String(what + 1));
    await page.waitForFunction(() => window.snug.state().asked?.picked);
    return page.keyboard.press("Enter");
  }
  for (let i = 0; i < 60; ++i) {
    if (await page.evaluate(() => ["Name", "Names"].includes(document.activeElement.getAttribute("aria-label")))) break;
    await page.keyboard.press("Tab");
  }
  assert.ok(asked.targets.includes(what), `${what} can be the answer`);
  await page.keyboard.type(what);
  await page.keyboard.press("Enter");
}
