// Tabs that share a place, by pointer and by arrow keys.
import { element, set_text } from "./dom.js";

export class TabList {
  #tabs;

  /** list: the element that they stand in. names: a tab's words by the id of what it shows. open(id): called when one
   *  is opened by hand.
   *  @param {HTMLElement} list @param {Record<string, string>} names @param {(id: string) => void} open */
  constructor(list, names, open) {
    const before = list.id === "tabs" ? "" : `${list.id}-`;
    this.#tabs = Object.entries(names).map(([id, words]) => {
      const shows = { "aria-controls": id, "data-shows": id, onclick: () => open(id) };
      return element("button", { type: "button", role: "tab", id: `${before}tab-${id}`, ...shows }, words);
    });
    list.append(...this.#tabs);
    list.addEventListener("keydown", (event) => this.#key(event));
  }

  /** @param {number} at @param {string} words */
  set_words(at, words) {
    set_text(this.#tabs[at], words);
  }

  mark(/** @type {string} */ id) {
    for (const tab of this.#tabs) {
      const chosen = tab.dataset.shows === id;
      tab.setAttribute("aria-selected", chosen);
      tab.tabIndex = chosen ? 0 : -1;
    }
  }

  #key(/** @type {KeyboardEvent} */ event) {
    const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    if (!step) return;
    event.preventDefault();
    event.stopPropagation(); // not a step of the player
    const shown = this.#tabs.filter((tab) => tab.checkVisibility());
    const at = shown.findIndex((tab) => tab === document.activeElement);
    const next = shown[(at + step + shown.length) % shown.length];
    next.click();
    next.focus();
  }
}
