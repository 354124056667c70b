// What the panels beside the stage tell beyond the numbers, as tables after them, and the panels' buttons: for people who
// do not see the canvas.
import { button, by_id, element, set_text, spelled, when_changed } from "./dom.js";

const table_of = ({ title, head, rows, says }) => [
  element("table", {}, element("caption", {}, ...spelled(title)),
    ...(head.length > 1 ? [element("thead", {}, element("tr", {}, ...head.map((words) => element(words ? "th" : "td", words ? { scope: "col" } : {}, ...spelled(words)))))] : []),
    element("tbody", {}, ...rows.map(([name, ...cells]) =>
      element("tr", {}, element("th", { scope: "row" }, ...spelled(name)), ...cells.map((words) => element("td", {}, words)))))),
  ...(says ? [element("p", { class: "label" }, ...spelled(says))] : []),
];

export class PanelWords {
  #act;

  /** act(command) */
  constructor(act) {
    this.#act = act;
  }

  #show = when_changed((panels) => by_id("panel-words").replaceChildren(...panels.flatMap(table_of)));

  /** Laid out once for the same commands: what is pressed keeps the focus, and its words change in place. */
  #lay_out = when_changed((commands) =>
    by_id("panel-buttons").replaceChildren(...commands.map((command) => button("", () => this.#act(command)))));

  update({ panels }) {
    this.#show(panels.map(({ title, head, rows, says }) => ({ title, head, rows, says })));
    const buttons = panels.flatMap((panel) => panel.button ?? []);
    this.#lay_out(buttons.map(({ command }) => command));
    for (const [i, { words, enabled }] of buttons.entries()) {
      const own = by_id("panel-buttons").children[i];
      set_text(own, words);
      own.setAttribute("aria-disabled", !enabled);
    }
  }
}
