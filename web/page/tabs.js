// Read, Numbers and Code, where there is no room for all three beside the stage.
import { by_id, element } from "./dom.js";

const kTabs = [["read", "Read"], ["numbers", "Numbers"], ["code", "Code"]];

export class Tabs {
  #tabs = kTabs.map(([id, words]) => element("button", { type: "button", role: "tab", id: `tab-${id}`, "aria-controls": id,
    onclick: () => this.choose(id) }, words));

  constructor() {
    by_id("tabs").append(...this.#tabs);
    by_id("tabs").addEventListener("keydown", (event) => this.#key(event));
    this.choose("read");
  }

  choose(id) {
    document.documentElement.dataset.tab = id;
    this.#tabs.forEach((tab, i) => {
      const chosen = kTabs[i][0] === id;
      tab.setAttribute("aria-selected", chosen);
      tab.tabIndex = chosen ? 0 : -1;
    });
  }

  #key(event) {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation(); // not a step of the player
    const next = this.#tabs[(this.#tabs.indexOf(document.activeElement) + step + this.#tabs.length) % this.#tabs.length];
    next.click();
    next.focus();
  }
}
