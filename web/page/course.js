// The course: what Snug is, where to start or to continue, and every lesson under its chapter. It is plain HTML and
// does not need the program, so it is shown before that has loaded.
import { button, by_id, element, followed_here, save_file, set_hidden, set_text, whole_names } from "./dom.js";
import { exercise_link } from "./address.js";
import { result_text } from "./exercise.js";
import { way_into } from "./lesson_menu.js";
/** @import { Kept } from "./kept.js" */

/** The lessons of course.json in order, each with its number and its chapter's title.
 *  @param {CourseFile} course @returns {CourseLesson[]} */
export function lessons_of(course) {
  const all = course.chapters.flatMap(({ title, lessons }) => lessons.map((lesson) => ({ ...lesson, chapter: title })));
  return all.map((lesson, i) => ({ ...lesson, number: i + 1 }));
}

const plain = (/** @type {string} */ text) =>
  text.toLowerCase().normalize("NFKD").replace(/[\u0300-\u036f]/g, "").replace(/[’']/g, "");

/** The student's progress, as a mark and a word.
 *  @param {CourseLesson} lesson @param {KeptLesson | null} entry */
function progress_of(lesson, entry) {
  if (!entry) return { kind: "open", words: "Not begun" };
  if (entry.done) return { kind: "done", words: entry.task ? "Done, task too" : "Done" };
  if (entry.answered > 0) return { kind: "begun", words: `${entry.answered} of ${lesson.questions} predictions` };
  return { kind: "begun", words: `At step ${entry.step} of ${entry.steps}` };
}

/** The best mark of an exercise. */
function mark_words(/** @type {KeptExercise | null} */ entry) {
  if (entry?.best) return `${entry.best.mark} of ${entry.best.of}`;
  return entry?.now ? "Begun" : "";
}

/** A lesson that is being written has none: an empty stage is in its place. A card whose picture does not arrive still
 *  says everything.
 *  @param {CourseLesson} lesson */
function picture(lesson, how = {}) {
  if (lesson.picture === false) return element("div", { class: "picture blank" });
  const own = { "data-picture": lesson.id, alt: "", width: 480, height: 300, decoding: "async" };
  const image = element("img", { class: "picture", ...own, ...how });
  image.addEventListener("error", () => image.removeAttribute("src"));
  return image;
}

/** @param {DemoEntry} demo @param {number} i */
const demo_nodes = ({ id, title, states }, i) =>
  [i > 0 ? ", " : "", element("a", { href: `?demo=${encodeURIComponent(id)}&state=1` }, title), ` (${states} states)`];

/** What the search found.
 *  @param {number} lessons @param {number} exercises @param {string} asked */
function found_words(lessons, exercises, asked) {
  const counted = (/** @type {number} */ count, /** @type {string} */ one) =>
    count > 0 && `${count} ${one}${count === 1 ? "" : "s"}`;
  return [counted(lessons, "lesson"), counted(exercises, "exercise")].filter(Boolean).join(", ") ||
    `No lesson or exercise has “${asked.trim().slice(0, 40)}”.`;
}

export class Course {
  #lessons;
  #chapters;
  #sets;
  #demos;
  #feet = /** @type {(() => void)[]} */ ([]); // each shows how far a set is done
  #marks = /** @type {{ id: string, node: HTMLElement }[]} */ ([]); // where each exercise's mark is shown
  /** @type {{ id: string, item: HTMLElement, text: string }[]} */
  #lines = []; // of each exercise, in each of its sets
  #kept;
  #choose;
  /** @type {Map<string, { item: HTMLElement, link: HTMLElement, says: HTMLElement, text: string }>} */
  #cards = new Map(); // by id
  #sections = /** @type {HTMLElement[]} */ ([]);
  #laid_out = false;

  /** choose(id): called in place of loading the page anew.
   *  @param {CourseFile} course @param {Kept} kept @param {GoTo} choose */
  constructor(course, kept, choose) {
    this.#chapters = course.chapters;
    const { sets = [], exercises = [] } = course;
    this.#sets = sets;
    this.exercises = exercises;
    this.#demos = course.demos ?? [];
    this.version = course.version ?? "";
    this.playground = course.playground ?? "";
    this.#lessons = lessons_of(course);
    this.#kept = kept;
    this.#choose = choose;
    const student = by_id("student");
    student.addEventListener("change", () => kept.keep_student(student.value.trim()));
    by_id("search").addEventListener("input", () => this.#filter());
    by_id("search").addEventListener("keydown", (event) => event.key === "Escape" && this.#clear_search());
    by_id("search-clear").addEventListener("click", () => {
      this.#clear_search();
      by_id("search").focus();
    });
  }

  is_exercise(/** @type {string} */ id) {
    return this.exercises.some((exercise) => exercise.id === id);
  }

  /** The same list when the course has changed. */
  get lessons() {
    return this.#lessons;
  }

  /** Takes another course in its place, which show lays out.
   *  @param {CourseFile} course */
  replace(course) {
    this.#chapters = course.chapters;
    this.#lessons.splice(0, this.#lessons.length, ...lessons_of(course));
    this.#laid_out = false;
  }

  /** The course's part of window.snug.state(). */
  state() {
    return this.#lessons.map(({ id, number, title, chapter }) => ({
      id,
      number,
      title,
      chapter,
      done: Boolean(this.#kept.lesson(id)?.done),
    }));
  }

  show() {
    this.#kept.refresh();
    if (!this.#laid_out) this.#lay_out();
    this.#show_progress();
  }

  /** Shows the pictures that belong to the theme. */
  show_theme(/** @type {boolean} */ dark) {
    for (const image of /** @type {NodeListOf<HTMLImageElement>} */ (document.querySelectorAll("[data-picture]"))) {
      const source = `course/${image.dataset.picture}${dark ? "-dark" : ""}.png`;
      if (image.dataset.shown !== source) [image.dataset.shown, image.src] = [source, window.snug.at(source)];
    }
  }

  // ---- laid out once ------------------------------------------------------------------------------------------

  /** @param {Record<string, string>} properties @param {string} id @param {...(Node | string)} children */
  #link(properties, id, ...children) {
    const to = { href: way_into(id, this.#kept), onclick: followed_here(() => this.#choose(id)) };
    return element("a", { ...properties, ...to }, ...children);
  }

  #lay_out() {
    this.#laid_out = true;
    const first = this.#lessons[0];
    if (first) by_id("course-picture").replaceChildren(picture(first));
    this.#cards.clear();
    this.#sections = this.#chapters.map((chapter, i) => this.#chapter(chapter, i));
    by_id("chapters").replaceChildren(...this.#sections);
    this.#marks = [];
    this.#feet = [];
    this.#lines = [];
    if (this.#demos.length > 0)
      by_id("demos").replaceChildren("Lecture demos, led by a clicker: ", ...this.#demos.flatMap(demo_nodes), ".");
    by_id("sets").replaceChildren(...this.#sets.map((set) => this.#set(set)));
    for (const id of ["exercises", "to-exercises"]) set_hidden(by_id(id), this.#sets.length === 0);
    this.#filter();
  }

  /** @param {ChapterOf<LessonEntry>} chapter @param {number} i */
  #chapter({ title, lessons }, i) {
    const ids = lessons.map(({ id }) => id);
    return element("section", { class: "chapter", "aria-labelledby": `chapter-${i}` },
      element("div", { class: "chapter-head" },
        element("h2", { id: `chapter-${i}` }, title),
        element("p", { class: "label", id: `chapter-${i}-says` }),
      ),
      element("ul", { class: "cards" },
        ...this.#lessons.filter(({ id }) => ids.includes(id)).map((lesson) => this.#card(lesson)),
      ),
    );
  }

  /** A set, fit to be given as homework: its exercises in order, each with its mark. */
  #set(/** @type {ExerciseSet} */ { id, title, lecture, exercises }) {
    const minutes = exercises.reduce((sum, { minutes: own }) => sum + own, 0);
    return element("section", { class: "set", "aria-labelledby": `set-${id}` },
      element("h3", { id: `set-${id}` }, title),
      element("p", { class: "label" },
        lecture && `${lecture} · ${exercises.length} exercises · `, `about ${minutes} min`),
      element("ol", { class: "set-list" },
        ...exercises.map((exercise) => this.#exercise_line(exercise, `${title} ${lecture}`))),
      this.#set_foot(id, exercises),
    );
  }

  /** The mark so far, and the way to hand in the best attempts.
   *  @param {string} id @param {ExerciseEntry[]} exercises */
  #set_foot(id, exercises) {
    const says = element("p", { class: "label" });
    const own = (/** @type {Attempt} */ attempt) => exercises.some((exercise) => exercise.id === attempt.exercise);
    const hand_in = button("Hand in", () =>
      save_file(result_text(this.#kept.student, this.#kept.attempts.filter(own), this.version), `${id}.json`));
    this.#feet.push(() => {
      const best = exercises.flatMap((exercise) => this.#kept.exercise(exercise.id)?.best ?? []);
      const mark = best.reduce((sum, own) => sum + own.mark, 0);
      const of = best.reduce((sum, own) => sum + own.of, 0);
      const done = `${best.length} of ${exercises.length} exercises done`;
      set_text(says, best.length > 0 ? `Mark ${mark} of ${of}, ${done}` : `${done}`);
      hand_in.disabled = best.length === 0;
    });
    return element("div", { class: "set-foot" }, says, hand_in);
  }

  #exercise_line(/** @type {ExerciseEntry} */ { id, title, summary }, /** @type {string} */ set) {
    const node = element("b", { class: "mark" });
    this.#marks.push({ id, node });
    const to = { href: exercise_link(id), onclick: followed_here(() => this.#choose(id)) };
    const words = element("span", {}, element("b", {}, title), ` ${summary}`);
    const item = element("li", {}, element("a", to, words, node));
    this.#lines.push({ id, item, text: plain(`exercises ${set} ${title} ${summary}`) });
    return item;
  }

  #card(/** @type {CourseLesson} */ lesson) {
    const says = element("span", { class: "progress" });
    const link = this.#link({ class: "lesson-card" }, lesson.id,
      picture(lesson, { loading: "lazy" }),
      element("span", { class: "card-body" },
        element("span", { class: "card-title" },
          element("span", { class: "number" }, String(lesson.number)),
          element("b", {}, whole_names(lesson.title)),
        ),
        element("span", { class: "card-foot" },
          element("span", {}, lesson.minutes > 0 ? `${lesson.minutes} min` : "Draft"),
          says,
        ),
      ),
    );
    const item = element("li", {}, link);
    const text = plain(`${lesson.number} ${lesson.title} ${lesson.summary} ${lesson.chapter} ${lesson.words}`);
    this.#cards.set(lesson.id, { item, link, says, text });
    return item;
  }

  // ---- what changes -------------------------------------------------------------------------------------------

  #show_progress() {
    for (const lesson of this.#lessons) {
      const card = this.#cards.get(lesson.id);
      if (!card) continue;
      const { link, says } = card;
      const { kind, words } = progress_of(lesson, this.#kept.lesson(lesson.id));
      link.setAttribute("href", way_into(lesson.id, this.#kept));
      says.className = `progress ${kind}`;
      says.replaceChildren(
        element("span", { class: "mark", "aria-hidden": "true" }, kind === "done" ? "✓" : ""),
        words,
      );
    }
    for (const [i, { lessons }] of this.#chapters.entries()) {
      const done = lessons.filter(({ id }) => this.#kept.lesson(id)?.done).length;
      set_text(by_id(`chapter-${i}-says`), `${done} of ${lessons.length} done`);
    }
    for (const show of this.#feet) show();
    by_id("student").value = this.#kept.student;
    for (const { id, node } of this.#marks) set_text(node, mark_words(this.#kept.exercise(id)));
    this.#show_start();
    set_hidden(by_id("course-forgets"), this.#kept.works);
    set_hidden(by_id("course-damaged"), !this.#kept.set_aside);
  }

  /** Offers a newcomer one way to start, and anyone who was in a lesson a way to continue it. */
  #show_start() {
    const first = this.#lessons[0];
    if (!first) return;
    const last = this.#lessons.find(({ id }) => id === this.#kept.last && this.#kept.lesson(id));
    const done = (/** @type {string} */ id) => Boolean(this.#kept.lesson(id)?.done);
    const next = last && done(last.id) && this.#lessons.find(({ id, number }) => number > last.number && !done(id));
    const lead = next || last || first;
    const words = next ? "Next lesson" : last ? "Continue" : "Start here";
    const entry = last && this.#kept.lesson(lead.id);
    by_id("course-start").replaceChildren(
      this.#link({ class: "button primary", id: "start" }, lead.id, words),
      element("p", { class: "start-to" },
        `${lead.number} · ${lead.title}`,
        entry && !entry.done && element("span", { class: "label" }, ` at step ${entry.step} of ${entry.steps}`),
      ),
    );
  }

  // ---- the search ---------------------------------------------------------------------------------------------

  #clear_search() {
    by_id("search").value = "";
    this.#filter();
  }

  #filter() {
    const asked = plain(by_id("search").value).split(/[\s,]+/).filter(Boolean);
    const fits = (/** @type {{ item: HTMLElement, text: string }} */ { item, text }) => {
      const fit = asked.every((word) => text.includes(word));
      set_hidden(item, !fit);
      return fit;
    };
    const shown = [...this.#cards.values()].filter(fits).length;
    const exercises = new Set(this.#lines.filter(fits).map(({ id }) => id)).size; // some stand in several sets
    for (const section of [...this.#sections, ...by_id("sets").children])
      set_hidden(/** @type {HTMLElement} */ (section), !section.querySelector("li:not([hidden])"));
    set_hidden(by_id("exercises"), exercises === 0);
    by_id("course").classList.toggle("searching", asked.length > 0);
    set_text(by_id("search-says"), asked.length === 0 ? "" : found_words(shown, exercises, by_id("search").value));
    set_hidden(by_id("search-found"), asked.length === 0);
  }
}
