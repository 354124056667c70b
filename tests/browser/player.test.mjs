// Lessons are stepped, asked and answered, without a pointer and with one.
import { after, before, test } from "node:test";
import {
  answer, assert, cut_off, handles, kFirst, kPhone, lessons, moved, start, state, still, stop, until, visit,
} from "./support.mjs";

before(start);
after(stop);

// axe.test.mjs plays one of each kind, from question to question.
test("lessons are stepped to their ends by keyboard alone, each prediction answered", async (t) => {
  for (const id of ["sphere-ritter", "aabb-updates", "frustum-2d", "bvh-traverse"]) {
    const page = await visit(t, `?lesson=${id}`);
    await page.keyboard.press("Home");
    let now = await until(page, (it) => it.step === 0);
    let answered = 0, skipped = 0;
    for (let presses = 0; now.step < now.steps || now.asked || now.outcome; ++presses) {
      assert.ok(presses < 3 * now.steps + 50, `${id} goes on`);
      if (now.asked || now.outcome) assert.deepEqual(await cut_off(page), [], `${id}, step ${now.step}`);
      if (now.asked?.field === "Number") { // it has no first answer
        ++skipped;
        await page.evaluate(() => document.activeElement.blur());
        await page.keyboard.press("s");
      } else if (now.asked) {
        ++answered;
        await answer(page, now.asked.choices.length > 0 ? 0 : now.asked.targets[0], "keyboard");
      } else {
        await page.keyboard.press("ArrowRight");
      }
      now = await moved(page, now);
    }
    // Some of its questions may wait in other situations and algorithms.
    const asked = answered + skipped;
    assert.ok(asked > 0 && asked >= Math.min(3, now.questions), `${id} asks ${asked} times of ${now.questions}`);
    assert.equal(now.outcomes.filter((outcome) => !outcome.skipped).length, answered, id);
    if (answered > 0) await page.locator(".summary").getByText(/\d+ of \d+ predictions? correct/).waitFor();
  }
});

/** Steps on until a question that is answered on the stage. */
async function to_stage_question(t) {
  for (const { id } of await lessons()) {
    const page = await visit(t, `?lesson=${id}&step=0`);
    for (let now = await state(page); now.step < now.steps || now.asked; now = await state(page)) {
      if (now.asked?.onStage) return { page, asked: now.asked };
      await page.evaluate(() => document.activeElement.blur());
      if (now.asked) await page.getByRole("button", { name: "Skip" }).click();
      else await page.keyboard.press("PageDown");
      await moved(page, now);
    }
  }
  throw new Error("no lesson asks on the stage");
}

test("a prediction is answered by tapping the point on the stage twice", async (t) => {
  const { page, asked } = await to_stage_question(t);
  const [name] = asked.targets;
  const answered = await answer(page, name);
  assert.equal(answered.outcome.skipped, false);
  assert.ok(answered.outcome.predicted.includes(name));
  await page.locator(".outcome").getByText(answered.outcome.verdict).first().waitFor();
});

test("only what can be the answer responds, by pointer, name and bracket keys; all else costs nothing", async (t) => {
  const page = await visit(t, "?lesson=sphere-welzl&step=0");
  let now = await state(page);
  for (let i = 0; i < 400 && !(now.asked?.onStage && now.asked.targets.length < now.size); ++i) {
    await page.keyboard.press(now.asked ? "s" : "PageDown");
    await moved(page, now);
    now = await state(page);
  }
  const { asked, outcomes } = now;
  await still(page);
  const other = (await handles(page)).find(({ id }) => !asked.targets.includes(id));
  await page.mouse.click(other.x, other.y);
  await page.locator(".says", { hasText: `${other.id} cannot be the answer.` }).waitFor();
  now = await state(page);
  assert.deepEqual([now.asked.id, now.asked.picked, now.outcomes.length], [asked.id, null, outcomes.length]);
  // A tap that slips is taken back, and the keys go through the targets alone.
  await page.evaluate(() => document.activeElement.blur());
  const seen = [];
  for (let i = 0; i < asked.targets.length; ++i) {
    await page.keyboard.press("]");
    seen.push(
      (await until(page, (it, before) => it.asked.picked && it.asked.picked.handle !== before, seen.at(-1) ?? null))
        .asked.picked.handle,
    );
    if (asked.targets.length === 1) break;
  }
  assert.deepEqual([...seen].sort(), [...asked.targets].sort());
  await page.keyboard.press("Escape");
  await until(page, (it) => it.asked && !it.asked.picked);
  await page.keyboard.press("]");
  await until(page, (it) => it.asked?.picked);
  await page.keyboard.press("Enter");
  const given = await until(page, (it, id) => it.outcome?.question === id || it.asked?.tried, asked.id);
  assert.ok((given.outcome?.predicted ?? given.asked.tried.handle).includes(asked.targets[0]));
});

test("a typed name that there is not is told, and asks again", async (t) => {
  for (const { id } of await lessons()) {
    const page = await visit(t, `?lesson=${id}&step=0`);
    for (
      let now = await state(page), i = 0;
      i < 60 && (now.step < now.steps || now.asked);
      now = await state(page), ++i
    ) {
      if (now.asked?.onStage && now.asked.choices.length === 0) {
        await page.getByLabel("Name", { exact: true }).fill("Q7");
        await page.keyboard.press("Enter");
        await page.locator(".says", { hasText: "Nothing here is called “Q7”." }).waitFor();
        assert.equal((await state(page)).asked.id, now.asked.id);
        return;
      }
      await page.evaluate(() => document.activeElement.blur());
      await page.keyboard.press(now.asked ? "s" : "PageDown");
      await moved(page, now);
    }
  }
  assert.fail("no lesson asks for a name");
});

test("with a finger on a phone the first tap chooses, the second answers", async (t) => {
  const page = await visit(t, "?lesson=frustum-2d&step=0", kPhone);
  const { asked } = await until(page, (it) => it.asked);
  await page.locator("#stage").scrollIntoViewIfNeeded();
  await still(page);
  const at = async () => (await handles(page)).find(({ id }) => id === asked.targets[0]);
  let place = await at();
  await page.touchscreen.tap(place.x, place.y);
  await until(page, (it, name) => it.asked?.picked?.handle === name, asked.targets[0]);
  await still(page);
  place = await at();
  await page.touchscreen.tap(place.x, place.y);
  const given = await until(page, (it) => it.outcome || it.asked?.tried);
  assert.equal(given.outcome?.predicted ?? given.asked.tried.handle, asked.targets[0]);
});

test("playing waits for the answer", async (t) => {
  const { page, asked } = await to_stage_question(t);
  const { step } = await state(page);
  await page.evaluate(() => document.activeElement.blur());
  for (const key of [" ", "End"]) {
    await page.keyboard.press(key);
    await still(page);
    const now = await state(page);
    assert.deepEqual([now.step, now.asked?.id], [step, asked.id], `after "${key}"`);
  }
  // A clicker has no other key than Page Down: it says what a second press does, and that skips.
  await page.keyboard.press("PageDown");
  await page.locator(".says", { hasText: "Press again to skip this question." }).waitFor();
  assert.equal((await state(page)).step, step);
  await page.keyboard.press("PageDown");
  const skipped = await until(page, (it, id) => it.asked?.id !== id, asked.id);
  assert.equal(skipped.outcome.skipped, true);
});

test("an answer that came about over several steps can be watched", async (t) => {
  const page = await visit(t, "?lesson=sphere-welzl&step=0");
  const far = (it) => it.outcome && it.outcome.step - it.outcome.fromStep > 1;
  let now = await state(page);
  for (let i = 0; i < 200 && !far(now); ++i) {
    await page.keyboard.press("PageDown"); // to the next mark, or past the question
    await page.waitForTimeout(60);
    now = await state(page);
  }
  assert.ok(far(now));
  // Also by who wants no motion, for it is asked for.
  const { question, fromStep, step } = now.outcome;
  await page.locator(".outcome").getByRole("button", { name: "Watch how" }).click();
  await until(page, (it, from, to) => it.deciding && !it.outcome && it.step > from && it.step < to, fromStep, step);
  await until(page, (it, to) => it.step === to && !it.playing && it.outcome, step);
  assert.equal((await state(page)).outcome.question, question);
});

test("playing goes on by itself while nothing else happens", async (t) => {
  const page = await visit(t, "?lesson=sphere-iterative&step=14");
  const { asked, step } = await state(page);
  assert.equal(asked, null);
  await page.keyboard.press(" ");
  const on = await until(page, (it, from) => it.step >= from + 2 || it.asked, step);
  assert.ok(on.step > step);
});

test("a menu of the canvas is not covered by the step's sentence", async (t) => {
  const page = await visit(t, `${kFirst}&step=1`);
  const faded = () => page.locator("#caption").evaluate((node) => getComputedStyle(node).opacity);
  assert.equal(await faded(), "1");
  const { x, y, width, height } = await page.locator("#timeline").boundingBox();
  // The speed stands at the right of the timeline's row of buttons.
  for (let to = x + width - 12; to > x + width / 2 && (await faded()) === "1"; to -= 24) {
    await page.mouse.click(to, y + height - 30);
    await still(page);
  }
  assert.equal(await faded(), "0");
  await page.mouse.click(x + width / 2, y - 200);
  await page.waitForFunction(() => getComputedStyle(document.getElementById("caption")).opacity === "1");
});

test("the player's buttons are there for the Tab key", async (t) => {
  const page = await visit(t, `?lesson=${(await lessons())[0].id}&step=0`);
  const step = page.getByRole("toolbar", { name: "Player" }).getByRole("button", { name: "Step", exact: true });
  await step.focus();
  await page.keyboard.press("Enter");
  await until(page, (now) => now.step === 1 || now.asked);
});

test("when nothing changes no frame is drawn", async (t) => {
  const page = await visit(t);
  await still(page);
  const before = (await state(page)).framesDrawn;
  await page.waitForTimeout(1000);
  assert.equal((await state(page)).framesDrawn, before);
  await page.keyboard.press("Home");
  await page.waitForFunction((drawn) => window.snug.state().framesDrawn > drawn, before);
});

test("one or two algorithms are chosen, and the pseudocode is theirs", async (t) => {
  const page = await visit(t);
  const options = await page
    .locator("#algorithm")
    .locator("option")
    .evaluateAll((all) => all.map((each) => each.value));
  assert.ok(options.length >= 2);
  await page.locator("#algorithm").selectOption(options[1]);
  const chosen = await until(page, (now, name) => now.algorithm === name, options[1]);
  assert.deepEqual(await page.locator(".lines code").allTextContents(), chosen.code.map((line) => line.trimStart()));
  await page.locator("#beside").selectOption(options[0]);
  await until(page, (now, name) => now.beside === name, options[0]);
  await page.locator("#beside").selectOption("");
  await until(page, (now) => now.beside === null);
});
