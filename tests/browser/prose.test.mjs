// Prose speaks to the stage: its links do what they say, its marks light handles and handles their words, its sections
// follow the step, and its formulas are MathML.
import { after, before, test } from "node:test";
import {
  add_lesson, answer, assert, drag, go_on, handles, kPhone, kWide, lessons, load, start, state, still, stop, until,
  visit,
} from "./support.mjs";

before(start);
after(stop);

const words = (page, name) => page.locator("#prose").getByRole("button", { name, exact: true });
/** The heading of the section that is marked as the step's; null for none. */
const current = (page) => page.evaluate(() => document.querySelector("#prose [aria-current] h2")?.textContent ?? null);
/** Whether the heading of the marked section is in view. */
const in_view = (page) =>
  page.evaluate(() => {
    const [box, head] = ["#read", "#prose [aria-current] h2"].map((what) =>
      document.querySelector(what).getBoundingClientRect(),
    );
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

test("a finger that holds a mark lights it, until it goes; a tap leaves it lit and brings up the stage", async (t) => {
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
  const lights = () =>
    page.evaluate(() => [...document.querySelectorAll("#prose .lit")].map((node) => node.textContent));
  const places = await handles(page);
  const held = places.find(({ id }) => lit.handles.includes(id));
  const free = places.find(
    ({ id, x, y }) =>
      !lit.handles.includes(id) &&
      places.every((other) => other.id === id || Math.hypot(other.x - x, other.y - y) > 30),
  );
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
  await page.waitForFunction(
    () => document.getElementById("numbers").getBoundingClientRect().top < innerHeight / 2 + 1,
  );
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
});

test("every lesson's formulas are typeset, and none is wider than its column, on any screen", async (t) => {
  for (const { id } of await lessons()) {
    const page = await visit(t, `?lesson=${id}`);
    assert.equal(await page.locator("#prose .formula").count(), 0, `${id}: a formula was not typeset`);
    for (const { viewport } of [kWide, kPhone]) {
      await page.setViewportSize(viewport);
      await page.waitForFunction(
        (phone) => (document.documentElement.dataset.layout === "phone") === phone,
        viewport === kPhone.viewport,
      );
      const wide = await page.evaluate(() =>
        [...document.querySelectorAll("#prose math")]
          .filter((math) => {
            const [own, column] = [
              math.getBoundingClientRect(),
              document.getElementById("prose").getBoundingClientRect(),
            ];
            return own.width > 0 && own.right > column.right + 1;
          })
          .map((math) => math.getAttribute("aria-label")),
      );
      assert.deepEqual(wide, [], `${id} at ${JSON.stringify(viewport)}`);
    }
  }
});

const kWords = `version = 2
title = "Words"
summary = "Every kind of words."
minutes = 1
algorithms = ["ritter", "welzl"]

[points]
list = [[-2, 0], [2, 0], [0, 1], [0, -1], [0, 2.5], [0.5, 0.2]]

[[section]]
title = "Words"
text = """
An *emphasised*, a **strong** and a ***doubly marked*** word, \`code * {\`, x_{min} and n^{5}. Now {radius}.

- one
- *two*

1. first
2. second

| circle | radius |
|---|---:|
| Ritter | {count radius ritter} |
| smallest | {radius welzl} |
"""

[[question]]
id = "pair"
algorithm = "ritter"
before = "pair_chosen"
asks = "axis"
prompt = "Which *pair* is d_{max}, with $d^2$? In the end {radius welzl}."
because = "It is \`farther\` apart: {radius ritter}."

[[task]]
prompt = "Make it *fail*: {excess ritter}."
algorithm = "ritter"
points = 4
hint = "Think of x_{max}."
model = [[-2, 0], [2, 0], [0, -1], [0, 2.5]]

[[task.require]]
figure = "excess"
at_least = 5
`;

test("words, lists and tables are HTML elements without a style of their own", async (t) => {
  await add_lesson("words", kWords);
  const page = await load(t, "?lesson=words&step=9999");
  const texts = (what) => page.locator(`#prose ${what}`).allTextContents();
  assert.deepEqual(await texts("em"), ["emphasised", "doubly marked", "two"]);
  assert.deepEqual(await texts("strong"), ["strong", "doubly marked"]);
  assert.deepEqual(await texts("code"), ["code * {"]);
  assert.deepEqual([await texts("sub"), await texts("sup")], [["min"], ["5"]]);
  assert.deepEqual([await texts("ul > li"), await texts("ol > li")], [["one", "two"], ["first", "second"]]);
  assert.deepEqual(await texts("thead th[scope=col]"), ["circle", "radius"]);
  assert.deepEqual(await texts("tbody tr:last-child td"), ["smallest", "2.050\u00a0units"]);
  assert.equal(
    await page
      .locator("#prose td.right")
      .first()
      .evaluate((cell) => getComputedStyle(cell).textAlign),
    "right",
  );
  assert.equal(await page.locator("#prose [style], #task [style]").count(), 0);
  assert.deepEqual(await page.locator("#task em, #task sub").allTextContents(), ["fail", "max"]);
  for (const size of [kWide, kPhone]) {
    await page.setViewportSize(size.viewport);
    assert.ok(
      await page
        .locator("#prose table")
        .evaluate(
          (table) =>
            table.getBoundingClientRect().right <= document.getElementById("prose").getBoundingClientRect().right + 1,
        ),
    );
  }
});

test("figures of the run follow a drag in place, and are not read out at each change", async (t) => {
  await add_lesson("words", kWords);
  const page = await load(t, "?lesson=words&step=9999");
  const shown = () => page.locator("#prose .figure").allTextContents();
  const due = ({ figures, readout, rivals }) =>
    [
      figures.find(({ key }) => key === "radius").text,
      readout.radius.toFixed(3),
      `${rivals[1].size.toFixed(3)} units`,
    ].map((text) => text.replaceAll(" ", "\u00a0"));
  const first = await shown();
  assert.deepEqual(first, due(await state(page)));
  const [node] = await page.locator("#prose .figure").elementHandles();
  assert.equal(await node.getAttribute("aria-live"), "off");
  await drag(page, "P1", 60, 40);
  const dragged = await shown();
  assert.notDeepEqual(dragged, first);
  assert.deepEqual(dragged, due(await state(page)));
  assert.ok(await node.evaluate((own) => own.isConnected), "it is the same element");
  assert.equal(
    await page.locator("#task .figure").textContent(),
    (await state(page)).figures.find(({ key }) => key === "excess").text.replace(" ", "\u00a0"),
  );
});

test("a figure that would give an answer away says that it is hidden, in the prompt as well", async (t) => {
  await add_lesson("words", kWords);
  const page = await load(t, "?lesson=words&step=1");
  const { asked } = await until(page, (now) => now.asked);
  assert.equal(asked.prompt, "Which pair is dmax, with d²? In the end ….");
  const prompt = page.locator("#ask .prompt");
  assert.deepEqual(await prompt.locator("em, sub").allTextContents(), ["pair", "max"]);
  const hidden = prompt.locator(".figure");
  assert.equal(await hidden.locator("[aria-hidden]").textContent(), "…");
  assert.equal(await hidden.locator(".unseen").textContent(), "hidden until you answer");
  assert.match(await page.locator("#prose table").textContent(), /hidden until you answer.*hidden until you answer/);
  const { outcome } = await answer(page, 0);
  assert.equal(outcome.because, "It is farther apart: 2.250\u00a0units.");
  assert.deepEqual(
    await page
      .locator("#ask code, #ask .figure")
      .allTextContents()
      .then((all) => all.slice(-2)),
    ["farther", "2.250\u00a0units"],
  );
  await go_on(page);
  assert.doesNotMatch(await page.locator("#prose table").textContent(), /hidden/);
});

test("what ends a phrase stays on the line of the link before it", async (t) => {
  for (const width of [1280, 1920]) {
    const page = await visit(t, "?lesson=sphere-ritter", { viewport: { width, height: 800 } });
    const alone = await page.evaluate(() => {
      const walker = document.createTreeWalker(document.getElementById("prose"), NodeFilter.SHOW_TEXT);
      const found = [];
      for (let text = walker.nextNode(); text; text = walker.nextNode()) {
        const link = text.previousSibling;
        if (!/^[.,:;?!)]/.test(text.nodeValue) || !(link instanceof Element)) continue;
        if (!link.matches("a, button, :has(> a), :has(> button)")) continue;
        const range = document.createRange();
        (range.setStart(text, 0), range.setEnd(text, 1));
        found.push({
          words: link.textContent,
          below: range.getBoundingClientRect().top > link.getBoundingClientRect().bottom - 4,
        });
      }
      return found;
    });
    assert.ok(alone.length > 3);
    assert.deepEqual(alone.filter(({ below }) => below), [], `${width} pixels`);
  }
});

test("a number and its per cent sign stay on one line of the step's sentence", async (t) => {
  const page = await visit(t, "?lesson=scene-updates&step=119");
  const lines = await page.locator("#caption").evaluate((caption) => {
    const range = document.createRange(), walker = document.createTreeWalker(caption, NodeFilter.SHOW_TEXT);
    for (let text = walker.nextNode(); text; text = walker.nextNode()) {
      const at = text.nodeValue.indexOf(" %");
      if (at < 0) continue;
      range.setStart(text, at - 1), range.setEnd(text, at + 2);
      return new Set([...range.getClientRects()].map(({ top }) => Math.round(top))).size;
    }
    return 0;
  });
  assert.equal(lines, 1);
});
