// Exercises on the page: decided by mouse, finger and keyboard; hints, mistakes, marks; kept over a reload; handed in.
import { spawnSync } from "node:child_process";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import {
  assert, handles, kPhone, kWide, load, paste, ready, start, state, still, stop, tap, until, visit,
} from "./support.mjs";

const kSnug = fileURLToPath(new URL("../../build/release/snug", import.meta.url));

before(start);
after(stop);

const exercise = (page) => page.evaluate(() => window.snug.exercise());
const result = (page) => page.evaluate(() => JSON.parse(window.snug.result()));
/** Without the joiners that keep a vertex's signs on one line. */
const hint_of = async (page) => (await page.locator(".ask .hint").last().textContent() ?? "").replaceAll("\u2060", "");

/** Until the exercise asks for that decision: the step of the one before may still be played. */
async function at(page, decision) {
  await until(page, (now, wanted) => now.asked && now.exercise?.decision === wanted, decision);
  return exercise(page);
}

/** The names of the right answers, as the last hint of each decision tells them. */
async function answers_of(t, id, seed) {
  const page = await visit(t, `?exercise=${id}&seed=${seed}`);
  const names = [];
  const { decisions } = await exercise(page);
  for (let i = 0; i < decisions; ++i) {
    await at(page, i);
    for (let hint = ""; !/^Hint: The (answer|order): /.test(hint); hint = await hint_of(page)) {
      const { hints } = await exercise(page);
      await page.getByRole("button", { name: /^(Hint|Show the answer)/ }).press("Enter");
      await until(page, (now, before) => now.exercise.hints.length > before, hints);
    }
    names.push(/The (?:answer|order): (.*)\.$/.exec(await hint_of(page))[1]);
    await decide(page, names[i]);
  }
  return names;
}

/** Decides by keyboard alone: the name is typed, or the choice's button is pressed. */
async function decide(page, name) {
  const { choices } = await exercise(page);
  if (name.startsWith("1. ")) { // its lines by their digits, from wherever the focus is; Enter then gives all of it
    await page.locator(".ask .choices .button").first().focus();
    for (const line of name.split("; "))
      await page.keyboard.press(String(choices.indexOf(line.replace(/^\d+\. /, "")) + 1));
    return page.keyboard.press("Enter");
  }
  // Any of several right choices will do.
  const choice = choices.find((one) => one === name || name.split(/, | or /).includes(one));
  if (choice) {
    await page.getByRole("button", { name: choice, exact: true }).focus();
    return page.keyboard.press("Enter");
  }
  await page.locator(".ask input").focus();
  await page.keyboard.type(name);
  await page.keyboard.press("Enter");
}

/** Makes all decisions in order. */
async function decide_all(page, names) {
  for (const [i, name] of names.entries()) {
    await at(page, i);
    await decide(page, name);
  }
}

test("a tap decides, the step is played at once, and what happened is told beside the next decision", async (t) => {
  const names = await answers_of(t, "be-quickhull", 11);
  const page = await visit(t, "?exercise=be-quickhull&seed=11");
  const begun = await exercise(page);
  assert.deepEqual([begun.decision, begun.mark, begun.told], [0, 0, false]);
  assert.ok(begun.targets.includes(names[0]));
  const { step } = await state(page);
  await tap(page, names[0]);
  const next = await at(page, 1);
  assert.equal(next.mark, 1);
  assert.ok((await state(page)).step > step);
  assert.match(await page.locator(".ask .before").textContent(), new RegExp(`^✓ ${names[0]} is farthest from`));
});

test("a number, an order and each sort of decision are given by keyboard alone, for every mark", async (t) => {
  for (const id of ["be-ritter", "sat-plane", "p-and-n-vertex", "radii-of-boxes", "order-of-a-sat-test"]) {
    const names = await answers_of(t, id, 3);
    const page = await visit(t, `?exercise=${id}&seed=3`);
    const code = page.locator("#code .lines li");
    const waits = (await code.allTextContents()).join() === "Shown once you have answered.";
    assert.equal(waits, id === "order-of-a-sat-test", "the pseudocode would tell the order");
    await decide_all(page, names);
    const over = await until(page, (now) => now.exercise.finished);
    assert.equal(over.exercise.mark, names.length, id);
    assert.equal(await page.locator(".mark-line").textContent(), `${names.length} of ${names.length}`);
    assert.ok((await code.count()) > 1);
  }
});

test("a wrong decision is told with its rule, a second try earns a half, then the right step is shown", async (t) => {
  const [first] = await answers_of(t, "be-quickhull", 11);
  const page = await visit(t, "?exercise=be-quickhull&seed=11");
  const { targets } = await exercise(page);
  const [one, other] = targets.filter((name) => name !== first);
  await tap(page, one);
  let now = await until(page, (it) => it.asked?.tried);
  assert.equal(now.exercise.decision, 0);
  assert.match(await page.locator(".says").textContent(), /Not that one/);
  await tap(page, other);
  now = await until(page, (it) => it.exercise.told);
  assert.match(await page.locator(".ask .outcome").textContent(), new RegExp(`Not quite.*${first} is farthest`));
  await page.keyboard.press("Enter");
  assert.equal((await at(page, 1)).mark, 0);
});

test("at its end the student's run is gone through beside the right one, by keyboard", async (t) => {
  const names = await answers_of(t, "be-quickhull", 11);
  const page = await visit(t, "?exercise=be-quickhull&seed=11");
  await at(page, 0);
  await decide(page, names[0]);
  const { targets } = await at(page, 1);
  for (const name of targets.filter((one) => one !== names[1]).slice(0, 2)) {
    await decide(page, name);
    await until(page, (now) => now.asked?.tried || now.exercise.told);
  }
  await page.keyboard.press("Enter");
  for (let i = 2; i < names.length; ++i) await at(page, i), await decide(page, names[i]);
  await until(page, (now) => now.exercise.finished && !now.outcome);
  assert.match(await page.locator(".exercise-end").textContent(), /first differs .* at decision 2 \(yours: /);
  const { step } = await state(page);
  await page.keyboard.press("r");
  const own = await until(page, (now) => now.exercise.run === "own");
  assert.deepEqual([own.exercise.decision, own.outcome.right, own.outcome.shown], [1, false, true]);
  await page.keyboard.press("ArrowRight");
  await until(page, (now) => now.exercise.decision === 2 && now.outcome.right);
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("r");
  const right = await until(page, (now) => now.exercise.run === "right");
  assert.equal(right.step, own.step);
  assert.match(await page.locator(".ask").textContent(), /Decision 2 [(]yours: .*; right: /);
  await page.keyboard.press("ArrowRight");
  await until(page, (now, before) => now.step === before + 1, own.step);
  await page.keyboard.press("End");
  await until(page, (now, last) => now.step === last && now.exercise.run === "", step);
});

test("hints have their price, and the attempt goes on after a reload", async (t) => {
  const page = await load(t, "?exercise=be-ritter&seed=5");
  await page.keyboard.press("h");
  await until(page, (now) => now.exercise.hints.length === 1);
  assert.match(await page.getByRole("button", { name: /^(Hint|Show the answer)/ }).textContent(), /costs 0\.25/);
  const { attempts: [attempt] } = await result(page);
  assert.deepEqual([attempt.exercise, attempt.seed, attempt.hints], ["be-ritter", 5, 1]);
  await page.waitForTimeout(500);
  await page.reload();
  await ready(page);
  const back = await exercise(page);
  assert.deepEqual([back.decision, back.hints], [0, 1]);
  assert.equal(await page.evaluate(() => window.snug.saved()), "device");
});

/** What is on the stage, from wherever it is looked at: the view can be moved. */
const on_stage = ({ size, seed, edited, canUndo, trace }) => ({ size, seed, edited, canUndo, trace });

test("nothing on the stage can be changed, and no decision is skipped", async (t) => {
  const page = await visit(t, "?exercise=fit-a-kdop&seed=2");
  const before = on_stage(await state(page));
  assert.deepEqual([before.edited, before.canUndo, typeof before.trace], [false, false, "string"]);
  const [{ x, y }] = await handles(page);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y + 40, { steps: 6 });
  await page.mouse.up();
  await still(page);
  const keys = ["s", "a", "Delete", "Control+z", "PageDown", "PageDown", "ArrowRight", "End"];
  for (const key of keys) await page.keyboard.press(key);
  await still(page);
  assert.deepEqual(on_stage(await state(page)), before);
  assert.equal((await exercise(page)).decision, 0);
  await paste(page, "0\t0\n4\t0\n");
  await page.getByText("In an exercise, points cannot be pasted or opened.", { exact: true }).waitFor();
  assert.deepEqual(on_stage(await state(page)), before);
});

test("where a test ends is not told by the number of steps before the last decision", async (t) => {
  const page = await visit(t, "?exercise=sat-space&seed=1");
  const slider = page.locator("#player input[type=range]");
  const { step, steps, furthest } = await state(page);
  assert.ok(furthest < steps);
  assert.equal(await slider.getAttribute("aria-valuetext"), `step ${step}`);
  assert.equal(await slider.getAttribute("max"), String(furthest));
});

test("a double click decides once", async (t) => {
  const [name] = await answers_of(t, "be-iterative-ritter", 7);
  const page = await visit(t, "?exercise=be-iterative-ritter&seed=7");
  await at(page, 0);
  await page.getByRole("button", { name, exact: true }).dblclick();
  await still(page);
  assert.equal((await exercise(page)).decision, 1);
});

test("by finger on a phone, with targets large enough, and the summary leads to another instance", async (t) => {
  const names = await answers_of(t, "aabb-overlap", 4);
  const page = await visit(t, "?exercise=aabb-overlap&seed=4", kPhone);
  for (const [i, name] of names.entries()) {
    await at(page, i);
    const button = page.getByRole("button", { name, exact: true });
    assert.ok((await button.boundingBox()).height >= 44);
    await button.tap();
  }
  const over = await until(page, (now) => now.exercise.finished);
  assert.ok((await page.getByRole("button", { name: "Go through your run" }).boundingBox()).height >= 44);
  const saved = page.waitForEvent("download");
  await page.getByRole("button", { name: "Hand in" }).tap();
  const file = await saved;
  assert.equal(file.suggestedFilename(), "aabb-overlap-4.json");
  const { stdout } = spawnSync(kSnug, ["grade", "--json", await file.path()], { encoding: "utf8" });
  const { status, mark, of } = JSON.parse(stdout);
  assert.deepEqual([status, mark, of], ["ok", over.exercise.mark, names.length], "the replay earns the page's mark");
  await page.getByRole("button", { name: "Harder instance" }).tap();
  const other = await until(page, (now) => now.exercise && now.exercise.seed !== 4);
  assert.equal(other.exercise.decision, 0);
});

test("the course lists the sets, with the marks that were reached", async (t) => {
  const names = await answers_of(t, "be-quickhull", 6);
  const page = await load(t, "?exercise=be-quickhull&seed=6");
  await decide_all(page, names);
  await until(page, (now) => now.exercise.finished);
  await page.waitForTimeout(500);
  await page.locator("#home").click();
  await page.locator(".set").first().waitFor();
  const line = page.locator(".set-list a", { hasText: "Be Quickhull" }).first();
  assert.match(await line.textContent(), new RegExp(`${names.length} of ${names.length}$`));
  await line.click();
  await until(page, (now) => now.exercise?.exercise === "be-quickhull");
});

/** The movable points of the instance of seed 3, and where they make Ritter's circle bad. */
const kBegin = { P0: [-0.12152, -0.18495], P1: [0.4214, 0.4223], P2: [-0.39414, -0.07755] };
const kModel = { P0: [-0.282, -0.362], P1: [0.784, 0.653], P2: [0.789, -0.908] };

/** Drags a point to where the model has it. places: where the points are, of which two tell the scale of the stage. */
async function put(page, places, name) {
  const [x, y] = kModel[name];
  const at = Object.fromEntries((await handles(page)).map((handle) => [handle.id, handle]));
  const [a, b] = ["P0", "P2"];
  const scale = (at[b].x - at[a].x) / (places[b][0] - places[a][0]);
  await page.mouse.move(at[name].x, at[name].y);
  await page.mouse.down();
  await page.mouse.move(at[a].x + scale * (x - places[a][0]), at[a].y - scale * (y - places[a][1]), { steps: 4 });
  await page.mouse.up();
  await still(page);
  places[name] = [x, y];
}

test("what is built by dragging earns a mark for each level, is kept over a reload, and handed in", async (t) => {
  const page = await visit(t, "?exercise=build-worst-ritter&seed=3");
  const begun = await exercise(page);
  assert.deepEqual([begun.mark, begun.of, begun.targets], [0, 4, ["P0", "P1", "P2"]]);
  assert.match(begun.prompt, /^Move P0, P1 and P2/);
  assert.ok(await page.getByRole("button", { name: "Done" }).isDisabled());
  const places = { ...kBegin };
  await put(page, places, "P0");
  assert.equal((await exercise(page)).mark, 1);
  assert.equal(await page.locator(".levels .now").count(), 1);
  await page.reload();
  await ready(page);
  assert.equal((await exercise(page)).mark, 1);
  await put(page, places, "P1");
  await put(page, places, "P2");
  await until(page, (now) => now.exercise.finished);
  const [attempt] = (await result(page)).attempts;
  assert.deepEqual([attempt.mark, attempt.of], [4, 4]);
  assert.match(attempt.decisions[0], /^b-?[\d.]+,/);
  const { trace } = await state(page);
  await page.getByRole("button", { name: "Show a solution" }).press("Enter");
  await until(page, (now, before) => now.trace !== before, trace);
  assert.ok((await state(page)).exercise.build.levels.every(({ now }) => now));
  assert.equal(await page.locator(".exercise-end .levels .now").count(), 4);
});

test("a solution that is shown after one level ticks no other", async (t) => {
  const page = await visit(t, "?exercise=build-worst-ritter&seed=3");
  await put(page, { ...kBegin }, "P0");
  await page.getByRole("button", { name: "Done" }).press("Enter");
  await page.getByRole("button", { name: "Show a solution" }).press("Enter");
  await until(page, (now) => now.exercise.build.levels.every((level) => level.now));
  const card = page.locator(".exercise-end");
  await card.getByText("On the stage: a solution.").waitFor();
  assert.equal(await card.locator(".mark-line").textContent(), "1 of 4");
  assert.equal(await card.locator(".levels .now").count(), 1);
});

test("an exercise that is opened from the Points shows its text, where it has no Points", async (t) => {
  for (const exercise of ["be-quickhull", "be-ritter"]) {
    const page = await visit(t, "?lesson=convex-hull", exercise === "be-ritter" ? kPhone : kWide);
    await page.getByRole("tab", { name: "Points" }).click();
    await page.evaluate((id) => window.snug.restart(`?exercise=${id}&seed=3`), exercise);
    await at(page, 0);
    assert.ok(await page.locator("#prose").isVisible());
    assert.equal(await page.locator("#tab-read").getAttribute("aria-selected"), "true");
  }
});

test("the name of an axis stays on one line", async (t) => {
  const page = await visit(t, "?exercise=sat-space&seed=3", kPhone);
  await at(page, 0);
  assert.match(await page.locator(".ask .prompt").textContent() ?? "", /onto A\u00a0x[?]$/);
});

test("an example is built by keyboard alone: what is selected is moved by the arrows", async (t) => {
  const page = await visit(t, "?exercise=build-worst-ritter&seed=3");
  await page.keyboard.press("]");
  await until(page, (now) => now.selected === 0);
  for (let i = 0; i < 40 && (await exercise(page)).mark < 1; ++i) {
    await page.keyboard.press(i % 2 ? "ArrowLeft" : "ArrowDown");
    await still(page);
  }
  await page.getByRole("button", { name: "Done" }).press("Enter");
  const { exercise: over } = await until(page, (now) => now.exercise.finished);
  assert.equal((await result(page)).attempts[0].mark, over.mark);
});

test("a claim is refuted by keyboard alone, with the numbers of the points", async (t) => {
  const page = await visit(t, "?exercise=break-pca-box&seed=2");
  assert.equal((await exercise(page)).of, 4);
  assert.match(await page.locator(".claim").textContent(), /always less than 60 % above/);
  await page.getByRole("tab", { name: "Points" }).focus();
  await page.keyboard.press("Enter");
  const points = page.locator("#points");
  for (const hidden of ["Scatter", "Open file…"]) assert.ok(await points.getByText(hidden).first().isHidden(), hidden);
  const select = async (i) => {
    await page.getByLabel("Selected point", { exact: true }).fill(String(i));
    await page.keyboard.press("Enter");
    await until(page, (now, wanted) => now.selected === wanted, i);
  };
  const { size } = await state(page);
  for (let left = size; left > 4; --left) {
    await select(0);
    await points.getByRole("button", { name: "Delete" }).press("Enter");
    await until(page, (now, more) => now.size < more, left);
  }
  for (const [i, at] of [[-1.06, -0.48], [0.23, 0.73], [0.19, -0.52], [-1.03, 0.78]].entries()) {
    await select(i);
    for (const [axis, value] of at.entries()) {
      const field = points.locator(".coordinates input").nth(axis + 1); // after the point
      await field.fill(String(value));
      await field.press("Enter");
    }
  }
  const over = await until(page, (now) => now.exercise.finished);
  assert.equal(over.exercise.mark, 4);
  assert.equal((await result(page)).attempts[0].mark, 4);
});

test("practice has no mark, takes nothing for hints, and keeps nothing", async (t) => {
  const page = await visit(t, "?exercise=be-aabb-centre&seed=4&practice=1");
  assert.equal((await exercise(page)).mark, null);
  await page.getByRole("button", { name: "Hint", exact: true }).press("Enter");
  await until(page, (now) => now.exercise.hints.length === 1);
  const names = await answers_of(t, "be-aabb-centre", 4);
  const again = await visit(t, "?exercise=be-aabb-centre&seed=4&practice=1");
  await decide_all(again, names);
  await until(again, (now) => now.exercise.finished);
  assert.equal(await again.locator(".mark-line").count(), 0);
  await again.getByRole("button", { name: "Do it for a mark" }).click();
  await until(again, (now) => now.exercise && !now.exercise.practises);
  assert.equal((await exercise(again)).mark, 0);
});

test("who does well is led to a harder instance", async (t) => {
  const names = await answers_of(t, "be-aabb-centre", 5);
  const page = await visit(t, "?exercise=be-aabb-centre&seed=5");
  await decide_all(page, names);
  await page.getByRole("button", { name: "Harder instance" }).click();
  await until(page, (now) => now.exercise?.level === 1);
  assert.match(page.url(), /&level=1$/);
});

test("an exercise's formulas are typeset, in its text and in what it asks", async (t) => {
  const page = await visit(t, "?exercise=radii-of-boxes&seed=4");
  assert.ok(await page.locator("#prose math").count() >= 6);
  assert.equal(await page.locator(".ask .prompt math").count(), 1);
  const words = await page.locator("#prose").evaluate((prose) => {
    const copy = prose.cloneNode(true);
    for (const math of copy.querySelectorAll("math")) math.remove();
    return copy.textContent;
  });
  assert.doesNotMatch(words, /[a-z]_[a-zA-Z]/);
});
