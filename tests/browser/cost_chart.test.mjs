// The charts of costs: predicted, measured in slices while the page stays alive, loaded from, saved and laid over, refused.
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { answer, assert, cut_off, handles, kPhone, start, state, still, stop, to_points, until, until_within, visit } from "./support.mjs";

before(start);
after(stop);

const kLesson = "?lesson=cost-chart";
const button = (page, name) => page.getByRole("button", { name, exact: true });
const decided = (now) => now.costs.decided && !now.costs.running;
const kAll = 6;

async function skip_all(page) {
  for (let i = 0; i < 3; ++i) {
    await button(page, "Skip").click();
    await until(page, (now, before) => now.outcomes.length > before, i);
  }
}

const choice = (page, name) => page.getByRole("radio", { name, exact: true });

/** Chooses a chart with the mouse, and measures it to the end. */
async function measure_chart(page, name, chart) {
  await page.locator(".segments label", { hasText: name }).click();
  await until(page, (now, wanted) => now.costs.chart === wanted && now.costs.shown, chart);
  await button(page, "Measure").click();
  await until(page, (now) => now.costs.running);
  await page.waitForFunction(() => !window.snug.state().costs.running, null, { timeout: 180_000 });
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
  const { asked, costs } = await until(page, (now) => now.asked);
  assert.ok(asked.many);
  assert.equal(asked.choices.length, kAll);
  assert.deepEqual(await cut_off(page), [], "all choices are in sight");
  assert.ok(!costs.ready && await button(page, "Measure").isDisabled());
  assert.ok(costs.shown && costs.rows.length === 0, "an empty chart stands there");
  for (const name of ["PCA of the points", "Exact minimum"]) await button(page, name).click();
  assert.equal(await button(page, "Exact minimum").getAttribute("aria-pressed"), "true");
  await button(page, "Answer").click();
  await until(page, (now) => now.outcomes.length === 1);
  await answer(page, "Exact minimum");
  await button(page, "Skip").click();
  const { outcomes: given } = await until(page, (now) => now.outcomes.length === 3);
  assert.ok(given.every(({ pending }) => pending));
  await page.locator(".costs-says", { hasText: "Now press Measure: " }).waitFor();
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
      window.bars.add(document.querySelector(".costs-bar").getAttribute("aria-valuenow"));
      if (!window.snug.state().costs.decided) requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  });
  const { framesDrawn: earlier } = await state(page);
  const { costs: done, outcomes, framesDrawn: later } = await measure(page);
  const bars = await page.evaluate(() => window.bars.size);
  assert.ok(bars > 5, `the bar stood at ${bars} places`);
  assert.ok(later - earlier < 40, `the stage was drawn ${later - earlier} times: the bar alone is no reason to`);
  const gaps = (await page.evaluate(() => window.gaps)).sort((a, b) => a - b);
  t.diagnostic(`${gaps.length} frames: median ${gaps[gaps.length >> 1].toFixed(0)} ms, 95 % ${gaps[Math.floor(gaps.length * 0.95)].toFixed(0)} ms, longest ${gaps.at(-1).toFixed(0)} ms`);
  assert.ok(gaps.length > 20, `${gaps.length} frames while measuring`);
  assert.equal(done.rows.length, kAll);
  t.diagnostic(done.rows.map(({ title, time, size, points, front }) => `${title}: ${time}, ${size}, ${points}${front ? " *" : ""}`).join("; "));
  const badly = done.rows.some(({ trusted, points, of }) => points === of && !trusted); // on a machine that others use
  assert.deepEqual(outcomes.map(({ pending }) => pending), [badly, false, false]);
  const front = done.rows.filter((row) => row.front).map(({ title }) => title);
  assert.ok(front.length > 0);
  if (badly) assert.match(outcomes[0].says, /measured badly/);
  else assert.ok(front.every((title) => outcomes[0].happened.includes(title)));
  assert.equal(await page.locator("#told .outcome").count(), 3);
  assert.equal(await page.locator(".costs tbody tr").count(), kAll);
});

test("an address with a step shows the points at that step, one without shows the chart", async (t) => {
  for (const [step, shown] of [["&step=3", false], ["", true]]) {
    const { costs, step: at } = await state(await visit(t, kLesson + step));
    assert.deepEqual([costs.shown, step ? at : 3], [shown, 3]);
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
  const loaded = await until(page, (now) => !now.costs.shown);
  assert.equal(loaded.algorithm, "aabb");
  assert.equal(loaded.step, loaded.steps);
  await page.mouse.move(5, 5);
  await button(page, "Chart").click();
  await until(page, (now) => now.costs.shown);
  await page.locator("#canvas").focus();
  await page.keyboard.press("ArrowRight");
  const { caption } = await until(page, (now) => /front\.$/.test(now.caption));
  assert.match(caption, /: [\d.]+ (ns|µs|ms|s)/);
  for (let i = 0; i < kAll && !(await state(page)).caption.startsWith("PCA of the points"); ++i) {
    await page.keyboard.press("ArrowLeft");
    await still(page);
  }
  await page.keyboard.press("Enter");
  assert.equal((await until(page, (now) => !now.costs.shown)).algorithm, "pca");
});

test("what is ready stays when it is stopped; results are saved, and lie over the next ones", async (t) => {
  const page = await visit(t, kLesson);
  await skip_all(page);
  await button(page, "Measure").click();
  await until(page, (now) => now.costs.rows.length > 0);
  await button(page, "Stop").click();
  const { costs } = await until(page, (now) => !now.costs.running);
  assert.ok(costs.rows.length > 0 && costs.rows.length < kAll && !costs.decided);

  const saved = {};
  for (const format of ["CSV", "JSON"]) {
    const [download] = await Promise.all([page.waitForEvent("download"), button(page, `Save as ${format}`).click()]);
    assert.equal(download.suggestedFilename(), `snug-costs.${format.toLowerCase()}`);
    saved[format] = await readFile(await download.path());
  }
  const table = JSON.parse(saved.JSON);
  assert.equal(table.rows.length, costs.rows.length);
  assert.equal(table.provenance.platform, "WebAssembly");
  assert.ok(table.provenance.version && table.provenance.build && table.provenance.clock_resolution_ns > 0);
  assert.ok(saved.CSV.toString().startsWith("# snug table: costs\n"));

  await to_points(page);
  for (const format of ["CSV", "JSON"]) {
    await page.locator("#points input[type=file]").setInputFiles({ name: `old.${format.toLowerCase()}`, mimeType: "text/plain", buffer: saved[format] });
    await until(page, (now) => now.costs.then === "teapot");
  }
  await page.locator("#points input[type=file]").setInputFiles({ name: "cut.json", mimeType: "text/plain", buffer: saved.JSON.subarray(0, 200) });
  await page.getByText("is no whole result").waitFor();
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
  const { costs, size } = await until(page, (now) => now.costs.size === 6000);
  assert.equal(size, 5000);
  assert.ok(costs.ready);
});

test("five per cent tighter: the fastest that is so does the task, on the student's own shape", async (t) => {
  const page = await visit(t, kLesson, kPhone);
  await skip_all(page);
  await page.getByRole("button", { name: "Start with 500 points" }).click();
  await until(page, (now) => now.size === 500 && now.grade.says === "Measure this shape.");
  await measure(page);
  for (let press = 0; press < kAll && !(await state(page)).grade.done; ++press) {
    if (!(await state(page)).costs.shown) await button(page, "Chart").click();
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
  await page.getByText("Answer the questions first: the other charts would give the answers away.").waitFor();
  await page.locator("#canvas").focus();
  await page.keyboard.press("v");
  assert.equal((await state(page)).costs.chart, "accuracy");
  await skip_all(page);
  await choice(page, "Accuracy").focus();
  await page.keyboard.press("ArrowRight");
  assert.ok((await until(page, (now) => now.costs.chart === "growth")).costs.shown);
  assert.ok(await choice(page, "Growth").isChecked());
  await page.locator("#canvas").focus();
  await page.keyboard.press("v");
  await until(page, (now) => now.costs.chart === "turn");
  assert.ok(await choice(page, "Looseness in a turn").isChecked());
});

test("growth: from ten points on, stopped before a frame would have to wait, figures by key, saved and laid over", async (t) => {
  const page = await visit(t, kLesson);
  await skip_all(page);
  const { costs, caption, outcomes } = await measure_chart(page, "Growth", "growth");
  assert.equal(costs.of, "cube:1000000");
  assert.equal(costs.rows.length, kAll);
  assert.ok(!costs.decided && outcomes.every(({ pending }) => pending), "the questions are of the other chart");
  t.diagnostic(costs.rows.map(({ title, points, exponent, theory, stopped }) => `${title}: ${points}, ${exponent?.toFixed(2)} (${theory?.toFixed(2)}), ${stopped}`).join("; "));
  for (const row of costs.rows) assert.ok(row.points >= 10 && (row.points === 1_000_000 || /^one run of \d+ points would take about/.test(row.stopped)), row.stopped);
  if (costs.rows.some(({ stopped }) => stopped)) assert.match(caption, /where one run would take over 12 ms: a longer run would hold up the page/);
  assert.equal(await page.locator(".costs tbody tr").count(), kAll);
  assert.deepEqual(await page.locator(".costs thead th").allTextContents(), ["Algorithm", "Points at most", "Time of these", "Power of n", "In theory"]);

  await page.locator("#canvas").focus();
  await page.keyboard.press("ArrowRight");
  const first = await until(page, (now) => /: 10 points, /.test(now.caption));
  await page.keyboard.press("ArrowRight");
  await until(page, (now) => /: 32 points, /.test(now.caption));
  await page.keyboard.press("ArrowDown");
  const other = await until(page, (now, was) => /: 32 points, /.test(now.caption) && now.caption.split(":")[0] !== was, first.caption.split(":")[0]);
  const mark = (await handles(page)).find(({ id }) => id === "exact");
  await page.mouse.click(mark.x, mark.y);
  const clicked = await until(page, (now, was) => now.caption !== was, other.caption);
  assert.ok(clicked.costs.shown, "a line's mark tells its figures, and loads nothing");

  const saved = {};
  for (const format of ["CSV", "JSON"]) {
    const [download] = await Promise.all([page.waitForEvent("download"), button(page, `Save as ${format}`).click()]);
    assert.equal(download.suggestedFilename(), `snug-growth.${format.toLowerCase()}`);
    saved[format] = await readFile(await download.path());
  }
  const table = JSON.parse(saved.JSON);
  assert.equal(table.table, "growth");
  assert.ok(table.rows.length >= 3 * kAll && table.rows.every(({ points, time_ns }) => points >= 10 && time_ns.median > 0));
  await page.locator(".segments label", { hasText: "Accuracy" }).click();
  await until(page, (now) => now.costs.chart === "accuracy");
  await to_points(page);
  for (const [name, buffer] of Object.entries(saved)) {
    await page.locator("#points input[type=file]").setInputFiles({ name: `old.${name.toLowerCase()}`, mimeType: "text/plain", buffer });
    await until(page, (now) => now.costs.chart === "growth" && now.costs.then === "cube:1000000");
  }
});

test("a turn: every update at 72 angles; stopped, what is ready stays; a saved turn waits for the predictions", async (t) => {
  const page = await visit(t, kLesson, kPhone);
  await skip_all(page);
  const { costs, caption } = await measure_chart(page, "Looseness in a turn", "turn");
  t.diagnostic(costs.rows.map(({ title, most, time }) => `${title}: ${most}, ${time}`).join("; "));
  assert.equal(costs.rows.length, 10);
  assert.ok(costs.rows.every(({ angles, time }) => angles === 72 && time));
  const slack = Object.fromEntries(costs.rows.map(({ volume, strategy, most }) => [`${volume} ${strategy}`, most]));
  assert.equal(slack["aabb rebuild"], "0 %");
  assert.ok(parseFloat(slack["aabb loose"]) > 100 && parseFloat(slack["aabb rotated_box"]) > 100);
  assert.match(caption, /^8 of 10 updates are always the tightest of their kind/);
  await page.locator("#stage").scrollIntoViewIfNeeded();
  await still(page);
  const loose = (await handles(page)).find(({ id }) => /^Loose/.test(id));
  await page.touchscreen.tap(loose.x, loose.y);
  await until(page, (now) => /at 355°: [\d,.]+ % larger than the tightest/.test(now.caption));

  await button(page, "Measure").click();
  await until(page, (now) => now.costs.running && now.costs.rows.length > 1);
  await button(page, "Stop").click();
  const { costs: part } = await until(page, (now) => !now.costs.running);
  assert.ok(part.rows.length > 1 && part.rows.length < 10, `${part.rows.length} of 10`);

  const [download] = await Promise.all([page.waitForEvent("download"), button(page, "Save as CSV").click()]);
  const buffer = await readFile(await download.path());
  assert.ok(buffer.toString().startsWith("# snug table: turn\n"));
  const fresh = await visit(t, kLesson);
  await to_points(fresh);
  await fresh.locator("#points input[type=file]").setInputFiles({ name: "turn.csv", mimeType: "text/plain", buffer });
  await fresh.locator(".notice", { hasText: "Answer the questions first" }).waitFor();
  assert.equal((await state(fresh)).costs.chart, "accuracy");
});
