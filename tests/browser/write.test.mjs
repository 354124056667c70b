// Code that a student writes: typed by keyboard, tried, mended and handed in; what it must not do.
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { assert, kPhone, kWide, load, start, stop } from "./support.mjs";

before(start);
after(stop);

const kExercise = "?exercise=write%3Aoverlap-min-max";
const kWrong = "return a.min.every((x, i) => x < b.max[i] && b.min[i] < a.max[i]);";
const kRight = kWrong.replaceAll("<", "<=");

const watch = () => {
  window.refused = [];
  addEventListener("securitypolicyviolation", ({ effectiveDirective, blockedURI }) =>
    window.refused.push(`${effectiveDirective}: ${blockedURI}`),
  );
};
const open = async (t, screen = kWide, exercise = kExercise) => {
  const page = await load(t, exercise, { ...screen, init: watch, wait: false });
  await page.locator(".write .cm-content").waitFor();
  return page;
};

/** Replaces the code by keys alone. */
async function type(page, body) {
  await page.locator(".cm-content").focus();
  await page.keyboard.press("Control+A");
  await page.keyboard.type(`function overlap(a, b) {\n${body}`); // the editor closes the brace
}
const ran = (page) => page.locator(".write-kinds, .write-wrong").first().waitFor({ timeout: 60_000 });
const mark = (page) => page.locator(".write-mark").textContent();

test("a function is typed, fails where boxes touch, is mended and handed in", async (t) => {
  const page = await open(t);
  await type(page, kWrong);
  await page.keyboard.press("Control+Enter");
  await ran(page);
  assert.match(await mark(page), /^Mark 5 of 7[.]/);
  const told = await page.locator(".write").textContent();
  assert.match(told, /All 400 random cases pass.*It fails on boxes that only touch/);
  assert.match(await page.locator(".write-case").textContent(), /right *true *yours *false/);
  const frame = page.frameLocator(".write-stage");
  await frame.locator("#title").filter({ hasText: "A case on which" }).waitFor({ state: "attached", timeout: 60_000 });
  // One's own method is a point of the chart, beside the reference solution on the same cases.
  await page.locator(".write-methods").waitFor({ timeout: 60_000 });
  assert.match(await page.locator(".write-methods tr.yours").textContent(), /^Yours[0-9.]+ %[0-9.]+$/);
  assert.match(await page.locator(".write-methods tr.model").textContent(), /^Reference solution100 %[0-9.]+$/);
  assert.equal(await page.locator(".cost-chart circle.yours").count(), 1);
  assert.ok((await page.locator(".cost-chart .other").count()) >= 2);
  const { exercise, mark: earned, of } = await page.evaluate(() => window.snug.exercise());
  assert.deepEqual([exercise, earned, of], ["write:overlap-min-max", 5, 7]);

  await type(page, kRight);
  await page.keyboard.press("Escape"); // Tab leaves the editor now
  assert.match(await page.locator(".write-hint").textContent(), /Press Tab to leave/);
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement?.textContent), "Run");
  await page.locator(".write-kinds").evaluate((table) => table.remove());
  await page.keyboard.press("Enter");
  await ran(page);
  assert.match(await mark(page), /^Mark 7 of 7[.]/);
  const [file] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "Hand in" }).click(),
  ]);
  const { attempts } = JSON.parse(readFileSync(await file.path(), "utf8"));
  assert.equal(attempts[0].mark, 7);
  assert.match(attempts[0].decisions[0], /^wfunction overlap/);
  assert.deepEqual(await page.evaluate(() => window.refused), []);
});

test("on a phone: a mistake is shown at its line, variables are told, three tries show the solution", async (t) => {
  const page = await open(t, kPhone);
  /** @param {string} body */
  const runs = async (body) => {
    await type(page, body);
    await page.locator(".write-kinds, .write-wrong").evaluateAll((all) => all.forEach((one) => one.remove()));
    await page.getByRole("button", { name: "Run" }).tap();
    await ran(page);
  };
  const solution = page.getByRole("button", { name: "Reference solution" });
  const bottoms = await page.locator(".write-actions > :is(a, button)").evaluateAll((all) =>
    all.map((one) => one.getBoundingClientRect()).map(({ right, height }) => right <= innerWidth && height < 60));
  assert.deepEqual(bottoms, [true, true, true, true]);
  await runs("let sum = 0;\nfor (const x of a.min) sum += x * x + 1;\n" +
    "const first = ((v) => { const own = v; return own; })(sum);\nreturn first > 1e9;");
  const told = await page.locator(".write").textContent();
  const [, sum, first] = told.match(/Your variables, at their last *sum([0-9.e+]+).*first([0-9.e+]+)/);
  assert.ok(Number(sum) >= 3 && Number(first) === Number(sum), told);
  assert.ok(await solution.isHidden());
  await runs("return false;");
  await runs("let x = ;");
  assert.match(await page.locator(".write-wrong").textContent(), /^Line 2: SyntaxError/);
  await page.locator(".cm-lint-marker-error").waitFor();
  await solution.tap();
  assert.match(await page.locator(".write").textContent(), /at most half from then on/);
  assert.equal(await page.getByText("if (a.max[i] < b.min[i]").count(), 0);
  await solution.tap();
  await page.getByText("if (a.max[i] < b.min[i]").waitFor();
  await runs(kRight);
  assert.match(await mark(page), /^Mark 3 of 7, at most half: the solution was seen[.] Best mark 3 of 7[.]$/);
  await type(page, "let x = ;");
  await page.locator(".cm-content").focus();
  await page.keyboard.press("Control+f");
  await page.locator(".cm-search input").first().waitFor();
  await page.keyboard.press("Escape");
  await page.reload();
  await page.locator(".write .cm-content").waitFor();
  assert.match(await page.locator(".cm-content").textContent(), /let x = ;/); // it is kept
});

test("what is typed last is kept, however soon one leaves, and a function that is not there is named", async (t) => {
  const page = await open(t);
  await page.locator(".cm-content").focus();
  await page.keyboard.press("Control+A");
  await page.keyboard.type("function overlaps(a, b) {\nreturn true;");
  await page.reload();
  await page.locator(".write .cm-content").waitFor();
  assert.match(await page.locator(".cm-content").textContent() ?? "", /function overlaps.*return true;/);
  await page.locator(".cm-content").focus();
  await page.keyboard.press("Control+Enter");
  await ran(page);
  assert.equal(await page.locator(".write-wrong").textContent(), "There is no function overlap.");
});

test("a place that a function gives stands on the stage beside the right one, and words say how", async (t) => {
  const page = await open(t, kWide, "?exercise=write%3Afarthest-from-edge");
  /** @param {string} yours */
  const says = (yours) =>
    page.getByText(`On the stage what is right has dashes or a ring; yours ${yours}.`).waitFor({ timeout: 60_000 });
  await page.getByRole("button", { name: "Run" }).click(); // the stub gives none
  await says("is -1: none");
  await page.locator(".button.primary:enabled", { hasText: "Run" }).waitFor(); // the first run has come to its end
  await page.locator(".cm-content").focus();
  await page.keyboard.press("Control+A");
  await page.keyboard.type("function farthest(points, a, b) {\nreturn a;");
  await page.keyboard.press("Control+Enter");
  await says("has dots or a cross");
});
