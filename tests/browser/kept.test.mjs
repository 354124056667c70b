// What the page keeps on the device: answers, the place, the edits; over real reloads, and where storage does not work.
import { after, before, test } from "node:test";
import {
  answer, assert, drag, handles, kFirst, kPatience, load, ready, start, state, stop, until,
} from "./support.mjs";

before(start);
after(stop);

const kPlace = 500; // milliseconds: the place is kept a moment after it changes
const kept = (page) => page.evaluate(() => JSON.parse(localStorage.getItem("snug-course")));

async function reload(page, query) {
  await page.waitForTimeout(kPlace);
  if (query === undefined) await page.reload();
  else await page.goto(new URL(query, page.url()).href);
  await ready(page);
  return state(page);
}

/** Steps until something is asked. */
async function to_question(page) {
  for (let i = 0; i < 60 && !(await state(page)).asked; ++i) await page.keyboard.press("ArrowRight");
  return until(page, (now) => now.asked);
}

test("answers, step and edits survive a reload, and the course tells of them", async (t) => {
  const page = await load(t, `${kFirst}&step=0`);
  const [{ id }] = await handles(page);
  await drag(page, id, 6, 4);
  await to_question(page);
  const { outcomes, step, readout } = await answer(page, null, "keyboard");
  assert.equal(outcomes.length, 1);
  const back = await reload(page, kFirst); // the bare lesson: where one was
  assert.deepEqual(back.outcomes, outcomes);
  assert.equal(back.step, step);
  assert.equal(back.edited, true);
  assert.deepEqual(back.readout, readout);
  await page.locator("#home").click();
  assert.match(await page.locator(".progress").first().textContent(), /^1 of \d+ predictions$/);
});

test("a task that was done is so in later visits, without what solved it", async (t) => {
  const page = await load(
    t,
    "?lesson=frustum-2d&a=corners_outside&boxes=0.6,0,0.2,1.7,1,0;0.55,0,1.05,1.15,1,0&step=99",
  );
  await until(page, (now) => now.grade.done);
  await page.keyboard.press("ArrowLeft");
  const back = await reload(page, "?lesson=frustum-2d&step=0");
  assert.equal(back.grade.done, false);
  await page.locator("#task .done").waitFor();
  await page.locator("#task .done .unsolved").waitFor(); // as it stands now, it is not solved
});

test("a conversation goes on where it stood: at a second try, on the way, at an outcome, at the summary", async (t) => {
  const page = await load(t, `${kFirst}&step=2`); // with motion: the way to an outcome is played
  const field = page.getByLabel("Name", { exact: true });
  await field.fill("P0");
  await page.keyboard.press("Enter");
  await until(page, (now) => now.asked?.tried);
  let now = await reload(page);
  assert.equal(now.asked.tried?.handle, "P0");
  assert.equal(await page.locator(".says").textContent(), now.asked.says);
  await field.fill("P2");
  await page.keyboard.press("Enter");
  await until(page, (it) => it.deciding);
  now = await reload(page, kFirst);
  assert.deepEqual(
    [now.outcome?.question, now.outcome?.kind, now.outcome?.tries, now.step],
    ["first-growth", "wrong", 2, now.outcome.step],
  );
  await page.locator("#home").click();
  await page.goBack();
  now = await until(page, (it) => it.lesson);
  assert.equal(now.outcome?.question, "first-growth");
  await page.getByRole("button", { name: "Continue", exact: true }).first().click();
  for (now = await state(page); !now.summary; now = await state(page)) {
    await page.keyboard.press(now.asked ? "s" : now.outcome || now.deciding ? "Enter" : "End");
    await page.waitForTimeout(50);
    // A question that the address passed is before the step.
    if (now.step === now.steps && !now.asked && !now.outcome && now.tally.open > 0) await page.keyboard.press("Home");
  }
  now = await reload(page);
  assert.deepEqual([now.summary, now.step, now.previewing], [true, now.steps, false]);
  assert.ok(await page.locator(".summary").isVisible());
});

test("a wrong first answer before the first step is kept too", async (t) => {
  const page = await load(t, "?lesson=kdop-space&step=0");
  await until(page, (now) => now.asked?.id === "tightest" && now.step === 0);
  await page.locator("#canvas").focus();
  await page.keyboard.press("1"); // the 14-DOP, which is not the tightest
  await page.keyboard.press("Enter");
  const { asked } = await until(page, (now) => now.asked?.tried);
  assert.deepEqual((await reload(page)).asked.tried, asked.tried);
});

/** The same address in another tab of the same device. */
async function second_tab(page) {
  const other = await page.context().newPage();
  await other.goto(page.url());
  await ready(other);
  return other;
}

test("an attempt that goes on in one tab goes on in the other; on the course's page none is open", async (t) => {
  const page = await load(t, "?exercise=be-quickhull&seed=11");
  const made = (tab) => tab.evaluate(() => window.snug.exercise()?.decision);
  const until_made = async (tab, count) => {
    for (const end = Date.now() + kPatience; (await made(tab)) !== count; await tab.waitForTimeout(50))
      assert.ok(Date.now() < end, `${await made(tab)} decisions are made, not ${count}`);
  };
  const other = await second_tab(page);
  for (const [count, tab, name] of [[1, page, "P4"], [2, other, "P0"]]) {
    await tab.locator(".ask input").fill(name);
    await tab.locator(".ask input").press("Enter");
    for (const each of [page, other]) await until_made(each, count);
  }
  await page.locator(".notice", { hasText: "This attempt went on in another tab." }).waitFor();
  await other.close();
  await reload(page);
  assert.equal(await made(page), 2);
  const { now } = (await kept(page)).exercises["be-quickhull"];
  assert.deepEqual([now.decisions.length, now.mark], [2, 2]);
  const attempts = () => page.evaluate(() => JSON.parse(window.snug.result()).attempts.length);
  assert.equal(await attempts(), 1);
  await page.locator("#home").click();
  await page.locator("#course").waitFor();
  assert.equal(await attempts(), 0, "none is open, and none finished");
});

test("a tab in which nothing was done writes nothing over what another tab has kept", async (t) => {
  const page = await load(t, `${kFirst}&step=0`);
  await to_question(page);
  await page.waitForTimeout(kPlace);
  const other = await second_tab(page);
  await to_question(other);
  await answer(other, null, "keyboard");
  await other.waitForTimeout(kPlace);
  await other.close();
  const { outcomes } = await reload(page, kFirst);
  assert.equal(outcomes.length, 1);
  assert.equal((await kept(page)).lessons["sphere-ritter"].answered, 1);
});

test("an address with a step wins over the step that is kept", async (t) => {
  const page = await load(t, `${kFirst}&step=0`);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  await until(page, (now) => now.step >= 1);
  const { step } = await state(page);
  assert.equal((await reload(page, kFirst)).step, step);
  assert.equal((await reload(page, `${kFirst}&step=0`)).step, 0);
});

test("Erase my answers asks once more, then leaves nothing of them", async (t) => {
  const page = await load(t, `${kFirst}&step=0`);
  await to_question(page);
  await answer(page, null, "keyboard");
  await page.waitForTimeout(kPlace);
  assert.equal(Object.keys((await kept(page)).lessons).length, 1);
  await page.locator("#settings").click();
  await page.getByRole("button", { name: "Erase my answers" }).click();
  assert.equal(Object.keys((await kept(page)).lessons).length, 1);
  await page.getByRole("button", { name: "Press again to erase them" }).click();
  assert.deepEqual((await kept(page)).lessons, {});
  assert.deepEqual((await state(page)).outcomes, []);
  await page.waitForTimeout(kPlace);
  assert.deepEqual((await kept(page)).lessons, {});
  await page.keyboard.press("Escape");
  assert.deepEqual((await reload(page, kFirst)).outcomes, []);
  assert.equal((await kept(page)).invited, 3); // who has seen the invitations has seen them
});

const kEntry = {
  address: "?lesson=sphere-ritter&step=2&seed=143",
  answers: "",
  answered: 0,
  step: 2,
  steps: 21,
  done: false,
  task: false,
};
const kept_as = (entry) =>
  JSON.stringify({ version: 1, last: "sphere-ritter", invited: 3, lessons: { "sphere-ritter": entry } });
const kDamaged = {
  "no JSON": "{",
  "lessons that are none":
    '{"version":1,"last":7,"invited":"x","lessons":{"sphere-ritter":{"address":3},"__proto__":{},"x":null}}',
  "a damaged place in a question":
    kept_as({ ...kEntry, told: 7, tried: { question: "first-growth", choices: "x" } }),
  "a place in a question that there is not":
    kept_as({ ...kEntry, told: "none", tried: { question: "none", choices: [9], handle: null } }),
  "damaged answers":
    kept_as({ ...kEntry, address: "?lesson=sphere-ritter&step=oops&moved=1,x", answers: "[[answer]]\nquestion = " }),
};
for (const [name, text] of Object.entries(kDamaged)) {
  test(`damaged storage does no harm: ${name}`, async (t) => {
    const page = await load(t, "", {
      init: `if (!sessionStorage.getItem("once")) localStorage.setItem("snug-course", ${JSON.stringify(text)});
        sessionStorage.setItem("once", "1")`,
      newcomer: true,
    });
    assert.equal((await state(page)).lesson, null);
    // What no lesson can be read from is set aside as it was, and the page says so.
    const lost = ["no JSON", "lessons that are none"].includes(name);
    assert.equal(await page.evaluate(() => localStorage.getItem("snug-course-damaged")), lost ? text : null);
    assert.equal(await page.locator("#course-damaged").isVisible(), lost);
    await page.locator(".lesson-card").first().click();
    await ready(page);
    assert.equal((await state(page)).lesson, "sphere-ritter");
    assert.equal(await page.locator(".notice").count(), 0);
    await page.keyboard.press("ArrowRight");
    await page.waitForTimeout(kPlace);
    assert.equal((await kept(page)).version, 1);
  });
}

test("a later version's storage is left as it is", async (t) => {
  const later = '{"version":99,"what":"ever"}';
  const page = await load(t, "", {
    init: `localStorage.setItem("snug-course", ${JSON.stringify(later)})`,
    newcomer: true,
  });
  await page.locator(".lesson-card").first().click();
  await ready(page);
  await page.keyboard.press("ArrowRight");
  await page.waitForTimeout(kPlace);
  assert.equal(await page.evaluate(() => localStorage.getItem("snug-course")), later);
});

for (const [name, init] of [
  [
    "forbidden",
    () =>
      Object.defineProperty(window, "localStorage", {
        get: () => {
          throw new DOMException("no", "SecurityError");
        },
      }),
  ],
  [
    "full",
    () =>
      (Storage.prototype.setItem = () => {
        throw new DOMException("full", "QuotaExceededError");
      }),
  ],
]) {
  test(`${name} storage does no harm: the course says quietly that nothing lasts`, async (t) => {
    const page = await load(t, "", { init, newcomer: true });
    await page.locator(".lesson-card").first().click();
    await ready(page);
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowRight");
    const { step } = await until(page, (now) => now.step > 0);
    assert.equal(await page.locator(".notice").count(), 0);
    await page.locator("#home").click();
    assert.ok(await page.locator("#course-forgets").isVisible());
    await page.locator("#start").click(); // until the page is closed, the place is known
    assert.equal((await until(page, (now) => now.lesson !== null)).step, step);
  });
}
