// What a course's site keeps of a student: the marks, and the decisions, as a text short enough for any of them.

import { kWritten } from "./kept.js";

export const kRoom = 4000; // characters: SCORM 1.2 has 4,096, the counters before the text among them
const kId = /^[a-z0-9:-]+~/; // what an entry begins with
const kWhole = /^snug1\.(\d+)\.\d+\.(.*)$/s;

/** The whole text: what begins it, the counter of changes, that of the times it was handed over, and what pack gave.
 *  @param {number} count @param {number} turn @param {string} body */
export const whole_text = (count, turn, body) => `snug1.${count}.${turn}.${body}`;

// Fields are parted by ~, those of an attempt by _, entries by |, so that no site has to escape anything but what it
// must: of decisions ">" becomes "!", and a number's exponent loses its plus. What was built is coordinates, which may
// come back cut, and what was written is code, which may be long: both stay on the device.

const is_built = (/** @type {string} */ decision) => /^\?*[bw]/.test(decision);
const packed = (/** @type {string} */ decision) => decision.replaceAll(">", "!").replaceAll("+", "");
const unpacked = (/** @type {string} */ decision) => decision.replaceAll("!", ">");

/** @param {Attempt | null} attempt @param {boolean} whole */
function attempt_text(attempt, whole) {
  if (!attempt) return "";
  const { hash, seed, level = 0, mark, of, decisions } = attempt;
  const kept = whole && !decisions.some(is_built) ? decisions.map(packed) : [];
  return [hash, seed.toString(36), level, mark, of, kept.join(",")].join("_");
}

/** @param {string} exercise @param {string} text @returns {Attempt | null} */
function attempt_of(exercise, text) {
  const [hash, seed, level, mark, of, kept] = text.split("_");
  const decisions = kept ? kept.split(",").map(unpacked) : [];
  if (!/^[0-9a-f]+$/.test(hash ?? "") || ![parseInt(seed, 36), +level, +mark, +of].every(Number.isFinite)) return null;
  return {
    exercise, hash, seed: parseInt(seed, 36), ...(+level > 0 && { level: +level }), decisions,
    hints: decisions.join("").split("?").length - 1, mark: +mark, of: +of,
    seconds: Math.max(0, ...decisions.map((decision) => Number(decision.split("@")[1]) || 0)),
  };
}

/** whole: whether with the decisions of the best attempt; the one that is not finished is nothing without them.
 *  @param {string} id @param {KeptExercise} entry @param {boolean} whole */
function exercise_text(id, { tries, best, now, at, hides }, whole) {
  const goes_on = now?.decisions.some(is_built) ? null : now;
  const attempts = [attempt_text(best, whole), attempt_text(goes_on, true)];
  return [id, at.toString(36), tries, ...attempts, hides ? "h" : ""].join("~");
}

/** What fits of the marks and decisions, and the exercises of which the decisions gave way, the oldest first. The
 *  counter stands before it, in the whole text.
 *  @param {Readonly<KeptData>} data @param {{ lessons: string[] }} of @param {number} room */
export function pack({ lessons, exercises }, of, room = kRoom) {
  const done = of.lessons.filter((id) => lessons[id]?.done || lessons[id]?.answered > 0).map((id) =>
    [id, lessons[id].answered, lessons[id].done ? "d" : "", lessons[id].task ? "t" : ""].join("~"));
  const entries = Object.entries(exercises).map(([id, entry]) => ({ id, entry, text: exercise_text(id, entry, true) }));
  const text = () => [done.join("/"), ...entries.map((one) => one.text)].join("|");
  const gave_way = /** @type {string[]} */ ([]);
  const oldest = [...entries].sort((a, b) => a.entry.at - b.entry.at);
  /** @type {((one: typeof entries[0]) => string)[]} */
  const ways = [
    ({ id, entry }) => exercise_text(id, entry, false),
    ({ id, entry }) => exercise_text(id, { ...entry, now: entry.best ? null : entry.now }, false),
    () => "",
  ];
  for (const shorter of ways)
    for (const one of oldest) {
      if (text().length <= room) break;
      one.text = shorter(one);
      if (!gave_way.includes(one.id)) gave_way.push(one.id);
    }
  return { text: text().replace(/\|+$/, ""), gave_way };
}

/** What a text of pack says, with the counter before it; null if it is none, or damaged.
 *  @param {string} text */
export function unpack(text) {
  const [, count, body] = kWhole.exec(text) ?? [];
  if (count === undefined) return null;
  const [done, ...entries] = body.split("|");
  const lessons = done.split("/").filter((one) => kId.test(one)).map((one) => {
    const [id, answered, is_done, task] = one.split("~");
    const nowhere = { address: "", answers: "", step: 0, steps: 0, told: null, tried: null };
    return [id, { ...nowhere, answered: Number(answered) || 0, done: is_done === "d", task: task === "t" }];
  });
  const exercises = entries.filter((one) => kId.test(one)).map((one) => {
    const [id, at, tries, best = "", now = "", hides] = one.split("~");
    // In the order in which kept.js has them, which compares them as texts.
    const entry = { tries: Number(tries) || 0, best: attempt_of(id, best), now: attempt_of(id, now) };
    return [id, { ...entry, at: parseInt(at, 36) || 0, ...(hides === "h" && { hides: true }) }];
  });
  return {
    count: Number(count),
    lessons: /** @type {Record<string, KeptLesson>} */ (Object.fromEntries(lessons)),
    exercises: /** @type {Record<string, KeptExercise>} */ (Object.fromEntries(exercises)),
    body,
  };
}

// ---- the score --------------------------------------------------------------------------------------------------

const share_of = (/** @type {Attempt | null} */ attempt) => (attempt && attempt.of > 0 ? attempt.mark / attempt.of : 0);

/** Whether more than hints were taken. Code is a draft until it is run, and what it then earns is kept as the best. */
const has_decided = (/** @type {Attempt | null} */ now) =>
  Boolean(now?.decisions.some((decision) => !/^\?+@/.test(decision) && !kWritten.test(decision)));

/** From 0 to 100: the mean of the exercises, of each the best attempt or the one that goes on. Null before the first
 *  decision, and where there is no exercise.
 *  @param {Readonly<KeptData>} data @param {{ exercises: string[] }} of */
export function score_of({ exercises }, of) {
  const begun = of.exercises.flatMap((id) => exercises[id] ?? []);
  if (!begun.some(({ best, now, hides }) => best || (!hides && has_decided(now)))) return null;
  const earned = begun.reduce((sum, { best, now, hides }) =>
    sum + Math.max(share_of(best), hides ? 0 : share_of(now)), 0);
  return Math.round(1000 * earned / of.exercises.length) / 10;
}

/** Whether each exercise was finished once, and each lesson is done.
 *  @param {Readonly<KeptData>} data @param {{ lessons: string[], exercises: string[] }} of */
export const is_complete = ({ lessons, exercises }, of) =>
  of.exercises.every((id) => exercises[id]?.tries > 0) && of.lessons.every((id) => lessons[id]?.done);
