// What the notes say comes next, and a picture that is cut out. How the page plays a demo is tested in
// tests/browser/demo.test.mjs.
import assert from "node:assert/strict";
import { test } from "node:test";
import { next_text } from "../../web/page/demo_text.js";
import { cut_out } from "../../web/page/picture_bytes.js";

test("the notes say what is left to reveal, and what the next state is about", () => {
  /** @type {any} */
  const file = { states: [{ slide: "One", reveal: ["answer", "numbers"] }, { slide: "Two", reveal: ["steps"] }] };
  const next = (at, revealed) => next_text(file, { at, revealed });
  assert.equal(next(0, 0), "Next: the answer, then the numbers. After that: Two");
  assert.equal(next(0, 1), "Next: the numbers. After that: Two");
  assert.equal(next(0, 2), "Next: Two");
  assert.equal(next(1, 0), "Next: the steps, played. This is the last state.");
  assert.equal(next(1, 1), "This is the last state.");
});

test("a picture without a ground has the opacity by which it looks otherwise over black than over white", () => {
  const over = (ground) => Uint8ClampedArray.from([
    ...[ground, ground, ground, 255], // nothing
    ...[10, 95, 191, 255], // a colour
    ...[100, 50, 0].map((channel) => channel + ground * 0.6), 255, // another, of which two fifths are opaque
  ]);
  assert.deepEqual([...cut_out(over(0), over(255))], [0, 0, 0, 0, 10, 95, 191, 255, 250, 125, 0, 102]);
});
