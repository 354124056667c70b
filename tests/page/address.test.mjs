// The address as it is read and written, and what it says of an edited text. What the program makes of it is tested in
// tests/browser/address.test.mjs.
import assert from "node:assert/strict";
import { test } from "node:test";
import { read_address, write_address } from "../../web/page/address.js";
import { change_of, changed } from "../../web/page/text_change.js";

const kWrong = {
  "step=abc": /step “abc”/,
  "seed=-4": /seed “-4”/,
  "step=9007199254740993": /step “9007199254740993”/,
  "rows=1,2;x,4": /numbers that the address gives as rows/,
  "moved=1,,2": /numbers that the address gives as moved/,
  "from=%3Cb%3E": /points that do not exist/,
  "from=cube:0": /points that do not exist/,
  "scalar=half": /neither float nor double/,
};
const kNothing = read_address("");

for (const [query, says] of Object.entries(kWrong))
  test(`of a wrong address (${query}) the mistake is left out and told`, () => {
    const { problems, ...asked } = read_address(`?lesson=a&${query}`);
    assert.equal(problems.length, 1);
    assert.match(problems[0], says);
    assert.deepEqual({ ...asked, problems: [] }, { ...kNothing, lesson: "a" });
  });

test("rows of numbers are read, by their names of old too", () => {
  for (const name of ["rows", "points", "boxes"])
    assert.deepEqual(read_address(`?${name}=0,0;4.125,-1e-3`).rows, [[0, 0], [4.125, -0.001]]);
  assert.deepEqual(read_address("?slide=1,2.5").slide, [1, 2.5]);
  assert.deepEqual(read_address("?camera=30,20,4,0,0,1").camera, [30, 20, 4, 0, 0, 1]);
});

const kLesson = /** @type {Lesson} */ ({
  id: "a lesson",
  situations: [],
  algorithms: [{ name: "welzl", title: "Welzl", source: "", maxPoints: 0 }],
  compare: "",
  scalar: "double",
});
const kView = /** @type {View} */ ({
  previewing: false,
  step: 3,
  seed: 7,
  situation: null,
  algorithm: "welzl",
  beside: null,
  scalar: null,
  file: null,
  exercise: null,
});

test("what differs from the lesson's own is written, and read again as it was", () => {
  assert.equal(write_address(kView, kLesson, {}, false), "?lesson=a%20lesson&step=3&seed=7");
  assert.equal(write_address({ ...kView, previewing: true }, kLesson, {}, true), "?lesson=a%20lesson&seed=7&embed=1");
  const file = { own: "one\ntwo", runs: "one\n2 & 3", typed: "one\n2 & ", heading: "", mistakes: [] };
  const view = { ...kView, algorithm: "ritter", beside: "pca", scalar: /** @type {Scalar} */ ("float"), file };
  const moved = [[0, 1.5, -2]];
  const asked = read_address(write_address(view, kLesson, { how: "cube:20", slide: [0.5], moved }, false));
  const own = { lesson: "a lesson", step: 3, seed: 7, a: "ritter", b: "pca", scalar: "float" };
  const { file: runs, draft } = asked;
  assert.deepEqual(asked, { ...kNothing, ...own, from: "cube:20", slide: [0.5], moved, file: runs, draft });
  assert.equal(changed(file.own, runs), file.runs);
  assert.equal(changed(file.runs, draft), file.typed);
});

test("of an exercise the instance is written, and no place in it", () => {
  const view = { ...kView, exercise: /** @type {ShownExercise} */ ({ seed: 4294967295 }) };
  assert.equal(write_address(view, kLesson, { rows: [[1]] }, false), "?exercise=a%20lesson&seed=4294967295");
  const { seed, ...asked } = read_address(write_address(view, kLesson, {}, true));
  assert.equal(seed, 4294967295);
  assert.deepEqual({ ...asked, seed: null }, { ...kNothing, exercise: "a lesson", embed: true });
});

test("of an exercise the level and practice are written where they are not as usual", () => {
  const view = { ...kView, exercise: /** @type {ShownExercise} */ ({ seed: 7, level: 2, practises: true }) };
  const address = write_address(view, kLesson, { rows: [] }, false);
  assert.equal(address, "?exercise=a%20lesson&seed=7&level=2&practice=1");
  const { level, practice } = read_address(address);
  assert.deepEqual([level, practice], [2, true]);
});

test("a change of a text leads from one to the other; of another text it is refused", () => {
  for (const [from, to] of [["", "abc"], ["abc", ""], ["aaa", "aa"], ["abcabc", "abcXabc"], ["ä\nb", "ä\nc"]])
    assert.equal(changed(from, change_of(from, to)), to);
  assert.equal(change_of("same", "same"), "");
  assert.equal(changed("short", "4-3-x"), null);
  for (const wrong of ["", "x", "1-2", "-1-2-x"]) assert.equal(changed("text", wrong), null);
});
