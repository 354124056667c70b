// Situations and sliders: by control, link, section and question, with mouse, keys and a finger, kept in the address.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { drag, kPhone, kWide, load, ready, start, state, still, stop, until } from "./support.mjs";

const kLesson = readFileSync(new URL("../corpus/lessons/near-boxes.toml", import.meta.url), "utf8");
const kNear = "?lesson=near-boxes";

before(async () => {
  const site = await start();
  const course = await (await fetch(`${site.url}course.json`)).json();
  course.chapters[0].lessons.unshift({
    ...course.chapters[0].lessons[0],
    id: "near-boxes",
    title: "Far boxes, near boxes",
  });
  site.add.set("course.json", JSON.stringify(course));
  site.add.set("lessons/near-boxes.toml", kLesson);
});
after(stop);

const slider = (page, name) => page.getByRole("slider", { name });
const value_of = async (page, title) => (await state(page)).sliders.find((one) => one.title === title).value;
/** The angle of B's first axis, as the number fields have it. */
const angle_of_b = async (page) => (await state(page)).numbers[1].rows[2].values[0];

test("the control switches, and what was moved in a situation is kept meanwhile", async (t) => {
  const page = await load(t, kNear);
  assert.equal((await state(page)).situation, "own");
  assert.deepEqual((await state(page)).sliders.map(({ title }) => title), ["Turn of B", "B to the right"]);
  await drag(page, "A", 0, -40);
  const moved = (await state(page)).numbers[0].rows[0].values;
  assert.notEqual(moved[1], 0);
  await page.getByRole("radio", { name: "Near" }).check();
  const near = await until(page, (now) => now.situation === "near");
  assert.deepEqual(near.sliders.map(({ title, text }) => [title, text]), [["Turn of B", "5°"]]);
  assert.equal(near.edited, false);
  await page.getByRole("radio", { name: "Far apart" }).check();
  assert.deepEqual((await until(page, (now) => now.situation === "own")).numbers[0].rows[0].values, moved);
  await page.getByRole("button", { name: "Undo" }).click();
  await until(page, (now) => now.situation === "near");
});

test("a link and a section's button switch, and the section about it is the one at hand", async (t) => {
  const page = await load(t, kNear);
  await page.getByRole("button", { name: "near", exact: true }).click();
  assert.equal((await until(page, (now) => now.situation === "near")).section, 1);
  assert.equal(await page.getByRole("button", { name: "Show: Near" }).getAttribute("aria-pressed"), "true");
  await page.getByRole("button", { name: "Show: Far apart" }).click();
  assert.equal((await until(page, (now) => now.situation === "own")).section, 0);
});

test("each situation asks its own question, and the summary leads to the other's", async (t) => {
  const page = await load(t, kNear);
  await page.evaluate(() => document.getElementById("canvas").focus());
  await page.keyboard.press("End");
  assert.equal((await until(page, (now) => now.asked)).asked.id, "far");
  await page.getByRole("button", { name: "Skip" }).click();
  await until(page, (now) => now.outcome);
  await page.keyboard.press("End");
  await page.keyboard.press("End");
  const end = await until(page, (now) => now.summary);
  assert.deepEqual(end.situationsWaiting, ["near"]);
  await page.getByRole("button", { name: "Go on with Near" }).click();
  await until(page, (now) => now.situation === "near" && now.step === 0);
  await page.evaluate(() => document.getElementById("canvas").focus());
  await page.keyboard.press("End");
  assert.equal((await until(page, (now) => now.asked)).asked.id, "near");
});

test("a slider is dragged with the mouse, in one entry of undo, and the stage follows", async (t) => {
  const page = await load(t, kNear);
  const turn = slider(page, "Turn of B");
  const { x, y, width, height } = await turn.boundingBox();
  const before = (await state(page)).trace;
  await page.mouse.move(x + 8, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 3, y + height / 2, { steps: 4 });
  const half = await state(page);
  assert.notEqual(half.trace, before, "it follows before the mouse lets go");
  await page.mouse.move(x + width / 2, y + height / 2, { steps: 4 });
  await page.mouse.up();
  const there = await value_of(page, "Turn of B");
  assert.ok(Math.abs(there - 45) <= 1, `${there}`);
  assert.ok(Math.abs(await angle_of_b(page) - there) < 1e-9);
  assert.equal(await turn.getAttribute("aria-valuetext"), `${there}°`);
  await page.getByRole("button", { name: "Undo" }).click();
  const own = await until(page, (now) => now.sliders[0].value === 0);
  assert.equal(own.edited, false);
  assert.equal(own.canUndo, false);
});

test("keys move a slider, and leave the player where it is", async (t) => {
  const page = await load(t, kNear);
  await slider(page, "Turn of B").focus();
  for (let i = 0; i < 3; ++i) await page.keyboard.press("ArrowRight");
  assert.equal(await value_of(page, "Turn of B"), 3);
  await page.keyboard.press("End");
  assert.equal(await value_of(page, "Turn of B"), 90);
  assert.equal((await state(page)).step, 0);
  await page.keyboard.press("Control+z");
  assert.equal(await value_of(page, "Turn of B"), 3);
});

test("a slider follows what is typed or dragged", async (t) => {
  const page = await load(t, kNear);
  await page.getByRole("tab", { name: "Boxes" }).click();
  await page.getByLabel("Turn of B in degrees").fill("33.5");
  await page.keyboard.press("Enter");
  assert.equal((await until(page, (now) => now.sliders[0].value > 33)).sliders[0].text, "33.5°");
  await drag(page, "B", 30, 0);
  const { sliders, numbers } = await state(page);
  assert.equal(sliders[1].value, numbers[1].rows[0].values[0]);
});

test("the address brings situation, sliders and edits back, after a reload and from another place", async (t) => {
  const page = await load(t, kNear);
  await page.getByRole("radio", { name: "Near" }).check();
  await slider(page, "Turn of B").fill("40");
  await page.waitForURL(/situation=near.*slide=40/);
  const slid = await state(page);
  assert.doesNotMatch(page.url(), /rows=|moved=/, "the slider says it all");
  await page.reload();
  await ready(page);
  assert.equal((await state(page)).trace, slid.trace);
  assert.equal((await state(page)).situation, "near");
  await drag(page, "A", -30, 10);
  await page.waitForURL(/slide=40.*(moved|rows)=/);
  const edited = await state(page);
  await page.goto("about:blank");
  await page.goBack();
  await ready(page);
  const back = await state(page);
  assert.equal(back.trace, edited.trace);
  assert.equal(await value_of(page, "Turn of B"), 40);
});

test("an address with a situation or sliders that are not there says so", async (t) => {
  const page = await load(t, `${kNear}&situation=nowhere&slide=1,2,3`, kWide);
  const told = await page.locator(".notice").allTextContents();
  assert.match(told.join(), /there is no situation nowhere/);
  assert.match(told.join(), /there are no such sliders/);
  assert.equal((await state(page)).situation, "own");
});

test("on a phone the slider stands under the stage, both in view, and a finger moves it", async (t) => {
  const page = await load(t, kNear, kPhone);
  const box = await slider(page, "Turn of B").boundingBox();
  const stage = await page.locator("#stage").boundingBox();
  assert.ok(stage.y >= 0 && box.y > stage.y + stage.height - 1 && box.y + box.height < 844, `${box.y}`);
  assert.ok(box.height >= 44);
  const touch = await page.context().newCDPSession(page);
  const send = (type, ...points) =>
    touch.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
  const y = box.y + box.height / 2;
  await send("touchStart", [box.x + 8, y]);
  for (let i = 1; i <= 6; ++i) await send("touchMove", [box.x + 8 + (box.width / 2 - 8) * i / 6, y]);
  await send("touchEnd");
  await still(page);
  assert.ok(Math.abs(await value_of(page, "Turn of B") - 45) <= 3);
  await page.locator("#controls label", { hasText: "Near" }).tap();
  await until(page, (now) => now.situation === "near");
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true);
});

test("a lesson without situations and sliders shows none", async (t) => {
  const page = await load(t);
  assert.equal(await page.locator("#controls").isVisible(), false);
  const { situation, sliders } = await state(page);
  assert.equal(situation, null);
  assert.deepEqual(sliders, []);
});

test("a slider's value ends where its row does, below the slider too", async (t) => {
  const page = await load(t, "?lesson=rounding-sphere&step=1");
  const ends = await page.evaluate(() => [...document.querySelectorAll(".slider")].map((slider) =>
    slider.getBoundingClientRect().right - slider.querySelector("output").getBoundingClientRect().right));
  assert.equal(ends.length, 2);
  assert.ok(ends.every((gap) => gap < 2), `${ends}`);
});
