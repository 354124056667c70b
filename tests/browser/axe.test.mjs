// axe-core finds nothing to complain of: in the text of every lesson; in one of each kind at every question, beside
// every outcome, be it right, wrong or skipped, and at its end; at a task as it is set and as it is done. On a laptop
// the whole page is looked at, in all situations; on a phone, where the same parts stand in another place, those that
// change.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import {
  answer, assert, cut_off, go_on, kinds, kPhone, kWide, lessons, load, moved, start, state, still,
  stop, until, visit,
} from "./support.mjs";

before(start);
after(stop);

const kAxe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** What axe finds wrong with the page as it stands, or with some parts of it, one line each. */
async function violations(page, parts = null) {
  if (!(await page.evaluate(() => Boolean(window.axe)))) await page.evaluate(kAxe);
  return page.evaluate(async (parts) => {
    const seen = parts?.filter((part) => document.querySelector(part)?.checkVisibility());
    if (seen?.length === 0) return [];
    const { violations } = await window.axe.run(seen ? { include: seen } : document, { resultTypes: ["violations"] });
    return violations.flatMap(({ id, impact, nodes }) =>
      nodes.map(({ target, failureSummary }) => `${id} (${impact}) at ${target}: ${failureSummary}`),
    );
  }, parts);
}

/** Where questions, what comes of them and the step's words stand. */
const kSpoken = ["#ask", "#told", "#caption", "#figures"];

/** What axe finds wrong with those parts, or with the whole page. Other words in elements that it has seen there make
 *  no difference to it: it looks once there is an element of another kind. seen: receives the kinds of elements. */
async function violations_of_new(page, seen, parts = kSpoken) {
  const elements = await page.evaluate(
    (parts) =>
      [...document.querySelectorAll(parts.map((part) => `${part}, ${part} *`).join())].map((node) => {
        const attributes = [...node.attributes].map(({ name, value }) =>
          /^(class|role|type|aria-(pressed|current|checked))$/.test(name) ? `${name}=${value}` : name,
        );
        return [
          node.parentElement.tagName,
          node.parentElement.className,
          node.tagName,
          ...attributes,
          node.textContent.trim() !== "",
        ].join(" ");
      }),
    parts,
  );
  if (elements.every((element) => seen.has(element))) return [];
  for (const element of elements) seen.add(element);
  return violations(page, parts);
}

/** Answers what is asked by its number-th choice, as far as digits reach, or by the name of the number-th handle that
 *  can be the answer. */
const answer_with = (page, asked, number) =>
  answer(
    page,
    asked.choices.length > 0
      ? number % Math.min(asked.choices.length, 9)
      : asked.targets[number % asked.targets.length],
    "keyboard",
  );

/** Plays what is open to its end and looks at every question and at what stands beside its outcome. On a laptop nothing
 *  of a question may be cut off. look: what is wrong with the page. Returns how many questions there were, and the
 *  situations in which others wait. seen: receives the outcomes. */
async function play(page, name, seen, look) {
  const phone = page.viewportSize().width < kWide.viewport.width;
  let questions = 0;
  let now = await state(page);
  if (now.cover && !now.asked) { // it asks once measuring is wanted
    await page.keyboard.press("m");
    now = await until(page, (it) => it.asked);
  }
  for (let presses = 0; presses < 400 && (now.asked || now.outcome || now.step < now.steps); ++presses) {
    const { asked } = now;
    await page.evaluate(() => document.activeElement.blur());
    // On a phone one scrolls.
    if (!phone && (asked || now.outcome)) assert.deepEqual(await cut_off(page), [], `${name}, step ${now.step}`);
    if (asked) {
      assert.deepEqual(await look(page), [], `${name}, ${asked.id}`);
      // Each in turn is skipped, answered by its first and by its last answer: some of them are right, some wrong.
      // A number has no first and last answer.
      if (questions % 3 === 2 || asked.many || asked.field === "Number")
        await page.getByRole("button", { name: "Skip", exact: true }).click();
      else
        await answer_with(
          page,
          asked,
          questions % 3 === 0 ? 0 : Math.max(asked.choices.length, asked.targets.length) - 1,
        );
      ++questions;
    } else if (now.cover) {
      break; // its outcomes stand beside its questions
    } else if (now.outcome) {
      await go_on(page);
    } else {
      await page.keyboard.press("End"); // as far as the next question
    }
    now = await moved(page, now);
    if (!now.outcome) continue;
    seen.add(now.outcome.skipped ? "skipped" : now.outcome.right ? "right" : "wrong");
    assert.deepEqual(await look(page), [], `${name}, the outcome of ${now.outcome.question}`);
  }
  return { questions, of: now.questions, situations: now.situationsWaiting };
}

for (const [name, size] of Object.entries({ laptop: kWide, phone: { ...kPhone, deviceScaleFactor: 1 } })) {
  test(`on a ${name} lessons are clean at rest, at each question, beside each outcome and at their end`, async (t) => {
    const seen = new Set(), elements = new Set();
    const look = (page) => violations_of_new(page, elements, name === "laptop" ? ["body"] : kSpoken);
    for (const { id } of await kinds()) {
      const page = await visit(t, `?lesson=${id}&step=0`, size);
      assert.deepEqual(await violations(page), [], `${id}, at rest`);
      const { questions, of, situations } = await play(page, id, seen, look);
      // Some of its questions may wait in other situations and algorithms.
      assert.ok(questions > 0 && questions >= Math.min(3, of), `${id} asks ${questions} times of ${of}`);
      assert.deepEqual(await look(page), [], `${id}, at its end`);
      for (const situation of name === "laptop" ? situations : []) {
        const there = `?lesson=${id}&situation=${situation}`;
        await play(await visit(t, `${there}&step=0`, size), `${id}, ${situation}`, seen, look);
      }
    }
    assert.deepEqual([...seen].sort(), ["right", "skipped", "wrong"]);
  });
}

test("the text of every lesson is clean at rest", async (t) => {
  const elements = new Set();
  for (const { id } of await lessons()) {
    const page = await visit(t, `?lesson=${id}&step=0`);
    assert.deepEqual(await violations_of_new(page, elements, ["#read", ...kSpoken]), [], id);
  }
});

test("an exercise of each kind is clean as it is asked, hinted, tried, told and over", async (t) => {
  const press = (page, name) => page.getByRole("button", { name }).first().press("Enter");
  for (const size of [kWide, { ...kPhone, deviceScaleFactor: 1 }]) {
    const elements = new Set();
    const look = async (page, what) => assert.deepEqual(await violations_of_new(page, elements), [], what);
    for (const id of ["be-aabb-centre", "radii-of-boxes", "order-of-a-sat-test"]) {
      const page = await visit(t, `?exercise=${id}&seed=3`, size);
      await look(page, `${id}, asked`);
      for (let presses = 0; presses < 40; ++presses) {
        const { exercise, asked, outcome } = await state(page);
        if (exercise.finished) break;
        if (outcome) await press(page, "Continue");
        else if (exercise.hint && presses < 2) await press(page, /^(Hint|Show the answer)/);
        else if (asked.ordered) {
          for (const i of asked.choices.keys()) await page.locator(".predict .choices .button").nth(i).press("Enter");
          await press(page, "Answer");
        } else {
          const name = asked.targets[presses % asked.targets.length];
          await page.locator(".ask input").fill(asked.field === "Number" ? "77" : name);
          await page.keyboard.press("Enter");
        }
        await still(page);
        await look(page, `${id}, ${presses}`);
      }
    }
    for (const id of ["build-worst-ritter", "break-pca-box"]) {
      const page = await visit(t, `?exercise=${id}&seed=3`, size);
      await press(page, /^(Hint|Show the answer)/);
      await until(page, (now) => now.exercise.hints.length === 1);
      await look(page, id);
    }
  }
});

test("a task is clean as it is set, and as it is done", async (t) => {
  // As it begins, the test that the task is about is right; across the frustum lies a box that it loses.
  const page = await visit(t, "?lesson=frustum-2d");
  await page.getByRole("button", { name: "Start", exact: true }).click();
  assert.equal((await until(page, (now) => now.grade.says)).grade.done, false);
  assert.deepEqual(await violations(page), [], "set");
  await visit(t, "?lesson=frustum-2d&a=corners_outside&boxes=0.6,0,0.2,1.7,1,0;0.55,0,1.05,1.15,1,0&step=99");
  assert.equal((await until(page, (now) => now.grade.says)).grade.done, true);
  await page.locator("#task .done").waitFor();
  assert.deepEqual(await violations(page), [], "done");
});

test("each of the parts that share a place, the menu and a presentation are clean", async (t) => {
  for (const size of [kWide, kPhone]) {
    const page = await load(t, "?lesson=obb-sat&step=1", size);
    for (const tab of await page.getByRole("tab").all()) {
      if (!(await tab.isVisible())) continue;
      await tab.click();
      assert.deepEqual(await violations(page), [], await tab.textContent());
    }
    await page.locator("#picker").click();
    assert.deepEqual(await violations(page), [], "the menu");
    await page.keyboard.press("Escape");
    if (size === kPhone) continue;
    await page.getByRole("button", { name: "Present" }).click();
    assert.deepEqual(await violations(page), [], "presented");
    await page.keyboard.press("t");
    assert.deepEqual(await violations(page), [], "presented, with its text");
    const figure = await load(t, "?lesson=frustum-3d&step=1&embed=1", { viewport: { width: 400, height: 300 } });
    let now = await state(figure);
    for (const seen = new Set(); !seen.has("summary"); now = await state(figure)) {
      const where = now.summary ? "summary" : now.outcome ? "told" : now.asked ? "asked" : "rest";
      if (!seen.has(where)) assert.deepEqual(await violations(figure), [], `a figure, ${where}`);
      seen.add(where);
      await figure.keyboard.press(now.asked ? "s" : now.outcome ? "Enter" : "End");
      await figure.waitForTimeout(100);
    }
  }
});

test("a question is clean after a first wrong try, and where the right answer is shown", async (t) => {
  for (const size of [kWide, kPhone]) {
    const page = await visit(t, "?lesson=frustum-3d&step=1", size);
    await page.keyboard.press("1");
    await page.keyboard.press("Enter");
    await until(page, (now) => now.asked.tried);
    assert.deepEqual(await violations(page), [], "tried");
    await page.keyboard.press("2");
    await page.keyboard.press("Enter");
    await until(page, (now) => now.outcome);
    await page.getByRole("button", { name: "Show me" }).click();
    await until(page, (now) => now.outcome.shown);
    assert.deepEqual(await violations(page), [], "shown");
  }
});

test("every theme is clean, at a question and beside what came of it", async (t) => {
  // No colour on its way to another.
  const page = await load(t, "?lesson=sphere-ritter&step=1", { reducedMotion: "reduce" });
  for (const theme of ["Dark", "High contrast", "Projector"]) {
    await page.evaluate(() => window.snug.restart("?lesson=sphere-ritter&step=1"));
    await page.locator("#theme").click();
    await page.evaluate(() => document.activeElement.blur()); // Enter would press it again
    assert.equal(await page.locator("#theme-name").textContent(), theme);
    const { asked } = await until(page, (now) => now.asked);
    assert.deepEqual(await violations(page), [], `${theme}, asked`);
    const { outcome } = await answer_with(page, asked, 0);
    assert.equal(outcome.skipped, false);
    assert.deepEqual(await violations(page), [], `${theme}, told`);
  }
});

test("the selectors of a question state show their labels", async (t) => {
  const page = await visit(t, "?lesson=sphere-ritter&step=1");
  assert.ok((await state(page)).asked);
  for (const label of ["Algorithm", "Compare with"]) {
    assert.ok(await page.locator("#code").getByText(label, { exact: true }).isVisible());
    assert.ok(await page.getByRole("combobox", { name: label }).isVisible());
  }
});

test("prose is clean while a mark is lit, from either side, in every theme", async (t) => {
  const page = await load(t, "?lesson=sphere-welzl&step=9999", { ...kWide, reducedMotion: "reduce" });
  for (let theme = 0; theme < 4; ++theme) {
    await page.locator("#theme").click();
    await page.locator("#prose .speaks").first().hover();
    const { lit } = await until(page, (now) => now.lit.mark === "support");
    assert.deepEqual(await violations(page), [], `theme ${theme}, words`);
    const { x, y } = (await page.evaluate(() => window.snug.handles())).find(({ id }) => lit.handles.includes(id));
    await page.mouse.move(x, y);
    await until(page, (now) => now.lit.words.includes("support"));
    assert.deepEqual(await violations(page), [], `theme ${theme}, handle`);
  }
});
