// The list of lessons and the menu with links to them. Each is a true link, which can be opened in a new tab or copied.
import { by_id, element, followed_here, is_within, set_hidden, set_text } from "./dom.js";
/** @import { Kept } from "./kept.js" */

export const link_of = (/** @type {string} */ id) => `?lesson=${encodeURIComponent(id)}`;

/** The way into a lesson: to where it was left; one that was not begun opens on its points, before the first step.
 *  @param {string} id @param {Kept} kept */
export const way_into = (id, kept) => (kept.lesson(id) ? link_of(id) : `${link_of(id)}&step=0`);

/** Links by chapter, the open one marked. choose(id): called instead of loading the page again.
 *  @param {CourseLesson[]} lessons @param {string | null} open_id @param {GoTo} choose */
export function lesson_links(lessons, open_id, choose) {
  const groups = Map.groupBy ? Map.groupBy(lessons, (lesson) => lesson.chapter) : grouped(lessons);
  return element("ul", { class: "lesson-groups" }, ...[...groups].map(([group, members]) =>
    element("li", {}, element("p", { class: "label" }, group),
      element("ul", {}, ...members.map((lesson) => element("li", {}, lesson_link(lesson, open_id, choose)))))));
}

function grouped(/** @type {CourseLesson[]} */ lessons) {
  /** @type {Map<string, CourseLesson[]>} */
  const groups = new Map();
  for (const lesson of lessons) groups.set(lesson.chapter, [...(groups.get(lesson.chapter) ?? []), lesson]);
  return groups;
}

/** @param {CourseLesson} lesson @param {string | null} open_id @param {GoTo} choose */
function lesson_link({ id, title, summary }, open_id, choose) {
  const to = { href: link_of(id), onclick: followed_here(() => choose(id)) };
  return element("a", { ...to, "aria-current": id === open_id ? "page" : null },
    element("b", {}, title),
    element("span", {}, summary),
  );
}

export class LessonMenu {
  #lessons;
  #choose;
  #open_id = /** @type {string | null} */ (null);

  /** @param {CourseLesson[]} lessons @param {GoTo} choose */
  constructor(lessons, choose) {
    this.#lessons = lessons;
    this.#choose = choose;
    by_id("picker").addEventListener("click", () => this.#toggle(!this.is_open));
    by_id("lessons").addEventListener("keydown", (event) => this.#key(event));
    addEventListener("pointerdown", ({ target }) => {
      if (!is_within(target, ".picker")) this.#toggle(false);
    });
    by_id("lessons").parentElement?.addEventListener("focusout", ({ relatedTarget }) => {
      if (relatedTarget && !is_within(relatedTarget, ".picker")) this.#toggle(false);
    });
  }

  get is_open() {
    return !by_id("lessons").hidden;
  }

  show(/** @type {Lesson} */ lesson) {
    this.#open_id = lesson.id;
    const of_none = document.documentElement.classList.contains("exercise") ? "Exercise" : "Hard cases";
    set_text(by_id("picker-group"), this.#lessons.find(({ id }) => id === lesson.id)?.chapter ?? of_none);
    set_text(by_id("picker-title"), lesson.title);
  }

  #toggle(/** @type {boolean} */ open) {
    if (open === this.is_open) return;
    const menu = by_id("lessons");
    set_hidden(menu, !open);
    by_id("picker").setAttribute("aria-expanded", open);
    if (!open) return menu.replaceChildren();
    menu.replaceChildren(lesson_links(this.#lessons, this.#open_id, (id) => {
      this.#toggle(false);
      by_id("picker").focus();
      this.#choose(id);
    }));
    const links = [...menu.querySelectorAll("a")];
    (links.find((link) => link.hasAttribute("aria-current")) ?? links[0])?.focus();
  }

  #key(/** @type {KeyboardEvent} */ event) {
    if (event.key === "Escape") {
      this.#toggle(false);
      by_id("picker").focus();
    }
    const step = event.key === "ArrowDown" ? 1 : event.key === "ArrowUp" ? -1 : 0;
    if (step) {
      event.preventDefault();
      const links = [...by_id("lessons").querySelectorAll("a")];
      const at = links.findIndex((link) => link === document.activeElement);
      links[(at + step + links.length) % links.length].focus();
    }
    event.stopPropagation(); // the stage's keys do nothing while the menu is open
  }
}
