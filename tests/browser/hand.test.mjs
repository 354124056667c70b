// A volume is fitted by hand: its knobs and ends are dragged by mouse, finger and keyboard, shared and taken back.
import { after, before, test } from "node:test";
import { assert, drag, drag_by_finger, handles, kPhone, start, state, stop, until, visit } from "./support.mjs";

before(start);
after(stop);

const kBox = "?lesson=obb-pca&a=by_hand&step=2";
const number_of = (view, key) => Number.parseFloat(view.figures.find((figure) => figure.key === key).text);
const measure_of = (view) => number_of(view, "measure");
const differs = (now, text) => now.figures.find((figure) => figure.key === "measure").text !== text;
const text_of = (view) => view.figures.find((figure) => figure.key === "measure").text;
const has = async (page, id) => (await handles(page)).some((handle) => handle.id === id);

test("the knob is there with the box by hand alone; it turns the box, which keeps all points; undo too", async (t) => {
  const page = await visit(t, kBox);
  const before = await state(page);
  await drag(page, "Box turn", -20, -90);
  const turned = await until(page, differs, text_of(before));
  assert.ok(measure_of(turned) < measure_of(before), "towards the cloud's own direction the box is smaller");
  assert.equal(number_of(turned, "outside"), 0);
  assert.equal(turned.size, before.size, "a knob is no point");
  await page.keyboard.press("Control+z");
  assert.equal(text_of(await until(page, (now) => now.canRedo)), text_of(before));
  assert.ok(await has(page, "Box turn"));
  assert.ok(!(await has(await visit(t, "?lesson=obb-pca&a=pca&step=5"), "Box turn")));
});

test("a finger turns the box on a phone", async (t) => {
  const page = await visit(t, kBox, kPhone);
  const before = await state(page);
  await drag_by_finger(page, "Box turn", -6, -30);
  const turned = await until(page, differs, text_of(before));
  assert.equal(number_of(turned, "outside"), 0);
});

test("arrow keys turn the box", async (t) => {
  const page = await visit(t, kBox);
  const before = await state(page);
  await page.locator("#canvas").focus();
  await page.keyboard.press("[");  // the last handle
  await until(page, (now) => now.selectedName === "Box turn");
  await page.keyboard.press("ArrowUp");
  await until(page, differs, text_of(before));
});

test("an address brings back what the hand has set", async (t) => {
  const page = await visit(t, "?lesson=swept-fit&a=capsule/by_hand&step=2");
  const before = await state(page);
  await drag(page, "Capsule b", 60, -40);
  const dragged = await until(page, differs, text_of(before));
  await page.waitForTimeout(400); // the page's own delay: browsers count how often an address is replaced
  assert.match(page.url(), /moved=|rows=/);
  const again = await visit(t, new URL(page.url()).search);
  assert.equal(
    text_of(
      await until(
        again,
        (now, text) => now.figures.some((figure) => figure.key === "measure" && figure.text === text),
        text_of(dragged),
      ),
    ),
    text_of(dragged),
  );
});

test("directions of a k-DOP are added by the slider, dragged, deleted; their address brings them back", async (t) => {
  const page = await visit(t, "?lesson=kdop-slabs&a=kdop/by_hand&step=9");
  const two = await state(page);
  assert.deepEqual(
    (await handles(page)).map(({ id }) => id).filter((id) => id.startsWith("Axis")),
    ["Axis 1", "Axis 2"],
  );
  await page.getByRole("slider", { name: "Your slabs" }).fill("2"); // its third place: from 2 to 4
  const four = await until(page, differs, text_of(two));
  assert.equal(number_of(four, "slabs"), 4);
  assert.ok(measure_of(four) < measure_of(two), "x+y and x−y cut the AABB's corners off");
  await page.locator("#canvas").focus();
  await drag(page, "Axis 4", 28, -22);  // across the stick
  const turned = await until(page, differs, text_of(four));
  assert.equal(number_of(turned, "outside"), 0);
  assert.ok(measure_of(turned) < measure_of(four));
  await page.keyboard.press("Delete");
  const three = await until(page, differs, text_of(turned));
  assert.equal(number_of(three, "slabs"), 3);
  for (let href = ""; href !== page.url(); await page.waitForTimeout(1000)) href = page.url(); // it is written later
  const again = await visit(t, new URL(page.url()).search);
  assert.equal(
    text_of(await until(again, (now) => now.figures.some(({ key, text }) => key === "slabs" && text.startsWith("3")))),
    text_of(three),
  );
});

test("before its slab is shown, the points that bound a direction by hand are asked for, and tapped", async (t) => {
  const page = await visit(t, "?lesson=kdop-slabs&a=kdop/by_hand&step=1");
  const { asked } = await until(page, (now) => now.asked !== null);
  assert.equal(asked.id, "own-extremes");
  assert.ok(asked.targets.every((name) => name.startsWith("P")), "a knob is no answer");
});
