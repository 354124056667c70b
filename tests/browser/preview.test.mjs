// Lessons that are being written, as ./run --lessons serves them: a save is followed at the same place, and what is
// wrong with a file stands in a strip over its stage.
import { mkdtempSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { spawnSync } from "node:child_process";
import { fileURLToPath } from "node:url";
import {
  answer, assert, drag, handles, kPhone, kWide, load, serve_drafts, start_on, state, still, stop, until, until_within,
} from "./support.mjs";

const kSoon = 10_000; // milliseconds: a second where nothing else runs
const root = fileURLToPath(new URL("../../", import.meta.url));
const example = (name) => readFileSync(join(root, "lessons/examples", `${name}.toml`), "utf8");
const kCloud = example("cloud");
const kAxe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

const folder = mkdtempSync(join(tmpdir(), "snug-lessons-"));
const write = (name, text) => writeFileSync(join(folder, name), text);
write("mine.toml", kCloud);
before(() => start_on(() => serve_drafts(folder)));
after(async () => {
  await stop();
  rmSync(folder, { recursive: true });
});

/** The lesson's text with one stretch of it replaced. */
function changed(from, to, text = kCloud) {
  assert.ok(text.includes(from), from);
  return text.replace(from, to);
}

/** Where a stretch of a text stands: its line and column. */
function place_of(text, words) {
  const before = text.slice(0, text.indexOf(words)).split("\n");
  return `${before.length}:${before.at(-1).length + 1}`;
}

/** A page on the lesson, which is as the example at first. */
async function open(t, query = "?lesson=mine", options = kWide) {
  write("mine.toml", kCloud);
  return load(t, query, options);
}

const soon = (page, test, ...given) => until_within(kSoon, page, test, ...given);
const prose_has = (page, words) => page.locator("#prose").getByText(words).waitFor({ timeout: kSoon });

test("a save is followed at once, at the same algorithm and step", async (t) => {
  const page = await open(t, "?lesson=mine&step=0");
  await page.locator("#code select").first().selectOption("welzl");
  await page.keyboard.press("End");
  await until(page, (now) => now.algorithm === "welzl" && now.step === now.steps);
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("ArrowLeft");
  const before = await until(page, (now) => now.step === now.steps - 2);
  const at_hand = await page.locator("#prose section[aria-current]").count();
  write("mine.toml", changed("has a centre.", "has a middle of its own."));
  await prose_has(page, "has a middle of its own.");
  assert.equal(
    await page.locator("#prose section[aria-current]").count(),
    at_hand,
    "the section at hand is still marked",
  );
  const now = await state(page);
  assert.deepEqual([now.algorithm, now.step, now.trace], ["welzl", before.step, before.trace]);
  assert.match(page.url(), new RegExp(`step=${before.step}`));
});

test("what was dragged stays, until the file has other points; answers stay too", async (t) => {
  const page = await open(t, "?lesson=mine&step=0");
  await until(page, (now) => now.asked || now.step === 0);
  await page.keyboard.press("End");
  await answer(page, "P4");
  await drag(page, "P0", -30, 12);
  const before = await until(page, (now) => now.edited && now.outcomes.length === 1);
  write("mine.toml", changed("Who sets the radius?", "Who decides?"));
  await page.locator("#title").getByText("Who decides?").waitFor({ timeout: kSoon });
  const kept = await state(page);
  assert.equal(kept.trace, before.trace, "the dragged points stand there");
  assert.deepEqual(
    kept.outcomes.map(({ question, kind }) => [question, kind]),
    before.outcomes.map(({ question, kind }) => [question, kind]),
  );
  write("mine.toml", changed("[0.5, 2.5]]", "[0.5, 2.5], [1, 1]]"));
  const replaced = await soon(page, (now) => now.size === 6);
  assert.equal(replaced.edited, false);
  assert.equal(replaced.outcomes.length, 1);
});

test("the view and the selection stay; formulas are typeset", async (t) => {
  const page = await open(t, "?lesson=mine&step=1", { ...kWide, reducedMotion: "reduce" });
  await page.locator("#canvas").focus();
  await page.keyboard.press("]");
  const { selectedName } = await until(page, (now) => now.selectedName);
  const { x, y, width, height } = await page.locator("#stage").boundingBox();
  await page.mouse.move(x + width / 3, y + height / 3);
  await page.mouse.wheel(0, -400);
  await still(page);
  const before = await handles(page);
  write("mine.toml", changed("has a centre.", "has a centre $c_1$."));
  await page.locator("#prose math").waitFor();
  await still(page);
  assert.deepEqual(await handles(page), before);
  assert.equal((await state(page)).selectedName, selectedName);
  write("mine.toml", changed("[0.5, 2.5]]", "[0.5, 2.5], [1, 1]]"));
  await soon(page, (now) => now.size === 6);
  await page.keyboard.press("0"); // and all of it is shown again
  await still(page);
  assert.equal((await handles(page)).length, 6);
});

test("two mistakes stand in the strip with their places, and the lesson is drawn all the same", async (t) => {
  const page = await open(t, "?lesson=mine&step=2");
  const wrong = changed('asks = "point"', 'asks = "pint"', changed("minutes = 5", "minuts = 5"));
  write("mine.toml", wrong);
  await page.locator("#strip").waitFor({ timeout: kSoon });
  assert.equal(await page.locator("#strip h2").textContent(), "mine.toml: 2 mistakes");
  const lines = await page.locator("#strip li").allTextContents();
  assert.equal(lines.length, 2);
  assert.ok(lines[0].startsWith(`${place_of(wrong, "minuts")}: the lesson has no key "minuts"`), lines[0]);
  assert.ok(lines[1].startsWith(`${place_of(wrong, '"pint"')}: `), lines[1]);
  const now = await until(page, (it) => it.questions === 0); // the strip is there a little before the lesson
  assert.deepEqual(now.mistakes, ["mine.toml: 2 mistakes", ...lines]);
  assert.deepEqual([now.lesson, now.step, now.questions], ["mine", 2, 0]);
  assert.equal(await page.locator("#strip-told").textContent(), "mine.toml: 2 mistakes");
  await page.locator("#prose section[aria-current]").waitFor(); // the section at hand is marked as before
  write("mine.toml", kCloud);
  await page.locator("#strip").waitFor({ state: "hidden", timeout: kSoon });
  await until(page, (it) => it.questions === 1);
});

test("a link to no lesson stands in the strip until that lesson is there", async (t) => {
  const page = await open(t);
  const linked = changed("has a centre.", "has a centre, as [there](lesson:other).");
  write("mine.toml", linked);
  await page.locator("#strip li").getByText("links to a lesson that is not there: other").waitFor({ timeout: kSoon });
  assert.ok(
    (await page.locator("#strip li").textContent()).startsWith(`${place_of(linked, "[there](lesson:other)")}: `),
  );
  write("other.toml", kCloud); // and now it is there
  await page.locator("#strip").waitFor({ state: "hidden", timeout: kSoon });
});

test("a warning is told as one", async (t) => {
  const page = await open(t);
  write("mine.toml", changed("Drag an outer point", "Drag P7"));
  await page.locator("#strip li").getByText("warning: ").waitFor({ timeout: kSoon });
  assert.equal(await page.locator("#strip h2").textContent(), "mine.toml: 1 warning");
  assert.equal(await page.locator("#strip li.wrong").count(), 0);
});

test("what cannot be drawn leaves the stage as it was", async (t) => {
  const page = await open(t, "?lesson=mine&step=2", { ...kWide, may_complain: /404/ }); // a check, while it is gone
  const before = await state(page);
  write("mine.toml", changed("[points]", "[points"));
  await page
    .locator("#strip h2")
    .getByText("mine.toml: 1 mistake. It cannot be drawn like this.")
    .waitFor({ timeout: kSoon });
  const now = await state(page);
  assert.deepEqual([now.step, now.trace], [before.step, before.trace]);
  await page.keyboard.press("ArrowRight"); // it goes on as it was
  await until(page, (it, step) => it.step !== step || it.asked, before.step);
  renameSync(join(folder, "mine.toml"), join(folder, "other.toml")); // as editors do for a moment, or for good
  await page.locator("#strip h2").getByText("mine.toml is gone.").waitFor({ timeout: kSoon });
  rmSync(join(folder, "other.toml"));
  write("mine.toml", changed("Who sets the radius?", "Who decides?"));
  await page.locator("#strip").waitFor({ state: "hidden", timeout: kSoon });
  assert.equal(await page.locator("#title").textContent(), "Who decides?");
});

test("a folder that is gone is told, and followed again once it is back", async (t) => {
  const page = await open(t, "?lesson=mine&step=2", { ...kWide, may_complain: /404/ });
  const before = await state(page);
  renameSync(folder, `${folder}-away`);
  await page.locator("#strip h2").getByText("The lessons cannot be reached.").waitFor();
  await page.keyboard.press("ArrowRight"); // it goes on as it was
  await until(page, (it, step) => it.step !== step || it.asked, before.step);
  renameSync(`${folder}-away`, folder);
  write("mine.toml", changed("Who sets the radius?", "Who decides?"));
  await page.locator("#title").getByText("Who decides?").waitFor();
  await page.locator("#strip").waitFor({ state: "hidden" });
});

test("a lesson that cannot be drawn at first opens once it is mended", async (t) => {
  write("mine.toml", kCloud);
  write("late.toml", "version = ");
  t.after(() => rmSync(join(folder, "late.toml")));
  const page = await load(t, "?lesson=late", { wait: false });
  await page.locator("#veil").getByText("opens once its file is mended").waitFor();
  assert.match(await page.locator("#strip li").textContent(), /^1:\d+: /);
  await page.locator("#veil").getByText("Who sets the radius?").waitFor(); // a way out
  write("late.toml", kCloud);
  const now = await until(page, (it) => it.lesson === "late");
  assert.ok(now.steps > 0);
  await page.locator("#veil").waitFor({ state: "hidden" });
  await page.locator("#strip").waitFor({ state: "hidden" });
});

test("the course is that of the folder, and follows it", async (t) => {
  const page = await open(t, "");
  const titles = () => page.locator(".card-title b").allTextContents();
  assert.deepEqual(await titles(), ["Who sets the radius?"]);
  assert.equal(await page.locator(".chapter h2").textContent(), folder.split("/").at(-1));
  assert.equal(await page.locator("img").count(), 0, "no picture is missing: there is none");
  assert.equal(await page.locator(".picture.blank").count(), 2);
  write("box.toml", example("pair"));
  await page.locator(".card-title b").nth(1).waitFor({ timeout: kSoon });
  write("mine.toml", changed("Who sets the radius?", "Who decides?"));
  await page.locator(".card-title b").getByText("Who decides?").waitFor({ timeout: kSoon });
  write("course.toml", 'version = 1\n\n[[chapter]]\ntitle = "Both"\nlessons = ["mine", "box"]\n');
  t.after(() => ["box.toml", "course.toml"].forEach((name) => rmSync(join(folder, name))));
  await page.locator(".chapter h2").getByText("Both").waitFor({ timeout: kSoon });
  assert.equal((await titles())[0], "Who decides?");
  write("course.toml", 'version = 1\n\n[[chapter]]\ntitle = "Both"\nlessons = ["mine"]\n');
  await page.locator("#strip li").getByText("does not name each lesson once").waitFor({ timeout: kSoon });
  await page.locator(".lesson-card").first().click();
  await until(page, (now) => now.lesson);
});

test("the strip is under the policy, and axe finds nothing wrong with it in any theme", async (t) => {
  for (const size of [kWide, { ...kPhone, deviceScaleFactor: 1 }]) {
    write("mine.toml", changed("Drag an outer point", "Drag P7", changed("minutes = 5", "minuts = 5")));
    const page = await load(t, "?lesson=mine&step=1", {
      ...size,
      reducedMotion: "reduce",
      init: () => {
        window.refused = [];
        addEventListener("securitypolicyviolation", ({ effectiveDirective, blockedURI }) =>
          window.refused.push(`${effectiveDirective}: ${blockedURI}`),
        );
      },
    });
    await page.locator("#strip li").nth(1).waitFor();
    await page.evaluate(kAxe);
    for (const theme of ["light", "dark", "contrast", "projector"]) {
      await page.evaluate((name) => (document.documentElement.dataset.theme = name), theme);
      await still(page);
      const found = await page.evaluate(async () =>
        (await window.axe.run("#strip", { resultTypes: ["violations"] })).violations.map(
          ({ id, nodes }) => `${id} at ${nodes.map(({ target }) => target)}`,
        ),
      );
      assert.deepEqual(found, [], theme);
    }
    assert.deepEqual(
      (await page.evaluate(() => window.refused)).filter((one) => !one.includes("axe")),
      [],
    );
    assert.ok(
      await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth),
      "nothing needs a sideways scroll",
    );
  }
});

test("a folder that has no lessons is refused in words", () => {
  for (const { lessons, says } of [
    { lessons: "/nowhere/at/all", says: /^\/nowhere\/at\/all is not a folder/ },
    { lessons: join(root, "web/page"), says: /has no lesson/ },
  ]) {
    const { status, stderr } = spawnSync(
      "python3",
      [join(root, "web/serve.py"), join(root, "web/page"), "--port", "0", "--lessons", lessons],
      { encoding: "utf8" },
    );
    assert.equal(status, 1);
    assert.match(stderr, says);
  }
  const { status, stderr } = spawnSync(join(root, "run"), ["--lessons", "/nowhere/at/all"], { encoding: "utf8" });
  assert.equal(status, 1);
  assert.match(stderr, /^\/nowhere\/at\/all is not a folder/);
});
