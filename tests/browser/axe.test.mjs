// axe-core finds nothing to complain of: in the idle state of every lesson, at every question, beside every outcome.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { assert, kPhone, kWide, lessons, start, state, stop, until, visit } from "./support.mjs";

before(start);
after(stop);

const kAxe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** What axe finds wrong with the page as it stands, one line each. without: rules that do not hold there. */
async function violations(page, without = []) {
  await page.evaluate(kAxe);
  return page.evaluate(async (off) => {
    const rules = Object.fromEntries(off.map((rule) => [rule, { enabled: false }]));
    const { violations } = await window.axe.run(document, { resultTypes: ["violations"], rules });
    return violations.flatMap(({ id, impact, nodes }) => nodes.map(({ target, failureSummary }) => `${id} (${impact}) at ${target}: ${failureSummary}`));
  }, without);
}

const kHeadingElsewhere = ["page-has-heading-one"]; // the lesson's heading stands on its own tab

for (const [name, size] of [["laptop", kWide], ["phone", kPhone]]) {
  test(`on a ${name} every lesson is clean at rest, at each question and beside each outcome`, async (t) => {
    for (const { id } of await lessons()) {
      const page = await visit(t, `?lesson=${id}&step=0`, size);
      assert.deepEqual(await violations(page), [], `${id}, at rest`);
      let questions = 0;
      let now = await state(page);
      for (let presses = 0; presses < 400 && (now.asked || now.step < now.steps); ++presses) {
        const place = [now.step, now.asked?.id];
        if (now.asked) {
          ++questions;
          assert.deepEqual(await violations(page), [], `${id}, ${now.asked.id}`);
          await page.getByRole("button", { name: "Skip", exact: true }).click();
        } else if (now.costs) {
          break; // its outcomes stand beside its questions
        } else {
          await page.evaluate(() => document.activeElement.blur());
          await page.keyboard.press("End"); // as far as the next question
        }
        now = await until(page, (it, step, asked) => it.step !== step || it.asked?.id !== asked, ...place);
        if (now.outcome) assert.deepEqual(await violations(page), [], `${id}, the outcome of ${now.outcome.question}`);
      }
      assert.ok(questions >= 3, `${id} asks ${questions} times`);
      assert.deepEqual(await violations(page), [], `${id}, at its end`);
      await page.context().close();
    }
  });
}

test("each of the parts that share a place, the menu and a presentation are clean", async (t) => {
  for (const size of [kWide, kPhone]) {
    const page = await visit(t, "?lesson=obb-sat&step=1", size);
    for (const tab of await page.getByRole("tab").all()) {
      if (!(await tab.isVisible())) continue;
      await tab.click();
      assert.deepEqual(await violations(page, kHeadingElsewhere), [], await tab.textContent());
    }
    await page.locator("#picker").click();
    assert.deepEqual(await violations(page, kHeadingElsewhere), [], "the menu");
    await page.keyboard.press("Escape");
  }
  const page = await visit(t, "?lesson=sphere-ritter&step=1");
  await page.getByRole("button", { name: "Present" }).click();
  assert.deepEqual(await violations(page), [], "presented");
});

for (const theme of ["dark", "contrast", "projector"]) {
  test(`the ${theme} theme is clean`, async (t) => {
    const page = await visit(t, "?lesson=sphere-ritter&step=1", { init: `localStorage.setItem("snug-theme", "${theme}")` });
    assert.deepEqual(await violations(page), []);
  });
}

test("the selectors of a question state show their labels", async (t) => {
  const page = await visit(t, "?lesson=sphere-ritter&step=1");
  assert.ok((await state(page)).asked);
  for (const label of ["Algorithm", "Compare with"]) {
    assert.ok(await page.getByText(label, { exact: true }).isVisible());
    assert.ok(await page.getByRole("combobox", { name: label }).isVisible());
  }
});
