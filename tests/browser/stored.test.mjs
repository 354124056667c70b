// How a volume is stored, beside the stage: each representation with its numbers, which follow every drag.
import { after, before, test } from "node:test";
import { assert, drag, kPhone, start, state, still, stop, until, visit } from "./support.mjs";

before(start);
after(stop);

const numbers = (page) =>
  page
    .locator(".member")
    .evaluateAll((all) =>
      Object.fromEntries(all.map((one) => [one.firstChild.textContent, one.lastChild.textContent])),
    );

test("each representation has its members, its bytes and what each operation takes; the least is ticked", async (t) => {
  const page = await visit(t, "?lesson=aabb");
  const forms = page.locator(".form");
  assert.deepEqual(await forms.locator("h4").allTextContents(), ["min-max", "min-widths", "centre-radius"]);
  for (const form of await forms.all()) {
    assert.match(await form.textContent(), /16 bytes in float, 32 in double/);
    assert.deepEqual(await form.locator("dt").allTextContents(), ["test", "move", "turn", "grow"]);
  }
  assert.equal(await forms.nth(0).locator("dd.least").count(), 1);
  assert.equal(await forms.nth(1).locator("dd.least").count(), 1);
  assert.equal(await forms.nth(2).locator("dd.least").count(), 2);
});

test("the numbers follow a drag, and what stays is not marked", async (t) => {
  const page = await visit(t, "?lesson=aabb");
  await still(page);
  const before = await numbers(page);
  await drag(page, "A", 60, 25);
  await page.waitForFunction(
    (was) => document.querySelector(".member .numbers-of").textContent !== was,
    before["Point min"],
  );
  const after = await numbers(page);
  for (const name of ["Point min", "Point max", "Point c"]) assert.notEqual(after[name], before[name], name);
  for (const name of ["float d[0]", "float d[1]", "float r[0]", "float r[1]"])
    assert.equal(after[name], before[name], name);
  const news = await page
    .locator(".member:has(.news)")
    .evaluateAll((all) => all.map((one) => one.firstChild.textContent));
  assert.ok(
    news.every((name) => name.startsWith("Point")),
    news.join(),
  );
});

test("a member that is pointed at or has the focus is lit on the stage", async (t) => {
  const page = await visit(t, "?lesson=aabb");
  await page.getByRole("button", { name: /^float d\[0\]/ }).hover();
  await until(page, (now) => now.lit.mark === "stored:A/1/1");
  await page.mouse.move(2, 2);
  await until(page, (now) => now.lit.mark === "");
  await page.getByRole("button", { name: /^Point max/ }).focus();
  await until(page, (now) => now.lit.mark === "stored:A/0/1");
});

test("in a wide window it is a tab beside the numbers, over the code; on a phone a tab of its own", async (t) => {
  const wide = await visit(t, "?lesson=aabb");
  assert.ok(await wide.locator("#stored").isVisible());
  assert.ok(await wide.locator("#code").isVisible());
  assert.equal(await wide.locator("#numbers").isVisible(), false);
  await wide.locator("#side-tabs").getByRole("tab", { name: "Numbers" }).click();
  assert.equal(await wide.locator("#stored").isVisible(), false);
  assert.ok(await wide.locator("#numbers").isVisible());
  const phone = await visit(t, "?lesson=aabb", kPhone);
  assert.equal(await phone.locator("#stored").isVisible(), false);
  await phone.locator("#tabs").getByRole("tab", { name: "Stored as" }).click();
  assert.ok(await phone.locator("#stored").isVisible());
});

test("the bounds of a k-DOP around a cloud are filled in slab by slab", async (t) => {
  const dashes = async (page) => Object.values(await numbers(page)).filter((text) => text === "—").length;
  const some = await visit(t, "?lesson=kdop-slabs&step=2");
  await until(some, (now) => now.step === 2);
  assert.equal(await dashes(some), 4);
  const all = await visit(t, "?lesson=kdop-slabs&step=99");
  await until(all, (now) => now.step === now.steps);
  assert.equal(await dashes(all), 0);
  assert.equal(Object.keys(await numbers(all)).length, 8);
});

test("a lesson that asks for nothing has no such tab", async (t) => {
  const page = await visit(t, "?lesson=swept-overlap");
  await still(page);
  assert.deepEqual((await state(page)).stored, []);
  assert.equal(await page.locator("#side-tabs-tab-stored").isVisible(), false);
  assert.equal(await page.locator("#tab-stored").isVisible(), false);
});
