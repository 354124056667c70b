// A question is a conversation: on the stage's foot it is asked, tried again, played to where it is decided, told, and
// acknowledged; and a lesson ends with a summary.
import { after, before, test } from "node:test";
import {
  answer, assert, drag, go_on, handles, kinds, kPhone, kWide, lessons, load, moved, start, state, still, stop, until,
  visit,
} from "./support.mjs";

before(start);
after(stop);

const box = (page, selector) => page.locator(selector).boundingBox();
/** @type {Opened} */
const kMoving = { ...kWide, reducedMotion: "no-preference" };

/** Skips on to the first question that asks for a point by its name. */
async function to_named_question(page) {
  let now = await state(page);
  for (
    let i = 0;
    i < 60 && !(now.asked?.onStage && now.asked.choices.length === 0 && now.asked.targets.length > 2);
    ++i
  ) {
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press(now.asked ? "s" : "PageDown");
    now = await moved(page, now);
  }
  assert.ok(now.asked);
  return now;
}

test("the question stands on the stage's foot, the stage is framed above it, the prose keeps its column", async (t) => {
  const page = await visit(t, "?lesson=sphere-ritter&step=1");
  const { asked } = await until(page, (now) => now.asked);
  await still(page);
  const [card, stage, prose] = [await box(page, "#ask"), await box(page, "#stage"), await box(page, "#read")];
  assert.ok(
    card.y > stage.y + stage.height / 3 && card.y + card.height <= stage.y + stage.height,
    JSON.stringify(card),
  );
  assert.ok(card.x >= stage.x && card.x + card.width <= stage.x + stage.width);
  for (const { id, y } of await handles(page))
    if (asked.targets.includes(id)) assert.ok(y < card.y, `${id} is under the card`);
  assert.ok(prose.y + prose.height > 790, "the prose reaches the foot of its column");
  const [numbers, code] = [await box(page, "#numbers"), await box(page, "#code")];
  assert.ok(
    code.y >= numbers.y + numbers.height - 1 && Math.abs(code.x - numbers.x) < 3,
    "the pseudocode stands under the numbers",
  );
});

test("on a phone the stage and the question are in view together, and so is what came of it", async (t) => {
  const page = await visit(t, "?lesson=sphere-ritter&step=1", kPhone);
  await until(page, (now) => now.asked);
  for (const what of ["asked", "told"]) {
    await still(page);
    const [card, stage] = [await box(page, "#ask"), await box(page, "#stage")];
    assert.ok(
      stage.y >= 0 && card.y >= stage.y + stage.height - 1 && card.y + card.height <= 844,
      `${what}: ${JSON.stringify([stage, card])}`,
    );
    if (what === "asked") await answer(page, 0);
  }
});

test("answering plays what was skipped, a key ends that, and the outcome stays until Continue", async (t) => {
  const page = await visit(t, "?lesson=sphere-welzl&step=0", kMoving);
  let now = await state(page);
  // Each outcome that is decided later than at the next step is played to.
  for (let i = 0, played = 0; i < 60 && played < 2; ++i) {
    await page.evaluate(() => document.activeElement.blur());
    if (now.asked) {
      const { step, asked } = now;
      await page.keyboard.press("s");
      now = await until(page, (it, id) => it.deciding?.question === id || it.outcome?.question === id, asked.id);
      if (now.deciding) {
        assert.equal(now.outcome, null);
        assert.ok(now.step < now.deciding.step && now.step >= step);
        const begun = Date.now();
        if (played++ === 0) await until(page, (it) => it.outcome); // to its end
        else await page.keyboard.press("x");
        now = await until(page, (it) => it.outcome);
        assert.ok(Date.now() - begun < 8000, "four seconds, on a machine that others use");
      }
      assert.equal(now.step, now.outcome.step);
      assert.equal(now.asked, null);
    } else {
      await page.keyboard.press(now.outcome ? "Enter" : "PageDown");
      now = await moved(page, now);
    }
  }
  assert.ok(now.outcome);
  await page.waitForTimeout(300);
  assert.ok((await state(page)).outcome, "it stays");
  await go_on(page);
});

test("a first wrong answer is told to be wrong and no more; after the second the right one can be shown", async (t) => {
  const page = await visit(t, "?lesson=sphere-ritter&step=0");
  const { asked, step, caption, figures } = await to_named_question(page);
  const give = async (name) => {
    await page.getByLabel("Name", { exact: true }).fill(name);
    await page.keyboard.press("Enter");
    return until(page, (it, id) => it.outcome?.question === id || it.asked?.tried, asked.id);
  };
  // Two that are wrong, whichever is right.
  const names = asked.targets;
  let now = await give(names[0]);
  if (now.outcome) return; // the very first was right
  assert.equal(now.asked.tried.handle, names[0]);
  await page.locator(".says", { hasText: "Not that one. Try once more." }).waitFor();
  assert.deepEqual([now.step, now.caption, now.figures], [step, caption, figures]);
  await page.getByLabel("Name", { exact: true }).fill(names[1]);
  await page.keyboard.press("Enter");
  now = await until(page, (it) => it.outcome);
  assert.equal(now.outcome.tries, 2);
  if (now.outcome.right) return;
  assert.equal(now.outcome.kind, "wrong");
  assert.equal(await page.locator(".said.right").count(), 0);
  await page.getByRole("button", { name: "Show me" }).click();
  await until(page, (it) => it.outcome.shown);
  await page.locator(".said.right", { hasText: now.outcome.happened }).waitFor();
});

test("a choice that was wrong, and the right answer once it is shown, move nothing", async (t) => {
  const page = await visit(t, "?lesson=frustum-3d&step=1");
  const places = async () =>
    Promise.all(
      [...(await page.locator(".choices .button").all()), page.locator("#ask")].map((node) => node.boundingBox()),
    );
  const before = await places();
  await page.keyboard.press("1");
  await page.keyboard.press("Enter");
  await until(page, (now) => now.asked?.tried);
  await still(page);
  assert.deepEqual(await places(), before);
  assert.match(await page.locator(".tried").getAttribute("aria-label"), /not that one/);
  const other = await visit(t, "?lesson=sphere-ritter&step=2");
  await answer(other, "P2", "keyboard"); // and P0, which is wrong as well
  const card = await box(other, "#ask");
  await other.getByRole("button", { name: "Show me" }).click();
  await other.locator(".said.right").waitFor();
  assert.deepEqual(await box(other, "#ask"), card);
});

test("while a question stands, what the run comes to is told nowhere", async (t) => {
  for (const { id } of await kinds()) {
    const page = await visit(t, `?lesson=${id}&step=0`);
    await page.keyboard.press("End");
    if ((await state(page)).cover) await page.keyboard.press("m"); // some ask once measuring is wanted
    const { asked, rivals, outcome, lit, cover } = await until(page, (now) => now.asked);
    if (cover) assert.deepEqual(cover.table.rows, []);
    else
      assert.ok(
        rivals.every(({ size, excess }) => size === null && excess === null),
        `${id}, ${asked.id}: ${JSON.stringify(rivals)}`,
      );
    assert.deepEqual([outcome, lit.handles], [null, []]);
    assert.equal(await page.locator("#ask .right, #ask .said").count(), 0);
  }
});

test("in a lecture the question stands beside the stage, its choices and its answer in sight", async (t) => {
  const asked_by = [["epsilons", "unit-size", "End"], ["cost-volumes", "front", "m"], ["obb-axes", "nearest", "End"]];
  for (const [lesson, question, key] of asked_by) {
    const page = await load(t, `?lesson=${lesson}&step=0`, { viewport: { width: 1280, height: 720 } });
    await page.locator("#present").click();
    await page.locator(".presenting").waitFor();
    await page.keyboard.press(key);
    await until(page, (now, id) => now.asked?.id === id, question);
    await still(page);
    const [stage, card, answer] = await Promise.all(
      [page.locator("#stage"), page.locator(".ask .card"), page.getByRole("button", { name: "Answer" }).last()]
        .map((part) => part.boundingBox()));
    assert.ok(card.x >= stage.x + stage.width - 1 && stage.height >= 500, `${lesson}: ${JSON.stringify(stage)}`);
    assert.ok(answer.y + answer.height <= 720, `${lesson}: ${JSON.stringify(answer)}`);
    for (const choice of await page.locator(".ask .choices .button").all()) {
      const { y, height } = await choice.boundingBox();
      assert.ok(y + height <= answer.y + 1, `${lesson}: ${await choice.textContent()}`);
    }
  }
});

test("in a low window the question has the column beside the stage, and the way on is in sight", async (t) => {
  const page = await visit(t, "?lesson=obb-axes&step=0&a=sat_all", { viewport: { width: 844, height: 390 } });
  await page.keyboard.press("End");
  await until(page, (now) => now.asked);
  for (const what of ["Answer", "Continue"]) {
    await still(page);
    const { y, height } = await page.locator("#ask").getByRole("button", { name: what, exact: true }).boundingBox();
    assert.ok(y > 44 && y + height <= 390, `${what} stands at ${y}`);
    assert.ok((await box(page, "#ask")).height > 300);
    await page.keyboard.press("s");
  }
});

test("Page Down in the field of a name says that a second press skips, and the second one does", async (t) => {
  const page = await visit(t, "?lesson=sphere-ritter&step=2");
  const { asked } = await until(page, (now) => now.asked);
  await page.getByLabel("Name", { exact: true }).focus();
  await page.keyboard.press("PageDown");
  await page.locator(".says", { hasText: "Press again to skip" }).waitFor();
  assert.equal((await state(page)).asked.id, asked.id);
  await page.keyboard.press("PageDown");
  assert.equal((await until(page, (now) => now.outcome)).outcome.kind, "skipped");
});

test("a finger that continues brings up no keyboard; the outcome stays though a question waits", async (t) => {
  const page = await visit(t, "?lesson=sphere-ritter&step=1", kPhone);
  for (let i = 0; i < 2; ++i) {
    await page.locator(".choices .button").first().tap();
    await page.waitForTimeout(50);
  }
  const { outcome, asked, step } = await until(page, (now) => now.outcome);
  assert.deepEqual([asked, outcome.step], [null, step]);
  await page.locator("#ask").getByRole("button", { name: "Continue", exact: true }).tap();
  const next = await until(page, (now) => now.asked);
  assert.deepEqual([next.step, next.asked.onStage], [step, true]);
  assert.ok(await page.getByLabel("Name", { exact: true }).isVisible());
  assert.equal(await page.evaluate(() => document.activeElement.matches("input")), false);
});

test("on a phone the summary's way on is in sight, and the task is found from any tab", async (t) => {
  const page = await visit(t, "?lesson=sphere-ritter&step=0", kPhone);
  await page.locator("#tab-numbers").tap();
  await page.evaluate(() => document.activeElement.blur());
  let now = await state(page);
  for (let i = 0; i < 60 && !now.summary; ++i) {
    await page.keyboard.press(now.asked ? "s" : now.outcome ? "Enter" : "End");
    await page.waitForTimeout(50);
    now = await state(page);
  }
  await page.evaluate(() => document.getElementById("ask").scrollIntoView({ block: "start" }));
  const next = await page.getByRole("link", { name: "Next lesson" }).boundingBox();
  assert.ok(next.y + next.height <= 844, `${next.y}`);
  await page.getByRole("button", { name: "To the task" }).tap();
  await page.waitForFunction(() => document.getElementById("task").contains(document.activeElement));
  const { y, height } = await box(page, "#task");
  assert.ok(y >= 44 && y + height <= 844, `the task stands from ${y} to ${y + height}`);
});

test("the summary lowers the letters of a name, as its question does", async (t) => {
  const page = await visit(t, "?lesson=swept-overlap&a=swept_spheres&step=0");
  for (let now = await state(page), i = 0; i < 20 && !now.summary; ++i) {
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press(now.asked ? "s" : now.outcome ? "Enter" : "End");
    now = await until(
      page,
      (it, from) => it.summary || JSON.stringify([it.step, it.asked?.id, it.outcome?.question]) !== from,
      JSON.stringify([now.step, now.asked?.id, now.outcome?.question]),
    );
  }
  assert.deepEqual(await page.locator(".summary .what sub").allTextContents(), ["A", "B"]);
});

test("a lesson ends with what was predicted, each line leads back, and the next lesson follows", async (t) => {
  const page = await visit(t, "?lesson=frustum-2d&step=0");
  let now = await state(page);
  for (let i = 0; i < 80 && !now.summary; ++i) {
    await page.evaluate(() => document.activeElement.blur());
    if (now.asked && now.tally.skipped === 0) await page.keyboard.press("s");
    else if (now.asked) await answer(page, null, "keyboard");
    else await page.keyboard.press(now.outcome ? "Enter" : "End");
    now = await until(
      page,
      (it, from) => it.summary || JSON.stringify([it.step, it.asked?.id, it.outcome?.question]) !== from,
      JSON.stringify([now.step, now.asked?.id, now.outcome?.question]),
    );
  }
  assert.ok(now.summary);
  const { right, wrong, skipped, open } = now.tally;
  assert.equal(open, 0);
  assert.equal(skipped, 1);
  assert.equal(right + wrong + skipped, now.predictions.length);
  const lines = page.locator(".summary .line");
  assert.equal(await lines.count(), now.predictions.length);
  await lines.first().click();
  const back = await until(page, (it) => it.outcome);
  assert.equal(back.outcome.question, now.predictions[0].id);
  await go_on(page);
  await page.keyboard.press("End");
  await until(page, (it) => it.summary);
  const all = await lessons();
  const next = all[all.findIndex(({ id }) => id === now.lesson) + 1];
  await page.getByRole("link", { name: "Next lesson" }).click();
  const opened = await until(page, (it, id) => it.lesson === id, next.id);
  assert.deepEqual([opened.step, opened.previewing], [0, false]); // not its result
  assert.equal(await page.evaluate(() => document.activeElement === document.body), false); // the keys go on
});

test("once an edit is undone, the summary names the algorithms that have questions left", async (t) => {
  const page = await visit(t, "?lesson=frustum-2d&step=0");
  await drag(page, "Box", 12, -8);
  let now = await state(page);
  for (let i = 0; i < 80 && !now.summary; ++i) {
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press(now.asked ? "s" : now.outcome ? "Enter" : "End");
    await page.waitForTimeout(50);
    now = await state(page);
  }
  assert.ok(now.summary);
  assert.deepEqual(now.waiting, []); // nobody knows what is asked of an edited stage
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press("Control+z");
  const own = await until(page, (it) => it.waiting.length > 0);
  assert.ok(own.summary);
  const others = page.locator(".summary :is(button.waiting, .waiting button)");
  await others.first().waitFor();
  assert.equal(await others.count(), own.waiting.length + own.situationsWaiting.length);
});

test("on another example all is asked again, and the answers given before are kept, over a reload too", async (t) => {
  const page = await visit(t, "?lesson=sphere-ritter&step=0");
  let now = await state(page);
  for (let presses = 0; presses < 60 && !now.summary; ++presses) {
    await page.evaluate(() => document.activeElement.blur());
    if (now.outcome) await go_on(page);
    else await page.keyboard.press(now.asked ? "s" : "End");
    now = await moved(page, now);
  }
  const before = now.outcomes.length;
  assert.ok(before > 2 && now.canPractise);
  await page.getByRole("button", { name: "On another example" }).click();
  const other = await until(page, (it) => !it.summary && it.step === 0);
  assert.notEqual(other.seed, now.seed);
  assert.equal(other.outcomes.length, before);
  assert.equal(other.tally.open, other.questions);
  await page.keyboard.press("End");
  const { asked } = await until(page, (it) => it.asked);
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press("s");
  const answered = await until(page, (it, count) => it.outcomes.length > count, before);
  assert.deepEqual([answered.outcomes.at(-1).question, answered.outcomes.at(-1).on], [asked.id, other.seed]);
  const { step } = answered;
  await page.waitForURL(({ searchParams: of }) => of.get("seed") === `${other.seed}` && of.get("step") === `${step}`);
  await page.reload();
  const again = await until(page, (it, seed) => it.seed === seed && it.outcomes.length > 0 && it.step > 0, other.seed);
  assert.deepEqual([again.outcomes.length, again.tally.skipped, again.edited], [before + 1, 1, false]);
});
