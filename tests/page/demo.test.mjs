// A state as it is recorded on the page. How the page plays a demo is tested in tests/browser/demo.test.mjs.
import assert from "node:assert/strict";
import { test } from "node:test";
import { state_text } from "../../web/page/demo_text.js";

// demo_keys.json
/** @type {any} */
const kKeys = [["lesson", "lesson", false], ["situation", "situation", false], ["algorithm", "a", false],
  ["compare", "b", false], ["scalar", "scalar", false], ["seed", "seed", true], ["from", "from", false],
  ["sliders", "slide", false], ["moved", "moved", false], ["rows", "rows", false], ["packed", "packed", false],
  ["step", "step", true]];

test("what stands on the page is recorded in the words of a demo's file", () => {
  const address = "?lesson=sphere-ritter&step=3&seed=7&a=aabb_center&b=none&from=clusters:200&slide=0.5,2&moved=0,1,-2";
  assert.equal(state_text(kKeys, address, 'A "title"', "0123456789abcdef"), `[[state]]
hash = "0123456789abcdef"
slide = "A \\"title\\""
lesson = "sphere-ritter"
algorithm = "aabb_center"
compare = "none"
seed = 7
from = "clusters:200"
sliders = "0.5,2"
moved = "0,1,-2"
step = 3
shows = ["caption", "numbers", "code"]
notes = "What you say."
`);
});
