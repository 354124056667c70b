// The address is the state: copied or loaded again it leads to the same place, and a wrong one harms nothing.
import { after, before, test } from "node:test";
import {
  assert, kFirst, kWide, handles, lesson_with, lessons, load, ready, start, state, stop, until, visit,
} from "./support.mjs";

before(start);
after(stop);

const kept = ({ lesson, step, seed, trace, algorithm, beside, size }) => ({
  lesson,
  step,
  seed,
  trace,
  algorithm,
  beside,
  size,
});
const flat = (text) => /generate = /.test(text) && !/dim = 3/.test(text);

/** Waits until the address has caught up, loads it again and gives both states. */
async function again(page) {
  await page.waitForTimeout(400); // the page's own delay: browsers count how often an address is replaced
  const before = kept(await state(page));
  await page.reload();
  await ready(page);
  return [before, kept(await state(page))];
}

test("loading the address again finds lesson, step, seed and trace", async (t) => {
  const page = await visit(t, `?lesson=${(await lessons())[1].id}&step=2&seed=7`);
  const opened = await state(page);
  assert.deepEqual([opened.step, opened.seed], [2, 7]);
  const [before, after] = await again(page);
  assert.deepEqual(after, before);
});

test("the address follows steps, algorithms and dragged points", async (t) => {
  const page = await visit(t, `?lesson=${await lesson_with(flat)}`);
  const first = await state(page);
  const [handle] = await handles(page);
  await page.mouse.move(handle.x, handle.y);
  await page.mouse.down();
  await page.mouse.move(handle.x + 35, handle.y + 20, { steps: 5 });
  await page.mouse.up();
  await until(page, (now, trace) => now.trace !== trace, first.trace);
  await page.getByLabel("Compare with").selectOption({ index: 1 });
  await page.keyboard.press("Escape");
  const [before, after] = await again(page);
  assert.deepEqual(after, before);
  assert.match(new URL(page.url()).search, /moved=|rows=/);
});

test("the address has the view that a hand has made, until everything is shown again", async (t) => {
  const page = await load(t, "?lesson=obb-axes&step=3", { reducedMotion: "reduce" });
  assert.doesNotMatch(page.url(), /camera/);
  for (let press = 0; press < 3; ++press) await page.keyboard.press("Control+ArrowLeft");
  await page.mouse.move(700, 300);
  await page.mouse.wheel(0, 200);
  await page.keyboard.press("ArrowRight");
  await page.waitForURL(/camera=-?[\d.]+,/);
  const before = await handles(page);
  await again(page);
  for (const [i, { id, x, y }] of (await handles(page)).entries()) {
    assert.equal(id, before[i].id);
    assert.ok(Math.hypot(x - before[i].x, y - before[i].y) < 2, `${id} is where it was`);
  }
  await page.keyboard.press("0");
  await page.keyboard.press("ArrowLeft");
  await page.waitForURL((url) => !url.search.includes("camera"));
});

test("a handful of points of one's own is in the address", async (t) => {
  const page = await visit(t, `?lesson=${await lesson_with(flat)}&points=0,0;4.125,0;1e-3,-2.5&a=welzl`);
  assert.equal((await state(page)).size, 3);
  const [before, after] = await again(page);
  assert.deepEqual(after, before);
});

test("Share copies the address", async (t) => {
  const page = await visit(t);
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.getByRole("button", { name: "Share" }).click();
  await page.getByText("The address is copied").waitFor();
  await page.keyboard.press("Escape");
  assert.equal(await page.evaluate(() => navigator.clipboard.readText()), page.url());
});

test("the menu leads to another lesson, and Back returns", async (t) => {
  const page = await visit(t);
  const [first, second] = await lessons();
  await page.getByRole("button", { name: first.title }).click();
  await page.getByRole("link", { name: second.title }).click();
  await until(page, (now, id) => now.lesson === id, second.id);
  await page.waitForFunction((title) => document.getElementById("title").textContent === title, second.title);
  await page.goBack();
  await until(page, (now, id) => now.lesson === id, first.id);
});

test("an unknown lesson gets the list of those that there are", async (t) => {
  const page = await load(t, "?lesson=no-such", { wait: false });
  await page.getByText("There is no lesson “no-such”").waitFor();
  const all = await lessons();
  assert.equal(await page.locator("#veil").getByRole("link").count(), all.length);
  await page.locator("#veil").getByRole("link").last().click();
  await until(page, (now, id) => now?.lesson === id, all.at(-1).id);
  await page.locator("#veil").waitFor({ state: "hidden" });
});

const kWrong = [
  ["step=abc", 'step "abc"'],
  ["step=99999", "step 99999"],
  ["points=1,2;3", "Part of the address"],
  ["a=nonsense", "Part of the address"],
  ["from=nonsense:5", "Part of the address"],
  ["moved=100000,1,2", "Part of the address"],
];
for (const [query, says] of kWrong) {
  test(`a wrong address (${query}) is said plainly, and the lesson opens`, async (t) => {
    const page = await visit(t, `?lesson=${await lesson_with(flat)}&${query}`);
    await page.locator(".notice").getByText(says).waitFor();
    assert.ok((await state(page)).steps > 0);
  });
}

test("embed leaves out everything but the lesson, and stays", async (t) => {
  const page = await load(t, `${kFirst}&embed=1`);
  assert.equal(await page.locator("#bar").isVisible(), false);
  assert.equal(await page.locator("#read").isVisible(), false);
  assert.ok(await page.locator("#stage").isVisible());
  await page.keyboard.press("Home");
  await page.waitForTimeout(400);
  assert.match(page.url(), /embed=1/);
  const other = await load(t, "?lesson=obb-axes&embed=1"); // which has situations to choose
  assert.equal((await other.locator("#stage").boundingBox()).width, kWide.viewport.width);
});

test("a link to the second task opens the second task", async (t) => {
  const again = await visit(t, "?lesson=which-volume&situation=debris&from=task:2");
  assert.equal((await until(again, (now) => now.task === 1)).task, 1);
  assert.match(await again.evaluate(() => location.search), /from=task:2/);
  const beyond = await visit(t, "?lesson=which-volume&from=task:9");
  await beyond.getByText("this lesson has no task 9").waitFor();
});
