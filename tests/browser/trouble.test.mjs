// What goes wrong is said plainly, and mended where it can be.
import { after, before, test } from "node:test";
import {
  assert, handles, kFirst, lessons, load, pixels_of, ready, start_for_pictures, state, still, stop, until,
} from "./support.mjs";

let site;
before(async () => (site = await start_for_pictures()));
after(stop);

test("a lost context is said and comes back", async (t) => {
  const page = await load(t);
  await page.evaluate(() => {
    window.lose = document.getElementById("canvas").getContext("webgl2").getExtension("WEBGL_lose_context");
    window.lose.loseContext();
  });
  await page.locator("#stage-message").getByText("lost its graphics").waitFor();
  const before = await state(page);
  await page.keyboard.press("Home"); // the lesson goes on meanwhile
  await until(page, (now) => now.step === 0);
  await page.evaluate(() => window.lose.restoreContext());
  await page.locator("#stage-message").waitFor({ state: "hidden" });
  await page.waitForFunction((drawn) => window.snug.state().framesDrawn > drawn, before.framesDrawn);
  await still(page);
  assert.equal(await page.evaluate(() => document.getElementById("canvas").getContext("webgl2").getError()), 0);
  assert.ok((await colours_on_stage(page)) > 3, "the stage is drawn anew");
});

/** How many colours a picture of the stage has: one would be an empty canvas. */
async function colours_on_stage(page) {
  const [first] = await handles(page);
  const pixels = await pixels_of(page, { x: first.x - 20, y: first.y - 20, width: 40, height: 40 });
  return new Set(new Uint32Array(pixels.buffer)).size;
}

for (const missing of ["snug.wasm", "snug.js", "fonts/Inter-Regular.otf", "course.json"]) {
  test(`a failed download (${missing}) is said, and trying again mends it`, async (t) => {
    site.refuse.add(missing);
    t.after(() => site.refuse.delete(missing));
    const page = await load(t, kFirst, { wait: false, may_complain: /503|Failed to fetch/ });
    await page.getByText("could not be loaded").waitFor();
    site.refuse.delete(missing);
    await page.getByRole("button", { name: "Try again" }).click();
    await ready(page);
    await page.locator("#veil").waitFor({ state: "hidden" });
  });
}

test("a lesson that does not arrive can be tried again", async (t) => {
  const [{ id }] = await lessons();
  site.refuse.add(`lessons/${id}.toml`);
  t.after(() => site.refuse.clear());
  const page = await load(t, kFirst, { wait: false, may_complain: /503/ });
  await page.getByText("The lesson could not be loaded").waitFor();
  site.refuse.clear();
  await page.getByRole("button", { name: "Try again" }).click();
  await ready(page);
});

test("the page's own files missing is said without any of them", async (t) => {
  site.refuse.add("dom.js");
  t.after(() => site.refuse.clear());
  const page = await load(t, kFirst, { wait: false, may_complain: /503/ });
  await page.getByText("Some of the page’s own files could not be loaded").waitFor();
  site.refuse.clear();
  await page.getByRole("button", { name: "Try again" }).click();
  await ready(page);
});

test("the loading bar tells true progress", async (t) => {
  const seen = await load(t, kFirst, {
    init: () => {
      window.shares = [];
      const watch = () => {
        const bar = document.getElementById("veil-bar");
        if (!bar) return requestAnimationFrame(watch);
        new MutationObserver(() => window.shares.push(Number(bar.getAttribute("aria-valuenow")))).observe(bar, {
          attributes: true,
        });
      };
      watch();
    },
  }).then((page) => page.evaluate(() => window.shares));
  assert.ok(seen.length > 2 && seen.at(-1) === 100, `${seen}`);
  assert.ok(seen.every((share) => share >= 0 && share <= 100));
});
