// The gallery of hard cases: its list is fetched when it is opened, and each case opens on the stage in one click.
import { after, before, test } from "node:test";
import { assert, kPhone, load, start, stop, until } from "./support.mjs";

let site;
before(async () => (site = await start()));
after(stop);

async function listed(page) {
  await page.waitForSelector("#cases li");
  return page.$$eval("#cases li > a", (links) =>
    links.map((link) => ({
      id: new URL(link.href).searchParams.get("lesson"),
      title: link.querySelector("b").textContent,
      says: link.querySelector("span").textContent,
    })),
  );
}

test("the list comes when the gallery is opened, and not before", async (t) => {
  site.sent.clear();
  const page = await load(t, "");
  await page.waitForLoadState("networkidle");
  assert.ok(!site.sent.has("cases.json"));
  await page.locator("#gallery summary").click();
  const cases = await listed(page);
  assert.ok(site.sent.has("cases.json"));
  assert.ok(cases.length >= 25, `${cases.length} cases`);
  assert.ok(cases.every(({ title, says }) => title && says.endsWith(".")));
  assert.equal(new Set(cases.map(({ id }) => id)).size, cases.length);
  const addresses = await page.$$eval("#cases .label a", (links) =>
    links.map(({ href, textContent }) => [href, textContent]),
  );
  assert.ok(addresses.length >= 10);
  for (const [href, words] of addresses)
    assert.ok(/^https:\/\/\S+$/.test(href) && words.length > 20 && !words.includes("https:"), `${href} ${words}`);
});

test("a click opens a case, Back leads to the open gallery, and neither is kept as a lesson begun", async (t) => {
  const page = await load(t, "");
  await page.locator("#gallery summary").click();
  const cases = await listed(page);
  await page.locator("#cases li > a").first().click();
  const opened = await until(page, (now) => now.lesson !== null);
  assert.equal(opened.lesson, cases[0].id);
  assert.equal(opened.step, 0);
  assert.equal(await page.locator("#picker-group").textContent(), "Hard cases");
  await page.locator("#prose p", { hasText: cases[0].says }).waitFor();
  await page.keyboard.press("End");
  assert.ok(
    (await until(page, (now) => now.step === now.steps)).readout.outside_count > 0,
    "the naive circle leaves points outside",
  );
  await page.goBack();
  await until(page, (now) => now.lesson === null);
  assert.ok(await page.locator("#cases li").first().isVisible());
  assert.equal(await page.locator("#start").textContent(), "Start here");
});

test("every case opens by its address alone and runs to its end", async (t) => {
  const page = await load(t, "");
  await page.locator("#gallery summary").click();
  const cases = await listed(page);
  for (const { id } of cases) {
    await page.evaluate((one) => window.snug.restart(`?lesson=${one}&step=0`), id);
    const { steps } = await until(page, (now, asked) => now.lesson === asked && now.steps > 0, id);
    await page.keyboard.press("End");
    const end = await until(page, (now) => now.step === now.steps);
    assert.equal(end.step, steps, id);
    assert.ok(end.caption.length > 0, id);
  }
});

test("an address of neither a lesson nor a case offers the lessons", async (t) => {
  const page = await load(t, "?lesson=no-such-case", { wait: false });
  await page.getByText("There is no lesson “no-such-case”.").waitFor();
});

test("a finger opens it on a phone, and nothing is wider than the screen", async (t) => {
  const page = await load(t, "", kPhone);
  await page.locator("#gallery summary").tap();
  await listed(page);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  await page.locator("#cases li > a").nth(3).tap();
  const { lesson } = await until(page, (now) => now.lesson !== null);
  assert.ok(lesson);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
});
