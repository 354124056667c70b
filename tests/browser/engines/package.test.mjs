// Packages in Firefox and in WebKit: on two courses' sites, as one file without a server, and in a frame of a page of
// another origin. What else there is to packages is tested in Chromium. Needs a screen and a session bus.
import assert from "node:assert/strict";
import { once } from "node:events";
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { after, before, describe, test } from "node:test";
import { answers_of, kept_before, kSite, model_of, serve_packages, snug, workshop } from "../package_support.mjs";
import { serve_site } from "../support.mjs";
import * as firefox from "./firefox.mjs";
import * as webkit from "./webkit.mjs";

const kPatience = 25_000; // milliseconds
const kQuick = "be-quickhull";
const kFramed = "aabb-overlap";
const kKinds = ["strict", "worst"];
const [, kPage] = /```html\n([^]*?)```/.exec(readFileSync(new URL("../../../web/README.md", import.meta.url), "utf8"));
const shop = workshop();
let host, site, other;
before(async () => {
  for (const what of [`exercise:${kQuick}`, "set:collision", "lesson:aabb", "course"])
    shop.unpacked(what, what.split(":")[0]);
  shop.replaced("replaced");
  snug("package", `exercise:${kQuick}`, "--single", shop.at("single.html"), "--site", kSite);
  [host, site] = await Promise.all([serve_packages(shop.at("")), serve_site()]);
  for (const kind of kKinds) // two courses' sites beside each other, on one device
    host.texts[`two_${kind}.html`] = `<!doctype html>${`<iframe src="lms.html?site=${kind}"></iframe>`.repeat(2)}`;
  // No script reaches into a frame of another origin, and WebKit's driver no key: this one decides by itself.
  site.add.set("decides.js", `const answers = ${JSON.stringify(answers_of(kFramed, 4))};
    setInterval(() => {
      const at = window.snug?.state()?.asked && window.snug.exercise().decision;
      if (Number.isInteger(at)) document.querySelectorAll(".ask .choices .button")[answers[at]].click();
    }, 100);`);
  const page = await (await fetch(site.url)).text();
  site.add.set("index.html", page.replace("</head>", '<script src="decides.js"></script></head>'));
  const framed = kPage.replace(/src="[^"]*"/, `src="${site.url}?exercise=${kFramed}&seed=4&embed=1"`);
  other = createServer((_, answer) => answer.writeHead(200, { "Content-Type": "text/html" }).end(framed));
  await once(other.listen(0, "127.0.0.1"), "listening");
});
after(() => {
  for (const server of [host, site, other]) server?.close();
  shop.remove();
});

for (const [name, driver] of Object.entries({ Firefox: firefox, WebKit: webkit })) {
  describe(name, () => {
    let engine;
    before(async () => (engine = await driver.launch(1280, 800)), { timeout: 120_000 });
    after(() => engine?.close());
    const ask = (expression) => engine.evaluate(expression);
    async function until(expression, what) {
      const wait = (ms) => new Promise((later) => setTimeout(later, ms));
      // WebKit's driver never answers what was asked while a page with a frame was loading.
      for (const late = Date.now() + kPatience; Date.now() < late; await wait(50))
        if (await Promise.race([ask(expression).catch(() => false), wait(4000)])) return;
      assert.fail(`waited in vain until ${what}`);
    }
    /** lms.NAME(...given) */
    const lms = (own, ...given) => ask(`lms.${own}(...${JSON.stringify(given)})`);

    for (const kind of kKinds)
      test(`${name}: a ${kind} site gets the score, gives back the decision`, { timeout: 90_000 }, async () => {
        await engine.open(`${host.url}lms.html?site=${kind}`);
        await until("Boolean(window.lms)", "the course's site is there");
        await ask("localStorage.clear()");
        const { seed } = await lms("open", "exercise/");
        const answers = answers_of(kQuick, seed);
        await lms("decide_all", answers.slice(0, 2));
        await lms("state", "course");
        await lms("close");
        await ask("localStorage.clear()");
        assert.equal((await lms("open", "exercise/")).decision, 2);
        assert.equal(await lms("says"), "Seen again in your course");
        await lms("decide_all", answers.slice(2), 2);
        await lms("finished");
        await lms("close");
        await comes_to(kind, "exercise", 100);
      });

    /** Opens a package and leaves it until the site has given everything back. */
    async function see_again(of) {
      for (let starts = 0, saved = ""; saved !== "seen" && starts < 4; ++starts) {
        await lms("open", `${of}/`);
        saved = await lms("saved");
        if (saved !== "seen") await lms("state", "course");
        await lms("close");
      }
    }

    /** Puts what a device has kept of a package's student there. */
    function fill(kind, of, kept) {
      const whole = JSON.stringify({ version: 1, count: 50, last: null, invited: 3, student: "", ...kept });
      const key = `snug-course.${of}${kind === "strict" ? ".6tsxic" : ""}`;
      return ask(`localStorage.setItem(${JSON.stringify(key)}, ${JSON.stringify(whole)})`);
    }

    async function comes_to(kind, of, score) {
      await see_again(of);
      assert.deepEqual(await ask("lms.site.arrived"), { score, status: "completed" }, `${of}, ${kind}`);
      assert.deepEqual(await ask("lms.site.broken"), []);
    }

    test(`${name}: a set, a lesson and the course are finished on both`, { timeout: 90_000 }, async () => {
      const lesson = { address: "?lesson=x", answers: "", answered: 1, step: 1, steps: 2, done: true, task: true };
      for (const of of ["set", "lesson", "course"]) {
        const { package: own } = JSON.parse(readFileSync(`${shop.at(of)}/course.json`, "utf8"));
        const exercises = own.exercises.map((id, i) => [id, { tries: 1, best: model_of(id), now: null, at: i + 1 }]);
        const lessons = own.lessons.map((id) => [id, lesson]);
        const kept = { exercises: Object.fromEntries(exercises), lessons: Object.fromEntries(lessons) };
        for (const kind of kKinds) {
          await engine.open(`${host.url}lms.html?site=${kind}&of=${of}`);
          await until("Boolean(window.lms)", "the course's site is there");
          await fill(kind, own.name, kept);
          await comes_to(kind, of, of === "lesson" ? null : 100);
        }
      }
    });

    test(`${name}: two tabs do not overwrite each other, on either site`, { timeout: 120_000 }, async () => {
      for (const kind of kKinds) {
        await engine.open(`${host.url}two_${kind}.html`);
        await until("frames.length === 2 && frames[0].lms && frames[1].lms", "both sites are there");
        await ask("localStorage.clear()");
        const tab = (at, own, ...given) => ask(`frames[${at}].lms.${own}(...${JSON.stringify(given)})`);
        for (const at of [0, 1]) await tab(at, "open", "set/");
        for (const [at, id] of ["be-aabb-centre", "be-ritter"].entries()) {
          const { seed } = await tab(at, "go", `?exercise=${id}`);
          await tab(at, "decide_all", answers_of(id, seed).slice(0, 1));
        }
        await tab(1, "close");
        await tab(0, "close"); // the last to hand over has what both did, and had it before it was closed
        await tab(0, "open", "set/");
        if ((await tab(0, "saved")) !== "seen") await tab(0, "state", "course");
        await tab(0, "close");
        await ask("localStorage.clear()");
        await tab(0, "open", "set/");
        for (const id of ["be-aabb-centre", "be-ritter"])
          assert.equal((await tab(0, "go", `?exercise=${id}`)).decision, 1, `${id}, ${kind}`);
      }
    });

    test(`${name}: a package that was replaced keeps what fits`, { timeout: 90_000 }, async () => {
      for (const kind of kKinds) {
        await engine.open(`${host.url}lms.html?site=${kind}&of=replaced`);
        await until("Boolean(window.lms)", "the course's site is there");
        await ask("localStorage.clear()");
        await fill(kind, "set.geometry", { exercises: kept_before() });
        await lms("open", "replaced/");
        assert.match(await lms("notices"), /replaced this package, now without be-welzl/);
        assert.equal((await lms("go", `?exercise=${kQuick}`)).decision, 0);
        assert.match(await lms("notices"), /changed since you began it.*Your best mark stays/);
        await lms("close");
        await see_again("replaced");
        assert.equal(await ask("lms.site.arrived.score"), 19.4); // of nine exercises the one, and 3/4 of another
        assert.deepEqual(await ask("lms.site.broken"), []);
      }
    });

    test(`${name}: one file opens without a server, is drawn and decided`, { timeout: 60_000 }, async () => {
      await engine.open(`file://${shop.at("single.html")}`);
      await until("window.snug?.state()?.asked && snug.state().framesDrawn > 0", "the exercise is drawn");
      assert.match(await ask("location.search"), /^[?]exercise=be-quickhull/);
      const { seed } = await ask("snug.exercise()");
      const [answer] = answers_of(kQuick, seed);
      await ask(`(document.querySelector(".ask input").value = ${JSON.stringify(answer)},
        document.querySelector(".ask form").requestSubmit())`);
      await until("snug.exercise().decision === 1", "it is decided");
      assert.equal(await ask("snug.exercise().mark"), 1);
    });

    test(`${name}: a frame of another origin tells its mark`, { timeout: 60_000 }, async () => {
      await engine.open(`http://127.0.0.1:${other.address().port}/`);
      await until(`JSON.parse(localStorage.getItem("snug") ?? "{}").score === 1`, "the page has collected every mark");
      assert.match(await ask(`JSON.parse(localStorage.getItem("snug")).state`), /aabb-overlap/);
    });
  });
}
