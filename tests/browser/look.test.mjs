// The page at every size, theme and text size: nothing cut off, everything named, every pair of colours readable.
import { after, before, test } from "node:test";
import {
  assert, cut_off, find_cut_off, handles, kFirst, kinds, kPhone, lessons, load, low_words, start, state, still, stop,
  until, visit,
} from "./support.mjs";

before(start);
after(stop);

const kSizes = [[1280, 800], [1920, 1080], [1024, 768], [768, 1024], [640, 400], [390, 844], [844, 390], [320, 568]];
const kThemes = ["light", "dark", "contrast", "projector"];
const with_theme = (theme) => ({ init: `localStorage.setItem("snug-theme", "${theme}")` });

/** What sticks out of the page sideways, or of a part that hides what overflows. */
const sticking_out = (page) =>
  page.evaluate(() => {
    const wide = document.documentElement.clientWidth;
    const shown = [...document.querySelectorAll("body *")].filter(
      (node) => node.checkVisibility() && !node.closest(".unseen, .skip, .player, svg, [hidden]"),
    );
    const out = shown.filter((node) => {
      const { left, right, width } = node.getBoundingClientRect();
      return width > 1 && (left < -1 || right > wide + 1);
    });
    if (document.documentElement.scrollWidth > wide) out.push(document.documentElement);
    return out.map((node) => `${node.tagName}#${node.id}.${node.className}`);
  });

/** Pairs of the page's parts that lie over each other. */
const overlaps = (page) =>
  page.evaluate(() => {
    const parts = ["bar", "stage", "caption", "timeline", "tabs", "ask", "read", "code", "numbers"]
      .map((id) => document.getElementById(id))
      .filter((node) => node.checkVisibility())
      .map((node) => ({ id: node.id, box: node.getBoundingClientRect() }))
      .filter(({ box }) => box.width > 0 && box.height > 0);
    const pairs = [];
    for (const { id: a, box: one } of parts)
      for (const { id: b, box: other } of parts)
        if (
          a < b &&
          !(["ask", "caption"].includes(a) && b === "stage") &&
          one.left < other.right - 1 &&
          other.left < one.right - 1 &&
          one.top < other.bottom - 1 &&
          other.top < one.bottom - 1
        )
          pairs.push(`${a} and ${b}`);
    return pairs;
  });

for (const [width, height] of kSizes) {
  test(`at ${width}x${height} nothing sticks out or overlaps, on any tab`, async (t) => {
    const page = await visit(t, `${kFirst}&step=0`, { viewport: { width, height }, hasTouch: width < 900 });
    await still(page);
    const tabs = await page.getByRole("tab").all();
    for (const tab of tabs.length > 0 ? tabs : [null]) {
      await tab?.click();
      await still(page);
      assert.deepEqual(await sticking_out(page), []);
      assert.deepEqual(await overlaps(page), []);
    }
    const stage = await page.locator("#stage").boundingBox();
    assert.ok(stage.width >= 250 && stage.height >= 130, `the stage is ${stage.width} x ${stage.height}`);
  });
}

/** Goes through what a lesson asks in its own run, and tells of each card its share of the stage and what is cut off
 *  meanwhile, beside its outcome as well. In the page, so that no message goes to and fro for each step. */
const cards = (page) =>
  page.evaluate(async (cut_off) => {
    const cut_off_now = new Function(`return (${cut_off})()`);
    const drawn = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    const press = (key) =>
      document.getElementById("canvas").dispatchEvent(new KeyboardEvent("keydown", { key, code: key, bubbles: true }));
    const area = (id) => {
      const { width, height } = document.getElementById(id).getBoundingClientRect();
      return width * height;
    };
    const shares = {}, faults = [];
    for (;;) {
      await drawn();
      const { asked, outcome, step, steps } = window.snug.state();
      if (asked) shares[asked.id] = area("ask") / area("stage");
      if (asked || outcome) faults.push(...cut_off_now().map((fault) => `step ${step}: ${fault}`));
      if (!asked && !outcome && step >= steps) return { shares, faults };
      press(asked ? "s" : outcome ? "Enter" : "PageDown");
    }
  }, String(find_cut_off));

test("on a laptop a question's card is whole and covers at most a third of the stage, whatever is asked", async (t) => {
  let asked = 0;
  const page = await visit(t);
  for (const { id } of await lessons()) {
    await page.evaluate((to) => { // as Back and Forward lead there: the program stays
      history.pushState(null, "", to);
      dispatchEvent(new PopStateEvent("popstate"));
    }, `?lesson=${id}&step=0`);
    await until(page, (now, id) => now.lesson === id && now.step === 0, id);
    const { shares, faults } = await cards(page);
    assert.deepEqual(faults, [], id);
    for (const [question, share] of Object.entries(shares)) {
      assert.ok(share <= 1 / 3, `${id}, ${question}: ${share.toFixed(3)}`);
      ++asked;
    }
  }
  assert.ok(asked > 120, `${asked} questions`);
});

test("on a phone on its side the stage has what the timeline leaves of its column, situations beside", async (t) => {
  for (const lesson of ["bvh-build&step=4", "which-volume&step=0", "frustum-sphere&step=1"]) {
    const page = await visit(t, `?lesson=${lesson}`, { ...kPhone, viewport: { width: 844, height: 390 } });
    while ((await state(page)).asked) {
      await page.keyboard.press("s");
      await still(page);
    }
    await still(page);
    assert.deepEqual(await sticking_out(page), []);
    assert.deepEqual(await overlaps(page), []);
    const [stage, controls] = await Promise.all(
      ["#stage", "#controls"].map((name) => page.locator(name).boundingBox()),
    );
    assert.ok(stage.height >= 190, `${lesson}: the stage is ${stage.height} high`);
    assert.ok(
      controls.x >= stage.x + stage.width - 1 && controls.y + controls.height <= 300,
      `${lesson}: ${JSON.stringify(controls)}`,
    );
  }
});

test("the tools of the charts stand at the foot of the column, and on a phone beneath the stage", async (t) => {
  for (const size of [{ viewport: { width: 1280, height: 800 } }, kPhone]) {
    const page = await visit(t, "?lesson=cost-chart&step=0", size);
    assert.deepEqual(await sticking_out(page), []);
    const [tools, part, stage] = await Promise.all(
      [".cover", size === kPhone ? "#work" : "#column", "#stage"].map((name) => page.locator(name).boundingBox()),
    );
    assert.ok(tools.x >= part.x && tools.x + tools.width <= part.x + part.width + 1, JSON.stringify([tools, part]));
    assert.ok(
      size === kPhone ? tools.y >= stage.y + stage.height : tools.y + tools.height > 790,
      JSON.stringify([tools, stage]),
    );
  }
});

test("at the largest text nothing sticks out, on desk and phone", async (t) => {
  for (const options of [{}, kPhone]) {
    const page = await load(t, `${kFirst}&step=0`, { ...options, init: 'localStorage.setItem("snug-text", "1.5")' });
    assert.deepEqual(await sticking_out(page), []);
    assert.deepEqual(await overlaps(page), []);
  }
});

test("projected at the largest text, the stage keeps its room and the sentence does not cover it", async (t) => {
  const page = await load(t, `${kFirst}&step=1`, {
    init: 'localStorage.setItem("snug-text", "1.5"); localStorage.setItem("snug-theme", "projector")',
  });
  const stage = await page.locator("#stage").boundingBox();
  assert.ok(stage.width >= 600 && stage.height >= 400, `the stage is ${stage.width} x ${stage.height}`);
  assert.ok((await page.locator("#caption").boundingBox()).y >= stage.y + stage.height - 1);
});

for (const [width, height] of [[1024, 768], [1280, 800]]) {
  test(`presented at ${width}x${height} the question, the lit line and the stage are in sight`, async (t) => {
    const page = await visit(t, "?lesson=sphere-ritter&step=1", { viewport: { width, height } });
    await page.getByRole("button", { name: "Present" }).click();
    await still(page);
    const stage = await page.locator("#stage").boundingBox();
    assert.ok(stage.width >= 550, `the stage is ${stage.width} wide`);
    assert.deepEqual(await sticking_out(page), []);
    assert.deepEqual(await overlaps(page), []);
    assert.ok((await state(page)).asked);
    await page.getByText("Page Down twice skips").waitFor();
    for (const part of [page.locator(".predict"), page.locator(".lines [aria-current]")]) {
      const box = await part.boundingBox();
      assert.ok(box.y >= 0 && box.y + box.height <= height, `${box.y} + ${box.height}`);
    }
    await page.getByRole("button", { name: "Leave presentation" }).click();
    assert.ok(await page.locator("#bar").isVisible());
  });
}

for (const [width, height] of [[1280, 720], [1920, 1080]])
  test(`presented at ${width}x${height} no word is lower than a fortieth of it, nothing sticks out or overlaps`,
    async (t) => {
      const faults = [];
      for (const { id } of await kinds()) {
        const page = await visit(t, `?lesson=${id}&step=1`, { viewport: { width, height } });
        await page.keyboard.press("F5");
        await page.waitForFunction(() => document.querySelector(".presenting"));
        for (const key of ["", "t"]) {
          if (key) await page.keyboard.press(key); // the lesson's text
          await still(page);
          const own = [await low_words(page), await sticking_out(page), await overlaps(page)].flat();
          const stage = await page.locator("#stage").boundingBox();
          if (!key && stage.height < height / 2) own.push(`the stage is ${stage.height} high`);
          faults.push(...own.map((fault) => `${id} ${key}: ${fault}`));
        }
        await page.keyboard.press("F5");
      }
      assert.deepEqual(faults, []);
    });

test("presented, the title stands above all, and no name in a selector is cut off", async (t) => {
  const page = await visit(t, "?lesson=obb-axes&step=5");
  await page.getByRole("button", { name: "Present" }).click();
  await still(page);
  assert.deepEqual(await cut_off(page), []);
  const title = await page.locator("#title").boundingBox();
  assert.ok(title.y < 60, `${title.y} pixels above it`);
  await page.keyboard.press("Escape");
});

test("where the numbers fill their column, the code is a tab beside them; elsewhere it is under them", async (t) => {
  const page = await visit(t, "?lesson=obb-axes&step=1");
  await page.locator("#side-tabs").getByRole("tab", { name: "Numbers", selected: true }).waitFor();
  assert.equal(await page.locator("#code").isVisible(), false);
  assert.ok((await page.locator("#numbers").boundingBox()).height > 690, "all fifteen axes have room");
  await page.locator("#side-tabs").getByRole("tab", { name: "Numbers" }).focus();
  await page.keyboard.press("ArrowRight");
  assert.ok(await page.locator("#code").isVisible());
  assert.equal((await state(page)).step, 1);
  assert.deepEqual(await overlaps(page), []);
  const other = await visit(t, "?lesson=sphere-welzl&step=21");
  assert.equal(await other.locator("#side-tabs").isVisible(), false);
  const [numbers, code] = [await other.locator("#numbers").boundingBox(), await other.locator("#code").boundingBox()];
  assert.ok(numbers.height > 440 && code.y >= numbers.y + numbers.height - 1, JSON.stringify([numbers, code]));
});

test("the lit line is in sight at every step", async (t) => {
  const page = await visit(t, "?lesson=sphere-iterative&step=1");
  const seen = new Set();
  for (let i = 0; i < 40 && seen.size < 5; ++i) {
    const now = await state(page);
    seen.add(now.line);
    const hidden = await page.evaluate(() => {
      const [line, box] = [document.querySelector(".lines [aria-current]"), document.getElementById("code")].map(
        (node) => node?.getBoundingClientRect(),
      );
      return line && (line.top < box.top || line.bottom > box.bottom);
    });
    assert.ok(!hidden, `line ${now.line}`);
    if (now.asked) await page.getByRole("button", { name: "Skip" }).click();
    else await page.keyboard.press("ArrowRight");
    await still(page);
  }
  assert.ok(seen.size >= 3);
});

test("the keyboard scrolls the text once it is there, and steps elsewhere", async (t) => {
  const page = await visit(t, "?lesson=sphere-ritter&step=0");
  await page.locator("#read").focus();
  await page.keyboard.press("PageDown");
  await page.waitForFunction(() => document.getElementById("read").scrollTop > 20);
  assert.equal((await state(page)).step, 0);
  await page.keyboard.press("ArrowRight");
  await until(page, (now) => now.step === 1);
});

test("no ring stands around the stage after a pointer", async (t) => {
  const page = await visit(t, "?lesson=sphere-ritter&step=0");
  const ring = () =>
    page.evaluate(() => getComputedStyle(document.getElementById("stage"), "::after").borderTopWidth === "2px");
  await page.locator("#canvas").focus();
  await page.keyboard.press("Tab");
  await page.keyboard.press("Shift+Tab");
  assert.equal(await ring(), true);
  const [handle] = await handles(page);
  await page.mouse.click(handle.x + 30, handle.y + 30);
  assert.equal(await ring(), false);
});

const luminance = (hex) =>
  [1, 3, 5]
    .map((i) => parseInt(hex.slice(i, i + 2), 16) / 255)
    .map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4))
    .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
const contrast = (a, b) =>
  (Math.max(luminance(a), luminance(b)) + 0.05) / (Math.min(luminance(a), luminance(b)) + 0.05);
const kWords = ["ink", "muted", "current", "support", "right", "wrong"];
const kGrounds = ["panel", "raised", "ground"];

test("in each theme words reach 4.5:1 and edges 3:1", async (t) => {
  const page = await load(t, kFirst, with_theme("contrast"));
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), "contrast", "it is remembered");
  const names = [...kWords, ...kGrounds, "lit", "on-current", "edge"];
  const pairs = [
    ...kWords.flatMap((word) => kGrounds.map((ground) => ({ a: word, b: ground, least: 4.5 }))),
    { a: "ink", b: "lit", least: 4.5 },
    { a: "on-current", b: "current", least: 4.5 },
    { a: "edge", b: "panel", least: 3 },
  ];
  for (const theme of kThemes) {
    const colours = await page.evaluate(
      ([name, all]) => {
        document.documentElement.dataset.theme = name;
        return Object.fromEntries(
          all.map((each) => [each, getComputedStyle(document.documentElement).getPropertyValue(`--${each}`).trim()]),
        );
      },
      [theme, names],
    );
    for (const { a, b, least } of pairs)
      assert.ok(
        contrast(colours[a], colours[b]) >= least,
        `${theme}: ${a} on ${b}: ${contrast(colours[a], colours[b]).toFixed(2)}`,
      );
  }
});

test("the first theme is the one that the system asks for", async (t) => {
  const theme = (page) => page.evaluate(() => document.documentElement.dataset.theme);
  assert.equal(await theme(await load(t, kFirst, { colorScheme: "dark" })), "dark");
  assert.equal(await theme(await load(t, kFirst, { colorScheme: "light" })), "light");
  assert.equal(await theme(await load(t, kFirst, { contrast: "more" })), "contrast");
});

test("the theme button goes round, and canvas and page change together", async (t) => {
  const page = await load(t);
  const seen = [];
  while (seen.length < kThemes.length) {
    seen.push(await page.locator("#theme-name").textContent());
    const { framesDrawn } = await state(page);
    await page.locator("#theme").click();
    await page.waitForFunction((drawn) => window.snug.state().framesDrawn > drawn, framesDrawn);
  }
  assert.deepEqual(seen, ["Light", "Dark", "High contrast", "Projector"]);
});

test("presenting hides the chrome and Escape brings it back", async (t) => {
  const page = await visit(t);
  await page.getByRole("button", { name: "Present" }).click();
  assert.equal(await page.locator("#bar").isVisible(), false);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), "projector");
  assert.deepEqual(await overlaps(page), []);
  await page.keyboard.press("Escape");
  assert.ok(await page.locator("#bar").isVisible());
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), "light");
});

test("everything that can be pressed or filled in has a name, and there is one main heading", async (t) => {
  const page = await visit(t, `${kFirst}&step=0`);
  for (let i = 0; i < 4 && !(await state(page)).asked; ++i) await page.keyboard.press("PageDown");
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll("button, a[href], input:not([type=file]), select, canvas")]
      .filter((node) => {
        const { labels } = /** @type {HTMLInputElement} */ (node);
        const labelled = [...(labels ?? [])].map((each) => each.textContent.trim()).join("");
        return !(node.getAttribute("aria-label") || node.textContent.trim() || labelled);
      })
      .map((node) => node.outerHTML),
  );
  assert.deepEqual(nameless, []);
  assert.equal(await page.locator("h1:visible").count(), 1);
  assert.equal((await page.locator('[role="status"][aria-live="polite"]').count()) >= 1, true);
});

test("Tab reaches everything, and shows where it is", async (t) => {
  const page = await load(t);
  const reached = new Set();
  await page.evaluate(() => document.getElementById("tab-points").click()); // where the focus is stays
  for (let i = 0; i < 80; ++i) {
    await page.keyboard.press("Tab");
    const here = await page.evaluate(() => {
      const node = document.activeElement;
      const style = getComputedStyle(node);
      const ring = style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 2;
      const stage = getComputedStyle(document.getElementById("stage"), "::after").borderTopWidth === "2px";
      return {
        name: node.id || node.getAttribute("aria-label") || node.textContent,
        visible: ring || (node.id === "canvas" && stage),
        body: node === document.body,
      };
    });
    if (here.body) break;
    assert.ok(here.visible, `focus shows on ${here.name}`);
    reached.add(here.name);
  }
  for (const name of ["picker", "share", "theme", "canvas", "algorithm", "beside", "Step", "Play", "Add", "Open file…"])
    assert.ok(reached.has(name), `${name} is reached`);
});

test("the step's sentence is HTML, and the same as the state's", async (t) => {
  const page = await visit(t, `?lesson=${(await lessons())[0].id}&step=1`);
  const { caption } = await state(page);
  assert.ok(caption.length > 5);
  assert.equal(await page.locator("#caption").textContent(), caption);
  await page.keyboard.press("Home");
  const start_of_it = await until(page, (now) => now.step === 0);
  assert.equal(await page.locator("#caption").textContent(), start_of_it.caption);
});

test("in the step's sentence and in the pseudocode r_A has its subscript, as in the lesson's text", async (t) => {
  const page = await visit(t, "?lesson=obb-sat&step=2");
  const { caption } = await state(page);
  assert.match(caption, /r_A\u00a0\+\u00a0r_B/);
  assert.deepEqual(await page.locator("#caption sub").allTextContents(), ["A", "B"]);
  assert.deepEqual(await page.locator(".lines [aria-current] sub").allTextContents(), ["A", "B"]);
  assert.equal(await page.locator("#caption").textContent(), caption.replace(/r_(?=[AB])/g, "r"));
});

test("in the pseudocode p^T has its superscript", async (t) => {
  const page = await visit(t, "?lesson=covariance&step=2");
  assert.deepEqual(await page.locator(".lines sup").allTextContents(), ["T"]);
});

test("an index stands in the line of its letter, not in one of its own", async (t) => {
  const page = await visit(t, "?lesson=obb-axes&step=6");
  assert.ok(await page.locator("#caption").isVisible());
  const lines = await page.locator("#caption").evaluate((caption) => {
    const range = document.createRange();
    range.selectNodeContents(caption);
    const middles = [...range.getClientRects()].map(({ y, height }) => y + height / 2).sort((a, b) => a - b);
    return 1 + middles.filter((y, i) => i > 0 && y - middles[i - 1] > 10).length;
  });
  assert.ok(lines <= 2, `the sentence takes ${lines} lines`);
});
