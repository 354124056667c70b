// Every lesson in Firefox and in WebKit: the trace of the native program; of one of each kind a stage that is drawn,
// stepped, dragged by a handle and answered. All else about the page is tested in Chromium. Needs a screen and a
// session bus.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { after, before, describe, test } from "node:test";
import { fileURLToPath } from "node:url";
import { kinds, lessons, serve_site } from "../support.mjs";
import * as firefox from "./firefox.mjs";
import { colors_of, difference, read_png } from "./picture.mjs";
import * as webkit from "./webkit.mjs";

const kEngines = { Firefox: firefox, WebKit: webkit };
const kSize = [1280, 800];
const kPatience = 60_000; // milliseconds: other suites run beside
const kKeys = { "Arrow right": "\uE014", "Page down": "\uE00F", Control: "\uE009" };
const kLeastDrawn = 2000; // pixels that are not the ground's
const kMostWaits = 200; // presses until a lesson asks
const kMostTries = 5; // until a lesson shows all its situations
const kRoot = fileURLToPath(new URL("../../../", import.meta.url));

// From the first moment on, whatever the page complains of is kept. The drivers cannot give both engines such a script:
// it is of the site.
const kListen = `window.complaints = [];
addEventListener("error", ({ message, target }) =>
  complaints.push(message ?? "a file did not arrive: " + (target.src ?? target.href)), true);
addEventListener("unhandledrejection", ({ reason }) => complaints.push(String(reason)));
addEventListener("securitypolicyviolation", ({ violatedDirective, blockedURI, sample }) =>
  complaints.push(violatedDirective + " forbids " + (blockedURI || sample)));
for (const level of ["warn", "error"]) {
  const say = console[level];
  console[level] = (...said) => (complaints.push(said.join(" ")), say(...said));
}`;

const site = await serve_site();
after(() => site.close());
site.add.set("listen.js", kListen);
site.add.set(
  "index.html",
  (await (await fetch(site.url)).text()).replace("<head>", '<head><script src="listen.js"></script>'),
);
const every = await lessons(site);
const played = new Set((await kinds(site)).map(({ id }) => id));
// "LESSON STEPS HASH" a line: of all runs that a lesson offers.
const native = new Map(
  execFileSync(process.env.SNUG ?? `${kRoot}build/release/snug`, ["trace-hash"], { encoding: "utf8" })
    .trim()
    .split("\n")
    .map((line) => [line.split(" ")[0], line]),
);

/** One page of an engine, as a hand, an eye and a script have it. */
class Page {
  #engine;
  constructor(engine) {
    this.#engine = engine;
  }
  /** Opens an address of the site, in the page that stands there where one does, and waits until it is drawn. */
  async open(query) {
    if (await this.ask("Boolean(window.snug)")) {
      await this.ask(`(complaints.length = 0, snug.restart(${JSON.stringify(query)}))`);
    } else {
      await this.#engine.open(site.url + query);
      await this.until("window.snug?.state()?.framesDrawn > 0", "the lesson is drawn");
      await this.ask("snug.ready");
    }
    const { lesson } = Object.fromEntries(new URLSearchParams(query));
    await this.until(`snug.state()?.lesson === ${JSON.stringify(lesson)}`, "it is the lesson that was asked for");
    await this.ask("document.activeElement.blur()");
    await this.still();
  }
  ask(expression) {
    return this.#engine.evaluate(expression);
  }
  state() {
    return this.ask("snug.state()");
  }
  /** Until an expression holds in the page. */
  async until(expression, what) {
    const held = await this.ask(`new Promise((resolve) => {
      const late = performance.now() + ${kPatience};
      const look = () => {
        if (${expression}) resolve(true);
        else if (performance.now() > late) resolve(false);
        else setTimeout(look, 20);
      };
      look();
    })`);
    if (!held)
      assert.fail(
        `waited in vain until ${what}; the page complains: ${JSON.stringify(await this.ask("window.complaints"))}` +
          ` and shows at ${await this.ask("location.search")}: ${await this.ask("document.body.innerText")}`,
      );
  }
  /** Until the browser has come round several times, and no frame was drawn. */
  async still() {
    await this.ask(`new Promise((resolve, reject) => {
      const late = performance.now() + ${kPatience};
      let rounds = 0, drawn = -1;
      const look = () => {
        const { framesDrawn } = snug.state();
        rounds = framesDrawn === drawn ? rounds + 1 : 0;
        drawn = framesDrawn;
        if (rounds > 4) resolve();
        else if (performance.now() > late) reject(new Error("frames are drawn on end"));
        else requestAnimationFrame(look);
      };
      requestAnimationFrame(look);
    })`);
  }
  async press(key, ...held) {
    const ids = [...held, key].map((name) => kKeys[name] ?? name);
    const actions = [
      ...ids.map((value) => ({ type: "keyDown", value })),
      ...ids.reverse().map((value) => ({ type: "keyUp", value })),
    ];
    await this.#engine.perform([{ type: "key", id: "keyboard", actions }]);
  }
  /** Presses at the first place of the stage, goes on over the others, and lets go. */
  async hand(...places) {
    await this.point(...places);
    await this.still();
  }
  async point(...places) {
    const move = ([x, y]) => ({
      type: "pointerMove",
      origin: "viewport",
      x: Math.round(x),
      y: Math.round(y),
      duration: 20,
    });
    const pause = { type: "pause", duration: 40 }; // a frame in which the stage sees where the pointer is
    await this.#engine.perform([
      {
        type: "pointer",
        id: "mouse",
        parameters: { pointerType: "mouse" },
        actions: [
          move(places[0]),
          pause,
          { type: "pointerDown", button: 0 },
          pause,
          ...places.slice(1).flatMap((place) => [move(place), pause]),
          { type: "pointerUp", button: 0 },
        ],
      },
    ]);
  }
  async picture() {
    return read_png(await this.#engine.screenshot());
  }
  /** Where an element is seen: {x, y, width, height}. */
  place(selector) {
    return this.ask(
      `(({ x, y, width, height }) => ({ x, y, width, height }))(
        document.querySelector(${JSON.stringify(selector)}).getBoundingClientRect())`,
    );
  }
  async click(selector) {
    await this.ask(`document.querySelector(${JSON.stringify(selector)}).scrollIntoView({ block: "center" })`);
    const { x, y, width, height } = await this.place(selector);
    await this.point([x + width / 2, y + height / 2]);
  }
}

/** What the runs of every situation and algorithm of the lesson that is open are like; null if the page refused a
 *  situation because it had measured that its points would take too long. */
const runs_of = (page) =>
  page.ask(`(async () => {
    const select = document.getElementById("algorithm");
    const choose = (name) => {
      select.value = name;
      select.dispatchEvent(new Event("change"));
      return snug.state();
    };
    const situations = [...document.querySelectorAll('input[name="situation"]')];
    const runs = [];
    for (const situation of situations.length > 0 ? situations : [null]) {
      situation?.click();
      while (snug.state().preparing) await new Promise((later) => setTimeout(later, 20));
      if (situation && snug.state().situation !== situation.value) return null;
      const names = [...select.options].map(({ value }) => value);
      const all = names.map((name) => [name, choose(name)]).filter(([name, now]) => now.algorithm === name);
      choose(names[0]);
      runs.push(...all.map(([, { steps, trace }]) => ({ steps, trace })));
    }
    return runs;
  })()`);

/** The line of a lesson that is open as `snug trace-hash` prints it: each run's hash is folded in (FNV-1a). */
async function line_of(page, id) {
  let runs = null; // beside other suites the page may take its points for too slow
  for (let tries = 0; !runs && tries < kMostTries; ++tries) runs = await runs_of(page);
  assert.ok(runs, `${id} refuses the points of a situation, ${kMostTries} times`);
  let hash = 0xcbf29ce484222325n;
  for (const { trace } of runs)
    for (let bits = BigInt(`0x${trace}`), byte = 0; byte < 8; ++byte, bits >>= 8n)
      hash = BigInt.asUintN(64, (hash ^ (bits & 0xffn)) * 0x100000001b3n);
  return `${id} ${runs.reduce((sum, { steps }) => sum + steps, 0)} ${hash.toString(16).padStart(16, "0")}`;
}

const given = (now) => now.outcomes.filter((outcome) => !outcome.skipped);

/** Drags a handle, and takes it back. picture: as the page looks before. A point inside of all others may change no
 *  run: then one on the outside is dragged as well. */
async function drags(page, picture) {
  const before = await page.state();
  const handles = await page.ask("snug.handles()");
  if (before.cover) return; // its points are on the other side: marks and pictures are not dragged
  assert.ok(handles.length > 0, "there is nothing to drag");
  const leftmost = handles.reduce((a, b) => (b.x < a.x ? b : a));
  let drags = 0;
  for (const { x, y } of [handles[0], leftmost]) {
    await page.hand([x, y], [x + 12, y + 8], [x + 24, y + 15], [x + 33, y + 21]);
    await page.until("snug.state().canUndo", "what was dragged can be taken back");
    ++drags;
    if ((await page.state()).trace !== before.trace) break;
  }
  const moved = (await page.ask("snug.handles()")).some(({ id, x, y }) =>
    handles.some((old) => old.id === id && Math.hypot(x - old.x, y - old.y) > 10),
  );
  assert.ok(moved || (await page.state()).trace !== before.trace, "what was dragged has moved, or has changed the run");
  assert.ok(difference(picture, await page.picture(), await page.place("#stage")) > 200, "and the stage shows it");
  for (; drags > 0; --drags) await page.press("z", "Control");
  await page.until(`!snug.state().canUndo && snug.state().trace === "${before.trace}"`, "it is as before the drag");
}

/** Steps on until something is asked; lessons that ask at once are not stepped. */
async function steps_to_a_question(page) {
  for (let presses = 0; presses < kMostWaits; ++presses) {
    const { step, steps, asked, cover } = await page.state();
    if (asked) return asked;
    if (cover) { // it asks once measuring is wanted
      await page.press("m");
      await page.until("snug.state().asked", "it asks before it measures");
      continue;
    }
    assert.ok(step < steps, "the lesson asks nothing");
    await page.press(presses % 2 === 0 ? "Arrow right" : "Page down");
    await page.until(`snug.state().step > ${step} || snug.state().asked`, `step ${step} is left`);
  }
  throw new Error(`${kMostWaits} presses, and nothing is asked`);
}

/** Answers with the mouse: chooses, and taps what is chosen once more. A number is typed. */
async function answers(page, asked) {
  // Decided, or wrong at the first of two tries.
  const answered = `snug.state().outcomes.some((each) => each.question === ${JSON.stringify(asked.id)})
    || Boolean(snug.state().asked?.tried)`;
  const tap =
    asked.field === "Number"
      ? null
      : asked.choices.length > 0
        ? () => page.click(".predict .choices .button")
        : await tap_on_stage(page, asked);
  if (asked.field === "Number") {
    await page.click(".predict input");
    await page.press("7");
    return page.click(".predict .button.primary").then(() => page.until(answered, "the number is taken"));
  }
  await tap();
  for (let i = 1; asked.ordered && i < asked.choices.length; ++i) // an order is whole when everything has its place
    await page.ask(`document.querySelectorAll(".predict .choices .button")[${i}].click()`);
  if (asked.many || asked.ordered) await page.click(".predict .button.primary");
  else if (!(await page.ask(answered))) {
    await page.ask("new Promise((later) => setTimeout(later, 400))"); // two taps, no double click
    await tap();
  }
  await page.until(answered, "the answer is taken");
}

async function play(page, picture) {
  await drags(page, picture);
  const { step, framesDrawn } = await page.state();
  await answers(page, await steps_to_a_question(page));
  const now = await page.state();
  assert.ok(given(now).length === 1 || now.asked.tried, "it is decided, or to be tried once more");
  assert.ok(now.framesDrawn > framesDrawn && now.step >= step);
}

async function tap_on_stage(page, asked) {
  await page.still(); // the stage has made room for the card
  const handles = await page.ask("snug.handles()");
  const names = asked.targets ?? asked.stagePoints.map((i) => `P${i}`);
  const { x, y } = handles.find(({ id }) => names.length === 0 || names.includes(id));
  return () => page.hand([x, y]);
}

function is_drawn_on(picture, stage) {
  const [ground, ...drawn] = colors_of(picture, stage);
  const painted = drawn.reduce((sum, [, count]) => sum + count, 0);
  assert.ok(
    painted > kLeastDrawn && drawn.length > 8,
    `of ${ground[1] + painted} pixels ${painted} are drawn on, in ${drawn.length} colours`,
  );
}

for (const [name, driver] of Object.entries(kEngines)) {
  describe(name, () => {
    let engine;
    before(async () => (engine = await driver.launch(...kSize)), { timeout: 120_000 });
    after(() => engine?.close());

    for (const { id } of every) {
      test(
        `${name}: ${id} runs as it does natively${played.has(id) ? "; is drawn, dragged, stepped and answered" : ""}`,
        { timeout: 180_000 },
        async () => {
          const page = new Page(engine);
          await page.open(`?lesson=${id}&step=0`);
          if (played.has(id)) {
            const picture = await page.picture();
            is_drawn_on(picture, await page.place("#stage"));
            await play(page, picture);
          }
          assert.equal(await line_of(page, id), native.get(id), "every run is the native program's");
          // Firefox says so where a size that was watched changed once more in the same frame, which is no fault.
          assert.deepEqual(
            (await page.ask("complaints")).filter((said) => !said.startsWith("ResizeObserver loop completed")),
            [],
          );
          const foreign = await page.ask(
            `performance.getEntriesByType("resource").map((each) => each.name).filter((each) =>
              !each.startsWith(${JSON.stringify(site.url)}) && !/^(data|blob):/.test(each))`,
          );
          assert.deepEqual(foreign, []);
        },
      );
    }
  });
}
