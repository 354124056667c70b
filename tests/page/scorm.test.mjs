// What is handed to a course's site: the text, the score, and a session with the strictest and the worst of them. The
// page on such sites is tested in tests/browser/package.test.mjs.
import assert from "node:assert/strict";
import { test } from "node:test";
import { is_complete, pack, score_of, unpack, whole_text } from "../../web/page/course_text.js";
import { Scorm, find_api } from "../../web/page/scorm.js";
import { Scorm12API } from "../browser/node_modules/scorm-again/dist/esm/scorm12.js";
import { WorstSite, strict } from "./lms.mjs";

const attempt = (exercise, mark, decisions = ["p8@3.4", "?c0>c2@10.1", "l1.2.3@12.0", "n-1e+20@13.5"]) => ({
  exercise, hash: "0123456789abcdef", seed: 4294967295, decisions,
  hints: decisions.join("").split("?").length - 1, mark, of: 4, seconds: Number(decisions.at(-1)?.split("@")[1] ?? 0),
});
const done = (id, mark, at = 1) => ({ tries: 1, best: attempt(id, mark), now: null, at });
const data_of = (exercises, lessons = {}) =>
  ({ version: 1, count: 7, last: null, invited: 0, lessons, exercises, student: "" });
const kNowhere = { address: "", answers: "", step: 0, steps: 0, told: null, tried: null };
const kLesson = { ...kNowhere, answered: 3, done: true, task: false };

test("the text says again what was packed, in letters that no site escapes", () => {
  const now = { ...attempt("b", 0.75, ["?@0.0"]), level: 2 };
  const exercises = { a: done("a", 2.75, 5), b: { tries: 3, best: null, now, at: 36, hides: true } };
  const { text, gave_way } = pack(data_of(exercises, { l: kLesson }), { lessons: ["l"] });
  assert.deepEqual(gave_way, []);
  assert.match(text, /^[\w~|.,?!@/-]*$/);
  const back = unpack(whole_text(7, 1, text));
  assert.equal(back.count, 7);
  const plain = attempt("a", 2.75).decisions.map((decision) => decision.replace("+", ""));
  exercises.a.best.decisions = plain;
  assert.deepEqual(back.exercises, exercises);
  assert.deepEqual(back.lessons, { l: kLesson });
  for (const damaged of ["", "x", "snug1", "snug9.1.1.", '{"a":1}']) assert.equal(unpack(damaged), null, damaged);
  assert.deepEqual(Object.keys(unpack("snug1.1.1.__proto__~1~d/|__proto__~1~1~~|").exercises), []);
  assert.deepEqual(unpack("snug1.3.1.|a~z~1~zz_1_0_1_4_p1@1~~").exercises.a.best, null);
});

test("what was built stays on the device; its mark does not", () => {
  const built = attempt("a", 3, ["?b1.5,2;3,4@61.5"]);
  const { text } = pack(data_of({ a: { tries: 1, best: built, now: built, at: 1 } }), { lessons: [] });
  const { a } = unpack(whole_text(1, 1, text)).exercises;
  assert.deepEqual([a.best.mark, a.best.decisions, a.now], [3, [], null]);
});

test("what does not fit gives way, the oldest decisions first and marks last", () => {
  const ids = Array.from({ length: 30 }, (_, i) => `exercise-${i}`);
  const long = (id, at) => ({ ...done(id, 3, at), best: attempt(id, 3, Array(20).fill("p10>p11@100.5")) });
  const exercises = Object.fromEntries(ids.map((id, i) => [id, long(id, 30 - i)]));
  const { text, gave_way } = pack(data_of(exercises), { lessons: [] });
  assert.ok(text.length <= 4000 && text.length > 3500, `${text.length}`);
  assert.deepEqual(gave_way, ids.slice(ids.length - gave_way.length).reverse());
  const back = unpack(whole_text(99999, 999, text)).exercises;
  assert.equal(back["exercise-0"].best.decisions.length, 20);
  assert.deepEqual([back["exercise-29"].best.mark, back["exercise-29"].best.decisions], [3, []]);
  // An attempt that goes on gives way before the mark of the best.
  const now = (id) => attempt(id, 1, Array(9).fill("p1@1"));
  const begun = Object.fromEntries(ids.map((id, i) => [id, { ...long(id, i), now: now(id) }]));
  const { text: less } = pack(data_of(begun), { lessons: [] }, 1800);
  const marks = Object.values(unpack(whole_text(1, 1, less)).exercises).map(({ best }) => best?.mark);
  assert.ok(less.length <= 1800 && marks.length === ids.length && marks.every((mark) => mark === 3), less);
  const { text: least } = pack(data_of(exercises), { lessons: [] }, 300);
  assert.ok(least.length <= 300 && unpack(whole_text(1, 1, least)).exercises["exercise-0"]);
});

test("the score is the mean of the best attempts, and there is none before a decision", () => {
  const of = { exercises: ["a", "b", "c"], lessons: ["l"] };
  assert.equal(score_of(data_of({}), of), null);
  const draft = { tries: 0, best: null, now: attempt("a", 0, ["wreturn 1"]), at: 0 };
  assert.equal(score_of(data_of({ a: draft }), of), null, "code is a draft until it is run");
  assert.equal(score_of(data_of({ a: { tries: 0, best: null, now: attempt("a", 0, ["??@0.0"]), at: 1 } }), of), null);
  assert.equal(score_of(data_of({ a: { tries: 0, best: null, now: attempt("a", 2), at: 1, hides: true } }), of), null);
  assert.equal(score_of(data_of({ a: { tries: 0, best: null, now: attempt("a", 2), at: 1 } }), of), 16.7);
  const all = { a: done("a", 4), b: done("b", 4), c: { ...done("c", 2), now: attempt("c", 4) }, gone: done("gone", 4) };
  assert.equal(score_of(data_of(all), of), 100);
  assert.deepEqual([is_complete(data_of(all), of), is_complete(data_of(all, { l: kLesson }), of)], [false, true]);
});

test("the API is found around a window of another origin, and by the one that opened it", () => {
  const api = {};
  const foreign = { get API() { throw new Error("blocked"); }, get opener() { throw new Error("blocked"); } };
  const top = (own) => Object.assign(own, { parent: own, top: own });
  const outer = top({ API: api });
  assert.equal(find_api({ parent: Object.defineProperty(foreign, "parent", { value: outer }) }), api);
  const inner = { opener: { parent: outer } };
  assert.equal(find_api(top(inner)), api);
  assert.equal(find_api(top({})), null);
  assert.equal(find_api(top({ get opener() { throw new Error("blocked"); } })), null);
});

/** A session, with a clock that the test moves.
 *  @param {any} api @param {{ reaches?: () => boolean | Promise<boolean> }} of */
function session(api, { reaches = () => true } = {}) {
  const clock = { now: 0, timers: [] };
  const scorm = new Scorm(api, {
    now: () => clock.now,
    later: (what, ms) => clock.timers.push({ what, at: clock.now + ms }),
    forget: (timer) => timer !== null && (clock.timers[timer - 1].what = () => {}),
    reach: async () => reaches(),
    tell: () => {},
  });
  const pass = async (ms) => {
    clock.now += ms;
    for (const timer of clock.timers)
      if (timer.at <= clock.now) {
        const { what } = timer;
        timer.what = () => {};
        what();
      }
    await new Promise(setImmediate);
  };
  return { scorm, pass, begun: scorm.begin() };
}

const arrived = ({ server }) => [Number(server["cmi.core.score.raw"]), server["cmi.core.lesson_status"]];

const wanted = (score, { at = 1, mark = score / 25, complete = false } = {}) => {
  const data = data_of({ a: { ...done("a", mark, at), tries: complete ? 1 : 0 } });
  return { count: at, body: pack(data, { lessons: [] }).text, score, complete };
};

test("scorm-again, held to SCORM 1.2's limits: incomplete, then the score, then seen again", async () => {
  const broken = [];
  const inner = new Scorm12API({ autocommit: false, logLevel: 5 });
  const first = session(strict(inner, broken));
  assert.deepEqual([first.begun.kept, inner.LMSGetValue("cmi.core.lesson_status")], [null, "incomplete"]);
  first.scorm.save({ count: 0, body: "", score: null, complete: false });
  assert.equal(inner.LMSGetValue("cmi.core.score.raw"), "");
  first.scorm.save(wanted(50));
  await first.pass(3000);
  assert.equal(first.scorm.state, "course");
  first.scorm.save(wanted(100, { at: 2, complete: true }));
  assert.equal(first.scorm.state, "device");
  first.scorm.finish();
  first.scorm.finish();
  const { cmi } = inner.renderCMIToJSONObject();
  assert.deepEqual([Number(cmi.core.score.raw), cmi.core.lesson_status], [100, "completed"]);
  const again = new Scorm12API({ autocommit: false, logLevel: 5 });
  again.loadFromJSON({ suspend_data: cmi.suspend_data, core: { score: { raw: "100" }, lesson_status: "completed" } });
  const second = session(strict(again, broken));
  assert.equal(second.begun.kept.exercises.a.best.mark, 4);
  second.scorm.save(wanted(100, { at: 2, complete: true }));
  assert.equal(second.scorm.state, "seen");
  assert.deepEqual(broken, []);
});

test("between two commits lie three seconds, and what came meanwhile goes with the second", async () => {
  const site = new WorstSite({});
  const { scorm, pass } = session(site.open());
  for (let score = 1; score <= 25; ++score) {
    scorm.save(wanted(score, { at: score }));
    await pass(100);
  }
  await pass(1000);
  assert.equal(site.requests, 2);
  assert.equal(Number(site.server["cmi.core.score.raw"]), 25);
});

test("the worst site: what it lost is set anew at the next start, until it is seen", async () => {
  const site = new WorstSite({});
  let [starts, seen] = [0, false];
  for (; !seen && starts < 5; ++starts) {
    const { scorm, pass } = session(site.open());
    for (let turn = 0; turn < 3; ++turn) { // every third request is lost, and with it what only it had
      scorm.save(wanted(100, { at: 3, complete: true }));
      seen ||= scorm.state === "seen";
      await pass(6000);
    }
    scorm.finish();
  }
  assert.ok(seen && starts > 1, `after ${starts} starts`);
  assert.deepEqual(arrived(site), [100, "completed"]);
});

test("a site that logs out says true; it is asked itself, and what it missed is sent anew", async () => {
  const site = new WorstSite({});
  const { scorm, pass } = session(site.open(), { reaches: () => !site.logged_out });
  scorm.save(wanted(25));
  await pass(0);
  assert.equal(scorm.state, "course");
  site.logged_out = true;
  scorm.save(wanted(100, { at: 2, complete: true }));
  await pass(5000);
  assert.deepEqual([scorm.state, scorm.failed, Number(site.server["cmi.core.score.raw"])], ["device", true, 25]);
  site.logged_out = false;
  for (let i = 0; i < 3 && scorm.state !== "course"; ++i) await pass(20_000);
  assert.deepEqual([scorm.state, scorm.failed], ["course", false]);
  assert.deepEqual(arrived(site), [100, "completed"]);
});

test("a site that never answers counts as one that cannot be reached, and is tried again", async () => {
  const site = new WorstSite({});
  const { scorm, pass } = session(site.open(), { reaches: () => new Promise(() => {}) });
  scorm.save(wanted(25));
  await pass(9000);
  assert.deepEqual([scorm.state, scorm.failed], ["device", false]);
  await pass(1000);
  assert.deepEqual([scorm.state, scorm.failed], ["device", true]);
  const before = site.requests;
  await pass(20_000);
  assert.ok(site.requests > before);
});

test("a score never falls; a status that a teacher gave stays", async () => {
  const site = new WorstSite({ "cmi.core.score.raw": "80", "cmi.core.lesson_status": "failed" });
  const { scorm, pass } = session(site.open());
  scorm.save(wanted(50, { complete: true }));
  await pass(6000);
  assert.deepEqual(arrived(site), [80, "failed"]);
});

test("in review and browse mode nothing is written", async () => {
  for (const mode of ["review", "browse"]) {
    const site = new WorstSite({ "cmi.core.lesson_mode": mode });
    const { scorm, pass, begun } = session(site.open());
    scorm.save(wanted(50));
    await pass(6000);
    scorm.flush();
    scorm.finish();
    assert.deepEqual([begun !== null, scorm.reviews, site.server], [true, true, { "cmi.core.lesson_mode": mode }]);
  }
});

test("an API that throws, or will not begin, is none; one that goes away leaves all on the device", async () => {
  assert.equal(session({ LMSInitialize: () => "false" }).begun, null);
  assert.equal(session({}).begun, null);
  const api = new WorstSite({}).open();
  const { scorm, pass } = session(api);
  delete api.LMSSetValue;
  scorm.save(wanted(50));
  await pass(6000);
  assert.deepEqual([scorm.state, scorm.failed], ["device", true]);
});
