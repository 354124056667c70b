// The charts of the lectures' claims: predicted, tried while the page stays alive, a counter-example on the stage;
// saved as files and as pictures.
import { execFileSync } from "node:child_process";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import {
  assert, cut_off, handles, kPhone, revisit, start, state, still, stop, until, until_within, visit,
} from "./support.mjs";

before(start);
after(stop);

const kLesson = "?lesson=lecture-claims";
const kQuestions = 10;
const button = (page, name) => page.getByRole("button", { name, exact: true });

async function skip_all(page) {
  await button(page, "Measure").click(); // it asks first
  for (let i = 0; i < kQuestions; ++i) {
    await button(page, "Skip").click();
    await until(page, (now, before) => now.outcomes.length > before, i);
  }
}

async function measure(page) {
  await button(page, "Measure").click();
  await until_within(300_000, page, (now) => now.cover.decided && !now.cover.running);
  await still(page);
  return state(page);
}

let laptop; // it stays measured, for the tests of a file run one after the other

/** The page with all questions decided and all claims tried. */
async function measured(t) {
  if (laptop) return revisit(t, laptop);
  laptop = await visit(t, kLesson);
  await skip_all(laptop);
  await measure(laptop);
  return laptop;
}

/** Presses a button that saves, and gives the file. */
async function saved(within, name) {
  const page = within.page?.() ?? within;
  const [file] = await Promise.all([page.waitForEvent("download"), button(within, name).click()]);
  const path = await file.path();
  return { name: file.suggestedFilename(), path, bytes: await readFile(path) };
}

test("each claim is answered before it is tried, and decided by its clouds", async (t) => {
  const page = await visit(t, kLesson);
  const opened = await state(page);
  assert.equal(opened.asked, null, "nothing is asked before Measure is pressed");
  assert.match(opened.caption, /^Press Measure: first you predict/);
  await button(page, "Measure").click();
  const { asked, cover } = await until(page, (now) => now.asked);
  assert.equal(asked.choices.length, 3);
  assert.equal(cover.choices.length, 10);
  assert.deepEqual(await cut_off(page), [], "all choices are in sight");
  assert.ok(await button(page, "Measure").isDisabled());
  assert.ok(await button(page, "Save as SVG").isDisabled());
  await button(page, asked.choices[2]).click();
  await button(page, "Answer").click();
  await until(page, (now) => now.outcomes.length === 1 && now.outcomes[0].pending);
  for (let i = 1; i < kQuestions; ++i) {
    await button(page, "Skip").click();
    await until(page, (now, before) => now.outcomes.length > before, i);
  }
  const done = await measure(laptop = page);
  assert.equal(done.cover.table.rows.length, 10);
  assert.ok(done.outcomes[0].right, "the first claim is false on most clouds");
  assert.match(done.outcomes[0].says, /^It holds on 91 of 240 clouds\.$/);
  assert.equal(await page.locator(".cover tbody tr").count(), 10);
  const last = page.locator("#told .outcome").last(); // unfolded, it says which claim it is about
  await last.locator("summary").click();
  assert.equal(await last.locator(".asked").innerText(), done.predictions.at(-1).prompt);
});

test("a chart is saved as SVG with real words, as PNG at its own size, and as a table", async (t) => {
  const page = await measured(t);
  const before = await page.evaluate(() => {
    const { width, height } = document.getElementById("canvas");
    return [width, height];
  });
  const svg = await saved(page, "Save as SVG");
  assert.equal(svg.name, "snug-claims.svg");
  assert.match(svg.bytes.toString(), /claimed: no larger<\/text>/);
  assert.match(svg.bytes.toString(), /prefers-color-scheme:dark/);
  const address = /\?lesson=lecture-claims/;
  assert.match(/<metadata>(.*)<\/metadata>/.exec(svg.bytes.toString())[1], address);
  const blank = await page.context().newPage(); // where no policy forbids the picture's own style
  const words = await blank.evaluate((text) => {
    const read = new DOMParser().parseFromString(text, "image/svg+xml");
    return read.querySelector("parsererror") ? -1 : read.querySelectorAll("text").length;
  }, svg.bytes.toString());
  await blank.close();
  assert.ok(words > 15, `${words} words`);
  const png = await saved(page, "Save as PNG");
  assert.equal(png.name, "snug-claims.png");
  assert.equal(png.bytes.toString("latin1", 1, 4), "PNG");
  assert.deepEqual([png.bytes.readUInt32BE(16), png.bytes.readUInt32BE(20)], [2560, 1600]);
  assert.ok(png.bytes.length > 20_000, `${png.bytes.length} bytes: something is drawn`);
  const told = (path, ...how) => execFileSync("convert", [path, ...how, "info:"], { encoding: "utf8" });
  assert.match(told(png.path, "-format", "%[Source]"), address);

  await button(page, "Share").click();
  await button(page, "As a picture").click();
  const dialog = page.getByRole("dialog", { name: "Pictures of the chart" });
  await dialog.getByRole("checkbox", { name: "transparent" }).check();
  const clear = await saved(dialog, "1280 × 800");
  const opaque = Number(told(clear.path, "-alpha", "extract", "-format", "%[fx:mean]"));
  assert.ok(opaque > 0.005 && opaque < 0.4, `${opaque} of it is opaque`);
  assert.match(told(clear.path, "-format", "%[Source]"), address);
  assert.doesNotMatch((await saved(dialog, "Save SVG")).bytes.toString(), /<rect[^>]* width="1280" height="800"/);
  await button(dialog, "Close").click();
  await still(page);
  assert.deepEqual(
    await page.evaluate(() => {
      const { width, height } = document.getElementById("canvas");
      return [width, height];
    }),
    before,
  );
  const csv = await saved(page, "Save as CSV");
  assert.ok(csv.bytes.toString().startsWith("# snug table: trials\n"));
  assert.equal(csv.bytes.toString().trim().split("\n").filter((line) => /^\w+,/.test(line)).length, 1 + 10 * 240);
});

test("a click on a mark puts its cloud on the stage, and so does Enter on the worst one", async (t) => {
  const page = await measured(t);
  await page.locator("#canvas").focus();
  await page.keyboard.press("Enter");
  const worst = await until(page, (now) => !now.cover.shown);
  assert.equal(worst.source, "stick");
  assert.equal(worst.size, 12);
  assert.equal(worst.algorithm, "brute_force_slide");
  assert.equal(worst.step, worst.steps);
  await button(page, "Chart").click();
  await until(page, (now) => now.cover.shown);
  await still(page);
  const mark = (await handles(page)).find(({ id }) => id === "cube");
  await page.mouse.move(mark.x, mark.y);
  await page.mouse.down();
  await page.mouse.up();
  const loaded = await until(page, (now) => !now.cover.shown);
  assert.equal(loaded.source, "cube");
  assert.equal(loaded.outcomes.length, kQuestions, "no answer is lost");
});

test("in a window as narrow as a phone every claim can be chosen, and nothing is cut off", async (t) => {
  const page = await measured(t);
  await page.setViewportSize(kPhone.viewport);
  if (!(await state(page)).cover.shown) await button(page, "Chart").click();
  await page.locator(".segments label", { hasText: "14-DOP" }).click();
  const { cover } = await until(page, (now) => now.cover.choices.find(({ chosen }) => chosen).words === "14-DOP");
  assert.ok(cover.shown);
  assert.deepEqual(await cut_off(page), []);
});
