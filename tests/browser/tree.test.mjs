// Trees of boxes: built step by step, asked about, dragged and shared by the address; queries; merging; building by
// hand.
import { after, before, test } from "node:test";
import {
  answer, assert, drag, drag_by_finger, kPhone, panel_tables, ready, start, state, stop, tap, until, visit,
} from "./support.mjs";

before(start);
after(stop);

const text_of = (view) => JSON.stringify(view.numbers);
const changed = (now, numbers) => JSON.stringify(now.numbers) !== numbers;

for (const lesson of ["bvh-build", "bvh-traverse", "bvh-merge"])
  test(`${lesson}: a box is dragged, by itself, and undone`, async (t) => {
    const page = await visit(t, `?lesson=${lesson}`);
    const own = await state(page);
    await drag(page, "C", 13, -9);
    const now = await until(page, changed, text_of(own));
    assert.notDeepEqual(now.numbers[2], own.numbers[2]);
    assert.deepEqual(now.numbers[1], own.numbers[1]);
    await page.keyboard.press("Control+z");
    await until(page, (view, text) => JSON.stringify(view.numbers) === text, text_of(own));
  });

test("a finger drags a query's place on a phone, and the counts follow", async (t) => {
  const page = await visit(t, "?lesson=bvh-traverse&a=ray_query&step=99", kPhone);
  const own = await until(page, (now) => now.step === now.steps);
  await drag_by_finger(page, "R", 0, -70);
  const now = await until(page, changed, text_of(own));
  assert.notDeepEqual(now.readout, own.readout);
});

test("which boxes go left? Five boxes are tapped on the stage, and are right", async (t) => {
  const page = await visit(t, "?lesson=bvh-build&step=0");
  const { asked } = await until(page, (now) => now.asked);
  assert.equal(asked.id, "halves");
  for (const name of ["A", "B", "C", "D", "F"]) {
    await tap(page, name);
    await until(page, (now, last) => now.asked.picked?.handle.endsWith(last), name);
  }
  await page.locator("#ask").getByRole("button", { name: "Answer", exact: true }).click();
  const { outcome } = await until(page, (now) => now.outcome);
  assert.deepEqual([outcome.question, outcome.right], ["halves", true]);
});

test("a yes or no about a node is answered by its button", async (t) => {
  const page = await visit(t, "?lesson=bvh-traverse&step=1");
  const { asked } = await until(page, (now) => now.asked);
  assert.deepEqual(asked.choices, ["yes", "no"]);
  const { outcome } = await answer(page, "no");
  assert.ok(outcome.right);
});

test("the address carries boxes and query to the last digit", async (t) => {
  const page = await visit(t, "?lesson=bvh-traverse");
  const own = await state(page);
  await drag(page, "Q", 17, 31);
  const moved = await until(page, changed, text_of(own));
  for (let href = ""; href !== page.url() || !/(rows|moved)=/.test(href); await page.waitForTimeout(400))
    href = page.url(); // it follows a moment later
  await page.reload();
  await ready(page);
  const again = await state(page);
  assert.equal(text_of(again), text_of(moved));
  assert.equal(again.trace, moved.trace);
});

test("a tree that is built by hand is in the address: its mergers, and what it comes to", async (t) => {
  const page = await visit(t, "?lesson=bvh-build&a=by_hand&step=9&moved=10,2,0,3,10,2");
  const view = await until(page, (now) => now.step === now.steps);
  assert.equal(view.steps, 3); // two mergers, and the end
  assert.equal(view.readout.nodes, 12);
  assert.equal(view.readout.cost, undefined); // it is not finished
  assert.match(view.caption, /8 nodes without a parent/);
  const whole = await visit(
    t,
    "?lesson=bvh-build&a=by_hand&step=99&moved=10,9,1,4,0,3,5,6,2,10,7,8,11,13,9,14,12,15,16,17",
  );
  const { readout, grade } = await until(whole, (now) => now.steps === 10 && now.step === 10);
  assert.ok(readout.of_sah <= 100);
  assert.ok(grade);
});

test("a ray's order is chosen by two buttons beside the stage, is in the address, and is taken back", async (t) => {
  const page = await visit(t, "?lesson=bvh-traverse&situation=misled&a=ray_by_hand&step=9");
  if ((await state(page)).asked) await answer(page, "Only how many tests are needed");
  const due = await until(page, (now) => now.step === now.steps && now.asked === null);
  assert.match(due.caption, /choose which one comes next/);
  assert.equal(due.readout.of_near_first, undefined);
  const whole = await visit(t, "?lesson=bvh-traverse&situation=misled&a=ray_by_hand&step=99&moved=13,2,0,0");
  const end = await until(whole, (now) => now.step === now.steps && now.readout.of_near_first !== undefined);
  assert.equal(end.readout.of_near_first, 80);
  assert.equal(end.readout.found, 1);
});

test("two trees: the stack holds pairs, a drag of R moves the copy, and every pair is found", async (t) => {
  const page = await visit(t, "?lesson=bvh-traverse&situation=copies&a=two_trees&step=99");
  const own = await until(page, (now) => now.step === now.steps && now.asked === null);
  assert.equal(own.readout.found, 2);
  assert.equal(own.readout.left_out + own.readout.box_tests, 64);
  await drag(page, "R", 150, 0);
  const now = await until(page, (view, tests) => view.readout.tests !== tests, own.readout.tests);
  assert.equal(now.readout.left_out + now.readout.box_tests, 64);
});

test("circles and oriented boxes as nodes: the same tree, at another cost", async (t) => {
  const costs = [];
  for (const situation of ["own", "circles"]) {
    const page = await visit(t, `?lesson=bvh-build&situation=${situation}&a=insertion&step=99`);
    const { readout } = await until(page, (now) => now.step === now.steps);
    costs.push(readout.cost);
    assert.equal(readout.nodes, 19);
    assert.equal(readout.of_aabb === undefined, situation === "own");
  }
  assert.notEqual(costs[0], costs[1]);
});

/** The times of the panel that there is once a run is at its end, when all ways that have ended are timed. */
const times = async (page, ways) => {
  const now = await until(
    page,
    (it, count) => it.panels[0]?.rows.filter((row) => row[2] !== "").length === count,
    ways,
  );
  assert.deepEqual(
    await panel_tables(page),
    now.panels.map(({ title, head, rows }) => ({ title, head, rows })),
  );
  return now.panels[0];
};

test("what trees of many boxes cost, and how long they take, stands in HTML as beside the stage", async (t) => {
  const page = await visit(t, "?lesson=bvh-build&a=insertion&step=99");
  const { title, head, rows, says, button } = await times(page, 1);
  assert.deepEqual([title, head, button], ["With 2,000 boxes", ["", "Cost", "Time"], null]);
  assert.deepEqual(
    rows.map(([name]) => name),
    ["Top-down, median", "Top-down, surface area", "Bottom-up", "Insertion"],
  );
  assert.equal(says, "Each way is timed at the end of its run.");
  const [, cost, time] = rows[3];
  assert.ok(Number(cost) > 0, cost);
  assert.match(time, /^[\d.,]+ ms$/);
  await page.evaluate(() => document.getElementById("canvas").focus());
  await page.keyboard.press("Home");
  await until(page, (it) => it.panels.length === 0);
  assert.deepEqual(await panel_tables(page), []);
});

test("a refit and a rebuild are compared in HTML once both were seen", async (t) => {
  const page = await visit(t, "?lesson=bvh-merge&situation=moved&a=merge_aabb&step=99");
  await times(page, 1);
  await page.evaluate(() => {
    const choice = [...document.querySelectorAll("select")].find((one) =>
      [...one.options].some(({ value }) => value === "rebuild"),
    );
    choice.value = "rebuild";
    choice.dispatchEvent(new Event("change", { bubbles: true }));
  });
  await until(page, (now) => now.algorithm === "rebuild");
  await page.evaluate(() => document.getElementById("canvas").focus());
  await page.keyboard.press("End");
  const { rows, says } = await times(page, 2);
  assert.deepEqual(rows.map(([name]) => name), ["Refit", "Rebuild"]);
  assert.ok(Number(rows[0][1]) > Number(rows[1][1]), "a tree that was refitted costs more");
  assert.match(says, /^Here a rebuild takes [\d.,]+ times as long as a refit\.$/);
});
