// Pictures of the stage as files, as other programs open them: each carries the address of what it shows.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import {
  assert, kPatience, load, pixels_of, start_for_pictures, state, still, stop, until,
} from "./support.mjs";

before(start_for_pictures);
after(stop);

const described = (path, what) => execFileSync("identify", ["-format", what, path], { encoding: "utf8" });

test("a step is saved as PNG and SVG, and steps as an animation", async (t) => {
  const page = await load(t, "?lesson=obb-sat&step=5");
  const before = await state(page);
  await page.getByRole("button", { name: "Share" }).first().click();
  await page.getByRole("button", { name: "As a picture" }).click();
  const dialog = page.getByRole("dialog", { name: "Pictures of the stage" });
  const save = async (name) => {
    const saved = page.waitForEvent("download");
    await dialog.getByRole("button", { name }).click();
    return (await saved).path();
  };
  const address = /\?lesson=obb-sat\S*step=5/;

  const png = await save("2560 × 1600");
  assert.equal(described(png, "%wx%h"), "2560x1600");
  assert.match(described(png, "%[Source]"), address);

  const svg = await save("Save SVG"), text = readFileSync(svg, "utf8");
  assert.match(text, /<metadata>\S*lesson=obb-sat\S*step=5\S*<\/metadata>/);
  assert.ok(text.match(/<text /g).length > 5, "its words are text");
  assert.equal(execFileSync("rsvg-convert", ["--width=640", svg]).subarray(1, 4).toString(), "PNG");
  await dialog.getByRole("checkbox", { name: "with names and measures" }).uncheck();
  const bare = readFileSync(await save("Save SVG"), "utf8");
  assert.ok(bare.length < text.length, "names and measures can be left out");

  await dialog.getByRole("checkbox", { name: "with names and measures" }).check();

  // Without its ground, and in other colours: what is clear, and what is the ground's, is as it should be.
  const share = (path, ...how) => Number(execFileSync("convert", [path, ...how, "-format", "%[fx:mean]", "info:"]));
  await dialog.getByRole("checkbox", { name: "transparent" }).check();
  const clear = await save("1280 × 800");
  const opaque = share(clear, "-alpha", "extract");
  assert.ok(opaque > 0.005 && opaque < 0.4, `${opaque} of it is opaque`);
  assert.match(described(clear, "%[Source]"), address);
  await dialog.getByLabel("Colours").selectOption("dark");
  assert.doesNotMatch(readFileSync(await save("Save SVG"), "utf8"), /<rect x="0" y="0" width="1280" height="800"/);
  await dialog.getByRole("checkbox", { name: "transparent" }).uncheck();
  const dark = await save("1280 × 800");
  assert.ok(share(dark, "-fill", "white", "+opaque", "#10141B", "-negate") > 0.3, "the ground is dark");
  await dialog.getByLabel("Colours").selectOption("");

  await dialog.getByLabel("First step").fill("2");
  await dialog.getByLabel("Last step").fill("4");
  const gif = await save("Animate");
  assert.equal(described(gif, "%wx%h,"), "1280x800,".repeat(3));
  assert.match(described(gif, "%c"), address);
  assert.equal((await state(page)).step, before.step, "the stage is where it was");
});

test("a chart of nothing yet is no picture, and says so; of others see claims.test.mjs", async (t) => {
  const page = await load(t, "?lesson=cost-chart&step=0");
  await page.getByRole("button", { name: "Share" }).first().click();
  await page.getByRole("button", { name: "As a picture" }).click();
  const dialog = page.getByRole("dialog", { name: "Pictures of the chart" });
  await dialog.getByRole("button", { name: "Save SVG" }).click();
  await dialog.getByText("nothing has been measured yet").waitFor();
  await dialog.getByRole("button", { name: "Close" }).click();
});

test("a demo's state shows its numbers from their top again, however they were scrolled", async (t) => {
  const viewport = { width: 1280, height: 720 };
  const page = await load(t, "?demo=geometry&state=11", { viewport, reducedMotion: "reduce" });
  await until(page, (now) => now.size === 200 && now.step === now.steps);
  await still(page);
  const clip = await page.locator("#numbers").boundingBox();
  await page.mouse.move(clip.x + clip.width / 2, clip.y + clip.height / 2);
  await still(page);
  const top = await pixels_of(page, clip);
  const until_at_top = async (wanted) => {
    for (const end = Date.now() + kPatience;;) {
      const now = await pixels_of(page, clip);
      const other = now.filter((value, i) => Math.abs(value - top[i]) > 16).length / now.length;
      if ((other < 0.04) === wanted) return; // scrolled, a tenth of it is other; some letters are another time, too
      assert.ok(Date.now() < end, wanted ? "it stays where it was scrolled to" : "it does not scroll");
    }
  };
  await page.mouse.wheel(0, 400);
  await until_at_top(false);
  await page.keyboard.press("Home");
  await until_at_top(true);
});
