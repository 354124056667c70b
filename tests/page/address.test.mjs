// What an address asks the page for. The place that it names is read and written in the core (place.test.cpp).
import assert from "node:assert/strict";
import { test } from "node:test";
import { exercise_link, read_address, with_pair } from "../../web/page/address.js";

const kNothing = read_address("");

for (const [query, says] of Object.entries({
  "exercise=a&seed=-4": /seed "-4"/, "state=1.5": /state "1.5"/, "level=9007199254740993": /level "9007199254740993"/,
}))
  test(`of a wrong address (${query}) the mistake is left out and told`, () => {
    const { problems, ...asked } = read_address(`?${query}`);
    assert.equal(problems.length, 1);
    assert.match(problems[0], says);
    const exercise = query.startsWith("exercise") ? "a" : null;
    assert.deepEqual({ ...asked, problems: [] }, { ...kNothing, place: `?${query}`, exercise });
  });

test("a lesson's place is left to the core, its seed with it", () => {
  const search = "?lesson=a%20lesson&seed=-4&step=x&embed=1";
  assert.deepEqual(read_address(search), { ...kNothing, lesson: "a lesson", place: search, embed: true });
});

test("of an exercise the instance is written, and level and practice where they are not as usual", () => {
  assert.equal(exercise_link("a b", { seed: 4294967295 }), "?exercise=a%20b&seed=4294967295");
  const address = exercise_link("a", { seed: 7, level: 2, practice: true });
  assert.equal(address, "?exercise=a&seed=7&level=2&practice=1");
  const { exercise, seed, level, practice } = read_address(address);
  assert.deepEqual({ exercise, seed, level, practice }, { exercise: "a", seed: 7, level: 2, practice: true });
});

test("one more key stands before what is packed", () => {
  assert.equal(with_pair("?lesson=a", "embed=1"), "?lesson=a&embed=1");
  assert.equal(with_pair("?lesson=a#packed=xy", "embed=1"), "?lesson=a&embed=1#packed=xy");
});
