// The tabs beside the stage, because there is no room for everything: Lesson, Points and a scene's file always share a
// column; in a small window Numbers and Code join them, and how the volumes are stored where a lesson shows that.
import { by_id } from "./dom.js";
import { TabList } from "./tab_list.js";

const kTabs = {
  read: "Lesson", points: "Points", file: "File", stored: "Stored as", numbers: "Numbers", code: "Code",
};
const kOfTheColumn = ["read", "points", "file"];

const kSeen = 0.5; // of a phone's screen, which what its tab has opened takes at least

/** On a phone a tab is at the screen's foot, and what it opens beneath it. */
function bring_up(/** @type {HTMLElement} */ panel) {
  if (document.documentElement.dataset.layout !== "phone") return;
  const { top, height } = panel.getBoundingClientRect();
  const below = top + Math.min(height, innerHeight * kSeen) - innerHeight;
  if (below > 0) scrollBy({ top: below });
}

export class Tabs {
  #tabs;

  /** opened(id): called when a tab is opened by hand. */
  constructor(/** @type {(id: string) => void} */ opened) {
    this.#tabs = new TabList(by_id("tabs"), kTabs, (id) => {
      this.choose(id);
      bring_up(by_id(id));
      opened(id);
    });
    this.choose("read");
    const changes = { attributeFilter: ["data-layout", "class"] };
    new MutationObserver(() => this.#fit()).observe(document.documentElement, changes);
  }

  update(/** @type {View} */ { stored, file, exercise, toolsWord }) {
    this.#tabs.set_words(1, toolsWord);
    const { tab = "" } = document.documentElement.dataset;
    /** @type {Record<string, boolean>} */
    const lacks = { stored: !stored.length, file: !file, points: Boolean(exercise && !exercise.build?.adds) };
    if (lacks[tab]) this.choose("read");
  }

  choose(/** @type {string} */ id) {
    document.documentElement.dataset.tab = id;
    this.#tabs.mark(id);
  }

  /** Chooses another tab if this arrangement does not have the chosen one. */
  #fit() {
    const { dataset, classList } = document.documentElement;
    const of_column = kOfTheColumn.includes(dataset.tab ?? "");
    if (dataset.layout === "wide" && !of_column) this.choose("read");
    if (dataset.layout !== "wide" && classList.contains("presenting") && of_column) this.choose("code");
  }
}
