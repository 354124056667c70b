// Points are dragged, moved, typed, added and taken back, by mouse, finger and keyboard.
import { after, before, test } from "node:test";
import {
  assert, drag, drag_by_finger, handles, kPhone, lesson_with, paste, start, state, still, stop, until, visit, to_points,
} from "./support.mjs";

before(start);
after(stop);

const flat = (text) => /dim = 2/.test(text) || !/dim = |mesh = /.test(text);
const in_the_plane = async () => `?lesson=${await lesson_with(flat)}`;

const farthest_out = (list) => list.reduce((a, b) => (b.x > a.x ? b : a));

test("dragging a handle with the mouse moves its point and the radius follows", async (t) => {
  const page = await visit(t, await in_the_plane());
  const before = await state(page);
  const handle = farthest_out(await handles(page));
  await page.mouse.move(handle.x, handle.y);
  await page.mouse.down();
  await page.mouse.move(handle.x + 40, handle.y - 10, { steps: 6 });
  const during = await until(page, (now, radius) => now.readout.radius !== radius, before.readout.radius);
  assert.notEqual(during.trace, before.trace, "the trace follows while dragging");
  await page.mouse.up();
  await still(page);
  const moved = (await handles(page)).find(({ id }) => id === handle.id);
  assert.ok(Math.hypot(moved.x - handle.x, moved.y - handle.y) > 15, "the handle is where it was dragged to");
});

test("a drag is one entry of undo, and undo and redo restore the trace", async (t) => {
  const page = await visit(t, await in_the_plane());
  const before = await state(page);
  const handle = farthest_out(await handles(page));
  await page.mouse.move(handle.x, handle.y);
  await page.mouse.down();
  await page.mouse.move(handle.x + 60, handle.y + 30, { steps: 10 });
  await page.mouse.up();
  const dragged = await until(page, (now, trace) => now.trace !== trace && now.canUndo, before.trace);
  await page.keyboard.press("Control+z");
  assert.equal((await until(page, (now) => now.canRedo)).trace, before.trace);
  assert.equal((await state(page)).canUndo, false);
  await page.getByRole("button", { name: "Redo" }).click();
  assert.equal((await until(page, (now) => now.canUndo)).trace, dragged.trace);
});

test("a finger drags a handle on a phone", async (t) => {
  const page = await visit(t, await in_the_plane(), kPhone);
  const before = await state(page);
  await drag_by_finger(page, farthest_out(await handles(page)).id, -48, 24);
  await until(page, (now, trace) => now.trace !== trace && now.edited, before.trace);
});

test("two fingers pinch the view without moving a point", async (t) => {
  const page = await visit(t, await in_the_plane(), kPhone);
  const before = await state(page);
  const spread = (list) => Math.max(...list.map(({ x }) => x)) - Math.min(...list.map(({ x }) => x));
  const narrow = spread(await handles(page));
  const box = await page.locator("#stage").boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const touch = await page.context().newCDPSession(page);
  const send = (type, apart) => touch.send("Input.dispatchTouchEvent",
    { type, touchPoints: apart ? [{ x: x - apart, y, id: 0 }, { x: x + apart, y, id: 1 }] : [] });
  await send("touchStart", 40);
  for (let apart = 46; apart <= 80; apart += 6) await send("touchMove", apart);
  await send("touchEnd", 0);
  await still(page);
  assert.ok(spread(await handles(page)) > 1.2 * narrow, "the view is closer");
  assert.equal((await state(page)).trace, before.trace);
});

test("arrow keys move the selected point", async (t) => {
  const page = await visit(t, await in_the_plane());
  await page.locator("#canvas").focus();
  await page.keyboard.press("]");
  const chosen = await until(page, (now) => now.selected !== null);
  await page.keyboard.press("ArrowRight");
  const moved = await until(page, (now, at) => now.coordinates[0] > at[0], chosen.coordinates);
  assert.equal(moved.coordinates[1], chosen.coordinates[1]);
  assert.notEqual(moved.trace, chosen.trace);
  await page.keyboard.press("Escape");
  await until(page, (now) => now.selected === null);
});

test("after a drag an arrow key steps, and with Shift it moves the point a little", async (t) => {
  const page = await visit(t, await in_the_plane());
  await drag(page, (await handles(page))[0].id, 24, -16);
  const dragged = await until(page, (now) => now.selected !== null && now.coordinates);
  await page.keyboard.press("Shift+ArrowRight");
  const moved = await until(page, (now, at) => now.coordinates[0] > at[0], dragged.coordinates);
  assert.equal(moved.coordinates[1], dragged.coordinates[1]);
  assert.equal(moved.step, dragged.step);
  await page.keyboard.press("ArrowRight"); // shown whole at first, the run begins
  const stepped = await until(page, (now, step) => now.step !== step, moved.step);
  assert.deepEqual(stepped.coordinates, moved.coordinates);
});

test("a place is typed in numbers", async (t) => {
  const page = await visit(t, await in_the_plane());
  await to_points(page);
  await page.getByLabel("Selected point").first().fill("2");
  await page.keyboard.press("Enter");
  await until(page, (now) => now.selected === 2);
  await page.getByLabel("x of the selected point").fill("3.25");
  await page.keyboard.press("Tab");
  const typed = await until(page, (now) => now.coordinates[0] === 3.25);
  assert.equal(typed.selected, 2);
  await page.getByLabel("x of the selected point").fill("");
  await page.keyboard.press("Tab");
  assert.equal((await state(page)).trace, typed.trace, "an emptied field moves nothing");
  assert.equal(await page.getByLabel("x of the selected point").inputValue(), "3.25");
  await page.getByLabel("Selected point").first().fill("99999");
  await page.keyboard.press("Enter");
  await page.getByText("There is no point 99999").waitFor();
  assert.equal((await state(page)).selected, 2);
});

test("points are added, deleted, scattered and reset", async (t) => {
  const page = await visit(t, await in_the_plane());
  await to_points(page);
  const { size, trace, seed } = await state(page);
  await page.getByRole("button", { name: "Add", exact: true }).click();
  await until(page, (now, n) => now.size === n + 1, size);
  await page.getByLabel("Selected point").first().fill("0");
  await page.keyboard.press("Enter");
  await page.getByRole("button", { name: "Delete", exact: true }).click();
  await until(page, (now, n) => now.size === n, size);
  await page.getByRole("spinbutton", { name: "Seed" }).fill(String(seed + 5));
  await page.getByRole("button", { name: "Scatter" }).click();
  const scattered = await until(page, (now, s) => now.seed === s, seed + 5);
  assert.notEqual(scattered.trace, trace);
  await page.getByRole("button", { name: "Reset" }).click();
  assert.equal((await until(page, (now, s) => now.seed === s, seed)).trace, trace);
});

const set_shown = (page) =>
  page.getByRole("combobox", { name: "Set" }).evaluate((select) => select.selectedOptions[0].textContent);

test("Scatter has other points every time, and the box says which set they are of", async (t) => {
  const page = await visit(t, "?lesson=sphere-ritter");
  await to_points(page);
  const first = await state(page);
  assert.equal(await set_shown(page), "Gaussian");
  const scatter = page.getByRole("button", { name: "Scatter" });
  await scatter.click();
  const second = await until(page, (now, trace) => now.trace !== trace, first.trace);
  await scatter.click();
  await until(page, (now, traces) => !traces.includes(now.trace), [first.trace, second.trace]);
  await page.getByRole("combobox", { name: "Set" }).selectOption({ label: "Bunny" });
  await until(page, (now) => now.source === "bunny" && now.size === 1839);
  assert.equal(await set_shown(page), "Bunny");
  await scatter.click();
  await until(page, (now) => now.source === "gaussian" && now.size === 14);
  assert.equal(await set_shown(page), "Gaussian");
  await drop(page, "mine.xyz", "0 0\n1 0\n0 1\n");
  await until(page, (now) => now.source === "mine.xyz");
  assert.equal(await set_shown(page), "mine.xyz");
  await page.getByRole("combobox", { name: "Set" }).selectOption({ label: "Gaussian" });
  await until(page, (now, trace) => now.trace === trace, first.trace);
});

test("a coordinate has as many digits as its field shows, and what was not touched keeps all of them", async (t) => {
  const page = await visit(t, "?lesson=sphere-ritter");
  await to_points(page);
  await page.getByLabel("Selected point").first().fill("3");
  await page.keyboard.press("Enter");
  const { coordinates } = await until(page, (now) => now.selected === 3);
  assert.ok(String(coordinates[1]).length > 12, "it has more digits than a field");
  const field = (axis) => page.getByLabel(`${axis} of the selected point`);
  for (const axis of ["x", "y"]) {
    assert.ok((await field(axis).inputValue()).length <= 9);
    const [wide, room] = await field(axis).evaluate((input) => [input.scrollWidth, input.clientWidth]);
    assert.ok(wide <= room, `${axis}: ${wide} of ${room} px`);
  }
  await field("x").fill("0.25");
  await field("x").blur();
  const moved = await until(page, (now) => now.coordinates[0] === 0.25);
  assert.equal(moved.coordinates[1], coordinates[1]);
});

const drop = (page, name, text, ...others) =>
  page.evaluate(
    ([file_name, content, more]) => {
      const data = new DataTransfer();
      for (const each of [file_name, ...more]) data.items.add(new File([content], each));
      for (const type of ["dragover", "drop"])
        document
          .querySelector("#stage")
          .dispatchEvent(new DragEvent(type, { dataTransfer: data, bubbles: true, cancelable: true }));
    },
    [name, text, others],
  );

test("a drop says what became of each file", async (t) => {
  const page = await visit(t, await in_the_plane());
  await drop(page, "five.xyz", "0 0\n4 0\n4 3\n0 3\n2 1\n", "six.xyz", "seven.ply");
  await until(page, (now) => now.size === 5);
  await page.getByText("five.xyz is open.").waitFor();
  await page.getByText("One file is taken at a time; not opened: six.xyz, seven.ply.").waitFor();
});

test("rows of a spreadsheet are pasted, and decimal commas are refused with a hint", async (t) => {
  const page = await visit(t, await in_the_plane());
  await paste(page, "0\t0\n4\t0\n4\t3\n");
  assert.equal((await until(page, (now) => now.size === 3)).dim, 2);
  await paste(page, "0,5\t1,5\n");
  await page.getByText(/^Those rows cannot be used\. pasted\.csv:1: "0,5" is not a number.*decimal/).waitFor();
});

test("a dropped point file is used", async (t) => {
  const page = await visit(t, await in_the_plane());
  await drop(page, "five.xyz", "# five\n0 0\n4 0\n4 3\n0 3\n2 1\n");
  const dropped = await until(page, (now) => now.size === 5);
  assert.equal(dropped.dim, 2);
  await page.keyboard.press("Control+z");
  await until(page, (now) => now.size !== 5);
});

test("a malformed file is refused with its line, and what was there stays", async (t) => {
  const page = await visit(t, await in_the_plane());
  const before = await state(page);
  await drop(page, "bad.xyz", "0 0\n1 1\n2 two\n");
  await page.getByText(/bad\.xyz:3/).waitFor();
  assert.equal((await state(page)).trace, before.trace);
  await page.getByRole("button", { name: "Dismiss" }).click();
  assert.equal(await page.getByText(/bad\.xyz:3/).count(), 0);
});

test("a file is opened by the button", async (t) => {
  const page = await visit(t, await in_the_plane());
  await to_points(page);
  const chooser = page.waitForEvent("filechooser");
  await page.getByRole("button", { name: /Open file/ }).click();
  await (await chooser).setFiles({ name: "three.csv", mimeType: "text/csv", buffer: Buffer.from("0,0\n2,0\n1,2\n") });
  assert.equal((await until(page, (now) => now.size === 3)).size, 3);
});

test("an address whose points would take minutes is refused with how many can be shown, the lesson open", async (t) => {
  const page = await visit(t, "?lesson=obb-fitting&from=sphere:99999");
  await page.getByText(/would take about .* for 99,999 such points.*; up to about [\d,]+ (take|can)/).waitFor();
  assert.ok((await state(page)).size < 1000);
});

test("what takes long says what is done and how far; cancelled by mouse or key it leaves all as it was", async (t) => {
  const page = await visit(t, "?lesson=kdop-space");
  const opened = await state(page);
  await page.evaluate(() => {
    window.paints = [];
    let last = performance.now();
    const look = (now) => (window.paints.push(now - last), (last = now), requestAnimationFrame(look));
    requestAnimationFrame(look);
  });
  await to_points(page);
  let seed = 1;
  const next = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  const buffer = Buffer.from(Array.from({ length: 40_000 }, () => [next(), next(), next()].join(" ")).join("\n"));
  /** Opens the file, and does that once the page has drawn how far it is: sooner than a fast machine is done. */
  const begin = async (does) => {
    const told = page.evaluate(
      (deed) =>
        new Promise((done) => {
          const look = () => {
            const [veil, text, bar, cancel] = ["veil", "veil-text", "veil-bar", "veil-retry"].map((id) =>
              document.getElementById(id),
            );
            // A machine that others use refuses them before it has drawn anything.
            if (/would take about/.test(document.getElementById("notices").textContent)) return done(null);
            if (veil.hidden || bar.hidden || !/^Working/.test(text.textContent)) return requestAnimationFrame(look);
            const [role, label] = ["role", "aria-label"].map((name) => bar.getAttribute(name));
            done([text.textContent, role, label, document.activeElement === cancel]);
            if (deed === "click") cancel.click();
            if (deed === "Escape") cancel.dispatchEvent(new KeyboardEvent("keydown", { key: deed, bubbles: true }));
          };
          requestAnimationFrame(look);
        }),
      does,
    );
    const file = { name: "many.xyz", mimeType: "text/plain", buffer };
    await page.locator("#points input[type=file]").setInputFiles(file);
    return told;
  };
  const told = await begin("click");
  if (!told) return t.diagnostic("refused at once");
  const [says, role, label, focused] = told;
  assert.match(says, /^Working on 40,000 points/);
  assert.deepEqual([role, label, focused], ["progressbar", says, true]);
  await page.getByText("Cancelled: all is as it was.").waitFor();
  await page.getByRole("button", { name: "Dismiss" }).first().click();
  if (!(await begin("Escape"))) return t.diagnostic("refused at once");
  await page.getByText("Cancelled: all is as it was.").waitFor();
  const left = await state(page);
  assert.deepEqual([left.trace, left.size, left.canUndo], [opened.trace, opened.size, false]);
  await begin("nothing");
  await page.locator("#veil").waitFor({ state: "hidden", timeout: 60_000 });
  const { size } = await state(page);
  if (size !== 40_000) // on a machine that others use
    await page.getByText(/would take about .* for 40,000 such points.*; up to about [\d,]+ (take|can)/).waitFor();
  const longest = Math.round(await page.evaluate(() => Math.max(...window.paints)));
  t.diagnostic(`the longest time between two frames, with ${size} points: ${longest} ms`);
});
