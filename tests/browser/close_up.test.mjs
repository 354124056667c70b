// The close-up that a lesson's file asks for: it is on the stage, magnifies the gap, follows a drag and covers no
// handle.
import { after, before, test } from "node:test";
import {
  add_lesson, assert, drag, drag_by_finger, handles, kPhone, kWide, start_for_pictures, state, still, stop, until,
  visit,
} from "./support.mjs";

const lesson = `version = 2
title = "A small gap"
summary = "Two boxes, three thousandths apart."
minutes = 1
volume = "box_pair"
algorithms = ["sat"]

[boxes]
center = [[-1, 0], [1.003, 0.1]]
half_extents = [[1, 0.6], [1, 0.5]]
turn = [[0], [0]]

[view]
inset = { at = "gap" }

[[section]]
title = "A gap"
text = "It is small."
`;

before(async () => {
  await start_for_pictures();
  await add_lesson("small-gap", lesson);
});
after(stop);

const under = (panel, points) =>
  points.filter(({ x, y }) => x > panel.x && x < panel.x + panel.width && y > panel.y && y < panel.y + panel.height);

/// The panel, whose place is told on the canvas, on the page.
const on_page = (page, panel) => page.evaluate((panel) => {
  const { left, top } = document.querySelector("canvas").getBoundingClientRect();
  return { ...panel, x: panel.x + left, y: panel.y + top };
}, panel);

/// How many colours are in it: what is drawn there.
const colors_in = async (page, { x, y, width, height }) => {
  const picture = await page.screenshot({ clip: { x, y, width, height } });
  return page.evaluate(async (bytes) => {
    const bitmap = await createImageBitmap(new Blob([new Uint8Array(bytes)]));
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height), context = canvas.getContext("2d");
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height), seen = new Set();
    for (let i = 0; i < data.length; i += 4) seen.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
    return seen.size;
  }, [...picture]);
};

for (const [name, options] of Object.entries({ "a desktop": kWide, "a phone": kPhone }))
  test(`on ${name} a gap of 0.003 is shown enlarged, and stays shown while a box is dragged`, async (t) => {
    const page = await visit(t, "?lesson=small-gap", options);
    await still(page);
    const { closeUp: before } = await until(page, (it) => it.closeUp !== null);
    assert.ok(Math.abs(before.at[0] - 0.0015) < 1e-9);
    assert.ok(before.times > 40, `${before.times} times`);
    assert.ok(Math.abs(before.size - 0.009) < 1e-9);
    const panel = await on_page(page, before);
    assert.deepEqual(under(panel, await handles(page)), []);
    assert.ok(await colors_in(page, panel) > 5);
    await (options === kPhone ? drag_by_finger : drag)(page, "B", 0, 40);
    const { closeUp: after } = await until(page, (it, y) => it.closeUp !== null && it.closeUp.at[1] < y, before.at[1]);
    assert.ok(after.times > 10);
    assert.deepEqual(under(await on_page(page, after), await handles(page)), []);
  });

test("a lesson that asks for none has none", async (t) => {
  const page = await visit(t);
  assert.equal((await state(page)).closeUp, null);
});
