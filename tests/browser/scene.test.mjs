// Scenes that move: stepped by keyboard to their end, answered, reloaded, placed; and nothing is drawn while nothing
// moves.
import { after, before, test } from "node:test";
import {
  answer, assert, drag, go_on, handles, kPhone, moved, ready, start, state, still, stop, until, visit,
} from "./support.mjs";

before(start);
after(stop);

const kFrames = 120;
const kScenes = [
  { id: "scene-broad", first: "boxes", effects: ["spin", "orbit", "refit", "broad_phase", "narrow_phase"] },
  { id: "scene-updates", first: "slack-turned", effects: ["spin body", "refit"] },
];

const counts = (view) =>
  Object.fromEntries(
    view.effects.map(({ effect, constructed, run, skipped }) => [effect, [constructed, run, skipped]]),
  );
const all = (effects, runs) => Object.fromEntries(effects.map((effect) => [effect, [1, runs, 0]]));

/** To the end by keys alone; each question on the way is answered with its first choice. Returns their ids. */
async function step_through(page) {
  await page.locator("#canvas").focus();
  const asked = [];
  for (let view = await state(page); view.step < view.steps; view = await state(page)) {
    if (view.asked) {
      asked.push(view.asked.id);
      await answer(page, 0, "keyboard");
      await page.evaluate(() => document.activeElement.blur());
      await page.keyboard.press("ArrowRight"); // continues
      await until(page, (now) => !now.outcome);
      continue;
    }
    await page.keyboard.press("ArrowRight");
    await until(page, (now, step) => now.step !== step || now.asked, view.step);
  }
  return asked;
}

test("an effect is switched off and on by keyboard alone", async (t) => {
  const page = await visit(t, "?lesson=scene-broad&step=3");
  const field = page.getByRole("checkbox", { name: "narrow phase" });
  assert.ok(await field.isChecked());
  await page.locator("#player button").first().focus();
  for (let i = 0; i < 30 && !(await field.evaluate((node) => node === document.activeElement)); ++i)
    await page.keyboard.press("Tab");
  await page.keyboard.press(" ");
  const off = await until(page, (now) => now.effects.some(({ on }) => !on));
  assert.deepEqual(off.effects.filter(({ on }) => !on).map(({ effect }) => effect), ["narrow_phase"]);
  assert.ok(!(await field.isChecked()) && (await field.evaluate((node) => node === document.activeElement)));
  await page.keyboard.press(" ");
  await until(page, (now) => now.effects.every(({ on }) => on));
  assert.equal(off.step, 3);
});

test("what an effect that is off made is told as that of its last frame", async (t) => {
  const page = await visit(t, "?lesson=scene-broad&algorithm=tree&step=3");
  await page.getByRole("checkbox", { name: "broad phase" }).focus();
  await page.keyboard.press(" ");
  await until(page, (now) => now.effects.some(({ on }) => !on));
  await page.locator("#canvas").focus();
  await page.keyboard.press("ArrowRight");
  const later = await until(page, (now) => now.step === 4);
  assert.equal(later.caption, "Frame 4: broad phase is off, so the pairs are still those of frame 3.");
  await page.keyboard.press("ArrowLeft");
  assert.match((await until(page, (now) => now.step === 3)).caption, /^Frame 3: of 780 pairs, the AABBs leave \d+\./);
});

test("a scene's timeline counts frames, wherever it is named", async (t) => {
  const page = await visit(t, "?lesson=scene-updates&step=0");
  const player = page.getByRole("toolbar", { name: "Player" });
  await page.getByRole("button", { name: "Next frame" }).focus();
  for (const name of ["First frame", "Previous frame", "Next frame", "Last frame"])
    assert.equal(await player.getByRole("button", { name, exact: true }).count(), 1, name);
  assert.equal(await player.getByRole("button", { name: /step/i }).count(), 0);
  const slider = player.getByRole("slider", { name: "Frame" });
  assert.equal(await slider.getAttribute("aria-valuetext"), "frame 0 of 120");
  assert.match((await state(page)).caption, /nothing has moved yet\. Go to frame 1\.$/);
  const other = (await visit(t, "?lesson=sphere-ritter&step=0")).getByRole("toolbar", { name: "Player" });
  assert.equal(await other.getByRole("button", { name: "Step", exact: true }).count(), 1);
  assert.match(await other.getByRole("slider", { name: "Step" }).getAttribute("aria-valuetext"), /^step 0 of \d+$/);
});

test("every kind of volume is measured against the same hull", async (t) => {
  const told = {};
  for (const option of ["rotated_box", "rebuild", "loose", "sphere", "obb", "k14"])
    told[option] = (await state(await visit(t, `?lesson=scene-updates&a=${option}&step=40`))).readout;
  for (const [option, { over_hull }] of Object.entries(told)) assert.ok(over_hull > 1, option);
  assert.ok(told.sphere.slack < 1e-6 && told.obb.slack < 1e-6); // each against its own kind: that tells them not apart,
  assert.ok(told.obb.over_hull < told.sphere.over_hull / 2); // and the hull does: the stick is long and thin
  assert.ok(told.loose.over_hull > told.rotated_box.over_hull && told.rotated_box.over_hull > told.rebuild.over_hull);
});

for (const { id, first, effects } of kScenes) {
  test(`${id}: every frame by keyboard, each effect as often as it is called; at rest nothing is drawn`, async (t) => {
    const page = await visit(t, `?lesson=${id}`);
    const begun = await state(page);
    assert.equal(begun.steps, kFrames);
    assert.deepEqual(counts(begun), all(effects, 0));
    const asked = await step_through(page);
    assert.equal(asked[0], first);
    const end = await state(page);
    assert.equal(end.step, kFrames);
    assert.equal(end.readout.frame, kFrames);
    assert.equal(end.outcomes.length, asked.length);
    assert.deepEqual(counts(end), all(effects, kFrames));
    assert.match(end.caption, /[.]$/);
    await still(page);
    const { framesDrawn } = await state(page);
    await page.waitForTimeout(1000);
    assert.equal((await state(page)).framesDrawn, framesDrawn);
  });

  test(`${id}: a question is answered, and the address leads back to the same frame`, async (t) => {
    const page = await visit(t, `?lesson=${id}`);
    await page.locator("#canvas").focus();
    for (let view = await state(page); !view.asked; view = await state(page)) await page.keyboard.press("ArrowRight");
    const told = await answer(page, 0, "keyboard");
    assert.equal(told.outcome.question, first);
    assert.ok(told.outcome.happened.length > 0 && told.outcome.because.length > 0);
    await go_on(page);
    await page.keyboard.press((await state(page)).asked ? "s" : "ArrowRight"); // another question may wait here
    if ((await until(page, (now, step) => now.step === step + 1, told.step)).outcome) await go_on(page);
    const there = await state(page);
    // The address follows a moment later.
    for (let href = ""; href !== page.url() || !/step=/.test(href); await page.waitForTimeout(400)) href = page.url();
    await page.reload();
    await ready(page);
    const again = await state(page);
    for (const key of ["lesson", "seed", "step", "steps", "caption", "trace", "readout"])
      assert.deepEqual(again[key], there[key]);
    assert.deepEqual(counts(again), counts(there));
  });
}

test("each effect is timed here, and nothing that is the same everywhere says so", async (t) => {
  const page = await visit(t, "?lesson=scene-broad");
  const begun = await state(page);
  for (const { microseconds } of begun.effects) assert.match(microseconds, /^(< )?[\d.,]+$/);
  await page.reload();
  await ready(page);
  const again = await state(page);
  assert.deepEqual([again.trace, again.readout, counts(again)], [begun.trace, begun.readout, counts(begun)]);
});

test("the volume that follows the body, and how, is the student's choice", async (t) => {
  const page = await visit(t, "?lesson=scene-updates");
  const options = await page
    .locator("#algorithm")
    .locator("option")
    .evaluateAll((all) => all.map(({ value }) => value));
  assert.deepEqual(options, ["rotated_box", "rebuild", "hill_climb", "loose", "sphere", "obb", "k14"]);
  await page.locator("#canvas").focus();
  for (let view = await state(page); view.step < kFrames; view = await state(page)) {
    // It goes to the next question; pressed twice, it skips that.
    for (let presses = view.asked ? 2 : 1; presses > 0; --presses) await page.keyboard.press("PageDown");
    await moved(page, view);
  }
  const told = {};
  for (const option of options) {
    await page.locator("#algorithm").selectOption(option);
    const view = await until(page, (now, name) => now.algorithm === name && now.step === now.steps, option);
    assert.deepEqual(counts(view), all(["spin body", "refit"], kFrames));
    told[option] = view.readout;
  }
  // After a whole turn all are as tight as at the beginning; the loose box never was.
  for (const option of options)
    assert.ok(option === "loose" ? told[option].slack > 100 : told[option].slack < 0.01, option);
  assert.equal(told.rebuild.cost, 80);
  assert.ok(told.hill_climb.cost > 0 && told.hill_climb.cost < 80); // six walks
  assert.ok(told.k14.cost > told.hill_climb.cost); // fourteen
  for (const option of ["rotated_box", "loose", "sphere", "obb"]) assert.equal(told[option].cost, 0, option);
});

test("back takes a scene to the very frame that was there", async (t) => {
  const page = await visit(t, "?lesson=scene-broad&step=70");
  const there = await state(page);
  await page.locator("#canvas").focus();
  await page.keyboard.press("ArrowLeft");
  const before = await until(page, (now) => now.step === 69);
  assert.notDeepEqual(before.readout, there.readout);
  await page.keyboard.press("ArrowRight");
  assert.deepEqual((await until(page, (now) => now.step === 70)).readout, there.readout);
});

test("a body is placed where it begins, and nowhere else", async (t) => {
  const page = await visit(t, "?lesson=scene-broad");
  await page.getByRole("button", { name: "Start with 6 bodies" }).first().click(); // each task has its own
  const begun = await until(page, (now) => now.size === 6 && now.step === 0);
  assert.equal(begun.grade.done, false);
  const [first] = await handles(page);
  await drag(page, first.id, 30, -22);
  const dragged = await state(page);
  assert.notEqual(dragged.trace, begun.trace);
  assert.equal(dragged.step, 0);
  await page.locator("#canvas").focus();
  await page.keyboard.press("Escape");
  for (let now = dragged; now.step < 1; now = await moved(page, now))
    await page.keyboard.press(now.asked ? "s" : "ArrowRight");
  assert.deepEqual(await handles(page), []);
});

test("the tools speak of bodies where a body stands at each point", async (t) => {
  for (const [id, words] of [["scene-broad", "40 bodies"], ["scene-updates", "80 points"]]) {
    const page = await visit(t, `?lesson=${id}`, kPhone);
    await page.getByRole("tab", { name: id === "scene-broad" ? "Bodies" : "Points" }).click();
    await page.getByText(words, { exact: true }).waitFor();
  }
});
