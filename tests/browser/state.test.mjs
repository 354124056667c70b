// What window.snug.state() tells is what web/README.md says: key for key, at rest, asked, tried, told and at the end.
// And what the program gives the page is what tsc takes it to be.
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { misfits } from "./misfits.mjs";
import { answer, assert, go_on, kinds, serve_site, start_on, state, stop, until, visit } from "./support.mjs";

/** The site, but that the page's door to the program is its window's as well. */
async function serve_with_door() {
  const site = await serve_site();
  const glue = await (await fetch(`${site.url}snug.js`)).text();
  const shown = "export default async (given) => (window.door = await create_snug(given));";
  assert.match(glue, /export default create_snug;/);
  site.add.set("snug.js", glue.replace("export default create_snug;", shown));
  return site;
}

before(() => start_on(serve_with_door));
after(stop);

const kReadme = readFileSync(new URL("../../web/README.md", import.meta.url), "utf8");
/** The rows of the table with that heading, each as the texts of its cells. */
const rows = (heading) =>
  kReadme
    .split(`| ${heading} |`)[1]
    .split("\n\n")[0]
    .trimEnd()
    .split("\n")
    .slice(2)
    .map((row) => row.split("|").slice(1, -1));
/** The names in a cell, but for those that are its values, in brackets. */
const names = (cell) => [...cell.replace(/\([^)]*\)/g, "").matchAll(/`(\w+)`/g)].map(([, name]) => name);
const kState = rows("key | what it is").flatMap(([keys]) => names(keys));
const kParts = Object.fromEntries(rows("in | keys").map(([part, keys]) => [names(part)[0], names(keys)]));
const kTypes = ["PageState[\"asked\"]", "Told", "PageState"];
const same = (object, keys, what) => assert.deepEqual(Object.keys(object).sort(), [...keys].sort(), what);

test("the state of every kind of lesson has the keys that its table lists, and no other", async (t) => {
  const covered = ["cost-chart", "cost-volumes", "lecture-claims", "which-volume"]; // by charts, or by small pictures
  const given = [];
  for (const { id } of await kinds()) {
    const page = await visit(t, `?lesson=${id}&step=0`);
    const now = await state(page);
    same(now, kState, id);
    assert.equal(Boolean(now.cover), covered.includes(id), id);
    const [lesson, words] = await page.evaluate(() => {
      const { door } = window;
      return [door.lesson(), door.words()];
    });
    given.push({ type: "PageState", value: now }, { type: "Lesson", value: lesson });
    given.push({ type: "SharedWords", value: words });
  }
  assert.equal(misfits(given), "");
});

test("a question, its tries, its outcome and the count have the keys that are listed", async (t) => {
  const page = await visit(t, "?lesson=sphere-ritter&step=2");
  const told = [...kParts.outcomes, ...kParts.outcome];
  const { asked } = await until(page, (now) => now.asked);
  same(asked, kParts.asked);
  assert.deepEqual([asked.picked, asked.tried], [null, null]);
  await page.getByLabel("Name", { exact: true }).fill("P0");
  await page.keyboard.press("Enter");
  const { asked: again } = await until(page, (now) => now.asked?.tried);
  assert.deepEqual(again.tried, { choices: [], handle: "P0" });
  same(again, kParts.asked);
  const now = await answer(page, "P1");
  same(now.outcome, told);
  assert.deepEqual([now.outcome.kind, now.outcome.tries, now.outcome.given.handle], ["right", 2, "P1"]);
  same(now.outcomes[0], kParts.outcomes);
  same(now.predictions[0], kParts.predictions);
  same(now.tally, kParts.tally);
  assert.equal(misfits([again, now.outcome, now].map((value, i) => ({ type: kTypes[i], value }))), "");
  assert.deepEqual(now.tally, { right: 1, second: 1, wrong: 0, skipped: 0, open: now.questions - 1 });
  await go_on(page);
});

test("an exercise and its attempt are of the types that they are taken for, from its begin to its end", async (t) => {
  const page = await visit(t, "?exercise=aabb-overlap&seed=3");
  const given = [];
  const look = async () => {
    const now = await state(page);
    same(now, kState);
    const parts = await page.evaluate(() => [window.snug.exercise(), window.door.attempt(), window.door.lesson()]);
    for (const [i, type] of ["ExerciseState", "Attempt", "Lesson"].entries()) given.push({ type, value: parts[i] });
    given.push({ type: "PageState", value: now });
    return now;
  };
  await look();
  await page.keyboard.press("h");
  await until(page, (now) => now.exercise.hints.length === 1);
  let { exercise } = await look();
  for (let i = 0; i < 3 * exercise.decisions && !exercise.finished; ++i) {
    const { asked } = await until(page, (now) => now.asked || now.outcome);
    if (asked) await page.locator(".predict .choices .button").nth(asked.tried ? 1 : 0).click();
    else await page.getByRole("button", { name: "Continue", exact: true }).click();
    await until(page, (now) => now.exercise.finished || now.asked || now.outcome);
    ({ exercise } = await look());
  }
  assert.ok(exercise.finished);
  assert.equal(misfits(given), "");
});
