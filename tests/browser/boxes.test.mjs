// Two boxes are dragged, turned, typed and shared, by mouse, finger and keyboard.
import { after, before, test } from "node:test";
import {
  assert, drag, drag_by_finger, handles, kPhone, panel_tables, ready, start, state, still, stop, until, visit,
} from "./support.mjs";

before(start);
after(stop);

const kLesson = "?lesson=obb-sat";
const changed = (now, numbers) => JSON.stringify(now.numbers) !== numbers;
const text_of = (view) => JSON.stringify(view.numbers);
/** Where both boxes are, how large, how turned. */
const boxes_of = ({ numbers }) =>
  numbers.map(({ rows: [center, half_extents, turn] }) => ({
    center: center.values,
    half_extents: half_extents.values,
    degrees: turn.turn ? undefined : turn.values[0],
  }));

test("a box's centre is dragged: the box follows, the other stays, and one undo takes it back", async (t) => {
  const page = await visit(t, kLesson);
  const before = await state(page);
  const [first] = await handles(page);
  await drag(page, first.id, 40, 25);
  const after = await until(page, changed, text_of(before));
  assert.ok(boxes_of(after)[0].center[0] > boxes_of(before)[0].center[0]);
  assert.ok(boxes_of(after)[0].center[1] < boxes_of(before)[0].center[1], "down on the screen is down in the plane");
  assert.deepEqual(boxes_of(after)[0].half_extents, boxes_of(before)[0].half_extents);
  assert.equal(boxes_of(after)[0].degrees, boxes_of(before)[0].degrees);
  assert.deepEqual(boxes_of(after)[1], boxes_of(before)[1]);
  await page.keyboard.press("Control+z");
  assert.deepEqual(boxes_of(await until(page, (now) => now.canRedo)), boxes_of(before));
});

test("every handle of a box does something to it, and to no other", async (t) => {
  const page = await visit(t, kLesson);
  const start_boxes = await state(page);
  const kinds = new Set();
  for (const { id } of await handles(page)) {
    const before = await state(page);
    await drag(page, id, 14, 11);
    const boxes = boxes_of(await until(page, changed, text_of(before)));
    const touched = boxes.flatMap((box, i) => (JSON.stringify(box) === JSON.stringify(boxes_of(before)[i]) ? [] : [i]));
    assert.equal(touched.length, 1, `handle ${id} touches boxes ${touched}`);
    for (const key of ["center", "half_extents", "degrees"])
      if (JSON.stringify(boxes[touched[0]][key]) !== JSON.stringify(boxes_of(before)[touched[0]][key]))
        kinds.add(`${key} of ${touched[0]}`);
    await page.keyboard.press("Control+z");
    await until(page, (now, text) => JSON.stringify(now.numbers) === text, text_of(start_boxes));
  }
  for (const kind of [
    "center of 0",
    "half_extents of 0",
    "degrees of 0",
    "center of 1",
    "half_extents of 1",
    "degrees of 1",
  ])
    assert.ok(kinds.has(kind), `no handle changes the ${kind}`);
});

test("a finger drags a box on a phone", async (t) => {
  const page = await visit(t, kLesson, kPhone);
  const before = await state(page);
  const [first] = await handles(page);
  await drag_by_finger(page, first.id, 18, -24);
  const after = await until(page, changed, text_of(before));
  assert.notDeepEqual(boxes_of(after)[0].center, boxes_of(before)[0].center);
  assert.deepEqual(boxes_of(after)[1], boxes_of(before)[1]);
});

test("arrow keys move what is selected of a box", async (t) => {
  const page = await visit(t, kLesson);
  await page.locator("#canvas").focus();
  await page.keyboard.press("]");
  await until(page, (now) => now.selected !== null);
  const before = await state(page);
  await page.keyboard.press("ArrowRight");
  const after = await until(page, changed, text_of(before));
  assert.ok(boxes_of(after)[0].center[0] > boxes_of(before)[0].center[0]);
  assert.equal(boxes_of(after)[0].center[1], boxes_of(before)[0].center[1]);
});

test("a typed angle and a typed centre are those of the box; a negative size is not taken", async (t) => {
  const page = await visit(t, kLesson);
  await page.getByRole("tab", { name: "Boxes" }).click();
  await page.getByLabel("Turn of A in degrees").fill("30");
  await page.keyboard.press("Enter");
  const turned = await until(page, (now) => Math.abs(now.numbers[0].rows[2].values[0] - 30) < 1e-9);
  await page.getByLabel("Centre x of B").fill("2.5");
  await page.keyboard.press("Tab");
  const moved = await until(page, (now) => now.numbers[1].rows[0].values[0] === 2.5);
  assert.equal(boxes_of(moved)[1].center[1], boxes_of(turned)[1].center[1]);
  await page.getByLabel("Half extents x of A").fill("-1");
  await page.keyboard.press("Tab");
  await page.getByText(/half extent/i).last().waitFor();
  assert.deepEqual(boxes_of(await state(page)), boxes_of(moved));
});

test("boxes apart are told by fewer steps than boxes that overlap", async (t) => {
  const page = await visit(t, `${kLesson}&boxes=-2,0,1,0.5,1,0;2,0,1,0.5,1,0`);
  const apart = await state(page);
  assert.deepEqual(boxes_of(apart).map(({ center }) => center[0]), [-2, 2]);
  const together = await visit(t, `${kLesson}&boxes=-0.5,0,1,0.5,1,0;0.5,0,1,0.5,1,0`);
  const overlap = await state(together);
  assert.notEqual(apart.trace, overlap.trace);
  assert.ok(apart.steps < overlap.steps, "one gap is enough, no gap takes every axis");
});

test("the address carries the boxes to the last digit", async (t) => {
  const page = await visit(t, kLesson);
  const before = await state(page);
  const [, second] = await handles(page);
  await drag(page, second.id, -9, 7);
  const after = await until(page, changed, text_of(before));
  // The address follows a moment later.
  for (let href = ""; href !== page.url() || !/rows=/.test(href); await page.waitForTimeout(400)) href = page.url();
  await page.reload();
  await ready(page);
  const again = await state(page);
  assert.deepEqual(boxes_of(again), boxes_of(after));
  assert.equal(again.trace, after.trace);
});

test("an axis is chosen by its row in the table beside the stage", async (t) => {
  const page = await visit(t, "?lesson=obb-axes&a=sat_all&step=0");
  const asked = (await until(page, (now) => now.asked?.id === "which-axis")).asked;
  const numbers = await page.locator("#numbers").boundingBox();
  // Down the inspector until a row takes the click: what it takes is the axis whose row it is. The second gives it.
  for (let y = numbers.y + 8; y < numbers.y + numbers.height && !(await state(page)).asked.picked; y += 12) {
    await page.mouse.click(numbers.x + numbers.width / 3, y);
    await still(page);
  }
  await page.keyboard.press("Enter");
  const now = await until(page, (it) => it.outcomes.length > 0 || it.asked?.tried); // a wrong one may be tried again
  const chosen = now.outcomes[0]?.predicted ?? asked.choices[now.asked.tried.choices[0]];
  assert.ok(asked.choices.some((choice) => chosen?.includes(choice)), `${chosen} is one of the axes`);
});

test("which axis separates how many of 1,000 random pairs is read in HTML", async (t) => {
  const page = await visit(t, "?lesson=obb-axes&a=sat&step=0");
  await until(page, (now) => now.panels.length === 2);
  const { panels: [frames, { title, head, rows, says }], readout } = await state(page);
  assert.equal(title, "1,000 random pairs, seed 1");
  assert.deepEqual(head, ["Axis", "The test ends there", "It separates"]);
  assert.equal(rows.length, 15);
  const [first, all] = [1, 2].map((column) => rows.map((row) => Number(row[column])));
  const sum = first.reduce((a, b) => a + b, 0);
  assert.equal(sum, readout["random_apart"], "each pair that is apart is told so by one axis");
  assert.equal(1000 - sum, readout["random_overlap"]);
  assert.equal(says, `${readout["random_overlap"]} pairs overlap.`);
  assert.ok(
    first.every((count, i) => count <= all[i]) && first[0] === all[0],
    "the first axis ends the test wherever it separates",
  );
  assert.deepEqual(await panel_tables(page),
    [{ title: frames.title, head: frames.head, rows: frames.rows }, { title, head, rows }]);
});
