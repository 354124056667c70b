// The lesson on effects: what each does and why, a body at rest that is pushed, and a declaration that is edited.
import { after, before, test } from "node:test";
import { assert, start, state, stop, until, visit } from "./support.mjs";

before(start);
after(stop);

test("at rest nothing runs, and each effect says why it is skipped", async (t) => {
  const page = await visit(t, "?lesson=scene-effects&step=260");
  const view = await state(page);
  assert.equal(view.step, 260);
  for (const { effect, run, skipped, says } of view.effects) {
    assert.equal(run + skipped, 260, effect);
    assert.match(says, /^skipped: \w/, effect);
  }
  assert.match(view.caption, /^Frame 260: none of 8 effects runs; none of 8 bodies is awake\.$/);
});

test("a push of a body at rest wakes its island alone, and undo puts it to sleep again", async (t) => {
  const page = await visit(t, "?lesson=scene-effects&step=240");
  const before = await state(page);
  assert.equal(before.step, 240);
  await page.locator("#canvas").focus();
  await page.keyboard.press("]"); // selects the first body
  await page.keyboard.press("p");
  const pushed = await until(page, (now) => now.steps > 260);
  assert.equal(pushed.step, 240);
  await page.keyboard.press("Escape");
  await page.keyboard.press("ArrowRight");
  const awake = await until(page, (now) => now.step === 241);
  const some = Number(/; (\d) of 8 bodies are awake\.$/.exec(awake.caption)[1]);
  assert.ok(some >= 1 && some < 8, awake.caption);
  assert.equal(some, 4, "as snug scene --push 240:P0 has it: tests/command/scene.test.mjs");
  assert.match(awake.effects.find(({ effect }) => effect === "fall").says, /^runs: new time/);
  await page.keyboard.press("Control+z");
  await until(page, (now) => now.steps === 260);
});

test("before the first frame an effect is taken out of the declaration, and what needs it says so", async (t) => {
  const page = await visit(t, "?lesson=scene-effects&step=0");
  const field = page.getByRole("checkbox", { name: "broad phase" });
  await field.focus();
  await page.keyboard.press(" ");
  const refused = await until(page, (now) => now.steps === 0);
  assert.equal(
    refused.caption,
    "The scene cannot run: narrow phase reads pairs, which no effect of the scene makes: broad phase would.",
  );
  assert.ok(!(await field.isChecked()));
  assert.ok(await field.evaluate((node) => node === document.activeElement)); // although the order is another one now
  await page.keyboard.press(" ");
  await until(page, (now) => now.steps === 260);
});

test("the scene's file is edited beside the stage: a setting acts at once, mistakes are named", async (t) => {
  const page = await visit(t, "?lesson=scene-effects&step=0");
  const { file: { own }, trace } = await state(page);
  assert.match(own, /^\[scene\]\nframes = 260\n/);
  await page.locator("#tab-file").click();
  const text = page.getByRole("textbox", { name: "The stage’s file" });
  assert.equal(await text.inputValue(), own);
  const bouncy = own.replace("restitution = 0.2", "restitution = 0.9"),
    broken = bouncy.replace("friction = 0.6", "friction = -1\nglue = 3");
  assert.notEqual(bouncy, own);
  await text.fill(bouncy);
  const changed = await until(page, (now) => now.file.runs === now.file.typed && now.file.runs !== now.file.own);
  assert.notEqual(changed.trace, trace);
  await page.locator("#undo").focus(); // the typing is over
  await text.fill(broken);
  const wrong = await until(page, (now) => now.file.mistakes.length === 2);
  assert.equal(wrong.trace, changed.trace, "the last text without a mistake stays on the stage");
  const list = page.locator("#file li");
  assert.match(await list.first().textContent(), /^\d+:1: bounce: "friction" is out of range$/);
  await list.last().getByRole("button").click();
  const at = await text.evaluate((node) => node.value.slice(node.selectionStart));
  assert.ok(at.startsWith("glue = 3"), at.slice(0, 40));
  await page.waitForFunction(() => location.search.includes("draft="));
  await page.reload();
  const again = await until(page, (now) => now?.file?.mistakes.length === 2);
  assert.equal(again.file.typed, broken);
  assert.equal(again.file.runs, bouncy);
  assert.equal(again.trace, changed.trace);
  await page.locator("#undo").click();
  await until(page, (now) => now.file.mistakes.length === 0);
  await page.locator("#tab-file").click();
  assert.equal(await text.inputValue(), bouncy);
  await page.locator("#undo").click();
  const back = await until(page, (now) => now.file.typed === now.file.own);
  assert.equal(back.trace, trace);
});

test("the fewest effects for a picture: what nobody needs goes, what is missing is asked for", async (t) => {
  const page = await visit(t, "?lesson=scene-effects&situation=picture&step=0");
  await page.locator("#task").getByRole("button").nth(1).click();
  const own = await until(page, (now) => now.task === 1 && now.situation === "picture");
  assert.equal(own.grade.done, false);
  const box = (effect) => page.getByRole("checkbox", { name: effect });
  const press = async (effect, on) => {
    await box(effect).focus();
    await page.keyboard.press(" ");
    return until(
      page,
      (now, [name, wanted]) =>
        now.effects.some(
          ({ effect: one, on: is, called }) => one.replaceAll("_", " ").startsWith(name) && (is && called) === wanted,
        ),
      [effect, on],
    );
  };
  for (const effect of ["cull", "trail", "projection rays"])
    assert.equal((await press(effect, false)).grade.done, false, `without ${effect}`);
  for (const effect of ["shadow", "broad phase", "narrow phase"])
    assert.equal((await press(effect, true)).grade.done, false, `with ${effect}`);
  await press("bounce", true);
  const { tasks } = await until(page, (now) => now.grade.done);
  assert.ok(tasks[1].was);
  for (const effect of ["shadow", "bounce"]) {
    await press(effect, false);
    await until(page, (now) => !now.grade.done);
    await press(effect, true);
    await until(page, (now) => now.grade.done);
  }
  await press("trail", true);
  const { grade } = await until(page, (now) => !now.grade.done);
  assert.ok(grade.says.length > 0, "one more is too many");
});
