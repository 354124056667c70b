// What the page costs: bytes on the wire, the way from lesson to lesson, and the program's time for a frame while
// dragging and while 2,000 bodies move (told, and held to no time).
import { after, before, test } from "node:test";
import {
  kFirst, assert, choose, handles, kinds, lesson_with, load, pixels_of, start_for_pictures, state, still, stop, text_of,
  until,
} from "./support.mjs";

let site;
before(async () => (site = await start_for_pictures()));
after(stop);

test("a first view is at most 1,531 kB on the wire", async (t) => {
  site.sent.clear();
  await load(t);
  const total = [...site.sent.values()].reduce((sum, size) => sum + size, 0);
  t.diagnostic(`${total} bytes in ${site.sent.size} files; the program ${site.sent.get("snug.wasm")}`);
  assert.ok(site.sent.size > 10 && total > 100_000, "it was counted");
  assert.ok(total <= 1_531_000, `${total} bytes`);
});

const kQuietLooks = 3; // after so many that show nothing new, the page waits

/** How often the page waits for answers before its first frame: whatever it has asked for is answered at once, when it
 *  asks for nothing more. */
async function round_trips(t, query) {
  const page = await load(t, "icon.svg", { wait: false, may_complain: /404/ }); // it has no icon of its own
  const held = [];
  await page.route("**", (route) => void held.push(route));
  const going = page.goto(site.url + query);
  const drawn = () => page.evaluate(() => window.snug?.state()?.framesDrawn > 0).catch(() => false);
  let [trips, before, quiet] = [0, -1, 0];
  for (const late = Date.now() + 40_000; Date.now() < late; await new Promise((later) => setTimeout(later, 300))) {
    if (trips > 0 && (await drawn())) break; // what is still asked for, the first frame did not need
    quiet = held.length === before ? quiet + 1 : 0;
    before = held.length;
    if (held.length === 0 || quiet < kQuietLooks) continue;
    trips += 1;
    t.diagnostic(`${trips}: ${held.map((route) => route.request().url().slice(site.url.length)).join(" ")}`);
    await Promise.all(held.splice(0).map((route) => route.continue()));
    before = -1;
  }
  await going;
  await page.unrouteAll();
  return trips;
}

test("a lesson's first frame takes three round trips, and its mesh a fourth", async (t) => {
  assert.ok((await round_trips(t, kFirst)) <= 3);
  const mesh = await lesson_with((text) => /^mesh = /m.test(text));
  assert.ok((await round_trips(t, `?lesson=${mesh}`)) <= 4);
});

const middle_of = (times) => [...times].sort((a, b) => a - b)[Math.floor(times.length / 2)];

test("from lesson to lesson, and back and forward, half of the ways take less than 300 ms", async (t) => {
  const all = (await kinds()).map(({ id }) => id);
  const page = await load(t, `?lesson=${all[0]}`);
  const told = (id, took, way) => t.diagnostic(`${id}: ${took.toFixed(0)} ms, ${way}`) ?? took;
  const first = [], back = [], forward = [];
  for (const id of all.slice(1)) {
    await still(page);
    const took = told(id, await choose(page, id), "the first time");
    // A mesh is loaded as well, thousands of bodies take time of their own, and a chart takes the stage's place.
    if (!/^(mesh|chart) = |^objects = /m.test(await text_of(id))) first.push(took);
  }
  for (const id of all.slice(0, -1).reverse()) {
    await still(page);
    back.push(told(id, await choose(page, id, "back"), "back"));
  }
  for (const id of all.slice(1)) {
    await still(page);
    forward.push(told(id, await choose(page, id, "forward"), "forward"));
  }
  assert.ok(first.length > 5, `${first.length} lessons were timed`);
  for (const [way, times] of Object.entries({ first, back, forward })) {
    t.diagnostic(`${way}: median ${middle_of(times).toFixed(0)} ms, at most ${Math.max(...times).toFixed(0)} ms`);
    assert.ok(middle_of(times) < 300, `${way}: ${middle_of(times)} ms`);
  }
});

test("no layer nearly as large as the canvas is drawn over it", async (t) => {
  const page = await load(t);
  const inspector = await page.context().newCDPSession(page);
  let layers = [];
  inspector.on("LayerTree.layerTreeDidChange", (event) => (layers = event.layers ?? layers));
  await inspector.send("DOM.enable");
  await inspector.send("LayerTree.enable");
  const box = await page.locator("#canvas").boundingBox();
  const place = ({ transform, offsetX, offsetY }) => ({
    x: offsetX + (transform?.[12] ?? 0),
    y: offsetY + (transform?.[13] ?? 0),
  });
  const is_canvas = (layer) => layer.width === box.width && layer.height === box.height && place(layer).x === box.x;
  for (let tries = 0; tries < 50 && !layers.some(is_canvas); ++tries) {
    await page.mouse.move(box.x + 200 + tries, box.y + 200); // layers are told as the page draws
    await page.waitForTimeout(100);
  }
  const canvas = layers.findIndex(is_canvas);
  assert.ok(canvas >= 0, `the canvas is among ${layers.length} layers`);
  const covered = layers.slice(canvas + 1).filter((layer) => layer.drawsContent).map((layer) => {
    const { x, y } = place(layer);
    const across = Math.min(x + layer.width, box.x + box.width) - Math.max(x, box.x);
    const down = Math.min(y + layer.height, box.y + box.height) - Math.max(y, box.y);
    return Math.max(0, across) * Math.max(0, down);
  });
  const share = covered.reduce((sum, area) => sum + area, 0) / (box.width * box.height);
  t.diagnostic(`${(100 * share).toFixed(1)} % of the canvas`);
  assert.ok(share > 0 && share < 0.6, `${(100 * share).toFixed(0)} % of it`); // the numbers, and the code below them
});

/** Drags a handle round and round for two seconds of frames. */
async function drag_around(t, page) {
  await still(page);
  const before = await state(page);
  const box = await page.locator("#stage").boundingBox();
  const middle = [box.x + box.width / 2, box.y + box.height / 2];
  const near = (a) => Math.hypot(a.x - middle[0], a.y - middle[1]);
  const handle = (await handles(page)).reduce((a, b) => (near(b) < near(a) ? b : a));
  await page.mouse.move(handle.x, handle.y);
  await page.mouse.down();
  await page.evaluate(
    ([x, y]) =>
      new Promise((/** @type {(value?: unknown) => void} */ done) => {
        const stage = document.getElementById("stage");
        const begin = performance.now();
        window.snug.frameTimes().length = 0;
        const move = () => {
          const turn = (performance.now() - begin) / 300;
          stage.dispatchEvent(
            new PointerEvent("pointermove", {
              pointerId: 1,
              pointerType: "mouse",
              buttons: 1,
              bubbles: true,
              clientX: x + 60 * Math.sin(turn),
              clientY: y + 60 * (1 - Math.cos(turn)),
            }),
          );
          if (performance.now() - begin < 2000) requestAnimationFrame(move);
          else done();
        };
        move();
      }),
    [handle.x, handle.y],
  );
  const times = await page.evaluate(() => window.snug.frameTimes().map(({ at, cost }) => [at, cost]));
  await page.mouse.up();
  await until(page, (now, trace) => now.trace !== trace, before.trace);
  const costs = times.map(([, cost]) => cost).sort((a, b) => a - b);
  const rate = (times.length - 1) / ((times.at(-1)[0] - times[0][0]) / 1000);
  const [median, slow] = [0.5, 0.95].map((share) => costs[Math.floor(share * (costs.length - 1))].toFixed(1));
  t.diagnostic(
    `${before.size} points, ${before.steps} steps: ${rate.toFixed(0)} frames a second; ` +
      `the program's time for one: median ${median} ms, 95 % under ${slow} ms`,
  );
  assert.ok(times.length > 5, "frames were drawn while dragging");
}

test("dragging among 1,000 points of the plane draws frames and follows", async (t) => {
  const id = await lesson_with((text) => /generate = /.test(text) && /"welzl"/.test(text) && !/dim = 3/.test(text));
  const points = Array.from(
    { length: 1000 },
    (_, i) => `${Math.cos(i * 2.399963) * Math.sqrt(i / 1000)} ${Math.sin(i * 2.399963) * Math.sqrt(i / 1000)}`,
  );
  const page = await load(t, `?lesson=${id}`);
  await page
    .locator("#points input[type=file]")
    .setInputFiles({ name: "thousand.xyz", mimeType: "text/plain", buffer: Buffer.from(points.join("\n")) });
  await until(page, (now) => now.size === 1000);
  await drag_around(t, page);
});

test("dragging a vertex of the bunny draws frames and follows", async (t) => {
  const id = await lesson_with((text) => /bunny/.test(text));
  const page = await load(t, `?lesson=${id}&from=bunny`);
  assert.equal((await state(page)).size, 1839);
  await drag_around(t, page);
});

/** In the page, before anything of it: scene-broad asks nothing, and comes with bodies so small that thousands have
 *  room. */
function smaller_bodies(half_extents) {
  const own = window.fetch;
  window.fetch = async (path, ...more) => {
    const answer = await own(path, ...more);
    if (!/scene-broad[.]toml$/.test(String(path))) return answer;
    const text = (await answer.text())
      .replace("[0.30, 0.07, 0.12]", half_extents ?? "[0.048, 0.016, 0.032]")
      .replace(/\[\[question\]\][^]*/, "");
    return new Response(text);
  };
}

/** As smaller_bodies, and at each point stand two, in a few frames: more than 65,536 corners of faces. */
const twice_as_many = `(${smaller_bodies})("[0.008, 0.004, 0.006]");
  const once = window.fetch;
  window.fetch = async (path, ...more) => {
    const answer = await once(path, ...more);
    if (!/scene-broad[.]toml$/.test(path)) return answer;
    const text = (await answer.text()).replace("frames = 120", "frames = 4").replace("[[scene.effect]]",
      '[[scene.body]]\\nshape = "box"\\nhalf_extents = [0.008, 0.004, 0.006]\\nat_points = true\\n' +
      'position = [0.02, 0.02, 0.02]\\n\\n[[scene.effect]]');
    return new Response(text);
  };`;

test("of 8,000 bodies each is drawn where it is", async (t) => {
  const page = await load(t, "?lesson=scene-broad&step=0&from=cube:4000", { init: twice_as_many });
  await still(page);
  const places = await handles(page);
  const stage = await page.locator("#stage").boundingBox();
  const seen = places.filter(
    ({ x, y }) =>
      x > stage.x + 60 && x < stage.x + stage.width - 60 && y > stage.y + 60 && y < stage.y + stage.height - 120,
  );
  assert.ok(seen.length > 2000, `${seen.length} are on the stage`);
  const pixels = new Uint32Array((await pixels_of(page, stage)).buffer);
  const width = Math.round(stage.width);
  const at = ({ x, y }) => pixels[Math.floor(y - stage.y) * width + Math.floor(x - stage.x)];
  const often = new Map();
  for (const pixel of pixels) often.set(pixel, (often.get(pixel) ?? 0) + 1);
  const [ground] = [...often].reduce((a, b) => (a[1] > b[1] ? a : b));
  const drawn = seen.filter((place) => at(place) !== ground).length / seen.length;
  t.diagnostic(`${Math.round(100 * drawn)} % of ${seen.length} have a body's colour in their middle`);
  assert.ok(drawn > 0.98);
});

test("2,000 moving bodies, by broad and then narrow phase, are simulated and drawn", async (t) => {
  const page = await load(t, "?lesson=scene-broad&step=1&from=cube:2000", { init: smaller_bodies });
  const { effects, readout, size } = await state(page);
  assert.equal(size, 2000);
  assert.equal(readout.all_pairs, 1_999_000);
  assert.ok(
    readout.after_broad > 1000 && readout.after_loose < readout.after_broad && readout.touching < readout.after_loose,
  );
  await page.locator("#canvas").focus();
  await page.evaluate(() => (window.snug.frameTimes().length = 0));
  await page.keyboard.press(" ");
  const end = await until(page, (now) => now.step === now.steps && !now.playing);
  const times = await page.evaluate(() => window.snug.frameTimes().map(({ at, cost }) => [at, cost]));
  assert.deepEqual(end.effects.map(({ run }) => run), Array(5).fill(end.steps));
  const costs = times.map(([, cost]) => cost).sort((a, b) => a - b);
  const rate = (times.length - 1) / ((times.at(-1)[0] - times[0][0]) / 1000);
  const [median, slow] = [0.5, 0.95].map((share) => costs[Math.floor(share * (costs.length - 1))].toFixed(1));
  const simulated = effects.map(({ effect, microseconds }) => `${effect} ${microseconds}`).join(", ");
  t.diagnostic(
    `${readout.after_broad} pairs after the boxes, ${readout.after_loose} after the spheres, ` +
      `${readout.touching} touch; a frame's effects, µs: ${simulated}`,
  );
  t.diagnostic(
    `${rate.toFixed(0)} frames a second; the program's time to draw one: median ${median} ms, 95 % under ${slow} ms`,
  );
  assert.ok(times.length > 0, "frames were drawn"); // where others have the processors, playing passes over most
});
