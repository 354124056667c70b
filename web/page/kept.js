// What is kept on this device: each lesson's progress, the student's place in it, and the answers given. If the storage
// is forbidden, full, damaged or another version's, nothing else is lost. A course's site may keep the marks as well
// (packaged.js, splice.js): the counter says which of two is newer.

const kKey = "snug-course";
const kAside = "snug-course-damaged"; // what could not be understood, as it was
const kVersion = 1;
const kLongest = 200_000; // characters for one lesson: an address and its answers

const is_text = (/** @type {any} */ value) => typeof value === "string" && value.length <= kLongest;
const is_count = (/** @type {any} */ value) => Number.isSafeInteger(value) && value >= 0;

/** Whether it is a valid entry of a lesson; a lesson without one counts as not begun. */
const is_entry = (/** @type {any} */ entry) =>
  Boolean(entry) &&
  is_text(entry.address) &&
  is_text(entry.answers) &&
  is_count(entry.answered) &&
  is_count(entry.step) &&
  is_count(entry.steps) &&
  typeof entry.done === "boolean" &&
  typeof entry.task === "boolean";

const is_try = (/** @type {any} */ tried) =>
  Boolean(tried) &&
  is_text(tried.question) &&
  (tried.handle === null || is_text(tried.handle)) &&
  Array.isArray(tried.choices) &&
  tried.choices.every(is_count);

/** Where one was within a question came later: entries without it are entries.
 *  @returns {KeptLesson} */
const whole = (/** @type {any} */ entry) => ({
  ...entry,
  told: is_text(entry.told) ? entry.told : null,
  tried: is_try(entry.tried) ? entry.tried : null,
});

/** @returns {KeptData} */
const nothing = () =>
  ({ version: kVersion, count: 0, last: null, invited: 0, lessons: {}, exercises: {}, student: "" });

export const kMostLevel = 9; // of an exercise

/** Whether it can be an attempt, as a result file has it. */
const is_attempt = (/** @type {any} */ attempt) =>
  Boolean(attempt) &&
  is_text(attempt.exercise) &&
  is_text(attempt.hash) &&
  is_count(attempt.seed) &&
  is_count(attempt.of) &&
  (attempt.level === undefined || (is_count(attempt.level) && attempt.level <= kMostLevel)) &&
  Number.isFinite(attempt.mark) &&
  Array.isArray(attempt.decisions) &&
  attempt.decisions.every(is_text);

/** @returns {KeptExercise} */
const whole_exercise = (/** @type {any} */ { tries, best, now, at, hides }) => ({
  tries,
  best: is_attempt(best) ? best : null,
  now: is_attempt(now) ? now : null,
  at: is_count(at) ? at : 0,
  ...(hides === true && { hides }),
});

export const kWritten = /^\?*w/; // a decision that is the code

/** Whether nothing but the code has changed, as at each letter that is typed: for a course's site that is nothing.
 *  @param {KeptExercise} entry @param {KeptExercise} before */
const is_draft = (entry, before) =>
  entry.now?.decisions.every((decision) => kWritten.test(decision)) && entry.now.hints === (before.now?.hints ?? 0) &&
  entry.tries === before.tries && entry.best === before.best;

/** The better of two attempts, or what there is; of two with the same mark one that has its decisions.
 *  @param {Attempt | null} one @param {Attempt | null} other */
function better(one, other) {
  if (!one || !other) return one ?? other;
  const more = other.mark * one.of - one.mark * other.of;
  return more > 0 || (more === 0 && one.decisions.length === 0) ? other : one;
}

/** What two devices keep of an exercise, with nothing lost.
 *  @param {KeptExercise} one @param {KeptExercise} other @returns {KeptExercise} */
function both(one, other) {
  const newer = other.at > one.at ? other : one;
  const [best, second] = newer === one ? [one.best, other.best] : [other.best, one.best];
  return { ...newer, best: better(best, second), tries: Math.max(one.tries, other.tries) };
}

/** The same of a lesson: it goes on where it stands here.
 *  @param {KeptLesson} one @param {KeptLesson} other @returns {KeptLesson} */
const both_lessons = (one, other) => ({
  ...one,
  answered: Math.max(one.answered, other.answered),
  done: one.done || other.done,
  task: one.task || other.task,
});

const size = (/** @type {any} */ entries) => Object.keys(Object(entries)).length;

/** Exercises came later: what is kept of lessons alone is kept. */
export function exercises_in(/** @type {any} */ data) {
  const entries = Object.entries(Object(data.exercises)).filter(([, entry]) => Boolean(entry) && is_count(entry.tries));
  return Object.fromEntries(entries.map(([id, entry]) => [id, whole_exercise(entry)]));
}

/** The stored data, without entries that cannot be understood; null if it is a later version's. What cannot be
 *  understood is set aside, and starts anew.
 *  @param {string | null} text @returns {KeptData | null} */
function understood(text) {
  let data = null;
  try {
    data = JSON.parse(text ?? "null");
  } catch {
    // no version below
  }
  if (is_count(data?.version) && data.version > kVersion) return null;
  if (data?.version !== kVersion) {
    if (text) localStorage.setItem(kAside, text);
    return nothing();
  }
  const all = Object.entries(Object(data.lessons));
  const lessons = all.filter(([, entry]) => is_entry(entry)).map(([id, entry]) => [id, whole(entry)]);
  const exercises = exercises_in(data);
  const lost = all.length - lessons.length + size(data.exercises) - size(exercises);
  if (text && lost > 0) localStorage.setItem(kAside, text);
  return {
    version: kVersion,
    count: is_count(data.count) ? data.count : 0,
    last: is_text(data.last) ? data.last : null,
    invited: is_count(data.invited) ? data.invited : 0,
    lessons: Object.fromEntries(lessons),
    exercises,
    student: is_text(data.student) ? data.student : "",
  };
}

export class Kept {
  #data = nothing();
  #works = true;
  #key = kKey;
  #changed = () => {};
  #name = ""; // as the course's site calls the student

  constructor() {
    this.#read();
  }

  // ---- a course's site ----------------------------------------------------------------------------------------

  /** Keeps everything under a name of its own: that of a package, and of a student who may share the device. reads:
   *  nothing is written. name: the student's.
   *  @param {string} own @param {{ reads?: boolean, name?: string }} of */
  move_to(own, { reads = false, name = "" } = {}) {
    this.#key = `${kKey}.${own}`;
    this.#name = name;
    this.#data = nothing();
    this.#read();
    if (reads) this.#works = false;
  }

  /** changed: called after each change. */
  on_change(/** @type {() => void} */ changed) {
    this.#changed = changed;
  }

  /** @returns {Readonly<KeptData>} */
  get data() {
    return this.#data;
  }

  /** Takes over what another place has kept. Of an exercise that both have, the newer one goes on, and the best attempt
   *  stays.
   *  @param {{ count: number, lessons: Record<string, KeptLesson>, exercises: Record<string, KeptExercise> }} other */
  merge({ count, lessons, exercises }) {
    this.#change((data) => {
      data.count = Math.max(data.count, count);
      for (const [id, entry] of Object.entries(lessons))
        data.lessons[id] = data.lessons[id] ? both_lessons(data.lessons[id], entry) : entry;
      for (const [id, entry] of Object.entries(exercises))
        data.exercises[id] = data.exercises[id] ? both(data.exercises[id], entry) : entry;
    });
  }

  // ---- what is kept -------------------------------------------------------------------------------------------

  /** Whether kept data survives a reload. */
  get works() {
    return this.#works;
  }

  /** Whether something that was kept before could not be understood, and stands aside. */
  get set_aside() {
    try {
      return localStorage.getItem(kAside) !== null;
    } catch {
      return false;
    }
  }

  /** The lesson that was open last; null before the first. */
  get last() {
    return this.#data.last;
  }

  /** How many of the invitations on the stage have been followed. */
  get invited() {
    return this.#data.invited;
  }

  /** Null where the lesson was not begun. told: the question whose outcome stood there; tried: a first answer to it
   *  that was wrong.
   *  @param {string} id @returns {KeptLesson | null} */
  lesson(id) {
    return Object.hasOwn(this.#data.lessons, id) ? this.#data.lessons[id] : null;
  }

  /** @param {string} id @param {KeptLesson} entry */
  keep_lesson(id, entry) {
    this.#change((data) => {
      data.lessons[id] = entry;
      data.last = id;
    });
  }

  /** Null where it was not begun.
   *  @param {string} id @returns {KeptExercise | null} */
  exercise(id) {
    return Object.hasOwn(this.#data.exercises, id) ? this.#data.exercises[id] : null;
  }

  /** Keeps an attempt. Once it is finished it counts as a try, and as the best if it earns more than those before.
   *  counts: whether it is a try that was not counted yet. hides: whether its mark is not told before its end.
   *  @param {Attempt} attempt @param {boolean} finished @param {boolean} counts */
  keep_exercise(attempt, finished, counts = finished, hides = false) {
    this.#change(({ exercises, count }) => {
      const before = exercises[attempt.exercise] ?? { tries: 0, best: null, now: null, at: 0 };
      const entry = {
        tries: before.tries + (counts ? 1 : 0),
        best: finished ? better(before.best, attempt) : before.best,
        now: finished ? null : attempt,
        at: before.at,
        ...(hides && { hides }),
      };
      if (JSON.stringify(entry) === JSON.stringify(before)) return;
      exercises[attempt.exercise] = is_draft(entry, before) ? entry : { ...entry, at: count + 1 };
    });
  }

  /** The best attempts, for a result file: of one that came back from a course's site, perhaps only the mark did. */
  get attempts() {
    return Object.values(this.#data.exercises).flatMap(({ best }) => (best && best.decisions.length > 0 ? best : []));
  }

  /** The student's name, if it was typed or a course's site has it: it stays on the device, and makes the seed. */
  get student() {
    return this.#data.student || this.#name;
  }

  keep_student(/** @type {string} */ name) {
    this.#change((data) => (data.student = name));
  }

  keep_invited(/** @type {number} */ count) {
    this.#change((data) => (data.invited = Math.max(data.invited, count)));
  }

  /** Erases everything except the count of invitations, so that they are not shown again. */
  erase() {
    this.#change((data) => Object.assign(data, { last: null, lessons: {}, exercises: {} }));
  }

  /** Reads the storage again, because another tab may have written to it. */
  refresh() {
    if (this.#works) this.#read(); // otherwise there is only what is in memory
  }

  #read() {
    try {
      const text = localStorage.getItem(this.#key);
      const data = understood(text);
      this.#works = data !== null; // a later version's data is left as it is
      if (data) this.#data = data;
    } catch {
      this.#works = false;
    }
  }

  #change(/** @type {(data: KeptData) => void} */ change) {
    if (this.#works) this.#read();
    const before = JSON.stringify(this.#data);
    change(this.#data);
    if (JSON.stringify(this.#data) === before) return;
    this.#data.count += 1;
    try {
      if (this.#works) localStorage.setItem(this.#key, JSON.stringify(this.#data));
    } catch {
      this.#works = false;
    }
    this.#changed();
  }
}
