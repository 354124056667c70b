// Answers of several parts, by mouse, finger and keyboard: an order, a number, several points; two questions in a row;
// and more than one task.
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { add_lesson, assert, cut_off, handles, kPhone, start, state, still, stop, until, visit } from "./support.mjs";

const lesson = (id) => readFileSync(new URL(`../lessons/${id}.toml`, import.meta.url), "utf8");

before(async () => {
  await start();
  for (const id of ["best-box", "kdop-plane"]) await add_lesson(id, lesson(id));
});
after(stop);

const card = (page) => page.locator("#ask");
/** A choice that has its place in an order says that first. */
const choose = (page, words) => card(page).getByRole("button", { name: new RegExp(`^(\\d+ ?)?${words}$`) }).click();

test("an order is chosen one after the other, and is given once it is whole; then the next is asked", async (t) => {
  const page = await visit(t, "?lesson=best-box&step=0");
  const { asked } = await until(page, (now) => now.asked?.id === "order");
  assert.deepEqual([asked.ordered, asked.ready, asked.choices.length], [true, false, 4]);
  const commit = card(page).getByRole("button", { name: "Answer", exact: true });
  assert.ok(await commit.isDisabled());
  for (const words of ["Axis-aligned box", "Exact minimum", "PCA of the points"]) await choose(page, words);
  assert.ok(await commit.isDisabled());
  await choose(page, "Axis-aligned box"); // taken out again
  await choose(page, "PCA of the hull");
  await choose(page, "Axis-aligned box");
  const places = await card(page)
    .locator("[data-place]")
    .evaluateAll((buttons) => buttons.map((button) => button.dataset.place));
  assert.deepEqual(places, ["2", "3", "4", "1"]);
  await commit.click();
  const { asked: once } = await until(page, (now) => now.outcome || now.asked?.tried);
  if (once?.tried) { // that was another order than the right one, which depends on the points alone
    assert.deepEqual(once.picked, null);
    for (const words of ["Exact minimum", "PCA of the hull", "PCA of the points", "Axis-aligned box"])
      await choose(page, words);
    await commit.click();
  }
  // Two questions stand at the same place: the first is told there, before the step that both are about.
  const { outcome: order, step } = await until(page, (now) => now.outcome);
  assert.deepEqual([order.question, step, order.canWatch], ["order", 0, false]);
  assert.match(order.predicted, /^Exact minimum, PCA of the /);
  // The right order is a list, with the place that each had in the prediction.
  const { choices, rightChoices, given } = order;
  const lines = card(page).locator(".order li");
  assert.deepEqual(
    await lines.locator("span").allTextContents(),
    rightChoices.map((choice) => choices[choice]),
  );
  assert.deepEqual(
    (await lines.locator("b").allTextContents()).map((text) => Number(/\d/.exec(text)[0])),
    rightChoices.map((choice) => given.choices.indexOf(choice) + 1),
  );
  await page.keyboard.press("Enter");
  const { asked: second } = await until(page, (now) => now.asked?.id === "cheapest");
  assert.equal(second.place, "2 of 3");
  await choose(page, "Exact minimum");
  await page.keyboard.press("Enter");
  const { asked: again } = await until(page, (now) => now.asked?.tried);
  assert.match(again.says, /^Not that one\. Try once more\. The exact method tries every edge/);
  await choose(page, "Axis-aligned box");
  await page.keyboard.press("Enter");
  await until(page, (now) => now.outcome?.question === "cheapest");
});

test("several points are tapped on a phone, and taken back by a second tap", async (t) => {
  const page = await visit(t, "?lesson=kdop-plane&step=0", kPhone);
  await until(page, (now) => now.asked?.id === "tightest");
  await card(page).getByRole("button", { name: "Skip" }).tap();
  await until(page, (now) => now.outcome);
  await card(page).getByRole("button", { name: "Continue" }).tap();
  for (let taps = 0; !(await state(page)).asked; ++taps) {
    assert.ok(taps < 9);
    await page.getByRole("button", { name: "Next step" }).or(page.locator("#canvas")).first().press("ArrowRight");
  }
  const { asked } = await until(page, (now) => now.asked?.id === "extremes");
  assert.deepEqual([asked.many, asked.field, asked.choices], [true, "Names", []]);
  const tap = async (name) => {
    await still(page);
    const { x, y } = (await handles(page)).find(({ id }) => id === name);
    await page.touchscreen.tap(x, y);
  };
  await tap("P10");
  await until(page, (now) => now.asked.picked?.handle === "P10");
  await tap("P11");
  await until(page, (now) => now.asked.picked?.handle === "P10, P11");
  await tap("P10");
  await until(page, (now) => now.asked.picked?.handle === "P11");
  assert.deepEqual(await cut_off(page), []);
  await card(page).getByRole("textbox", { name: "Names" }).fill("P10 and P11");
  await page.keyboard.press("Enter");
  const { outcome } = await until(page, (now) => now.outcome ?? now.asked?.tried ?? false);
  assert.ok(outcome === null || outcome.predicted === "P10 and P11");
});

test("a number is typed; what is no number costs nothing", async (t) => {
  const page = await visit(t, "?lesson=kdop-plane&step=0");
  for (const id of ["tightest", "extremes"]) {
    await until(page, (now, due) => now.asked?.id === due, id);
    await card(page).getByRole("button", { name: "Skip" }).click();
    await until(page, (now) => now.outcome);
    await page.keyboard.press("Enter");
    for (let presses = 0; !(await state(page)).asked; ++presses) {
      assert.ok(presses < 9);
      await page.keyboard.press("ArrowRight");
    }
  }
  const { asked, readout } = await until(page, (now) => now.asked?.id === "slabs");
  assert.equal(asked.field, "Number");
  assert.equal(readout.excess, undefined); // it is what is asked for
  const field = card(page).getByRole("textbox", { name: "Number" });
  await field.fill("a lot");
  await page.keyboard.press("Enter");
  assert.equal(
    (await until(page, (now) => now.asked.says)).asked.says,
    "“a lot” is not a number. Write it like 12 or 2.5.",
  );
  await field.fill("12 %");
  await page.keyboard.press("Enter");
  const { outcome, asked: again } = await until(page, (now) => now.outcome ?? now.asked?.tried);
  assert.equal(outcome?.predicted ?? again.tried.handle, outcome ? "12 %" : "12");
});

test("a lesson with two tasks shows both, each with its own start and state", async (t) => {
  const page = await visit(t, "?lesson=obb-sat&step=0");
  const cards = page.locator("#task .task");
  assert.equal(await cards.count(), 2);
  assert.deepEqual(await cards.locator("h2").allTextContents(), ["Your turn, 1 of 2", "Your turn, 2 of 2"]);
  await cards.nth(1).getByRole("button", { name: "Start" }).click();
  const { task, tasks, tasksDone, grade } = await until(page, (now) => now.task === 1);
  assert.deepEqual([task, tasks.map(({ done }) => done), tasksDone], [1, [false, false], false]);
  assert.match(grade.says, /Vertices only/);
});
