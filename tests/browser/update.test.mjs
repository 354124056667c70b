// One update of an AABB: the body is rotated by its knob, and the climb's next vertex is named by pointing at it.
import { after, before, test } from "node:test";
import { answer, assert, drag, handles, moved, start, state, still, stop, until, visit } from "./support.mjs";

before(start);
after(stop);

test("the body is rotated by hand, and its AABB follows", async (t) => {
  const page = await visit(t, "?lesson=aabb-updates&algorithm=rebuild");
  await page.locator("#canvas").focus();
  for (let view = await state(page); view.step < view.steps; view = await state(page)) {
    if (view.asked) await page.getByRole("button", { name: "Skip" }).first().click();
    else await page.keyboard.press("ArrowRight");
    await moved(page, view);
  }
  await still(page); // the view eases after the last step
  const turned = await state(page);
  const places = Object.fromEntries((await handles(page)).map(({ id, x, y }) => [id, { x, y }]));
  const knob = places["Body turn"], pivot = places.Body;
  const reach = Math.hypot(knob.x - pivot.x, knob.y - pivot.y);
  await drag(page, "Body turn", pivot.x + reach - knob.x, pivot.y - knob.y);
  const flat = await until(page, (now, before) => now.trace !== before, turned.trace);
  assert.ok(Math.abs(flat.readout.turn) < 2, `${flat.readout.turn}`);
  assert.notEqual(flat.readout.measure, turned.readout.measure);
});

test("the next vertex of the climb is answered by pointing at it", async (t) => {
  const page = await visit(t, "?lesson=aabb-updates");
  await page.locator("#canvas").focus();
  for (let view = await state(page); !view.asked; view = await state(page)) {
    await page.keyboard.press("ArrowRight");
    await moved(page, view);
  }
  const { asked } = await state(page);
  assert.equal(asked.id, "next");
  assert.ok(asked.targets.length >= 8 && !asked.targets.some((name) => name.startsWith("Body")), asked.targets.join());
  const told = await answer(page, asked.targets[0]);
  assert.ok(told.outcomes.some(({ question }) => question === "next"));
});
