// Tabs that share a place, by pointer and by arrow keys.
import { element, set_text } from "./dom.js";

export class TabList {
  #tabs;

  /** list: the element that they stand in. names: [[the id of what a tab shows, its words] …]. open(id): called when one
   *  is opened by hand. */
  constructor(list, names, open) {
    this.#tabs = names.map(([id, words]) => element("button", { type: "button", role: "tab", id: `${list.id === "tabs" ? "" : `${list.id}-`}tab-${id}`, "aria-controls": id,
      "data-shows": id, onclick: () => open(id) }, words));
    list.append(...this.#tabs);
    list.addEventListener("keydown", (event) => this.#key(event));
  }

  set_words(at, words) {
    set_text(this.#tabs[at], words);
  }

  mark(id) {
    for (const tab of this.#tabs) {
      const chosen = tab.dataset.shows === id;
      tab.setAttribute("aria-selected", chosen);
      tab.tabIndex = chosen ? 0 : -1;
    }
  }

  #key(event) {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation(); // not a step of the player
    const shown = this.#tabs.filter((tab) => tab.checkVisibility());
    const next = shown[(shown.indexOf(document.activeElement) + step + shown.length) % shown.length];
    next.click();
    next.focus();
  }
}
