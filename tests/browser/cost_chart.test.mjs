// The charts of costs: predicted, measured in slices while the page stays alive, loaded from, saved and laid over,
// refused.
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import {
  answer, assert, cut_off, handles, kPhone, start, state, still, stop, to_points, until, until_within, visit,
} from "./support.mjs";

before(start);
after(stop);

const kLesson = "?lesson=cost-chart";
const button = (page, name) => page.getByRole("button", { name, exact: true });
const decided = (now) => now.cover.decided && !now.cover.running;
const kAll = 6;

async function skip_all(page) {
  await button(page, "Measure").click(); // it asks first
  for (let i = 0; i < 3; ++i) {
    await button(page, "Skip").click();
    await until(page, (now, before) => now.outcomes.length > before, i);
  }
}

const chosen_of = ({ cover }) => cover.choices.find(({ chosen }) => chosen).words;
const choice = (page, name) => page.getByRole("radio", { name, exact: true });

/** Chooses a chart with the mouse, and measures it to the end. */
async function measure_chart(page, name, chart) {
  await page.locator(".segments label", { hasText: name }).click();
  await until(
    page,
    (now, wanted) => now.cover.choices.find(({ chosen }) => chosen).command === wanted && now.cover.shown,
    `show_${chart}`,
  );
  await button(page, "Measure").click();
  await until(page, (now) => now.cover.running);
  await page.waitForFunction(() => !window.snug.state().cover.running, null, { timeout: 180_000 });
  await still(page);
  return state(page);
}

async function measure(page) {
  await button(page, "Measure").click();
  await until_within(120_000, page, decided);
  await still(page);
  return state(page);
}

test("predictions come first; then six algorithms are measured, and what happened stands beside them", async (t) => {
  const page = await visit(t, kLesson);
  const opened = await state(page);
  assert.equal(opened.asked, null, "nothing is asked before Measure is pressed");
  assert.equal(opened.caption, "Press Measure: first you predict, then it is measured.");
  await button(page, "Measure").click();
  const { asked, cover } = await until(page, (now) => now.asked);
  assert.ok(asked.many);
  assert.equal(asked.choices.length, kAll);
  assert.deepEqual(await cut_off(page), [], "all choices are in sight");
  assert.ok(!cover.work[0].enabled && await button(page, "Measure").isDisabled());
  assert.ok(cover.shown && cover.table.rows.length === 0, "an empty chart stands there");
  for (const name of ["PCA of the points", "Exact minimum"]) await button(page, name).click();
  assert.equal(await button(page, "Exact minimum").getAttribute("aria-pressed"), "true");
  await button(page, "Answer").click();
  await until(page, (now) => now.outcomes.length === 1);
  await answer(page, "Exact minimum");
  await button(page, "Skip").click();
  const { outcomes: given } = await until(page, (now) => now.outcomes.length === 3);
  assert.ok(given.every(({ pending }) => pending));
  await page.locator(".cover-says", { hasText: "Now press Measure: " }).waitFor();
  assert.equal((await state(page)).caption, "Your predictions are in: now press Measure.");
  assert.equal(given[0].predicted, "PCA of the points and Exact minimum");

  // While it measures, the page goes on drawing: told, and held to no frame's time on a machine that others use.
  await page.evaluate(() => {
    window.gaps = [];
    window.bars = new Set();
    let last = performance.now();
    const look = (now) => {
      window.gaps.push(now - last);
      last = now;
      window.bars.add(document.querySelector(".cover-bar").getAttribute("aria-valuenow"));
      if (!window.snug.state().cover.decided) requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  });
  const { framesDrawn: earlier } = await state(page);
  const { cover: done, outcomes, framesDrawn: later } = await measure(page);
  const bars = await page.evaluate(() => window.bars.size);
  assert.ok(bars > 5, `the bar stood at ${bars} places`);
  assert.ok(later - earlier < 40, `the stage was drawn ${later - earlier} times: the bar alone is no reason to`);
  const gaps = (await page.evaluate(() => window.gaps)).sort((a, b) => a - b);
  t.diagnostic(
    `${gaps.length} frames: median ${gaps[gaps.length >> 1].toFixed(0)} ms, ` +
      `95 % ${gaps[Math.floor(gaps.length * 0.95)].toFixed(0)} ms, longest ${gaps.at(-1).toFixed(0)} ms`,
  );
  assert.ok(gaps.length > 20, `${gaps.length} frames while measuring`);
  assert.equal(done.table.rows.length, kAll);
  t.diagnostic(done.table.rows.map((row) => row.join(", ")).join("; "));
  // On all points, on a machine that others use.
  const doubtful = done.table.rows.some(([, time]) => time.endsWith(", not measured reliably"));
  assert.deepEqual(outcomes.map(({ pending }) => pending), [doubtful, false, false]);
  const front = done.table.rows.filter((row) => row.at(-1) === "yes").map(([title]) => title);
  assert.ok(front.length > 0);
  if (doubtful) assert.match(outcomes[0].says, /could not be measured reliably/);
  else assert.ok(front.every((title) => outcomes[0].happened.includes(title)));
  assert.equal(await page.locator("#told .outcome").count(), 3);
  assert.equal(await page.locator(".cover tbody tr").count(), kAll);
});

test("an address with a step shows the points at that step, one without shows the chart", async (t) => {
  for (const [step, shown] of [["&step=3", false], ["", true]]) {
    const { cover, step: at } = await state(await visit(t, kLesson + step));
    assert.deepEqual([cover.shown, step ? at : 3], [shown, 3]);
  }
});

test("a click on a mark loads its box, and so do the arrow keys and Enter", async (t) => {
  const page = await visit(t, kLesson);
  await skip_all(page);
  await measure(page);
  const marks = await handles(page);
  assert.ok(marks.length >= 4, `${marks.length} marks`);
  const mark = marks.find(({ id }) => id === "aabb");  // it is measured on all points however busy the machine
  await page.mouse.move(mark.x, mark.y);
  await page.mouse.down();
  await page.mouse.up();
  const loaded = await until(page, (now) => !now.cover.shown);
  assert.equal(loaded.algorithm, "aabb");
  assert.equal(loaded.step, loaded.steps);
  await page.mouse.move(5, 5);
  await button(page, "Chart").click();
  await until(page, (now) => now.cover.shown);
  await page.locator("#canvas").focus();
  await page.keyboard.press("ArrowRight");
  const { caption } = await until(page, (now) => /front\.$/.test(now.caption));
  assert.match(caption, /: [\d.]+ (ns|µs|ms|s)/);
  for (let i = 0; i < kAll && !(await state(page)).caption.startsWith("PCA of the points"); ++i) {
    await page.keyboard.press("ArrowLeft");
    await still(page);
  }
  await page.keyboard.press("Enter");
  assert.equal((await until(page, (now) => !now.cover.shown)).algorithm, "pca");
});

test("what is ready stays when it is stopped; results are saved, and lie over the next ones", async (t) => {
  const page = await visit(t, kLesson);
  await skip_all(page);
  await button(page, "Measure").click();
  await until(page, (now) => now.cover.table.rows.length > 0);
  await button(page, "Stop").click();
  const { cover } = await until(page, (now) => !now.cover.running);
  assert.ok(cover.table.rows.length > 0 && cover.table.rows.length < kAll && !cover.decided);

  const saved = {};
  for (const format of ["CSV", "JSON"]) {
    const [download] = await Promise.all([page.waitForEvent("download"), button(page, `Save as ${format}`).click()]);
    assert.equal(download.suggestedFilename(), `snug-costs.${format.toLowerCase()}`);
    saved[format] = await readFile(await download.path());
  }
  const table = JSON.parse(saved.JSON);
  assert.equal(table.rows.length, cover.table.rows.length);
  assert.equal(table.provenance.platform, "WebAssembly");
  assert.ok(table.provenance.version && table.provenance.build && table.provenance.clock_resolution_ns > 0);
  assert.ok(saved.CSV.toString().startsWith("# snug table: costs\n"));

  await to_points(page);
  for (const format of ["CSV", "JSON"]) {
    await page
      .locator("#points input[type=file]")
      .setInputFiles({ name: `old.${format.toLowerCase()}`, mimeType: "text/plain", buffer: saved[format] });
    await until(page, (now) => now.cover.says.endsWith("Hollow marks: teapot, an earlier result."));
  }
  await page
    .locator("#points input[type=file]")
    .setInputFiles({ name: "cut.json", mimeType: "text/plain", buffer: saved.JSON.subarray(0, 200) });
  await page.getByText("is not a complete result").waitFor();
});

test("two million points and one are refused; six thousand are measured whole and shown in part", async (t) => {
  const page = await visit(t, kLesson);
  await skip_all(page);
  await to_points(page);
  const give = (name, n) => page.locator("#points input[type=file]").setInputFiles({ name, mimeType: "text/plain",
    buffer: Buffer.from(Array.from({ length: n }, (_, i) => `${i % 97} ${i % 89} ${i % 83}`).join("\n")) });
  await give("huge.xyz", 2_000_001);
  await page.getByText("2,000,001 points, and costs are measured on at most 2,000,000").waitFor();
  await give("large.xyz", 6000);
  const { cover, size } = await until(page, (now) => now.cover.says === "Now press Measure: 6,000 points.");
  assert.equal(size, 5000);
  assert.ok(cover.work[0].enabled);
});

test("on a phone the canvas draws the numbers, and covers nothing of the measurement above them", async (t) => {
  const page = await visit(t, kLesson, kPhone);
  await skip_all(page);
  await page.getByRole("tab", { name: "Numbers" }).click();
  await still(page);
  const covered = await page.evaluate(() => {
    document.querySelector(".cover").scrollIntoView({ block: "center" });
    const above = ({ x, y, width, height }) => document.elementFromPoint(x + width / 2, y + height / 2);
    const parts = [...document.querySelectorAll(".cover :is(button, p)")].filter((part) => part.checkVisibility());
    return parts
      .filter((part) => !above(part.getBoundingClientRect())?.closest(".cover"))
      .map(({ textContent }) => textContent);
  });
  assert.deepEqual(covered, []);
});

test("five per cent tighter: the fastest that is so does the task, on the student's own shape", async (t) => {
  const page = await visit(t, kLesson, kPhone);
  await skip_all(page);
  await page.getByRole("button", { name: "Start with 500 points" }).click();
  await until(page, (now) => now.size === 500 && now.grade.says === "Measure this shape.");
  await measure(page);
  for (let press = 0; press < kAll && !(await state(page)).grade.done; ++press) {
    if (!(await state(page)).cover.shown) await button(page, "Chart").click();
    await page.locator("#canvas").focus();
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("Enter");
    await still(page);
  }
  const { grade } = await state(page);
  assert.ok(grade.done || /nothing is/.test(grade.says), grade.says);
  t.diagnostic(grade.says);
});

test("the other charts wait for the predictions; then the keyboard chooses them", async (t) => {
  const page = await visit(t, kLesson);
  for (const name of ["Growth", "Looseness in a turn"]) assert.ok(await choice(page, name).isDisabled());
  assert.ok(await choice(page, "Accuracy").isChecked());
  await page.locator(".cover-says", { hasText: "Press Measure: first you predict, then it is measured." }).waitFor();
  await page.locator("#canvas").focus();
  await page.keyboard.press("v");
  assert.equal(chosen_of(await state(page)), "Accuracy");
  await skip_all(page);
  await choice(page, "Accuracy").focus();
  await page.keyboard.press("ArrowRight");
  assert.ok((await until(page, (now) => now.cover.choices[1].chosen)).cover.shown);
  assert.ok(await choice(page, "Growth").isChecked());
  await page.locator("#canvas").focus();
  await page.keyboard.press("v");
  await until(page, (now) => now.cover.choices[2].chosen);
  assert.ok(await choice(page, "Looseness in a turn").isChecked());
});

test("growth: from ten points on, stopped before a frame would wait, by key, saved, laid over", async (t) => {
  const page = await visit(t, kLesson);
  await skip_all(page);
  const { cover, caption, outcomes } = await measure_chart(page, "Growth", "growth");
  assert.match(cover.says, /^6 measured\. Points: cube\./);
  assert.equal(cover.table.rows.length, kAll);
  assert.ok(!cover.decided && outcomes.every(({ pending }) => pending), "the questions are of the other chart");
  t.diagnostic(cover.table.rows.map((row) => row.join(", ")).join("; "));
  for (const [, points, , power, theory] of cover.table.rows) {
    assert.match(points, /^(1,000,000$|[\d,]+: one run of \d+ points would take about)/);
    assert.match(power, /^(\d\.\d\d|too few points to tell)$/);
    assert.match(theory, /^O\(/);
  }
  if (cover.table.rows.some(([, points]) => points.includes(":")))
    assert.match(caption, /where one run would take over 12 ms: a longer run would hold up the page/);
  assert.equal(await page.locator(".cover tbody tr").count(), kAll);
  assert.deepEqual(await page.locator(".cover thead th").allTextContents(), [
    "Algorithm",
    "Most points",
    "Time for these",
    "Power of n",
    "In theory",
  ]);

  await page.locator("#canvas").focus();
  await page.keyboard.press("ArrowRight");
  const first = await until(page, (now) => /: 10 points, /.test(now.caption));
  await page.keyboard.press("ArrowRight");
  await until(page, (now) => /: 32 points, /.test(now.caption));
  await page.keyboard.press("ArrowDown");
  const other = await until(
    page,
    (now, was) => /: 32 points, /.test(now.caption) && now.caption.split(":")[0] !== was,
    first.caption.split(":")[0],
  );
  const mark = (await handles(page)).find(({ id }) => id === "exact");
  await page.mouse.click(mark.x, mark.y);
  const clicked = await until(page, (now, was) => now.caption !== was, other.caption);
  assert.ok(clicked.cover.shown, "a line's mark tells its figures, and loads nothing");

  const saved = {};
  for (const format of ["CSV", "JSON"]) {
    const [download] = await Promise.all([page.waitForEvent("download"), button(page, `Save as ${format}`).click()]);
    assert.equal(download.suggestedFilename(), `snug-growth.${format.toLowerCase()}`);
    saved[format] = await readFile(await download.path());
  }
  const table = JSON.parse(saved.JSON);
  assert.equal(table.table, "growth");
  assert.ok(
    table.rows.length >= 3 * kAll && table.rows.every(({ points, time_ns }) => points >= 10 && time_ns.median > 0),
  );
  await page.locator(".segments label", { hasText: "Accuracy" }).click();
  await until(page, (now) => now.cover.choices[0].chosen);
  await to_points(page);
  for (const [name, buffer] of Object.entries(saved)) {
    await page
      .locator("#points input[type=file]")
      .setInputFiles({ name: `old.${name.toLowerCase()}`, mimeType: "text/plain", buffer });
    await until(
      page,
      (now) => now.cover.choices[1].chosen && now.cover.says.endsWith("Hollow marks: cube:1000000, an earlier result."),
    );
  }
});

test("a turn: every update at 72 angles; stopped, what is ready stays; a saved one waits for answers", async (t) => {
  const page = await visit(t, kLesson, kPhone);
  await skip_all(page);
  const { cover, caption } = await measure_chart(page, "Looseness in a turn", "turn");
  t.diagnostic(cover.table.rows.map((row) => row.join(", ")).join("; "));
  const rows = cover.table.rows;
  assert.equal(rows.length, 13);
  assert.ok(rows.every(([, , , time]) => time !== "not measured"));
  const looseness = Object.fromEntries(rows.map(([title, , most]) => [title, most]));
  assert.equal(looseness["Rebuilt AABB"], "0 %");
  assert.ok(parseFloat(looseness["Loose AABB"]) > 100 && parseFloat(looseness["AABB of rotated AABB"]) > 100);
  assert.equal(rows.filter(([, , most]) => most === "0 %").length, 9);
  assert.match(caption, /^9 of 13 updates are always the tightest of their kind/);
  await page.locator("#stage").scrollIntoViewIfNeeded();
  await still(page);
  const loose = (await handles(page)).find(({ id }) => /^Loose/.test(id));
  await page.touchscreen.tap(loose.x, loose.y);
  await until(page, (now) => /at 355°: [\d,.]+ % larger than the tightest/.test(now.caption));

  await button(page, "Measure").click();
  await until(page, (now) => now.cover.running && now.cover.table.rows.length > 1);
  await button(page, "Stop").click();
  const { cover: part } = await until(page, (now) => !now.cover.running);
  assert.ok(
    part.table.rows.length > 1 && part.table.rows.length < rows.length,
    `${part.table.rows.length} of ${rows.length}`,
  );

  const [download] = await Promise.all([page.waitForEvent("download"), button(page, "Save as CSV").click()]);
  const buffer = await readFile(await download.path());
  assert.ok(buffer.toString().startsWith("# snug table: turn\n"));
  const fresh = await visit(t, kLesson);
  await to_points(fresh);
  await fresh.locator("#points input[type=file]").setInputFiles({ name: "turn.csv", mimeType: "text/plain", buffer });
  await fresh.locator(".notice", { hasText: "Answer the questions first" }).waitFor();
  assert.equal(chosen_of(await state(fresh)), "Accuracy");
});
