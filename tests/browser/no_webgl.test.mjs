// Without WebGL 2 the lesson is all there: what the canvas would show of the player and the numbers is HTML.
import { after, before, test } from "node:test";
import { assert, kPhone, kWide, load, moved, start, state, stop, until } from "./support.mjs";

before(start);
after(stop);

const no_webgl = () => {
  const get_context = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
    return kind.startsWith("webgl") ? null : get_context.call(this, kind, ...rest);
  };
};

const press = (page, name) =>
  page.getByRole("toolbar", { name: "Player" }).getByRole("button", { name, exact: true }).click();

/** The table of numbers as it is read. */
const table = (page) =>
  page.locator("#figures tr").evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.innerText)));

for (const [name, size] of Object.entries({ laptop: kWide, phone: kPhone })) {
  test(`on a ${name} without WebGL 2 numbers and step buttons stand on the page`, async (t) => {
    const page = await load(t, "?lesson=sphere-ritter&step=0", { ...size, init: no_webgl });
    const message = page.locator("#stage-message");
    await message.getByText("WebGL 2").waitFor();
    for (const button of ["First step", "Step back", "Step", "Next mark", "Play", "Last step"])
      assert.ok(await page.getByRole("button", { name: button, exact: true }).isVisible(), button);
    await press(page, "Step");
    let now = await until(page, (it) => it.step === 1);
    assert.ok(await page.locator("#caption").isVisible());
    assert.equal(await page.locator("#caption").textContent(), now.caption);
    const [says, caption] = [await message.locator("p").boundingBox(), await page.locator("#ask").boundingBox()];
    assert.ok(now.asked);
    assert.ok(
      says.y + says.height <= caption.y + 1,
      "the message leaves the question, in the sentence's place, its own",
    );
    await page.getByRole("button", { name: "Skip" }).click();
    await until(page, (it, asked) => it.asked?.id !== asked, now.asked.id);
    if (name === "phone") await page.getByRole("tab", { name: "Numbers" }).click();
    now = await state(page);
    assert.ok(now.figures.length >= 3);
    assert.deepEqual(await table(page), now.figures.map(({ name: of, text }) => [of, text]));
    const heading = await page.locator(".figures caption").boundingBox();
    const first = await page.locator("#figures tr").first().boundingBox();
    assert.ok(heading.y + heading.height <= first.y + 1, "the heading stands above the numbers");
    assert.ok(first.height >= 16 && first.width > 120);
    await press(page, "First step");
    await until(page, (it) => it.step === 0);
    await press(page, "Step");
    await press(page, "Step back");
    await until(page, (it) => it.step === 0);
  });
}

test("without WebGL 2 a lesson plays by itself, and is stepped to its end", async (t) => {
  const page = await load(t, "?lesson=sphere-iterative&step=14", { init: no_webgl });
  const { step, asked } = await state(page);
  assert.equal(asked, null);
  await press(page, "Play");
  await until(page, (now, from) => now.step >= from + 2 || now.asked, step);
  for (let now = await state(page); now.step < now.steps || now.asked || now.outcome; ) {
    if (now.asked) await page.getByRole("button", { name: "Skip" }).click();
    else await press(page, "Next mark");
    now = await moved(page, now);
  }
  const { tally } = await state(page);
  assert.ok(tally.skipped > 0 && tally.open > 0, "those before step 14 were passed, not asked");
});

test("what is for screen readers is unseen where there is a stage", async (t) => {
  const page = await load(t, "?lesson=sphere-ritter&step=0");
  const box = await page.locator(".figures").boundingBox();
  assert.ok(box.width <= 1 && box.height <= 1);
  // A caption is not clipped with its table in every engine: what hides it is a block around both.
  const bare = await page.evaluate(() => [...document.querySelectorAll("table.unseen, caption.unseen")].length);
  assert.equal(bare, 0);
});
