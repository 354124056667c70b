// Prose speaks to the stage: its links do what they say, its marks light handles and handles their words, its sections
// follow the step, and its formulas are MathML.
import { after, before, test } from "node:test";
import { assert, handles, kPhone, kWide, lessons, load, start, state, still, stop, until, visit } from "./support.mjs";

before(start);
after(stop);

const words = (page, name) => page.locator("#prose").getByRole("button", { name, exact: true });
/** The heading of the section that is marked as the step's; null for none. */
const current = (page) => page.evaluate(() => document.querySelector("#prose [aria-current] h2")?.textContent ?? null);
/** Whether the heading of the marked section is in view. */
const in_view = (page) => page.evaluate(() => {
  const [box, head] = ["#read", "#prose [aria-current] h2"].map((what) => document.querySelector(what).getBoundingClientRect());
  return head.top >= box.top - 1 && head.bottom <= box.bottom + 1;
});
const kLow = { viewport: { width: 1280, height: 560 } }; // the prose is longer than its column

test("a link changes the algorithm, by mouse; the mesh, by keyboard; and goes to a step", async (t) => {
  const page = await visit(t, "?lesson=sphere-ritter&step=0");
  await words(page, "AABB centre").click();
  await until(page, (now) => now.algorithm === "aabb_center");
  await words(page, "bunny").focus();
  await page.keyboard.press("Enter");
  await until(page, (now) => now.source === "bunny");
  const other = await visit(t, "?lesson=obb-sat&step=3");
  await until(other, (now) => now.lesson === "obb-sat" && now.step === 3);
  await words(other, "Step through the test").click();
  await until(other, (now) => now.step === 1);
  // One that a question stands before shows the question.
  const phone = await visit(t, "?lesson=obb-sat&step=1", kPhone);
  await until(phone, (now) => now.asked && now.step === 1);
  await words(phone, "Step through the test").tap();
  await phone.waitForFunction(() => {
    const { top, bottom } = document.querySelector("#ask .predict").getBoundingClientRect();
    return top < innerHeight && bottom > 0;
  });
  assert.equal((await state(phone)).step, 1);
});

test("a link leads to another lesson, and is one: it can be opened elsewhere", async (t) => {
  const page = await visit(t, "?lesson=obb-axes");
  const link = page.locator("#prose").getByRole("link", { name: "in the plane" });
  assert.match(await link.getAttribute("href"), /lesson=obb-sat/);
  await link.click();
  await until(page, (now) => now.lesson === "obb-sat");
});

test("a mark lights its handles while the mouse is over it, and while it has the focus", async (t) => {
  const page = await visit(t, "?lesson=sphere-welzl&step=9999");
  const mark = words(page, "support set").first();
  assert.equal((await state(page)).lit.mark, "");
  await mark.hover();
  const { lit } = await until(page, (now) => now.lit.mark === "support");
  assert.ok(lit.handles.length >= 2, JSON.stringify(lit));
  await page.mouse.move(700, 300);
  await until(page, (now) => now.lit.mark === "");
  await mark.focus();
  await until(page, (now) => now.lit.mark === "support");
  await page.evaluate(() => document.activeElement.blur());
  await until(page, (now) => now.lit.mark === "");
});

test("a finger that holds a mark lights it, until it goes; a tap leaves it lit and brings the stage into view", async (t) => {
  const page = await visit(t, "?lesson=sphere-welzl&step=9999", kPhone);
  const mark = words(page, "support set").first();
  await mark.scrollIntoViewIfNeeded();
  const { x, y, width, height } = await mark.boundingBox();
  const touch = await page.context().newCDPSession(page);
  const finger = (type, ...places) => touch.send("Input.dispatchTouchEvent", { type, touchPoints: places });
  const on = { x: x + width / 2, y: y + height / 2 };
  await finger("touchStart", on);
  await until(page, (now) => now.lit.mark === "support");
  await page.waitForTimeout(300);
  assert.equal((await state(page)).lit.mark, "support");
  await finger("touchMove", { x: on.x, y: on.y - 80 });
  await finger("touchMove", { x: on.x, y: on.y - 120 });
  await finger("touchEnd");
  await until(page, (now) => now.lit.mark === "");
  await mark.scrollIntoViewIfNeeded();
  await mark.tap();
  await until(page, (now) => now.lit.mark === "support");
  await page.waitForFunction(() => document.getElementById("stage").getBoundingClientRect().bottom > 100);
  await page.locator("#title").evaluate(() => document.activeElement.blur());
  await until(page, (now) => now.lit.mark === "");
});

test("a handle under the pointer lights the words of its marks", async (t) => {
  const page = await visit(t, "?lesson=sphere-welzl&step=9999");
  await words(page, "support set").first().hover();
  const { lit } = await until(page, (now) => now.lit.mark === "support");
  const lights = () => page.evaluate(() => [...document.querySelectorAll("#prose .lit")].map((node) => node.textContent));
  const places = await handles(page);
  const held = places.find(({ id }) => lit.handles.includes(id));
  const free = places.find(({ id, x, y }) => !lit.handles.includes(id) && places.every((other) => other.id === id || Math.hypot(other.x - x, other.y - y) > 30));
  await page.mouse.move(held.x, held.y);
  await until(page, (now) => now.lit.words.includes("support"));
  assert.ok((await lights()).includes("support set"));
  await page.mouse.move(free.x, free.y);
  await until(page, (now) => !now.lit.words.includes("support"));
  assert.ok(!(await lights()).includes("support set"));
});

test("the section of the step comes into view and is marked, but not under the eyes of one who reads", async (t) => {
  const page = await visit(t, "?lesson=sphere-ritter&step=0", kLow);
  assert.equal(await current(page), null);
  const scrolled = () => page.evaluate(() => document.getElementById("read").scrollTop);
  await page.mouse.move(700, 200); // over the stage
  await page.waitForTimeout(100);
  await page.keyboard.press("Home");
  await page.keyboard.press("PageDown");
  await until(page, (now) => now.asked);
  await still(page);
  assert.equal(await current(page), "Ritter's two passes");
  await page.waitForFunction(() => document.getElementById("read").scrollTop > 0);
  assert.ok(await in_view(page), "the question's section is in view");
  // One who has just scrolled reads on, though the mouse is elsewhere by now.
  const scroller = await load(t, "?lesson=sphere-ritter&step=0", { ...kLow, reducedMotion: "reduce" });
  await scroller.mouse.move(150, 300);
  await scroller.mouse.wheel(0, 40);
  await scroller.waitForFunction(() => document.getElementById("read").scrollTop > 0);
  const here = await scroller.evaluate(() => document.getElementById("read").scrollTop);
  await scroller.mouse.move(700, 200);
  await scroller.keyboard.press("PageDown");
  await until(scroller, (now) => now.asked);
  await still(scroller);
  assert.equal(await scroller.evaluate(() => document.getElementById("read").scrollTop), here);
  // One who reads: the mouse rests over the prose.
  const reader = await load(t, "?lesson=sphere-ritter&step=0", { ...kLow, reducedMotion: "reduce" });
  await reader.mouse.move(150, 300);
  await reader.mouse.move(152, 302);
  await reader.keyboard.press("PageDown");
  await until(reader, (now) => now.asked);
  await still(reader);
  assert.equal(await current(reader), "Ritter's two passes");
  assert.equal(await reader.evaluate(() => document.getElementById("read").scrollTop), 0);
  assert.ok((await scrolled()) > 0);
});

test("on a phone a tab that is opened comes into view, the text at the section at hand", async (t) => {
  const page = await visit(t, "?lesson=sphere-ritter&step=1", kPhone);
  await page.evaluate(() => scrollTo(0, 0));
  const tabs = () => page.evaluate(() => document.getElementById("tabs").getBoundingClientRect());
  assert.ok((await tabs()).bottom > 500);
  await page.locator("#tab-numbers").tap();
  await page.waitForFunction(() => document.getElementById("numbers").getBoundingClientRect().top < innerHeight / 2 + 1);
  await page.locator("#tab-read").tap();
  await page.waitForFunction(() => {
    const { top } = document.querySelector("#prose [aria-current] h2").getBoundingClientRect();
    return top >= document.getElementById("tabs").getBoundingClientRect().bottom && top < innerHeight / 2;
  });
  assert.equal(await current(page), "Ritter's two passes");
});

test("a question shows the section that it names", async (t) => {
  const page = await visit(t, "?lesson=scene-broad&step=0", kLow);
  await page.keyboard.press("PageDown");
  const { asked } = await until(page, (now) => now.asked);
  assert.equal(asked.id, "boxes");
  assert.equal(await current(page), "The broad phase");
});

test("formulas are MathML with a name, and need no style of their own", async (t) => {
  const page = await visit(t, "?lesson=sphere-ritter");
  const session = await page.context().newCDPSession(page);
  const { nodes } = await session.send("Accessibility.getFullAXTree");
  const math = nodes.filter(({ role }) => /^math/i.test(role?.value ?? "")).map(({ name }) => name?.value);
  assert.ok(math.includes("r′ = (r + d)/2"), JSON.stringify(math));
  assert.equal(await page.locator("#prose math [style], #prose math[style]").count(), 0);
  for (const { id } of await lessons()) {
    await visit(t, `?lesson=${id}`);
    assert.equal(await page.locator("#prose .formula").count(), 0, `${id}: a formula was not typeset`);
  }
});

test("no formula is wider than its column, on any screen", async (t) => {
  for (const size of [kWide, kPhone])
    for (const { id } of await lessons()) {
      const page = await visit(t, `?lesson=${id}`, size);
      const wide = await page.evaluate(() => [...document.querySelectorAll("#prose math")].filter((math) => {
        const [own, column] = [math.getBoundingClientRect(), document.getElementById("prose").getBoundingClientRect()];
        return own.width > 0 && own.right > column.right + 1;
      }).map((math) => math.getAttribute("aria-label")));
      assert.deepEqual(wide, [], `${id} at ${JSON.stringify(size.viewport)}`);
    }
});
