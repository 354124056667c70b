// What is kept on the device, read from a storage that is damaged, forbidden or full. How the page goes on then is
// tested in tests/browser/kept.test.mjs.
import assert from "node:assert/strict";
import { test } from "node:test";
import { unpack, whole_text } from "../../web/page/course_text.js";
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
const kData = { version: 1, count: 0, last: "a", invited: 3, lessons: { a: kEntry }, exercises: {}, student: "" };
const kAttempt = { exercise: "e", hash: "0f", seed: 7, decisions: ["p1@0.5"], hints: 0, mark: 1, of: 4, seconds: 2 };

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
    const now = { ...kData, count: 1, invited: 0, lessons: { a: kWhole } };
    assert.deepEqual(JSON.parse(texts.get("snug-course") ?? ""), now);
  });

test("an entry that cannot be understood is set aside, a damaged place in a question counts as none", () => {
  const lessons = { a: { ...kEntry, told: 7, tried: { question: "q", choices: "x" } }, b: { address: 3 }, c: null };
  storage(JSON.stringify({ version: 1, last: 7, invited: "x", lessons }).replace('"b"', '"__proto__":{},"b"'));
  const kept = new Kept();
  assert.deepEqual([kept.last, kept.invited, kept.set_aside], [null, 0, true]);
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
  assert.deepEqual(JSON.parse(texts.get("snug-course") ?? ""), { ...kData, count: 2, last: null, lessons: {} });
});

test("an attempt is kept until it is finished; then it counts once, and the best stays", () => {
  storage();
  const kept = new Kept();
  assert.equal(kept.exercise("e"), null);
  kept.keep_exercise(kAttempt, false);
  assert.deepEqual(new Kept().exercise("e"), { tries: 0, best: null, now: kAttempt, at: 1 });
  assert.deepEqual(kept.attempts, []);
  const good = { ...kAttempt, mark: 3 };
  kept.keep_exercise(good, true);
  for (const attempt of [good, { ...kAttempt, mark: 2 }]) kept.keep_exercise(attempt, true, false);
  assert.deepEqual(kept.exercise("e"), { tries: 1, best: good, now: null, at: 2 });
  kept.keep_exercise(kAttempt, false);
  kept.keep_exercise(kAttempt, true);
  kept.keep_student("A name");
  assert.deepEqual(new Kept().exercise("e"), { tries: 2, best: good, now: null, at: 4 });
  assert.deepEqual(new Kept().attempts, [good]);
  kept.erase();
  assert.deepEqual([kept.exercise("e"), kept.student], [null, "A name"]);
});

test("what was kept before there were exercises is kept; an attempt that cannot be understood is none", () => {
  storage(JSON.stringify({ ...kData, exercises: undefined, student: undefined }));
  assert.deepEqual([new Kept().lesson("a"), new Kept().exercise("e"), new Kept().student], [kWhole, null, ""]);
  const wrong = [{ seed: -1 }, { mark: null }, { decisions: [7] }, { hash: 3 }].map((it) => ({ ...kAttempt, ...it }));
  for (const now of [...wrong, null, 7]) {
    storage(JSON.stringify({ ...kData, exercises: { e: { tries: 1, best: kAttempt, now }, f: { best: kAttempt } } }));
    assert.deepEqual(new Kept().exercise("e"), { tries: 1, best: kAttempt, now: null, at: 0 });
    assert.equal(new Kept().exercise("f"), null);
  }
});

test("what two places keep is joined: the newer attempt goes on, the best and whole one stays", () => {
  storage();
  const kept = new Kept();
  const [own, other] = [{ ...kAttempt, seed: 1 }, { ...kAttempt, seed: 2 }];
  kept.keep_exercise({ ...own, mark: 3 }, true);
  kept.keep_exercise(own, false);
  const from = (entry) => ({ count: 9, lessons: { a: kWhole }, exercises: { e: entry } });
  kept.merge(from({ tries: 4, best: { ...other, mark: 2 }, now: other, at: 1 }));
  assert.deepEqual(kept.exercise("e"), { tries: 4, best: { ...own, mark: 3 }, now: own, at: 2 });
  kept.merge(from({ tries: 1, best: { ...other, mark: 3, decisions: [] }, now: other, at: 7 }));
  assert.deepEqual(kept.exercise("e"), { tries: 4, best: { ...own, mark: 3 }, now: other, at: 7 });
  assert.deepEqual([kept.lesson("a"), kept.data.count], [kWhole, 11]);
});

test("a lesson that was done elsewhere is done, and goes on where it stands here", () => {
  storage(JSON.stringify(kData));
  const kept = new Kept();
  const done = { ...kWhole, address: "", step: 0, answered: 4, done: true, task: true };
  kept.merge({ count: 0, lessons: { a: done }, exercises: {} });
  assert.deepEqual(kept.lesson("a"), { ...kWhole, answered: 4, done: true, task: true });
});

test("code that is typed is kept, and is no news for a course's site", () => {
  storage();
  const kept = new Kept();
  const typed = (/** @type {string} */ code) => ({ ...kAttempt, mark: 0, decisions: [`w${code}`] });
  kept.keep_exercise(typed("a"), false);
  kept.keep_exercise(typed("ab"), false);
  assert.deepEqual([kept.exercise("e")?.now, kept.exercise("e")?.at], [typed("ab"), 0]);
  kept.keep_exercise({ ...typed("ab"), mark: 2 }, true);
  assert.ok((kept.exercise("e")?.at ?? 0) > 0);
});

test("what came back and is kept again as it was is no change", () => {
  storage();
  const kept = new Kept();
  kept.move_to("frame", { reads: true });
  const { exercises } = unpack(whole_text(4, 1, "|e~3~0~~0f_7_0_1_4_p1@0.5~")) ?? { exercises: {} };
  kept.merge({ count: 4, lessons: {}, exercises });
  const { count } = kept.data;
  kept.keep_exercise({ ...kAttempt, seconds: 0.5 }, false);
  assert.deepEqual([kept.exercise("e")?.at, kept.data.count], [3, count]);
});

test("a package keeps under its own name; where it may only read nothing stays, and a mark alone is no result", () => {
  const texts = storage(JSON.stringify(kData));
  const kept = new Kept();
  kept.move_to("set.x.1", { name: "Lamarr, Hedy" });
  assert.deepEqual([kept.lesson("a"), kept.student], [null, "Lamarr, Hedy"]);
  kept.keep_exercise(kAttempt, true);
  assert.deepEqual([...texts.keys()], ["snug-course", "snug-course.set.x.1"]);
  kept.move_to("set.x.1", { reads: true });
  kept.keep_exercise({ ...kAttempt, exercise: "f", decisions: [] }, true);
  assert.deepEqual([kept.works, kept.attempts], [false, [kAttempt]]);
  kept.move_to("set.x.1");
  assert.equal(kept.exercise("f"), null);
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
