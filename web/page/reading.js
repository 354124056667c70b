// The text: the title, the prose, whose links light up marks on the stage, and the task with its current grade.
import { button, by_id, element, followed_here, lights, set_text, when_changed, whole_names } from "./dom.js";
import { link_of } from "./lesson_menu.js";
import { notice } from "./messages.js";
/** @import { Words } from "./words.js" */

// Milliseconds for which a student counts as reading after scrolling the prose or pressing a key in it.
const kReads = 6000;

const on_phone = () => document.documentElement.dataset.layout === "phone";
const behavior = () => (matchMedia("(prefers-reduced-motion: reduce)").matches ? "auto" : "smooth");

/** Scrolls the column so that a part of it that is not in view comes there.
 *  @param {HTMLElement} part @param {HTMLElement} column */
function bring(part, column) {
  const [box, place] = [column.getBoundingClientRect(), part.getBoundingClientRect()];
  if (place.top >= box.top && place.bottom <= box.bottom) return;
  column.scrollTo({ top: column.scrollTop + place.top - box.top - box.height / 8, behavior: behavior() });
}

/** On a phone the whole page scrolls, and the tabs stay at its top. */
function bring_on_page(/** @type {HTMLElement} */ part) {
  const { top, bottom } = part.getBoundingClientRect();
  const under = by_id("tabs").offsetHeight;
  if (top < under || bottom > innerHeight) scrollBy({ top: top - under - 8, behavior: behavior() });
}

export class Reading {
  #words;
  #start_task;
  #solve_again;
  #cards = /** @type {HTMLElement[]} */ ([]); // one for each task
  #grade_says = /** @type {HTMLElement[]} */ ([]); // and its line
  #backs = /** @type {HTMLElement[]} */ ([]); // and the button back to what solved it
  #texts;
  #follow;
  #light;
  #sections = /** @type {HTMLElement[]} */ ([]);
  #section = /** @type {HTMLElement | null} */ (null); // the one at hand
  /** The buttons of sections that are about a situation.
   *  @type {{ name: string, node: HTMLElement }[]} */
  #shows = [];
  /** The words that light up when their handle on the stage is pointed at.
   *  @type {{ mark: string, node: HTMLElement }[]} */
  #words_of = [];
  #read_at = -Infinity;
  #has;
  #pointed = false; // whether the mouse is over the prose
  #opened = false; // whether the lesson is not shown yet
  #was_open = false; // whether the task was not done when it was last graded in this lesson

  /** start_task: lays out the points that the task begins with; solve_again: those that solved it. texts: what makes
   *  HTML of words. light(mark): lights it up on the stage; "" for none.
   *  @param {SharedWords} words
   *  @param {{ start_task: (task: number) => void, solve_again: (task: number) => void, texts: Words,
   *    follow: (link: Link) => void, light: (mark: string) => void, has: (lesson: string) => boolean }} does */
  constructor(words, { start_task, solve_again, texts, follow, light, has }) {
    this.#has = has;
    this.#words = words;
    this.#start_task = start_task;
    this.#solve_again = solve_again;
    this.#texts = texts;
    this.#follow = follow;
    this.#light = light;
    const read = by_id("read");
    for (const sign of ["pointermove", "pointerleave", "wheel", "touchmove", "keydown"])
      read.addEventListener(sign, (event) => {
        this.#read_at = performance.now();
        if (event instanceof PointerEvent && event.pointerType === "mouse") this.#pointed = sign === "pointermove";
      }, { passive: true });
  }

  open(/** @type {Lesson} */ lesson) {
    for (const id of ["heading", "title"]) set_text(by_id(id), lesson.title);
    this.#words_of = [];
    this.#shows = [];
    this.#sections = lesson.sections.map(({ title, situation, blocks }) =>
      element("section", {},
        element("h2", {}, title),
        situation && this.#show_button(lesson, situation),
        ...blocks.map((block) => this.#texts.block(block, (text, link) => this.#link(text, link))),
      ),
    );
    by_id("prose").replaceChildren(...this.#sections);
    by_id("read").scrollTop = 0;
    this.#read_at = -Infinity;
    this.#opened = true;
    this.#was_open = false;
    const box = by_id("task");
    box.hidden = lesson.tasks.length === 0;
    this.#grade_says = lesson.tasks.map(() => element("p", { class: "grade", role: "status" }));
    this.#backs = lesson.tasks.map((_, i) =>
      button(this.#words.back_to_solution, () => this.#solve_again(i), { hidden: true }));
    this.#cards = lesson.tasks.map((task, i) => this.#task_card(task, i));
    box.replaceChildren(...this.#cards);
  }

  /** @param {Lesson["tasks"][0]} task @param {number} i */
  #task_card({ heading, prompt, start, hint }, i) {
    const hinted = [element("summary", {}, this.#words.hint), element("p", {}, ...this.#texts.of(hint))];
    const begin = button(start, () => this.#start_task(i));
    return element("section", { class: "card task" },
      element("h2", { class: "kicker" }, heading),
      element("p", {}, ...this.#texts.of(prompt)),
      element("p", {}, begin, " ", this.#backs[i]),
      this.#grade_says[i],
      hint.length > 0 && element("details", {}, ...hinted),
    );
  }

  /** Brings the situation that a section is about to the stage; pressed while it is there.
   *  @param {Lesson} lesson @param {string} name */
  #show_button({ situations }, name) {
    const title = situations.find((one) => one.name === name)?.title ?? name;
    const node = button(`Show: ${title}`, () => this.#follow({ kind: "situation", target: name }));
    node.classList.add("shows");
    this.#shows.push({ name, node });
    return element("p", {}, node);
  }

  /** @param {string} text @param {Link} link */
  #link(text, link) {
    const { kind, target } = link;
    const follow = () => this.#follow(link);
    // A package may lack the lesson, and says its name all the same.
    if (kind === "lesson" && document.querySelector(".packaged") && !this.#has(target))
      return element("span", {}, whole_names(text));
    if (kind === "lesson")
      return element("a", { href: link_of(target), onclick: followed_here(follow) }, whole_names(text));
    if (kind !== "mark")
      return element("button", { type: "button", class: "does", onclick: follow }, whole_names(text));
    const listens = lights(() => this.#light(target), () => this.#light(""));
    const onclick = () => by_id("stage").scrollIntoView({ block: "nearest" });
    const node = element("button", { type: "button", class: "speaks", ...listens, onclick }, whole_names(text));
    this.#words_of.push({ mark: target, node });
    return node;
  }

  update(/** @type {View} */ view) {
    const { lesson, tasks, task } = view;
    this.#show_grades({ lesson, tasks, task });
    this.#show_section(lesson, view.section);
    // Who begins a lesson reads it from its top.
    if (this.#opened && (view.step === 0 || view.previewing)) by_id("read").scrollTop = 0;
    this.#opened = false;
    this.#show_lit(lesson, view.lit);
    for (const { name, node } of this.#shows) node.setAttribute("aria-pressed", name === view.situation);
  }

  /** Scrolls to the section about the step or the question, unless the student is reading. */
  #show_section = when_changed((/** @type {string} */ _lesson, /** @type {number | null} */ now) => {
    for (const [i, section] of this.#sections.entries()) {
      if (i === now) section.setAttribute("aria-current", "true");
      else section.removeAttribute("aria-current");
    }
    const read = by_id("read");
    const section = now === null ? null : (this.#sections[now] ?? null);
    this.#section = section;
    const reads = this.#pointed || performance.now() - this.#read_at < kReads || read.contains(document.activeElement);
    if (!section || reads || read.scrollHeight <= read.clientHeight) return; // on a phone the whole page scrolls
    bring(section, read);
  });

  /** The section at hand, to one who has just opened the text. */
  bring_section() {
    if (!this.#section) return;
    if (on_phone()) bring_on_page(this.#section);
    else bring(this.#section, by_id("read"));
  }

  /** The task, and the focus with it. */
  bring_task() {
    const box = by_id("task");
    if (on_phone()) bring_on_page(box);
    else box.scrollIntoView({ block: "nearest" });
    box.querySelector("button")?.focus({ preventScroll: true });
  }

  #show_lit = when_changed((/** @type {string} */ _lesson, /** @type {View["lit"]} */ lit) => {
    for (const { mark, node } of this.#words_of)
      node.classList.toggle("lit", mark === lit.mark || lit.words.includes(mark));
  });

  #show_grades = when_changed((/** @type {Pick<View, "lesson" | "tasks" | "task">} */ { tasks, task: now }) => {
    if (tasks.length === 0) return;
    for (const [i, { was, done, says, kept }] of tasks.entries()) {
      this.#backs[i].hidden = !kept;
      this.#cards[i].classList.toggle("done", was);
      this.#grade_says[i].classList.toggle("unsolved", was && !done);
      set_text(this.#grade_says[i], `${was ? "✓ " : ""}${says}`);
    }
    // On a phone the task is far below the stage. If an address opens it already done, that is not news.
    const { top, bottom } = this.#grade_says[now].getBoundingClientRect();
    const solved = tasks[now].done && tasks[now].was; // not where a drag only passes through a solution
    if (solved && this.#was_open && (bottom < 0 || top > innerHeight)) notice(`✓ ${tasks[now].says}`, "told");
    this.#was_open = !solved;
  });
}
