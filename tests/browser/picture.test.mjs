// Pictures of the stage as files, as other programs open them: each carries the address of what it shows.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { assert, load, start_for_pictures, state, stop } from "./support.mjs";

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

  await dialog.getByLabel("First step").fill("2");
  await dialog.getByLabel("Last step").fill("4");
  const gif = await save("Animate");
  assert.equal(described(gif, "%wx%h,"), "1280x800,".repeat(3));
  assert.match(described(gif, "%c"), address);
  assert.equal((await state(page)).step, before.step, "the stage is where it was");
});
