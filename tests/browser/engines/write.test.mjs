// Code that a student writes, in Firefox and in WebKit: the same code gets the same mark as in `snug grade`, which runs
// it under Node. What else there is to such exercises is tested in Chromium. Needs a screen and a session bus.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { snug } from "../package_support.mjs";
import { serve_site } from "../support.mjs";
import * as firefox from "./firefox.mjs";
import * as webkit from "./webkit.mjs";

const kPatience = 60_000; // milliseconds
const kId = "write:sat";
// The result file of a usual mistake, whose mark `snug exercise answer` has from the engine under Node.
const { attempts: [answer] } = JSON.parse(snug("exercise", "answer", kId, "--wrong", "1"));

let site;
before(async () => (site = await serve_site()));
after(() => site?.close());

for (const [name, driver] of Object.entries({ Firefox: firefox, WebKit: webkit }))
  describe(name, () => {
    let engine;
    before(async () => (engine = await driver.launch(1280, 800)), { timeout: 120_000 });
    after(() => engine?.close());

    test(`${name}: the same code gets the same mark`, { timeout: 120_000 }, async () => {
      const until = async (expression, what) => {
        for (const late = Date.now() + kPatience; Date.now() < late;) {
          if (await engine.evaluate(expression)) return;
          await new Promise((later) => setTimeout(later, 100));
        }
        assert.fail(`waited in vain until ${what}`);
      };
      // The code is taken up as a draft that was typed before.
      const exercises = { [kId]: { tries: 0, best: null, now: answer, at: 1 } };
      const kept = { version: 1, count: 1, last: null, invited: 3, student: "", lessons: {}, exercises };
      await engine.open(`${site.url}icon.svg`);
      await engine.evaluate(`localStorage.setItem("snug-course", ${JSON.stringify(JSON.stringify(kept))})`);
      await engine.open(`${site.url}?exercise=${encodeURIComponent(kId)}`);
      await until('Boolean(document.querySelector(".write-actions"))', "the exercise is there");
      await engine.evaluate('document.querySelector(".write-actions .primary").click()');
      await until('Boolean(document.querySelector(".write-methods"))', "the code has run");
      const { mark, of } = await engine.evaluate("snug.exercise()");
      assert.deepEqual([mark, of], [answer.mark, answer.of]);
    });
  });
