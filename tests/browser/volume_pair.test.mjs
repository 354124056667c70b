// Any two volumes: their handles are dragged, the test answers at once, and its steps are drawn.
import { after, before, test } from "node:test";
import {
  add_lesson, assert, drag, handles, kPhone, drag_by_finger, panel_tables, pixels_of, pixels_of_volume, ready,
  start_for_pictures, state, still, stop, until, until_within, visit,
} from "./support.mjs";

const kFlatVolumes = {
  sphere: "{ sphere = { center = [1.3, 0.1], radius = 0.6 } }",
  aabb: "{ aabb = { min = [0.4, -1], max = [1.7, 0.4] } }",
  obb: "{ obb = { center = [1.2, 0], half_extents = [0.8, 0.4], turn = 25 } }",
  capsule: "{ capsule = { a = [1, -0.8], b = [1.4, 0.9], radius = 0.3 } }",
  lozenge: "{ lozenge = { origin = [0.8, -0.6], edges = [[1, 0], [0, 0.8]], radius = 0.2 } }",
  kdop: "{ kdop = { k = 8, min = [0.5, -1, -0.1, 0], max = [2, 1, 2.5, 2.5] } }",
  hull: "{ hull = { points = [[0.6, -1], [2, 0], [0.9, 1.1], [1.2, 0.1]] } }",
};
const kVolumes = {
  sphere: "{ sphere = { center = [1.3, 0.1, 0], radius = 0.6 } }",
  aabb: "{ aabb = { min = [0.4, -1, -0.5], max = [1.7, 0.4, 0.6] } }",
  obb: "{ obb = { center = [1.2, 0, 0], half_extents = [0.8, 0.4, 0.3], turn = [10, 20, 25] } }",
  capsule: "{ capsule = { a = [1, -0.8, 0.2], b = [1.4, 0.9, -0.1], radius = 0.3 } }",
  lozenge: "{ lozenge = { origin = [0.8, -0.6, 0], edges = [[1, 0, 0], [0, 0.6, 0.5]], radius = 0.2 } }",
  kdop: "{ kdop = { k = 14, min = [0.5, -1, -1, -2, -2, -2, -2], max = [2, 1, 1, 3, 3, 3, 3] } }",
  hull: "{ hull = { points = [[0.6, -1, 0], [2, 0, 0], [0.9, 1.1, 0], [1.2, 0.1, 0.9]] } }",
};
const kEach = [[2, kFlatVolumes, "[-1, 0.2]"], [3, kVolumes, "[-1, 0.2, 0]"]];
const small_lesson = (dim, center, volume) => `version = 2
title = "A sphere and another volume"
summary = "Two volumes."
minutes = 1
volume = "volume_pair"
algorithms = ["gjk"]

[volumes]
dim = ${dim}
a = { sphere = { center = ${center}, radius = 0.7 } }
b = ${volume}

[[section]]
title = "Two volumes"
text = "They are tested."
`;

before(async () => {
  await start_for_pictures();
  for (const [dim, volumes, center] of kEach)
    for (const [volume, fields] of Object.entries(volumes))
      await add_lesson(`pair-${volume}-${dim}`, small_lesson(dim, center, fields));
});
after(stop);

for (const [dim, volumes] of kEach) {
  test(`in ${dim}-D each volume and its handles are there, steps have sentences, drags are answered`, async (t) => {
    for (const volume of Object.keys(volumes)) {
      const page = await visit(t, `?lesson=pair-${volume}-${dim}&step=0`);
      let now = await state(page);
      assert.ok((await handles(page)).length >= 4, volume);
      await still(page);
      assert.ok(await pixels_of_volume(page) > 150, volume);
      while (now.step < now.steps) {
        await page.keyboard.press("PageDown");
        now = await until(page, (it, step) => it.step > step, now.step);
        assert.match(now.caption, /\.$/);
      }
      assert.match(now.caption, /^Apart/, volume);
      assert.ok(now.readout.gap > 0);
      const [center, ...others] = await handles(page);
      const other = others.find(({ id }) => id === "B");
      const { gap } = now.readout;
      await drag(page, center.id, other.x - center.x, other.y - center.y);
      // In space the hand moves at A's depth, and may pass B by.
      now = await until(page, (it) => dim === 2 ? /overlap/.test(it.caption) : it.readout.gap !== gap);
      assert.equal(now.edited, true, volume);
      await page.keyboard.press("Control+z");
      await until(page, (it) => it.readout.gap === gap);
    }
  });
}

test("the address brings volumes that were dragged back, to the last digit", async (t) => {
  for (const volume of ["obb", "hull"]) {
    const page = await visit(t, `?lesson=pair-${volume}-2&step=1`);
    const before = await state(page);
    for (const at of [0, -1]) await drag(page, (await handles(page)).at(at).id, 13, -11);
    const edited = await until(page, (it, trace) => it.edited && it.trace !== trace, before.trace);
    // The address follows a moment later.
    for (let href = ""; href !== page.url() || !/rows=/.test(href); await page.waitForTimeout(400)) href = page.url();
    await page.reload();
    await ready(page);
    const again = await state(page);
    assert.equal(again.trace, edited.trace, volume);
  }
});

test("the lesson on sphere-swept volumes: a finger changes a radius, and the steps follow", async (t) => {
  const page = await visit(t, "?lesson=swept-overlap&a=swept_spheres&step=2", kPhone);
  const before = await state(page);
  const radius = (await handles(page)).find(({ id }) => id === "A radius");
  await drag_by_finger(page, radius.id, -20, -14);
  const after = await until(page, (it, radii) => it.readout.radii > radii, before.readout.radii);
  assert.ok(after.readout.gap < before.readout.gap);
  await still(page);
});

for (const [where, device] of Object.entries({ "a laptop": undefined, "a phone": kPhone }))
  test(`on ${where} a cell of the table puts another pair on the stage, and the address brings it back`, async (t) => {
    const page = await visit(t, "?lesson=overlap-any&step=0", device);
    if (device) await page.locator("#tab-numbers").click();
    await still(page);
    const own = await state(page);
    const numbers = page.locator("#numbers");
    await numbers.scrollIntoViewIfNeeded();
    const box = await numbers.boundingBox();
    let now = own;
    for (let down = 40; down < 320 && !now.edited; down += 14) { // the last column has a cell in every row
      await page.mouse.click(box.x + box.width - 36, box.y + down);
      await still(page);
      now = await state(page);
    }
    assert.ok(now.edited, "a cell was clicked");
    assert.notEqual(now.trace, own.trace);
    await page.waitForFunction(() => /rows=/.test(location.search));
    await page.reload();
    const again = await until(page, (view) => view?.edited);
    assert.equal(again.trace, now.trace);
    assert.equal(again.algorithm, now.algorithm);
  });

/** A lesson's own pair is measured: 28 rows [pair, test, its time, in a scene, GJK's time, apart, source], once all are
 *  there. */
async function measured_pairs(page) {
  const measure = page.getByRole("button", { name: "Measure what each costs" });
  await measure.focus();
  await page.keyboard.press("Enter");
  const now = await until_within(300_000, page, (it) => it.panels[0].button?.words === "Measure again");
  return now.panels[0].rows;
}
const kKinds = ["AABB", "OBB", "capsule", "lozenge", "k-DOP", "hull"];
/** The rows of the table, from top to bottom: each kind with itself and those after it. */
const pairs_of = (kinds) => kinds.flatMap((a, i) => kinds.slice(i).map((b) => `${a} and ${b}`));
const nanoseconds = (text) => Number(/^([\d.,]+) ns$/.exec(text)[1].replaceAll(",", ""));

test("all 28 pairs are measured, each cell is tinted, a row of HTML has what the command says of each", async (t) => {
  const page = await visit(t, "?lesson=overlap-any&situation=boxes&step=0");
  const waits = await until(page, (now) => now.situation === "boxes" && now.panels[0]?.rows.length === 28);
  assert.equal(waits.panels[0].button, null, "not before it is predicted which test is cheaper");
  let turns = 0;
  for (let now = waits; !now.panels[0].button; now = await state(page)) {
    assert.ok(++turns < 20, "the question stands on the way to the end");
    if (now.asked) await page.getByRole("button", { name: "Skip" }).click();
    else if (now.outcome) await page.getByRole("button", { name: "Continue", exact: true }).click();
    else await page.evaluate(() => document.getElementById("canvas").focus()).then(() => page.keyboard.press("End"));
    await still(page);
  }
  const table = page.locator("#numbers"), before = await pixels_of(page, await table.boundingBox());
  const rows = await measured_pairs(page);
  assert.deepEqual(rows.map(([pair]) => pair), pairs_of(["circle", ...kKinds]));
  for (const [pair, test, own, scene, gjk, apart, source] of rows) {
    assert.ok(
      nanoseconds(own) > 0 && nanoseconds(scene) > 0 && nanoseconds(gjk) > 0,
      `${pair}: ${own}, ${scene}, ${gjk}`,
    );
    assert.match(source, /, \d{4}$/, pair);
    if (test === "GJK") assert.equal(own, gjk, pair);
    assert.match(apart, /^[\d.]+ %$/, pair);
  }
  assert.equal(new Set(rows.map(([, test]) => test)).size, 6, "each test that is a pair's own has a pair");
  assert.deepEqual((await panel_tables(page))[0].rows, rows);
  // The share of the bodies that are apart does not depend on the machine: it is that of snug overlap --costs, which
  // tests/command/overlap.test.mjs holds to the same numbers.
  assert.deepEqual(
    rows.map((row) => Math.round(0.96 * parseFloat(row[5]))),
    [19, 28, 26, 29, 31, 33, 37, 49, 44, 46, 46, 49, 54, 41, 43, 42, 47, 54, 46, 45, 46, 55, 45, 47, 55, 53, 57, 62],
    "of 96 pairs of bodies",
  );
  const after = await pixels_of(page, await table.boundingBox());
  // The palest tint is that of the cheapest pair: one that was measured badly makes all others pale.
  const tinted = (pixels) =>
    pixels.reduce((sum, _, i) => sum + (i % 4 === 0 && pixels[i] > pixels[i + 2] + 6 ? 1 : 0), 0);
  assert.ok(
    tinted(after) > tinted(before) + 10_000,
    `${tinted(before)} to ${tinted(after)} pixels in the tint of costs`,
  );
});
