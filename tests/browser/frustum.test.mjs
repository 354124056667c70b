// A box and a frustum: dragged, asked about on the stage, lost by the wrong test, shared by the address.
import { after, before, test } from "node:test";
import {
  answer, assert, drag, drag_by_finger, handles, kPhone, panel_tables, ready, start, state, still, stop, until,
  until_within, visit,
} from "./support.mjs";

before(start);
after(stop);

const kLessons = ["frustum-2d", "frustum-3d"];
const changed = (now, numbers) => JSON.stringify(now.numbers) !== numbers;
const text_of = (view) => JSON.stringify(view.numbers);
/** Where both boxes are, how large, how turned. */
const boxes_of = ({ numbers }) =>
  numbers.map(({ rows: [center, half_extents, turn] }) => ({
    center: center.values,
    half_extents: half_extents.values,
    degrees: turn.turn ? undefined : turn.values[0],
  }));
/** Places: name, of which box, what changes.
 *  @type {[string, 0 | 1, "center" | "half_extents"][]} */
const kPlaces = [["Box", 0, "center"], ["Frustum", 1, "center"], ["++", 0, "half_extents"], ["F3", 1, "half_extents"]];

for (const lesson of kLessons)
  test(`${lesson}: box and frustum are dragged, each by itself, and undone`, async (t) => {
    const page = await visit(t, `?lesson=${lesson}`);
    const own = await state(page);
    for (const [name, which, key] of kPlaces) {
      const id = lesson === "frustum-3d" && name === "++" ? "+++" : name;
      await drag(page, id, 13, -9);
      const now = await until(page, changed, text_of(own));
      assert.notDeepEqual(boxes_of(now)[which][key], boxes_of(own)[which][key], `${id} changes the ${key}`);
      assert.deepEqual(boxes_of(now)[1 - which], boxes_of(own)[1 - which]);
      await page.keyboard.press("Control+z");
      await until(page, (view, text) => JSON.stringify(view.numbers) === text, text_of(own));
    }
    if (boxes_of(own)[0].degrees === undefined) return;
    await drag(page, "Frustum turn", 0, 30);
    assert.notEqual(boxes_of(await until(page, changed, text_of(own)))[1].degrees, boxes_of(own)[1].degrees);
  });

test("a finger drags the frustum's corner on a phone", async (t) => {
  const page = await visit(t, "?lesson=frustum-2d", kPhone);
  const own = await state(page);
  await drag_by_finger(page, "F3", -14, 10);
  const now = await until(page, changed, text_of(own));
  assert.notDeepEqual(boxes_of(now)[1].half_extents, boxes_of(own)[1].half_extents);
  assert.deepEqual(boxes_of(now)[0], boxes_of(own)[0]);
});

for (const lesson of kLessons)
  test(`${lesson}: which corner is it? A click on the stage answers, and the step shows p and n`, async (t) => {
    const page = await visit(t, `?lesson=${lesson}&step=${lesson === "frustum-3d" ? 1 : 0}`);
    const { asked, step: from } = await until(page, (now) => now.asked);
    assert.equal(asked.id, "p-vertex");
    const places = await handles(page);
    // The centre of the box is no corner: nothing is answered.
    const middle = places.find(({ id }) => id === "Box");
    await page.mouse.click(middle.x, middle.y);
    await still(page);
    assert.ok((await state(page)).asked);
    const corners = places.filter(({ id }) => /^[+−]+$/.test(id));
    assert.equal(corners.length, asked.choices.length);
    const { outcome, step, readout } = await answer(page, corners[0].id);
    assert.equal(outcome.predicted === corners[0].id, outcome.tries === 1); // a wrong one is followed by another
    assert.equal(outcome.right, outcome.predicted === outcome.happened);
    assert.equal(step, from + 1);
    assert.ok(readout.p_distance > readout.n_distance);
  });

test("the corner's signs answer by keyboard as well", async (t) => {
  const page = await visit(t, "?lesson=frustum-2d&step=0");
  await until(page, (now) => now.asked);
  const { outcome } = await answer(page, "−+", "keyboard");
  assert.equal(outcome.predicted, "−+");
});

test("a long box across the frustum: the wrong test loses it, the right ones do not, the task is done", async (t) => {
  const across = "boxes=0.6,0,0.2,1.7,1,0;0.55,0,1.05,1.15,1,0";
  const verdicts = {};
  for (const algorithm of ["p_n_vertex", "corners_per_plane", "corners_outside"]) {
    const page = await visit(t, `?lesson=frustum-2d&a=${algorithm}&${across}&step=99`);
    const view = await until(page, (now) => now.step === now.steps);
    assert.equal(view.algorithm, algorithm);
    verdicts[algorithm] = view.readout.verdict;
    assert.ok(view.grade.done, view.grade.says);
  }
  assert.deepEqual(verdicts, { p_n_vertex: 1, corners_per_plane: 1, corners_outside: 2 });
});

test("the tools speak of a box and a frustum, and take numbers for both but no frustum without depth", async (t) => {
  const page = await visit(t, "?lesson=frustum-2d");
  await page.getByRole("tab", { name: "Boxes" }).click();
  await page.getByRole("heading", { name: "Box and frustum", exact: true }).waitFor();
  await page.getByLabel("Turn of the frustum in degrees").fill("20");
  await page.keyboard.press("Enter");
  await until(page, (now) => Math.abs(now.numbers[1].rows[2].values[0] - 20) < 1e-9);
  await page.getByLabel("Centre x of the box").fill("0.5");
  await page.keyboard.press("Tab");
  const before = await until(page, (now) => now.numbers[0].rows[0].values[0] === 0.5);
  await page.getByLabel("Half sizes: x depth, y far face x of the frustum").fill("0");
  await page.keyboard.press("Tab");
  await page.getByText(/depth and far face must be above 0/i).last().waitFor();
  assert.deepEqual(boxes_of(await state(page)), boxes_of(before));
  const other = await visit(t, "?lesson=obb-sat");
  await other.getByRole("tab", { name: "Boxes" }).click();
  await other.getByLabel("Turn of A in degrees").waitFor();
});

test("the address carries box and frustum to the last digit", async (t) => {
  for (const lesson of kLessons) {
    const page = await visit(t, `?lesson=${lesson}`);
    const own = await state(page);
    await drag(page, "Frustum", -11, 7);
    const moved = await until(page, changed, text_of(own));
    // The address follows a moment later.
    for (let href = ""; href !== page.url() || !/rows=/.test(href); await page.waitForTimeout(400)) href = page.url();
    await page.reload();
    await ready(page);
    const again = await state(page);
    assert.deepEqual(boxes_of(again), boxes_of(moved));
    assert.equal(again.trace, moved.trace);
  }
});

test("near an edge in space, a sphere that touches nothing is kept until one plane rejects it", async (t) => {
  const page = await visit(t, "?lesson=frustum-sphere&situation=edge&step=7");
  const own = await until(page, (now) => now.situation === "edge" && now.step === now.steps);
  assert.equal(own.readout.verdict, 1);
  await still(page);
  await drag(page, "Sphere", -25, 20);
  const { plane } = (await until(page, (now) => now.readout.verdict === 2)).readout;
  assert.equal(plane, 1, "the right plane rejects it");
});

test("six planes, six signs: their numbers follow the point, in HTML as beside the stage", async (t) => {
  const page = await visit(t, "?lesson=frustum-point&situation=space&step=99");
  const own = await until(
    page,
    (now) => now.situation === "space" && now.step === now.steps && now.asked === null && now.panels.length === 1,
  );
  assert.deepEqual(
    await panel_tables(page),
    own.panels.map(({ title, head, rows }) => ({ title, head, rows })),
  );
  const [{ title, rows }] = own.panels;
  assert.equal(title, "n · p + d, for every plane");
  assert.deepEqual(rows.map(([name]) => name), ["Left", "Right", "Bottom", "Top", "Near", "Far"]);
  const outside = ({ panels }) => panels[0].rows.filter(([, number]) => number.startsWith("+")).map(([name]) => name);
  assert.equal(own.readout.verdict === 2, outside(own).length > 0, "outside is outside of a plane");
  await still(page);
  await drag(page, "Point", 60, -200);
  const moved = await until(page, (now, before) => JSON.stringify(now.panels[0].rows) !== before, JSON.stringify(rows));
  assert.ok(outside(moved).length > 0, JSON.stringify(moved.panels[0].rows));
  assert.equal(moved.readout.verdict, 2);
});

test("how rare false positives are is counted by a button that the keyboard reaches, and read in HTML", async (t) => {
  const page = await visit(t, "?lesson=frustum-sphere&situation=edge&step=99");
  await until(page, (now) => now.situation === "edge" && now.asked === null && now.panels.length === 2);
  const count = page.getByRole("button", { name: "Test 1,000,000 random spheres" });
  await count.focus();
  const box = await count.boundingBox();
  assert.ok(box.height >= 24 && box.width > 100, "it is seen while it has the focus");
  await page.keyboard.press("Enter");
  // All million are counted in tests/app/panel_words.test.cpp: a page counts as many in a frame as its processor has
  // time for.
  const some = await until_within(
    120_000,
    page,
    ({ panels }) => panels[1].rows.length === 4 && Number(panels[1].rows[0][1].replaceAll(",", "")) > 2000,
  );
  const { rows, says, button } = some.panels[1];
  assert.match(button.words, /^Tested: [\d,]+ (of 1,000,000|random spheres)$/);
  assert.equal(button.enabled, false);
  assert.deepEqual(
    rows.map(([name]) => name),
    ["Called intersecting", "Touch nothing, near edges", "Touch nothing, near vertices", "False positives among them"],
  );
  const [intersecting, edges, vertices] = rows.map(([, count]) => Number(count.replaceAll(",", "")));
  assert.ok(edges > vertices && vertices > 0 && edges + vertices < intersecting);
  const share = 100 * (edges + vertices) / intersecting;
  assert.ok(Math.abs(parseFloat(rows[3][1]) - share) <= 0.005 * share, `${rows[3][1]} is ${share}`);
  assert.match(says, /seed 1;/);
  assert.deepEqual((await panel_tables(page))[1].rows.map(([name]) => name), rows.map(([name]) => name));
});
