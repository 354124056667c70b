// The table of a cover that everyone sees, under the stage: a head sorts by its column, a row's name chooses it.
import { button, by_id, element, set_hidden, set_text, when_changed } from "./dom.js";

export class CoverTable {
  #command;
  #head = element("tr", {});
  #body = element("tbody", {});
  #node = element("table", { class: "cover-table", hidden: true }, element("thead", {}, this.#head), this.#body);
  #heads = /** @type {HTMLElement[]} */ ([]); // the buttons
  #rows = /** @type {{ row: HTMLElement, name: HTMLElement, cells: HTMLElement[] }[]} */ ([]);
  #now = /** @type {WordTable | null} */ (null);

  constructor(/** @type {(command: string) => void} */ command) {
    this.#command = command;
    by_id("controls").prepend(this.#node);
  }

  /** Laid out once for a kind of table: what is pressed keeps the focus, and the figures change in place. */
  #lay_out = when_changed((/** @type {string[]} */ head, /** @type {number} */ count) => {
    this.#heads = head.map((_, i) => button("", () => this.#command(this.#now?.sorts[i] ?? "")));
    this.#head.replaceChildren(...this.#heads.map((name) => element("th", { scope: "col" }, name)));
    this.#rows = Array.from({ length: count }, (_, i) => {
      const name = button("", () => this.#command(this.#now?.picks[i] ?? ""));
      const cells = head.slice(1).map(() => element("td", {}));
      return { row: element("tr", {}, element("th", { scope: "row" }, name), ...cells), name, cells };
    });
    this.#body.replaceChildren(...this.#rows.map(({ row }) => row));
  });

  #show = when_changed((/** @type {WordTable} */ table) => {
    this.#now = table;
    this.#lay_out(table.head, table.rows.length);
    this.#node.setAttribute("aria-label", table.title);
    for (const [i, button_of] of this.#heads.entries()) {
      set_text(button_of, table.head[i]);
      const cell = this.#head.cells[i];
      if (i === table.sorted) cell.setAttribute("aria-sort", "ascending");
      else cell.removeAttribute("aria-sort");
    }
    for (const i of this.#rows.keys()) this.#show_row(table, i);
  });

  #show_row(/** @type {WordTable} */ { rows, best, picked }, /** @type {number} */ i) {
    const { row, name, cells } = this.#rows[i];
    row.classList.toggle("picked", i === picked);
    name.setAttribute("aria-pressed", i === picked);
    set_text(name, rows[i][0]);
    for (const [k, cell] of cells.entries()) {
      set_text(cell, rows[i][k + 1]);
      cell.classList.toggle("best", best[i][k + 1]);
    }
  }

  /** table: undefined where nothing can stand in the stage's place. */
  update(/** @type {WordTable | undefined} */ table) {
    set_hidden(this.#node, !table?.sorts.length);
    if (table?.sorts.length) this.#show(table);
  }
}
