// Float or double: a switch among the tools, undone like any edit, and kept by the address.
import { after, before, test } from "node:test";
import { assert, start, state, stop, until, visit } from "./support.mjs";

before(start);
after(stop);

const kLesson = "rounding-sphere";

test("a lesson opens in its own scalar, and the switch runs it in the other one", async (t) => {
  const page = await visit(t, `?lesson=${kLesson}&step=54`);
  const first = await state(page);
  assert.deepEqual([first.scalar, first.readout.outside_count], ["float", 1]);
  await page.getByRole("tab", { name: "Points" }).click();
  await page.getByLabel("Computed in").selectOption("double");
  await until(page, (now) => now.scalar === "double");
  assert.notEqual((await state(page)).trace, first.trace);
  await page.waitForTimeout(400); // the page's own delay
  assert.match(page.url(), /scalar=double/);
  await page.locator("#undo").click();
  await until(page, (now, trace) => now.scalar === "float" && now.trace === trace, first.trace);
  await page.waitForTimeout(400);
  assert.doesNotMatch(page.url(), /scalar=/);
});

test("an address opens a lesson in the scalar that it names, and tells of one that does not exist", async (t) => {
  const page = await visit(t, `?lesson=${kLesson}&step=0&scalar=double`);
  assert.equal((await state(page)).scalar, "double");
  await page.reload();
  await page.waitForFunction(() => window.snug?.state?.()?.scalar === "double");
  const other = await visit(t, `?lesson=${kLesson}&step=0&scalar=half`);
  assert.equal((await state(other)).scalar, "float");
  assert.match(await other.locator("body").innerText(), /scalar "half", which must be float or double/);
});

test("two boxes are rounded to float and tested in it, and are what they were in double again", async (t) => {
  const page = await visit(t, "?lesson=obb-sat&step=2");
  const first = await state(page);
  assert.equal(first.scalar, "double");
  await page.getByRole("tab", { name: "Boxes" }).click();
  const choice = page.getByLabel("Computed in");
  await choice.selectOption("float");
  const rounded = await until(page, (now) => now.scalar === "float");
  assert.notEqual(rounded.trace, first.trace);
  assert.equal(rounded.step, first.step);
  await choice.selectOption("double");
  await until(page, (now, trace) => now.scalar === "double" && now.trace === trace, first.trace);
});

test("two spheres are rounded to float and tested in it as well", async (t) => {
  const page = await visit(t, "?lesson=sphere-overlap&step=1");
  const first = await state(page);
  assert.equal(first.scalar, "double");
  await page.getByRole("tab", { name: "Volumes" }).click();
  await page.getByLabel("Computed in").selectOption("float");
  await until(page, (now) => now.scalar === "float");
  await page.locator("#undo").click();
  await until(page, (now, trace) => now.scalar === "double" && now.trace === trace, first.trace);
});

test("a lesson about other things has no such switch", async (t) => {
  const page = await visit(t, "?lesson=bvh-build&step=0");
  assert.equal((await state(page)).scalar, null);
  assert.equal(await page.getByLabel("Computed in").isVisible(), false);
});
