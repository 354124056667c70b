// The course: what Snug is, where to start or to continue, and every lesson under its chapter. It is plain HTML and
// does not need the program, so it is shown before that has loaded.
import { by_id, element, followed_here, set_hidden, set_text, whole_names } from "./dom.js";
import { way_into } from "./lesson_menu.js";

/** The lessons of course.json in order, each with its number and its chapter's title. */
export function lessons_of(course) {
  const all = course.chapters.flatMap(({ title, lessons }) => lessons.map((lesson) => ({ ...lesson, chapter: title })));
  return all.map((lesson, i) => ({ ...lesson, number: i + 1 }));
}

const plain = (text) => text.toLowerCase().normalize("NFKD").replace(/[\u0300-\u036f]/g, "").replace(/[’']/g, "");

/** The student's progress, as a mark and a word. */
function progress_of(lesson, entry) {
  if (!entry) return { kind: "open", words: "Not begun" };
  const count = `${entry.answered} of ${lesson.questions} predictions`;
  const words = entry.done ? `Done${entry.task ? ", task too" : ""}` : entry.answered > 0 ? count : `At step ${entry.step} of ${entry.steps}`;
  return { kind: entry.done ? "done" : "begun", words };
}

/** A lesson that is being written has none: an empty stage is in its place. */
const picture = (lesson, how = {}) => lesson.picture === false ? element("div", { class: "picture blank" }) : element("img", { class: "picture", alt: "", width: 480, height: 300, decoding: "async", "data-picture": lesson.id,
  onerror: ({ target }) => target.removeAttribute("src"), ...how }); // a card without its picture still says everything

export class Course {
  #lessons;
  #chapters;
  #kept;
  #choose;
  #cards = new Map(); // by id
  #laid_out = false;

  /** choose(id): called in place of loading the page anew. */
  constructor(course, kept, choose) {
    this.#chapters = course.chapters;
    this.playground = course.playground ?? "";
    this.#lessons = lessons_of(course);
    this.#kept = kept;
    this.#choose = choose;
    by_id("search").addEventListener("input", () => this.#filter());
    by_id("search").addEventListener("keydown", (event) => event.key === "Escape" && this.#clear_search());
    by_id("search-clear").addEventListener("click", () => {
      this.#clear_search();
      by_id("search").focus();
    });
  }

  /** The same list when the course has changed. */
  get lessons() {
    return this.#lessons;
  }

  /** Takes another course in its place, which show lays out. */
  replace(course) {
    this.#chapters = course.chapters;
    this.#lessons.splice(0, this.#lessons.length, ...lessons_of(course));
    this.#laid_out = false;
  }

  /** The course's part of window.snug.state(). */
  state() {
    return this.#lessons.map(({ id, number, title, chapter }) => ({ id, number, title, chapter, done: Boolean(this.#kept.lesson(id)?.done) }));
  }

  show() {
    this.#kept.refresh();
    if (!this.#laid_out) this.#lay_out();
    this.#show_progress();
  }

  /** Shows the pictures that belong to the theme. */
  show_theme(dark) {
    for (const image of document.querySelectorAll("[data-picture]")) {
      const source = `course/${image.dataset.picture}${dark ? "-dark" : ""}.png`;
      if (image.getAttribute("src") !== source) image.src = source;
    }
  }

  // ---- laid out once ------------------------------------------------------------------------------------------

  #link(properties, id, ...children) {
    return element("a", { ...properties, href: way_into(id, this.#kept), onclick: followed_here(() => this.#choose(id)) }, ...children);
  }

  #lay_out() {
    this.#laid_out = true;
    const first = this.#lessons[0];
    if (first) by_id("course-picture").replaceChildren(picture(first));
    this.#cards.clear();
    by_id("chapters").replaceChildren(...this.#chapters.map((chapter, i) => this.#chapter(chapter, i)));
    this.#filter();
  }

  #chapter({ title, lessons }, i) {
    return element("section", { class: "chapter", "aria-labelledby": `chapter-${i}` },
      element("div", { class: "chapter-head" }, element("h2", { id: `chapter-${i}` }, title), element("p", { class: "label" })),
      element("ul", { class: "cards" }, ...lessons.map(({ id }) => this.#card(this.#lessons.find((lesson) => lesson.id === id)))));
  }

  #card(lesson) {
    const says = element("span", { class: "progress" });
    const link = this.#link({ class: "lesson-card" }, lesson.id,
      picture(lesson, { loading: "lazy" }),
      element("span", { class: "card-body" },
        element("span", { class: "card-title" }, element("span", { class: "number" }, String(lesson.number)), element("b", {}, whole_names(lesson.title))),
        element("span", { class: "card-foot" }, element("span", {}, lesson.minutes > 0 ? `${lesson.minutes} min` : "Draft"), says)));
    const item = element("li", {}, link);
    this.#cards.set(lesson.id, { item, link, says, text: plain(`${lesson.number} ${lesson.title} ${lesson.summary} ${lesson.chapter} ${lesson.words}`) });
    return item;
  }

  // ---- what changes -------------------------------------------------------------------------------------------

  #show_progress() {
    for (const lesson of this.#lessons) {
      const { link, says } = this.#cards.get(lesson.id);
      const { kind, words } = progress_of(lesson, this.#kept.lesson(lesson.id));
      link.setAttribute("href", way_into(lesson.id, this.#kept));
      says.className = `progress ${kind}`;
      says.replaceChildren(element("span", { class: "mark", "aria-hidden": "true" }, kind === "done" ? "✓" : ""), words);
    }
    for (const [i, { lessons }] of this.#chapters.entries()) {
      const done = lessons.filter(({ id }) => this.#kept.lesson(id)?.done).length;
      set_text(by_id(`chapter-${i}`).nextElementSibling, `${done} of ${lessons.length} done`);
    }
    this.#show_start();
    set_hidden(by_id("course-forgets"), this.#kept.works);
    set_hidden(by_id("course-damaged"), !this.#kept.set_aside);
  }

  /** Offers a newcomer one way to start, and anyone who was in a lesson a way to continue it. */
  #show_start() {
    const first = this.#lessons[0];
    if (!first) return;
    const last = this.#lessons.find(({ id }) => id === this.#kept.last && this.#kept.lesson(id));
    const next = last && this.#kept.lesson(last.id).done ? this.#lessons.find(({ id, number }) => number > last.number && !this.#kept.lesson(id)?.done) : null;
    const lead = next ?? last;
    const start = this.#link({ class: "button primary", id: "start" }, (lead ?? first).id, lead ? (next ? "Next lesson" : "Continue") : "Start here");
    const to = element("p", { class: "start-to" }, `${(lead ?? first).number} · ${(lead ?? first).title}`);
    const entry = lead && this.#kept.lesson(lead.id);
    if (entry && !entry.done) to.append(element("span", { class: "label" }, ` at step ${entry.step} of ${entry.steps}`));
    by_id("course-start").replaceChildren(start, to);
  }

  // ---- the search ---------------------------------------------------------------------------------------------

  #clear_search() {
    by_id("search").value = "";
    this.#filter();
  }

  #filter() {
    const asked = plain(by_id("search").value).split(/[\s,]+/).filter(Boolean);
    let shown = 0;
    for (const { item, text } of this.#cards.values()) {
      const fits = asked.every((word) => text.includes(word));
      set_hidden(item, !fits);
      shown += fits;
    }
    for (const chapter of by_id("chapters").children) set_hidden(chapter, !chapter.querySelector("li:not([hidden])"));
    by_id("course").classList.toggle("searching", asked.length > 0);
    set_text(by_id("search-says"), asked.length === 0 ? "" : shown === 0 ? `No lesson has “${by_id("search").value.trim().slice(0, 40)}”.` : shown === 1 ? "1 lesson" : `${shown} lessons`);
    set_hidden(by_id("search-found"), asked.length === 0);
  }
}
