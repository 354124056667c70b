// A lecturer's demo on the page: walked through by the keys of a clicker, with wild drags between; its notes.
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { isDeepStrictEqual } from "node:util";
import { assert, handles, kPatience, load, low_words, ready, start, state, still, stop, until } from "./support.mjs";

let site;
before(async () => (site = await start()));
after(stop);

/** @type {Opened} */
const kHall = { viewport: { width: 1280, height: 720 }, reducedMotion: "reduce" };

const demo_of = async (id) => (await fetch(`${site.url}demos/${id}.json`)).json();
/** Where the demo stands, as the page says it: "7 of 20". */
const place = (page) => page.locator(".demo-place").textContent();
const classes = (page) => page.evaluate(() =>
  document.documentElement.className.split(" ").filter((name) => name !== "pointed").sort().join(" "));

/** Until the page has the state open that it says it is at. */
async function opened(page, says, hash) {
  await page.waitForFunction(([at, trace]) =>
    document.querySelector(".demo-place")?.textContent === at && window.snug.state()?.trace === trace, [says, hash]);
  await still(page);
}

/** What stands there, without what depends on the time. */
async function standing(page) {
  const { lesson, step, steps, trace, caption, situation, algorithm, beside, readout, asked } = await state(page);
  return { lesson, step, steps, trace, caption, situation, algorithm, beside, readout, asked: asked?.id ?? null };
}

/** Until the same stands there once more: what a key asks for comes when it has been loaded and drawn. */
async function stands(page, expected, says = "") {
  const end = Date.now() + kPatience;
  let now = await standing(page);
  while (!isDeepStrictEqual(now, expected) && Date.now() < end) now = await standing(page);
  assert.deepEqual(now, expected, says);
}

/** Until that is among the page's words. It is looked for while the lesson still loads: a notice goes by itself.
 *  @param {() => Promise<unknown>} deed */
async function says_after(page, deed, words) {
  const said = page.getByText(words).waitFor();
  await deed();
  await said;
}

/** Drags whatever there is, turns the view, and steps, as one does who forgets that the class is watching. */
async function drag_wildly(page) {
  const all = await handles(page);
  for (const { x, y } of [all[0], all.at(-1), { x: 300, y: 300 }].filter(Boolean)) {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 90, y - 60, { steps: 2 });
    await page.mouse.up();
  }
  await still(page); // what was done is there
  await page.keyboard.press(" ");
}

// The window walks through the other halves (tests/desktop/demo.test.sh).
for (const [id, width, height] of [["collision", 1280, 720], ["geometry", 1920, 1080]])
  test(`${id} is walked through by clicker alone at ${width}x${height}: each state as in its file, after any drag`,
    (t) => walk(t, id, { ...kHall, viewport: { width, height } }));

async function walk(t, id, size) {
  const { states } = await demo_of(id);
  const page = await load(t, `?demo=${id}&state=1`, size);
  let changed = 0;
  for (const [i, { hash, reveal }] of states.entries()) {
    const says = `${i + 1} of ${states.length}`;
    await opened(page, says, hash);
    const before = await standing(page);
    if (i % 4 === 2) {
      await drag_wildly(page);
      const { trace, step } = await state(page);
      if (trace !== hash || step !== before.step) changed += 1;
      await page.keyboard.press("Home");
      await opened(page, says, hash);
      await stands(page, before, `state ${says}, again`);
    }
    for (let press = 0; press <= reveal.length; ++press) await page.keyboard.press("PageDown");
  }
  assert.equal(await place(page), `${states.length} of ${states.length}`, "after the last there is none");
  assert.ok(changed >= 4, "the drags change what they are told to");
}

test("back leads to what was shown before, reveal by reveal; black, the address, and Escape", async (t) => {
  const { states } = await demo_of("collision");
  const page = await load(t, "?demo=collision&state=9", kHall);
  await opened(page, `9 of ${states.length}`, states[8].hash);
  const [first, shown] = [await standing(page), await classes(page)];
  await page.keyboard.press("PageDown"); // the steps
  await until(page, (now) => now.step === now.steps);
  await page.keyboard.press("PageDown"); // the numbers
  assert.match(shown, /without-numbers/);
  assert.doesNotMatch(await classes(page), /without-numbers/);
  await page.keyboard.press("PageDown"); // the next state
  await opened(page, `10 of ${states.length}`, states[9].hash);
  await page.waitForFunction(() => location.search === "?demo=collision&state=10");
  await page.keyboard.press("PageUp"); // as it was left: with all that was revealed
  await opened(page, `9 of ${states.length}`, states[8].hash);
  await until(page, (now) => now.step === now.steps);
  assert.doesNotMatch(await classes(page), /without-numbers/);
  await page.keyboard.press("PageUp");
  await page.keyboard.press("PageUp");
  await stands(page, first);
  assert.equal(await classes(page), shown);

  await page.keyboard.press(".");
  await page.locator(".hall-black").waitFor();
  await page.keyboard.press("PageDown"); // brings the picture back, and does nothing else
  await page.locator(".hall-black").waitFor({ state: "hidden" });
  await stands(page, first);

  await drag_wildly(page);
  for (let press = 0; press < 5; ++press) await page.keyboard.down("PageDown"); // held: told again by the keyboard
  await page.keyboard.up("PageDown");
  await stands(page, first, "as it was before that key");
  assert.equal(await classes(page), shown);

  await page.keyboard.press("f");
  await page.locator(".hall-picture").waitFor();
  await page.keyboard.press("ArrowRight");
  await until(page, (now) => now.step === now.steps);
  assert.equal(await page.locator(".hall-picture").count(), 1, "the picture stands");
  await page.keyboard.press("f");
  await page.locator(".hall-picture").waitFor({ state: "detached" });

  await page.keyboard.press("?");
  const keys = await page.getByRole("dialog", { name: "Keys" }).locator("dl").first().textContent();
  for (const key of ["Page Down", "Page Up", "Home", "F5", "Esc", "B  .", "Tab"])
    assert.ok(keys.includes(key), `what ${key} does in a demo is told first`);
  await page.keyboard.press("?");
  await page.getByRole("dialog", { name: "Keys" }).waitFor({ state: "detached" });

  await page.keyboard.press("Escape");
  await page.waitForFunction(() => location.search.startsWith("?lesson=sphere-ritter"));
  assert.doesNotMatch(await classes(page), /demo|presenting/);
  assert.equal(await page.locator(".demo-place").count(), 0);
  const kept = await page.evaluate(() => JSON.parse(localStorage.getItem("snug-course")).lessons);
  assert.deepEqual(Object.keys(kept).filter((id) => id !== "sphere-ritter"), [], "a demo is nobody's work");
});

test("the notes follow the demo in a second tab and lead it; closed and opened again, nothing is lost", async (t) => {
  const { states } = await demo_of("geometry");
  const page = await load(t, "?demo=geometry&state=25", { viewport: { width: 1920, height: 1080 } });
  await opened(page, `25 of ${states.length}`, states[24].hash);
  for (let i = 0; i < 2; ++i) {
    const notes = await page.context().newPage();
    await notes.goto(`${site.url}?demo=geometry&notes=1`);
    await notes.getByRole("heading", { name: states[24 - i].slide }).waitFor();
    assert.ok((await notes.locator(".says").textContent()).startsWith(states[24 - i].notes.slice(0, 40)));
    await notes.reload();
    await notes.getByRole("heading", { name: states[24 - i].slide }).waitFor();
    if (i === 1) assert.ok((await notes.locator(".next").textContent()).endsWith(states[24].slide), "the next state");
    await notes.getByRole("button", { name: "Back" }).click();
    await notes.getByRole("heading", { name: states[23 - i].slide }).waitFor();
    await opened(page, `${24 - i} of ${states.length}`, states[23 - i].hash);
    for (let press = 0; press < states[23 - i].reveal.length; ++press) await notes.keyboard.press("PageUp");
    if (i === 0) await notes.close();
  }
  await page.keyboard.press("Home");
  await opened(page, `23 of ${states.length}`, states[22].hash);
  const [, notes] = page.context().pages();
  await page.goto("about:blank"); // the projector's tab is lost, and opened again
  await notes.getByText("Waiting for the demo, in another tab of this browser.").waitFor();
  await page.goto(`${site.url}?demo=geometry&state=22`);
  await notes.getByRole("heading", { name: states[21].slide }).waitFor();
});

test("an address of no demo, or of no state of it, says so", async (t) => {
  const page = await load(t, "?demo=nowhere", { wait: false, may_complain: /404/ });
  await page.getByText("There is no demo “nowhere”").waitFor();
  await says_after(page, () => page.goto(`${site.url}?demo=collision&state=99`),
    "The address asks for state 99; the demo has 20.");
  await ready(page);
  assert.equal(await place(page), "20 of 20");
});

test("notes that the browser blocks are a link away", async (t) => {
  const page = await load(t, "?demo=geometry&state=2", { ...kHall, init: () => (window.open = () => null) });
  await page.waitForFunction(() => document.querySelector(".demo-place"));
  await page.keyboard.press("s");
  const [notes] = await Promise.all([
    page.context().waitForEvent("page"), page.getByRole("link", { name: "Open them in another tab" }).click(),
  ]);
  const { states } = await demo_of("geometry");
  await notes.getByRole("heading", { name: states[1].slide }).waitFor();
});

test("a key adds what stands there to a demo's file, which grows by a state with each press", async (t) => {
  const page = await load(t, "?lesson=sphere-ritter&step=3&seed=7");
  const { trace } = await state(page);
  const texts = [];
  for (let press = 0; press < 2; ++press) {
    const saved = page.waitForEvent("download");
    await page.keyboard.press("Shift+D");
    texts.push(readFileSync(await (await saved).path(), "utf8"));
    await page.keyboard.press("ArrowRight");
  }
  assert.ok(texts[0].includes(`[[state]]\nhash = "${trace}"\n`), texts[0]);
  assert.match(texts[0], /lesson = "sphere-ritter"\nstep = 3\nseed = 7\n/);
  assert.ok(texts[1].startsWith(texts[0]) && texts[1].match(/\[\[state\]\]/g).length === 2, texts[1]);
});

test("no word beside the stage is lower than a fortieth of the screen's height", async (t) => {
  for (const viewport of [{ width: 1280, height: 720 }, { width: 1920, height: 1080 }]) {
    const page = await load(t, "?demo=collision&state=2", { ...kHall, viewport });
    await until(page, (now) => now.lesson === "aabb");
    await still(page);
    for (let press = 0; press < 3; ++press, await still(page)) {
      assert.deepEqual(await low_words(page), []);
      await page.keyboard.press("PageDown"); // the sentence, the numbers, a question
    }
    assert.deepEqual(await low_words(page), []);
    await page.close();
  }
});

test("the code of a state is seen beside its numbers: nothing is chosen there", async (t) => {
  const { states } = await demo_of("collision");
  const page = await load(t, "?demo=collision&state=7", kHall);
  await opened(page, `7 of ${states.length}`, states[6].hash);
  for (let press = 0; press < states[6].reveal.length; ++press) await page.keyboard.press("PageDown");
  await still(page);
  const beyond = await page.locator("#code").evaluate((code) => code.scrollHeight - code.clientHeight);
  assert.ok(beyond <= 1, `${beyond} pixels of it are not seen`);
  assert.ok(await page.locator("#code .fields").isHidden());
});

/** The letters alone that are read on the page: counters are in no element's text. */
async function letters_of(page) {
  const devtools = await page.context().newCDPSession(page);
  const { nodes } = await devtools.send("Accessibility.getFullAXTree");
  return nodes.filter(({ role }) => role?.value === "StaticText").map(({ name }) => name?.value)
    .filter((text) => /^[A-Z]$/.test(text));
}

test("a class votes twice, and no number is on the page before the answer is revealed", async (t) => {
  const { states } = await demo_of("collision");
  const page = await load(t, "?demo=collision&state=3", kHall);
  await opened(page, `3 of ${states.length}`, states[2].hash);
  const notes = await page.context().newPage();
  await notes.goto(`${site.url}?demo=collision&notes=1`);
  await notes.getByRole("heading", { name: states[2].slide }).waitFor();
  const vote = page.locator(".demo-vote");
  await page.waitForFunction(() => document.querySelector(".demo-vote")); // its program has arrived
  assert.deepEqual(await letters_of(page), ["A", "B", "C"], "each choice is called as its vote calls it");
  for (const key of ["1", "2", "Enter", "3", "1", "Enter", "Enter", "v", "4", "Enter", "3", "9", "Enter", "Enter"])
    await page.keyboard.press(key);
  assert.match(await vote.textContent(), /^Second vote: .* counted$/);
  assert.doesNotMatch((await vote.textContent()).replace(/P\d+/g, ""), /\d/, "nothing leaks");
  await notes.waitForFunction(() => // the last of the keys comes there last
    / 12, .* 31\. Second vote: .* 4, .* 39$/.test(document.querySelector(".vote").textContent));
  await page.reload(); // which loses none of it
  await opened(page, `3 of ${states.length}`, states[2].hash);
  await page.waitForFunction(() => /counted$/.test(document.querySelector(".demo-vote")?.textContent ?? ""));
  await page.keyboard.press("PageDown"); // plays the steps that decide it
  await until(page, (now) => now.asked === null && now.outcome && now.step > 0);
  assert.match(await vote.textContent(), /12 \(28 %\), then 4 \(9 %\)/);
  await page.keyboard.press("PageUp");
  await until(page, (now) => now.asked !== null);
  assert.doesNotMatch((await vote.textContent()).replace(/P\d+/g, ""), /\d/, "and is hidden again");
});

test("while the card of keys or the code is open keys lead nowhere, and Escape puts it away alone", async (t) => {
  const { states } = await demo_of("collision");
  const page = await load(t, "?demo=collision&state=9", kHall);
  const says = `9 of ${states.length}`;
  await opened(page, says, states[8].hash);
  const [stood, shown] = [await standing(page), await classes(page)];
  for (const [opens, sheet, keys] of [["?", "dialog[open]", ["PageDown", "ArrowRight", "Escape"]],
    ["q", ".qr", ["PageDown"]], ["q", ".qr", ["Escape"]]]) {
    await page.keyboard.press(String(opens));
    await page.locator(String(sheet)).waitFor();
    for (const key of keys) await page.keyboard.press(key);
    await page.locator(String(sheet)).waitFor({ state: "detached" });
    await still(page);
    assert.equal(await place(page), says);
    assert.deepEqual(await standing(page), stood);
    assert.equal(await classes(page), shown);
  }
  await page.keyboard.press("PageDown"); // leads on again
  await until(page, (now) => now.step === now.steps);
});

test("a vote for a place is a dot there, of the size of its share, once the answer is shown", async (t) => {
  const { states } = await demo_of("collision");
  const page = await load(t, "?demo=collision&state=6", kHall);
  await opened(page, `6 of ${states.length}`, states[5].hash);
  const [one, two] = (await state(page)).asked.targets;
  await page.waitForFunction(() => document.querySelector(".demo-vote"));
  await page.keyboard.press("v");
  for (const line of [`${one} 30`, `${two} 10`]) {
    await page.keyboard.type(line);
    await page.keyboard.press("Enter");
  }
  await page.keyboard.press("Enter");
  assert.match(await page.locator(".demo-vote").textContent(), new RegExp(`^First vote: .*${one}.* counted$`));
  assert.equal(await page.locator(".demo-dots span").count(), 0, "nothing leaks");
  await page.keyboard.press("PageDown");
  await until(page, (now) => now.asked === null);
  await still(page);
  // Each frame has dots of its own: all that belongs together is read at once.
  const [dots, all] = await page.evaluate(() => /** @type {const} */ ([
    [...document.querySelectorAll(".demo-dots span")].map((dot) => {
      const { x, y, width, height } = dot.getBoundingClientRect();
      return { x: x + width / 2, y: y + height / 2, width };
    }), window.snug.handles()]));
  assert.equal(dots.length, 2);
  const rows = await page.locator(".demo-vote p b").allTextContents();
  assert.equal(rows.length, 2, `no row for a place without hands: ${rows}`);
  for (const name of [one, two]) assert.ok(rows.some((row) => row.includes(name)), `${name}: ${rows}`);
  assert.ok(Math.abs(dots[0].width / dots[1].width - Math.sqrt(3)) < 0.05, JSON.stringify(dots));
  const places = all.filter(({ id }) => [one, two].includes(id));
  assert.equal(places.length, 2);
  for (const { x, y } of places)
    assert.ok(dots.some((dot) => Math.hypot(dot.x - x, dot.y - y) < 2), JSON.stringify([dots, places]));
});

/** How much of the page the lecturer's own canvas covers. */
const covered = (page) => page.evaluate(() => {
  const canvas = /** @type {HTMLCanvasElement | null} */ (document.querySelector("canvas.hall"));
  if (!canvas || canvas.hidden) return 0;
  const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  return data.filter((value, i) => i % 4 === 3 && value > 0).length / (data.length / 4);
});
/** deed: what has it covered, once more: what a pen writes fades while a slow machine looks. */
const until_covered = async (page, least, most, deed = async () => {}) => {
  const end = Date.now() + kPatience;
  for (let share = -1; share < least || share > most; share = await covered(page)) {
    assert.ok(Date.now() < end, `${share} is covered`);
    await deed();
  }
};

test("a lesson that is presented has what a demo has: black, a standing picture, pointers, all keys", async (t) => {
  const page = await load(t, "?lesson=sphere-ritter&step=3", kHall);
  await page.keyboard.press("Shift+P");
  await page.waitForFunction(() => document.fullscreenElement && document.querySelector(".presenting"));
  await still(page);
  const before = await standing(page);
  for (const key of ["b", "."]) {
    await page.keyboard.press(key);
    await page.locator(".hall-black").waitFor();
    await page.keyboard.press("PageDown");
    await page.locator(".hall-black").waitFor({ state: "hidden" });
  }
  assert.deepEqual(await standing(page), before, "a key that brings the picture back does nothing else");
  await page.keyboard.press("f");
  await page.locator(".hall-picture").waitFor();
  await page.keyboard.press("ArrowRight");
  await until(page, (now, step) => now.step !== step || now.asked, before.step);
  assert.equal(await page.locator(".hall-picture").count(), 1);
  await page.keyboard.press("f");
  await page.locator(".hall-picture").waitFor({ state: "detached" });

  await page.mouse.move(400, 300);
  await page.keyboard.press("l");
  await page.mouse.move(401, 300);
  await until_covered(page, 0.9, 0.99); // all but the spotlight
  await page.keyboard.press("l");
  await until_covered(page, 0, 0);
  await page.keyboard.press("r");
  await until_covered(page, 0.02, 0.3);
  await page.keyboard.press("r");
  await page.keyboard.press("w");
  await page.locator("canvas.hall.writes:not([hidden])").waitFor();
  await until_covered(page, 0.001, 0.02, async () => {
    await page.mouse.move(400, 300);
    await page.mouse.down();
    await page.mouse.move(700, 500, { steps: 3 });
    await page.mouse.up();
  });
  await page.keyboard.press("Escape"); // lays the pen down, and ends nothing
  assert.match(await classes(page), /presenting/);
  await until_covered(page, 0, 0); // what it wrote has faded

  await page.keyboard.press("?");
  const card = page.getByRole("dialog", { name: "Keys" });
  for (const key of ["Page Down", "Home", "F5", "Esc", "B  .", "Tab", "held"])
    assert.ok((await card.textContent()).includes(key), `the card says what ${key} does`);
  await page.keyboard.press("?");
  await card.waitFor({ state: "detached" });
  await page.keyboard.press("Tab"); // to the first control, as everywhere
  assert.notEqual(await page.evaluate(() => document.activeElement?.tagName), "BODY");
  await page.keyboard.press("F5");
  await page.waitForFunction(() => !document.fullscreenElement && !document.querySelector(".presenting"));
});

test("a state is taken along as a code; the phone says whether it shows the same", async (t) => {
  const page = await load(t, "?lesson=sphere-ritter&step=3&seed=7", kHall);
  await page.keyboard.press("q");
  await page.locator(".qr svg").waitFor();
  const { width, height } = await page.locator(".qr path").boundingBox();
  assert.ok(Math.min(width, height) > 0.6 * 720, "large enough for the last row");
  const letters = await page.locator(".qr .letters").textContent();
  assert.match(letters, /^[B-DF-HJKMNP-TV-Z]{4}$/);
  const says = await page.locator(".qr .says").textContent();
  assert.equal(says, `${site.url}?lesson=sphere-ritter&step=3&seed=7`, "as the window has it (desktop/demo.test.sh)");
  await page.keyboard.press("Escape");
  assert.equal(await page.locator(".qr").count(), 0);
  const scan = (seed) => page.goto(`${site.url}?lesson=sphere-ritter&step=3&seed=${seed}&mark=${letters}`);
  await says_after(page, () => scan(7), `This is the state on the screen: ${letters}.`);
  await says_after(page, () => scan(8), /^This is not the state on the screen: here [A-Z]{4}, there /);
  await ready(page);
});

test("800 points of one's own survive in an address; what is lost of more is told before it is shared", async (t) => {
  const page = await load(t, "?lesson=sphere-ritter&from=cube:800&step=0&seed=3");
  const give = async (count) => {
    const points = Array.from({ length: count }, (_, i) => [Math.cos(i) * (1 + i / count), Math.sin(3 * i) / 3]);
    const buffer = Buffer.from(points.map((point) => point.join(" ")).join("\n"));
    await page.setInputFiles('input[type="file"]', { name: "own.xyz", mimeType: "text/plain", buffer });
    await until(page, (now, size) => now.size === size && !now.preparing, count);
  };
  await give(800);
  await page.waitForFunction(() => location.hash.startsWith("#packed="));
  await still(page);
  const { trace } = await state(page);
  const address = page.url();
  assert.ok(address.length < 20_000, `${address.length} letters`);
  await page.goto("about:blank");
  await page.goto(address);
  await ready(page);
  assert.equal((await state(page)).trace, trace);
  await page.keyboard.press("q");
  await page.locator(".qr .says", { hasText: "without what was edited here, which is too much for a code." }).waitFor();
  await page.keyboard.press("Escape");
  await give(3500);
  await page.getByRole("button", { name: "Share" }).first().click();
  await page.getByText("without what was edited here, which is too much for an address.").waitFor();
});
