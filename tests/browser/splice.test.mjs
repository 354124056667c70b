// An exercise in a frame of a page of another origin, which collects the marks: the very page of web/README.md.
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { once } from "node:events";
import { after, before, test } from "node:test";
import { assert, load, start, stop } from "./support.mjs";
import { answers_of } from "./package_support.mjs";

const [, kPage] = /```html\n([^]*?)```/.exec(readFileSync(new URL("../../web/README.md", import.meta.url), "utf8"));
const kExercise = "?exercise=aabb-overlap&seed=4&embed=1";
let site, other, page_of;
before(async () => {
  site = await start();
  other = createServer((request, answer) =>
    answer.writeHead(200, { "Content-Type": "text/html" }).end(page_of[request.url.slice(1)] ?? ""));
  await once(other.listen(0, "127.0.0.1"), "listening");
  const framed = kPage.replace(/src="[^"]*"/, `src="${site.url}${kExercise}"`);
  const silent = framed.replace(/<script>[^]*/, "");
  page_of = {
    collects: framed,
    written: framed.replace(kExercise, "?exercise=write:overlap-min-max&embed=1"),
    silent,
    // A frame beside it answers in the page's place.
    beside: `${silent}<iframe src="liar"></iframe>`,
    liar: `<script>setInterval(() => parent.frames[0].postMessage({ subject: "SPLICE.getState.response",
      message_id: "1", state: "snug1.9.1.|x" }, "*"), 50)</script>`,
  };
});
after(() => (other.close(), stop()));

const kForeign = /^asked for http:\/\/127[.]0[.]0[.]1:\d+\/(collects|written|silent|beside|liar|favicon)|404/;
/** The page of another origin, and the frame in it once the exercise stands there. */
async function around(t, name, init = () => {}) {
  const page = await load(t, "", { wait: false, may_complain: kForeign, init });
  await page.goto(`http://127.0.0.1:${other.address().port}/${name}`);
  return { page, frame: await framed_in(page) };
}
async function framed_in(page) {
  const frame = page.frames().find((own) => own.url().startsWith(site.url));
  await frame.waitForFunction(() => window.snug?.state()?.asked);
  return frame;
}
const collected = (page) => page.evaluate(() => JSON.parse(localStorage.getItem("snug") ?? "null"));
const says = (frame) => frame.locator(".ask .saved span").textContent();

async function decide(frame, i) {
  await frame.waitForFunction((at) => window.snug.state().asked && window.snug.exercise().decision === at, i);
  await frame.locator(".ask .choices .button").nth(answers_of("aabb-overlap", 4)[i]).click();
}

test("the page of the README collects the mark, and gives back the decision", async (t) => {
  const { page, frame } = await around(t, "collects");
  assert.equal(await says(frame), "Goes to the page around this one");
  assert.equal(await collected(page), null);
  await decide(frame, 0);
  await frame.waitForFunction(() => window.snug.saved() === "course");
  assert.equal(await says(frame), "Handed to the page around this one");
  const { of } = await frame.evaluate(() => window.snug.exercise());
  assert.equal((await collected(page)).score, Math.round(1000 / of) / 1000);
  assert.equal(await frame.evaluate(() => localStorage.getItem("snug-course.frame")), null);
  await page.reload();
  const again = await framed_in(page);
  assert.equal((await again.evaluate(() => window.snug.exercise())).decision, 1);
  assert.equal(await says(again), "Seen again in the page around this one");
  for (let i = 1; i < of; ++i) await decide(again, i);
  await page.waitForFunction(() => JSON.parse(localStorage.getItem("snug")).score === 1);
});

test("code that is written in a frame comes back with the page around it", async (t) => {
  const page = await load(t, "", { wait: false, may_complain: kForeign });
  const open = async () => {
    await page.goto(`http://127.0.0.1:${other.address().port}/written`);
    const frame = page.frames().find((own) => own.url().startsWith(site.url));
    await frame.locator(".cm-content").waitFor();
    return frame;
  };
  const frame = await open();
  await frame.locator(".cm-content").click();
  await page.keyboard.type("// mine");
  await frame.waitForFunction(() => window.snug.saved() === "course");
  const again = await open();
  assert.match(await again.locator(".cm-content").textContent(), /[/][/] mine/);
  assert.equal(await again.locator(".saved span").textContent(), "Seen again in the page around this one");
});

test("a page that does not answer is told nothing but the frame's address; the device keeps it", async (t) => {
  for (const name of ["silent", "beside"]) {
    const { page, frame } = await around(t, name);
    const told = page.evaluate(() => new Promise((done) => {
      const all = [];
      addEventListener("message", ({ data }) => all.push(data.subject));
      setTimeout(() => done(all), 800);
    }));
    assert.equal(await says(frame), "Kept on this device", name);
    await decide(frame, 0);
    await frame.waitForFunction(() => window.snug.exercise().decision === 1);
    assert.deepEqual(await told, []);
    assert.equal(await frame.evaluate(() => window.snug.saved()), "device");
  }
});

test("where a foreign frame may keep nothing, it is said, and all else works", async (t) => {
  const { frame } = await around(t, "silent", () => {
    if (window !== parent)
      Object.defineProperty(window, "localStorage", { get: () => { throw new DOMException("no", "SecurityError"); } });
  });
  assert.equal(await says(frame), "Kept nowhere: save the file before you leave");
  assert.equal(await frame.evaluate(() => window.snug.saved()), "nowhere");
  await decide(frame, 0);
  await frame.waitForFunction(() => window.snug.exercise().mark === 1);
  assert.equal(await frame.evaluate(() => JSON.parse(window.snug.result()).attempts[0].mark), 1);
});

test("the dialog Share has the address, and a frame to copy, of a figure and of an exercise", async (t) => {
  const page = await load(t, "?exercise=aabb-overlap&seed=4");
  const shared = async () => {
    await page.locator("#share").click();
    await page.locator("dialog textarea").nth(1).waitFor();
    const [address, frame] = await page.locator("dialog textarea").evaluateAll((all) => all.map(({ value }) => value));
    await page.keyboard.press("Escape");
    await page.locator("dialog").waitFor({ state: "detached" });
    return { address, src: /src="([^"]*)"/.exec(frame)[1].replaceAll("&amp;", "&"), frame };
  };
  const exercise = await shared();
  assert.deepEqual([exercise.address, exercise.src], [page.url(), `${site.url}?exercise=aabb-overlap&embed=1`]);
  await page.evaluate(() => window.snug.restart("?lesson=sphere-ritter&step=2"));
  await page.waitForFunction(() => location.search.includes("seed="));
  const figure = await shared();
  assert.equal(figure.src, `${page.url()}&embed=1`);
  assert.match(figure.frame, /^<iframe src="[^"]*" title="[^"]+" width="800" height="600" style="border: 0"/);
});
