// Which volume when: all volumes in small pictures that one drag turns, the measured table, the sliders, the
// playground.
import { after, before, test } from "node:test";
import {
  assert, handles, kPhone, revisit, start_for_pictures, state, still, stop, until, until_within, visit,
} from "./support.mjs";

before(start_for_pictures);
after(stop);

const kLesson = "?lesson=which-volume";
const kVolumes = ["welzl", "aabb/min_max", "obb/dito", "kdop/k14", "capsule/pca", "lozenge/pca", "hull/quickhull"];
const button = (page, name) => page.getByRole("button", { name, exact: true });
const table = (page) => page.locator(".cover-table");
const column = (page, i) =>
  table(page)
    .locator("tbody tr")
    .evaluateAll((rows, at) => rows.map((row) => row.children[at].textContent), i);

/** Measures: what is asked before that is skipped. */
async function measure(page) {
  await button(page, "Measure").click();
  await until(page, (now) => now.asked);
  for (let i = 0; (await state(page)).asked && i < 3; ++i) {
    await button(page, "Skip").click();
    await until(page, (now, count) => now.outcomes.length > count, i);
  }
  await button(page, "Measure").click();
  await until_within(180_000, page, (now) => now.cover.decided && !now.cover.running);
  await still(page);
}

test("seven small pictures; one drag turns all, a click chooses one", async (t) => {
  const page = await visit(t, kLesson);
  await until(page, (now) => now.cover?.shown);
  const places = await handles(page);
  assert.deepEqual(places.map(({ id }) => id), kVolumes);
  const [from, other] = [places[0], places[5]];
  const look = async ({ x, y }) =>
    (await page.screenshot({ clip: { x: x - 30, y: y - 30, width: 60, height: 60 } })).toString("base64");
  const [before_from, before_other] = [await look(from), await look(other)];
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 60, from.y + 20, { steps: 6 });
  await page.mouse.up();
  await still(page);
  await page.mouse.move(2, 2);
  await still(page);
  assert.notEqual(await look(from), before_from);
  assert.notEqual(await look(other), before_other, "the others turn with it");
  assert.equal((await state(page)).algorithm, kVolumes[0], "a drag chooses nothing");
  await page.mouse.click(other.x, other.y);
  await until(page, (now, wanted) => now.algorithm === wanted, kVolumes[5]);
});

let measured; // the page with the table
test("the table is measured here, sorts by any column, and a slider loses none of it", async (t) => {
  const page = await visit(t, kLesson);
  await until(page, (now) => now.cover?.shown);
  assert.equal((await state(page)).asked, null, "seen first, then asked");
  assert.equal(await page.locator("#read").evaluate((read) => read.scrollTop), 0, "it opens at its top");
  assert.ok(await page.locator("#timeline").isHidden(), "the pictures have no steps");
  assert.ok(await table(page).isHidden(), "predict first");
  await measure(page);
  measured = page;
  assert.equal((await column(page, 0)).length, kVolumes.length);
  assert.ok((await column(page, 1)).every((text) => /\d (ns|µs|ms|s)$/.test(text)));
  assert.equal(await table(page).locator("thead th[scope=col]").count(), 7);
  assert.equal(await table(page).locator("tbody th[scope=row]").count(), 7);
  await button(page, "Looseness").click();
  await until(page, (now) => now.cover.table.sorted === 2);
  const loose = (await column(page, 2)).map(Number);
  assert.deepEqual(loose, [...loose].sort((a, b) => a - b));
  assert.equal(loose[0], 1);
  assert.equal((await column(page, 0))[0], "Hull");
  assert.equal(await table(page).locator("[aria-sort=ascending]").textContent(), "Looseness");

  const [before_slide, tests] = [await column(page, 6), await column(page, 1)];
  await page.getByRole("slider", { name: "Frames" }).focus();
  for (let i = 0; i < 5; ++i) await page.keyboard.press("ArrowRight");
  await still(page);
  assert.deepEqual(await column(page, 1), tests, "the slider has lost a measurement");
  assert.notDeepEqual(await column(page, 6), before_slide);

  const caption = await page.locator("#caption").boundingBox(),
    rows = await table(page).boundingBox();
  assert.ok(
    caption.y + caption.height <= rows.y + 1 || caption.y >= rows.y + rows.height,
    "the sentence covers rows of the table",
  );
  await page.locator(".segments label", { hasText: "Ranks" }).click();
  await until(page, (now) => now.cover.table.head[1] === "Textbook");
  const names = await column(page, 0), places = await column(page, 1);
  const textbook = { Sphere: "1", AABB: "2", "14-DOP": "3", OBB: "4", Hull: "5" };
  assert.deepEqual(places, names.map((name) => textbook[name] ?? "–"));
});

test("at a phone's width the table is whole, under the stage", async (t) => {
  const page = revisit(t, measured);
  await page.setViewportSize(kPhone.viewport);
  await still(page);
  await table(page).scrollIntoViewIfNeeded();
  const { x, width } = await table(page).boundingBox();
  assert.ok(x >= 0 && x + width <= 390, `the table is from ${x} to ${x + width}`);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "the page scrolls sideways");
});

test("every lesson leads here with its points, and back", async (t) => {
  const page = await visit(t, "?lesson=sphere-ritter&step=0");
  const { size } = await until(page, (now) => now.lesson === "sphere-ritter");
  await button(page, "Try every volume on these points").click();
  const there = await until_within(
    60_000,
    page,
    (now) => now.lesson === "which-volume" && now.source === "sphere-ritter",
  );
  assert.equal(there.size, size);
  assert.equal(there.dim, 2);
  assert.ok(there.edited && !there.asked, "it is a playground: nothing is asked of other points");
  await page.getByRole("button", { name: /^Back to / }).click();
  await until_within(60_000, page, (now) => now.lesson === "sphere-ritter");
});
