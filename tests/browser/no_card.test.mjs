// A browser without a graphics card draws and composites on the processor: the page is whole there, too.
import { after, before, test } from "node:test";
import { assert, kPhone, kWide, load, start_without_card, still, stop } from "./support.mjs";
import { colors_of, read_png } from "./engines/picture.mjs";

before(start_without_card);
after(stop);

/** How many colours an area shows, in CSS pixels. */
async function colors_in(page, { x, y, width, height }) {
  const scale = await page.evaluate(() => devicePixelRatio);
  const place = { x: x * scale, y: y * scale, width: width * scale, height: height * scale };
  return colors_of(read_png(await page.screenshot()), place).length;
}

/** The part of the canvas that lies where a panel over it is when it is turned upside down. */
const mirrored = (page, selector) =>
  page.evaluate((of) => {
    const canvas = document.getElementById("canvas").getBoundingClientRect(),
      panel = document.querySelector(of).getBoundingClientRect();
    return { x: panel.x, y: canvas.top + canvas.bottom - panel.bottom, width: panel.width, height: panel.height };
  }, selector);

for (const { name, size, panel } of [
  { name: "laptop", size: kWide, panel: ".code" },
  { name: "phone", size: kPhone, panel: ".ask" },
]) {
  test(`on a ${name} a panel over the canvas hides nothing but what it covers`, async (t) => {
    const page = await load(t, "?lesson=frustum-2d&step=0", size);
    assert.ok(
      await page.evaluate(() => document.documentElement.classList.contains("software")),
      "it is drawn by the processor",
    );
    for (let i = 0; i < 3; ++i) {
      // every second frame may be whole
      await page.mouse.move(200 + 9 * i, 200);
      await still(page);
      const place = await mirrored(page, panel);
      const colors = await colors_in(page, { ...place, y: place.y + 8, height: Math.min(place.height, 200) - 16 });
      assert.ok(colors > 50, `${colors} colours at ${JSON.stringify(place)}`);
    }
  });
}
