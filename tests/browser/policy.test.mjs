// The page's content-security policy: nothing but its own files, no inline script or style, no evaluated text.
import { after, before, test } from "node:test";
import { kFirst, assert, kinds, load, start, state, stop, until } from "./support.mjs";

let site;
before(async () => (site = await start()));
after(stop);

const watch = () => {
  window.refused = [];
  addEventListener("securitypolicyviolation", ({ effectiveDirective, blockedURI }) =>
    window.refused.push(`${effectiveDirective}: ${blockedURI}`),
  );
};

test("the policy allows the page's own files and WebAssembly, and no more", async () => {
  const html = await (await fetch(site.url)).text();
  const [, content] = /<meta http-equiv="Content-Security-Policy" content="([^"]*)">/.exec(html);
  const policy = Object.fromEntries(
    content
      .split(";")
      .map((part) => part.trim().split(" "))
      .map(([name, ...sources]) => [name, sources.join(" ")]),
  );
  assert.equal(policy["default-src"], "'none'");
  assert.equal(policy["script-src"], "'self' 'wasm-unsafe-eval'");
  for (const name of Object.keys(policy).filter((each) => !["default-src", "script-src"].includes(each)))
    assert.match(policy[name], /^'(self|none)'$/, name);
  assert.ok(html.indexOf("Content-Security-Policy") < html.search(/<script|<link/), "it stands before what it is of");
  assert.doesNotMatch(html, /<script(?![^>]*\ssrc=)|<style|\s(style|on\w+)=/, "nothing is inline");
});

test("no kind of lesson runs against the policy, stepped and saved", async (t) => {
  const page = await load(t, kFirst, { init: watch });
  for (const { id } of await kinds()) {
    await page.evaluate((query) => window.snug.restart(query), `?lesson=${id}`);
    for (const key of ["Home", "PageDown", "PageDown", "PageDown", "End"]) await page.keyboard.press(key);
    await page.locator("#theme").click();
    await page.locator("#share").click();
    await page.locator("dialog").getByRole("button", { name: "Close" }).click();
    assert.deepEqual(await page.evaluate(() => window.refused), [], id);
  }
});

test("results are saved under the policy", async (t) => {
  const page = await load(t, "?lesson=cost-chart", { init: watch });
  await page.getByRole("button", { name: "Measure", exact: true }).click(); // it asks first
  for (let i = 0; i < 3; ++i) {
    await page.getByRole("button", { name: "Skip" }).click();
    await until(page, (now, before) => now.outcomes.length > before, i);
  }
  await page.getByRole("button", { name: "Measure", exact: true }).click();
  await until(page, (now) => now.cover.table.rows.length > 0);
  const [file] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "Save as CSV" }).click(),
  ]);
  assert.match(file.suggestedFilename(), /\.csv$/);
  assert.deepEqual(await page.evaluate(() => window.refused), []);
});

test("a static host is never asked for a preview", async (t) => {
  const asked = [];
  const page = await load(t, kFirst, { wait: false });
  page.on("request", (request) => asked.push(request.url()));
  await page.reload();
  await until(page, (now) => now.framesDrawn > 0);
  await page.waitForTimeout(1000);
  assert.ok(asked.length > 5, "it asks for its files");
  assert.deepEqual(asked.filter((url) => /preview/.test(url)), []);
  assert.ok(await page.locator("#strip").isHidden());
});

const kForeign = {
  "an inline script": () =>
    document.body.append(Object.assign(document.createElement("script"), { textContent: "window.came = 1" })),
  "a handler in the HTML": () =>
    document.body.insertAdjacentHTML("beforeend", '<img src="nothing.png" onerror="window.came = 1">'),
  "an inline style": () =>
    document.head.append(Object.assign(document.createElement("style"), { textContent: "body { display: none }" })),
  "evaluated text": () => setTimeout("window.came = 1"),
  "a script of another host": () =>
    document.body.append(Object.assign(document.createElement("script"), { src: "http://127.0.0.1:9/x.js" })),
  "a question to another host": () => void fetch("http://127.0.0.1:9/x").catch(() => {}),
};
test("what is not the page's own is refused", async (t) => {
  const page = await load(t, kFirst, {
    init: watch,
    may_complain: /Content Security Policy|violates|404|127\.0\.0\.1:9/,
  });
  for (const [name, act] of Object.entries(kForeign)) {
    await page.evaluate(() => (window.refused = []));
    await page.evaluate(act);
    await page
      .waitForFunction(() => window.refused.length > 0, null, { timeout: 5000 })
      .catch(() => assert.fail(`${name} is refused`));
    await page.waitForTimeout(100);
    assert.equal(await page.evaluate(() => window.came), undefined, name);
    assert.ok(await page.locator("#title").isVisible(), name);
    assert.ok((await state(page)).steps > 0, name);
  }
});
