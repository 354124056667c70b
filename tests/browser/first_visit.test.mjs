// A newcomer's first lesson: three invitations on its stage, one at a time, each gone once followed and never shown
// again. And the lesson shown to others: presented, and as a figure in another page.
import { after, before, test } from "node:test";
import { assert, drag, handles, kFirst, lessons, load, ready, start, state, still, stop, until } from "./support.mjs";

before(start);
after(stop);

const invitation = async (page) => {
  await page.waitForTimeout(400);
  const box = page.locator(".invitation");
  return (await box.isVisible()) ? box.textContent() : null;
};

test("three invitations, one at a time, each followed by a real hand", async (t) => {
  const page = await load(t, "", { newcomer: true, reducedMotion: "reduce" });
  await page.locator("#start").click();
  await ready(page);
  const { previewing, step } = await state(page);
  assert.deepEqual([previewing, step], [false, 0]); // not "step 21 of 21, Done"
  const [, name] = /^Drag (P\d+)$/.exec(await invitation(page));
  assert.ok((await handles(page)).some(({ id }) => id === name));
  const box = await page.locator(".invitation").boundingBox();
  const point = (await handles(page)).find(({ id }) => id === name);
  assert.ok(
    Math.hypot(box.x + box.width / 2 - point.x, box.y + box.height / 2 - point.y) < 90,
    "it stands beside its point",
  );
  await drag(page, name, -30, 10);
  assert.equal(await invitation(page), "Now press Step");
  await page.reload();
  await ready(page);
  assert.equal(await invitation(page), "Now press Step"); // the first one is not shown again
  await page.keyboard.press("ArrowRight");
  await until(page, (now) => now.step === 1);
  for (let i = 0, now = await state(page); i < 8 && (now.asked || now.outcome); ++i, now = await state(page))
    await page.keyboard.press(now.asked ? "s" : "Enter");
  await page.locator(".invitation", { hasText: /^Press Play/ }).waitFor();
  await page.keyboard.press("Space");
  await page.waitForTimeout(300);
  assert.equal(await invitation(page), null);
  await page.evaluate(() => localStorage.removeItem("snug-theme"));
  await page.goto(new URL(`${kFirst}&step=0`, page.url()).href);
  await ready(page);
  assert.equal(await invitation(page), null);
});

test("no other lesson invites, nor a figure in another page", async (t) => {
  const page = await load(t, "?lesson=sphere-welzl&step=0", { newcomer: true });
  assert.equal(await invitation(page), null);
  const figure = await load(t, `${kFirst}&step=0&embed=1`, { newcomer: true });
  assert.equal(await invitation(figure), null);
});

test("presented, keys and buttons lead from lesson to lesson, and the text shows on demand", async (t) => {
  const page = await load(t, `${kFirst}&step=0`);
  const all = await lessons();
  await page.locator("#present").click();
  await page.waitForFunction(() => document.fullscreenElement === document.documentElement);
  assert.equal(await page.locator("#prose").isVisible(), false);
  await page.keyboard.press("t");
  assert.ok(await page.locator("#prose").isVisible());
  await page.keyboard.press("t");
  assert.equal(await page.locator("#prose").isVisible(), false);
  await page.keyboard.press("n");
  await until(page, (now, id) => now.lesson === id, all[1].id);
  await page.getByRole("button", { name: "Next lesson" }).click();
  await until(page, (now, id) => now.lesson === id, all[2].id);
  await page.keyboard.press("p");
  await until(page, (now, id) => now.lesson === id, all[1].id);
  assert.ok(await page.evaluate(() => document.documentElement.classList.contains("presenting")));
  await page.getByRole("button", { name: "Leave presentation" }).click();
  await page.waitForFunction(() => document.fullscreenElement === null);
  assert.equal(await page.evaluate(() => document.documentElement.classList.contains("presenting")), false);
  assert.equal(await page.getByRole("button", { name: "Next lesson" }).isVisible(), false);
  await page.keyboard.press("n");
  await page.waitForTimeout(300);
  assert.equal((await state(page)).lesson, all[1].id); // a key of the presentation alone
});

test("presented, the title is seen, and the text opens at the section at hand, the question over it", async (t) => {
  const page = await load(t, `${kFirst}&step=1`, { reducedMotion: "reduce" });
  await page.locator("#present").click();
  const over = (part) => page.evaluate((id) => {
    const node = document.querySelector(id), { left, top } = node.getBoundingClientRect();
    return node.contains(document.elementFromPoint(left + 5, top + 10));
  }, part);
  assert.ok(await over("#title"), "nothing lies over the title");
  await page.keyboard.press("t");
  await still(page);
  assert.ok(await over("#prose [aria-current] h2"), "the section at hand is in view");
  assert.equal(await page.locator("#numbers").isVisible(), false);
  const [card, text] = await Promise.all(["#ask", "#read"].map((part) => page.locator(part).boundingBox()));
  assert.ok(text.y >= card.y + card.height - 1 && card.height + text.height > 700, "under the question");
});

test("a figure's summary leads nowhere else", async (t) => {
  const page = await load(t, "?lesson=frustum-2d&step=0&embed=1", {
    viewport: { width: 400, height: 300 },
    reducedMotion: "reduce",
  });
  for (let now = await state(page); !now.summary; now = await state(page)) {
    await page.keyboard.press(now.asked ? "s" : now.outcome ? "Enter" : "End");
    await page.waitForTimeout(50);
  }
  await page.getByRole("button", { name: "Predict again" }).waitFor();
  assert.equal(await page.locator("a:visible").count(), 1);
  assert.equal(await page.getByRole("button", { name: "To the task" }).count(), 0);
});

test("a figure of 400 by 300 has stage, sentence, step and play, and one link to the whole", async (t) => {
  const page = await load(t, "?lesson=sphere-welzl&step=12&embed=1", { viewport: { width: 400, height: 300 } });
  assert.equal(
    await page.evaluate(
      () => document.documentElement.scrollHeight > innerHeight || document.documentElement.scrollWidth > innerWidth,
    ),
    false,
  );
  for (const part of ["#stage", "#caption", "#timeline"]) {
    const { y, height } = await page.locator(part).boundingBox();
    assert.ok(height > 30 && y >= 0 && y + height <= 300, part);
  }
  assert.equal(await page.locator("#bar, #read, #numbers").filter({ visible: true }).count(), 0);
  const links = await page.locator("a:visible").all();
  assert.equal(links.length, 1);
  const { step } = await state(page);
  await page.keyboard.press("ArrowLeft");
  await until(page, (now, before) => now.step === before - 1, step);
  await page.waitForTimeout(500);
  const whole = new URL(await links[0].getAttribute("href"), page.url());
  assert.deepEqual(
    [whole.searchParams.get("lesson"), whole.searchParams.get("step"), whole.searchParams.get("embed")],
    ["sphere-welzl", String(step - 1), null],
  );
  // A figure keeps nothing of its own.
  assert.equal(await page.evaluate(() => JSON.parse(localStorage.getItem("snug-course")).last), null);
});

test("a question in a figure of 400x300 leaves in sight what it asks about, and the way to answer it", async (t) => {
  for (const lesson of ["obb-pca", "sphere-ritter", "swept-overlap"]) {
    const page = await load(t, `?lesson=${lesson}&step=0&embed=1`, { viewport: { width: 400, height: 300 } });
    await page.keyboard.press("End");
    await until(page, (now) => now.asked);
    await still(page);
    const [stage, card, give] = await page.evaluate(() => ["#stage", "#ask", ".predict .commit .primary"].map((at) => {
      const { top, bottom } = document.querySelector(at).getBoundingClientRect();
      return { top, bottom };
    }));
    assert.ok(card.top - stage.top >= 120, `${lesson}: ${card.top - stage.top} pixels of the stage`);
    assert.ok(
      give.bottom <= 300 && give.top >= card.top,
      `${lesson}: Answer stands from ${give.top} to ${give.bottom}`,
    );
  }
});
