// What stands beside the stage, where there is no room for all of it: Lesson and Points share a column in any case,
// Numbers and Code join them where the window is small.
import { by_id, element } from "./dom.js";

const kTabs = [["read", "Lesson"], ["points", "Points"], ["numbers", "Numbers"], ["code", "Code"]];
const kOfTheColumn = ["read", "points"];

export class Tabs {
  #tabs = kTabs.map(([id, words]) => element("button", { type: "button", role: "tab", id: `tab-${id}`, "aria-controls": id,
    onclick: () => this.choose(id) }, words));

  constructor() {
    by_id("tabs").append(...this.#tabs);
    by_id("tabs").addEventListener("keydown", (event) => this.#key(event));
    this.choose("read");
    new MutationObserver(() => this.#fit()).observe(document.documentElement, { attributeFilter: ["data-layout", "class"] });
  }

  open(lesson) {
    this.#tabs[1].textContent = lesson.tools.word;
  }

  choose(id) {
    document.documentElement.dataset.tab = id;
    this.#tabs.forEach((tab, i) => {
      const chosen = kTabs[i][0] === id;
      tab.setAttribute("aria-selected", chosen);
      tab.tabIndex = chosen ? 0 : -1;
    });
  }

  /** The chosen tab may be one that this arrangement does not have. */
  #fit() {
    const { dataset: { layout, tab }, classList } = document.documentElement;
    if (layout === "wide" && !kOfTheColumn.includes(tab)) this.choose("read");
    if (layout !== "wide" && classList.contains("presenting") && kOfTheColumn.includes(tab)) this.choose("code");
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
