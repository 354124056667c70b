// What the panels beside the stage tell beyond the numbers, as tables after them, and the panels' buttons: for people
// who do not see the canvas.
import { button, by_id, element, set_text, spelled, when_changed } from "./dom.js";

/** @typedef {Omit<Panel, "button">} PanelTable */

const heading = (/** @type {string} */ words) =>
  words ? element("th", { scope: "col" }, ...spelled(words)) : element("td", {});

const row_of = (/** @type {string[]} */ [name, ...cells]) =>
  element("tr", {},
    element("th", { scope: "row" }, ...spelled(name)),
    ...cells.map((words) => element("td", {}, words)),
  );

const table_of = (/** @type {PanelTable} */ { title, head, rows, says }) => [
  element("table", {},
    element("caption", {}, ...spelled(title)),
    head.length > 1 && element("thead", {}, element("tr", {}, ...head.map(heading))),
    element("tbody", {}, ...rows.map(row_of)),
  ),
  ...(says ? [element("p", { class: "label" }, ...spelled(says))] : []),
];

export class PanelWords {
  #act;
  #buttons = /** @type {HTMLElement[]} */ ([]);

  constructor(/** @type {(command: string) => void} */ act) {
    this.#act = act;
  }

  #show = when_changed((/** @type {PanelTable[]} */ panels) =>
    by_id("panel-words").replaceChildren(...panels.flatMap(table_of)),
  );

  /** Laid out once for the same commands: what is pressed keeps the focus, and its words change in place. */
  #lay_out = when_changed((/** @type {string[]} */ commands) => {
    this.#buttons = commands.map((command) => button("", () => this.#act(command)));
    by_id("panel-buttons").replaceChildren(...this.#buttons);
  });

  update(/** @type {View} */ { panels }) {
    this.#show(panels.map(({ title, head, rows, says }) => ({ title, head, rows, says })));
    const buttons = panels.flatMap((panel) => panel.button ?? []);
    this.#lay_out(buttons.map(({ command }) => command));
    for (const [i, { words, enabled }] of buttons.entries()) {
      set_text(this.#buttons[i], words);
      this.#buttons[i].setAttribute("aria-disabled", !enabled);
    }
  }
}
