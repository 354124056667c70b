// The list of lessons and the menu with links to them. Each is a true link, which can be opened in a new tab or copied.
import { by_id, element, followed_here, set_hidden, set_text } from "./dom.js";

export const link_of = (id) => `?lesson=${encodeURIComponent(id)}`;

/** The way into a lesson: to where it was left; one that was not begun opens on its points, before the first step. */
export const way_into = (id, kept) => (kept.lesson(id) ? link_of(id) : `${link_of(id)}&step=0`);

/** Links by chapter, the open one marked. choose(id): called instead of loading the page again. */
export function lesson_links(lessons, open_id, choose) {
  const groups = Map.groupBy ? Map.groupBy(lessons, (lesson) => lesson.chapter) : grouped(lessons);
  return element("ul", { class: "lesson-groups" }, ...[...groups].map(([group, members]) =>
    element("li", {}, element("p", { class: "label" }, group),
      element("ul", {}, ...members.map((lesson) => element("li", {}, lesson_link(lesson, open_id, choose)))))));
}

function grouped(lessons) {
  const groups = new Map();
  for (const lesson of lessons) groups.set(lesson.chapter, [...(groups.get(lesson.chapter) ?? []), lesson]);
  return groups;
}

function lesson_link(lesson, open_id, choose) {
  return element("a", { href: link_of(lesson.id), onclick: followed_here(() => choose(lesson.id)), "aria-current": lesson.id === open_id ? "page" : null },
    element("b", {}, lesson.title), element("span", {}, lesson.summary));
}

export class LessonMenu {
  #lessons;
  #choose;
  #open_id = null;

  constructor(lessons, choose) {
    this.#lessons = lessons;
    this.#choose = choose;
    by_id("picker").addEventListener("click", () => this.#toggle(by_id("lessons").hidden));
    by_id("lessons").addEventListener("keydown", (event) => this.#key(event));
    addEventListener("pointerdown", (event) => {
      if (!event.target.closest?.(".picker")) this.#toggle(false);
    });
    by_id("lessons").parentElement.addEventListener("focusout", (event) => {
      if (event.relatedTarget && !event.relatedTarget.closest(".picker")) this.#toggle(false);
    });
  }

  get is_open() {
    return !by_id("lessons").hidden;
  }

  show(lesson) {
    this.#open_id = lesson.id;
    set_text(by_id("picker-group"), this.#lessons.find(({ id }) => id === lesson.id)?.chapter ?? "Hard cases");
    set_text(by_id("picker-title"), lesson.title);
  }

  #toggle(open) {
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
    (menu.querySelector("[aria-current]") ?? menu.querySelector("a"))?.focus();
  }

  #key(event) {
    if (event.key === "Escape") {
      this.#toggle(false);
      by_id("picker").focus();
    }
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step) {
      event.preventDefault();
      const links = [...by_id("lessons").querySelectorAll("a")];
      links[(links.indexOf(document.activeElement) + step + links.length) % links.length].focus();
    }
    event.stopPropagation(); // the stage's keys do nothing while the menu is open
  }
}
