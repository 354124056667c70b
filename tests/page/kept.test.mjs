// What is kept on the device, read from a storage that is damaged, forbidden or full. How the page goes on then is
// tested in tests/browser/kept.test.mjs.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Kept } from "../../web/page/kept.js";

const kEntry = {
  address: "?lesson=a&step=2&seed=143",
  answers: "",
  answered: 0,
  step: 2,
  steps: 21,
  done: false,
  task: false,
};
const kWhole = { ...kEntry, told: null, tried: null };
const kData = { version: 1, last: "a", invited: 3, lessons: { a: kEntry } };

/** A storage that holds a text. wrong: what it throws. */
function storage(text = /** @type {string | null} */ (null), wrong = {}) {
  const texts = new Map(text === null ? [] : [["snug-course", text]]);
  const own = {
    getItem: (/** @type {string} */ key) => texts.get(key) ?? null,
    setItem: (/** @type {string} */ key, /** @type {string} */ value) => void texts.set(key, value),
    ...wrong,
  };
  Object.defineProperty(globalThis, "localStorage", { value: own, configurable: true });
  return texts;
}

for (const text of ["{", "[1, 2]", '"x"', "{}"])
  test(`of ${text} nothing is a version's: it is set aside as it was, and all starts anew`, () => {
    const texts = storage(text);
    const kept = new Kept();
    assert.deepEqual([kept.works, kept.set_aside, kept.last, kept.lesson("a")], [true, true, null, null]);
    assert.equal(texts.get("snug-course-damaged"), text);
    kept.keep_lesson("a", kWhole);
    assert.deepEqual(JSON.parse(texts.get("snug-course") ?? ""), { ...kData, invited: 0, lessons: { a: kWhole } });
  });

test("an entry that cannot be understood counts as not begun, a damaged place in a question as none", () => {
  const lessons = { a: { ...kEntry, told: 7, tried: { question: "q", choices: "x" } }, b: { address: 3 }, c: null };
  storage(JSON.stringify({ version: 1, last: 7, invited: "x", lessons }).replace('"b"', '"__proto__":{},"b"'));
  const kept = new Kept();
  assert.deepEqual([kept.last, kept.invited, kept.set_aside], [null, 0, false]);
  assert.deepEqual(kept.lesson("a"), kWhole);
  for (const id of ["b", "c", "__proto__", "toString"]) assert.equal(kept.lesson(id), null);
  storage('{"version":1}');
  assert.equal(new Kept().lesson("a"), null);
});

test("what was tried and told is kept; erased, the invitations stay followed", () => {
  const texts = storage(JSON.stringify(kData));
  const kept = new Kept();
  const entry = { ...kWhole, told: "q", tried: { question: "q", choices: [1], handle: null } };
  kept.keep_lesson("b", entry);
  assert.deepEqual(new Kept().lesson("b"), entry);
  assert.equal(new Kept().last, "b");
  kept.keep_invited(2);
  kept.erase();
  assert.deepEqual(JSON.parse(texts.get("snug-course") ?? ""), { version: 1, last: null, invited: 3, lessons: {} });
});

test("a later version's storage is left as it is", () => {
  const later = '{"version":99,"what":"ever"}';
  const texts = storage(later);
  const kept = new Kept();
  kept.keep_lesson("a", kWhole);
  assert.deepEqual([kept.works, texts.get("snug-course"), kept.lesson("a")], [false, later, kWhole]);
});

const refuse = () => {
  throw new Error("no");
};
for (const [name, wrong] of Object.entries({ forbidden: { getItem: refuse }, full: { setItem: refuse } }))
  test(`${name} storage: the place is known until the page is closed`, () => {
    storage(null, wrong);
    const kept = new Kept();
    kept.keep_lesson("a", kWhole);
    assert.deepEqual([kept.works, kept.lesson("a")], [false, kWhole]);
  });
