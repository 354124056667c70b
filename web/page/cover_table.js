// The table of a cover that everyone sees, under the stage: a head sorts by its column, a row's name chooses it.
import { button, by_id, element, set_hidden, set_text, when_changed } from "./dom.js";

export class CoverTable {
  #command;
  #head = element("tr", {});
  #body = element("tbody", {});
  #node = element("table", { class: "cover-table", hidden: true }, element("thead", {}, this.#head), this.#body);
  #now = null;

  constructor(command) {
    this.#command = command;
    by_id("controls").prepend(this.#node);
  }

  /** Laid out once for a kind of table: what is pressed keeps the focus, and the figures change in place. */
  #lay_out = when_changed((head, count) => {
    this.#head.replaceChildren(...head.map((_, i) => element("th", { scope: "col" }, button("", () => this.#command(this.#now.sorts[i])))));
    this.#body.replaceChildren(...Array.from({ length: count }, (_, row) => element("tr", {},
      element("th", { scope: "row" }, button("", () => this.#command(this.#now.picks[row]))), ...head.slice(1).map(() => element("td", {})))));
  });

  #show_head(head, sorted) {
    for (const [i, cell] of [...this.#head.children].entries()) {
      set_text(cell.firstElementChild, head[i]);
      if (i === sorted) cell.setAttribute("aria-sort", "ascending");
      else cell.removeAttribute("aria-sort");
    }
  }

  #show_row(row, words, best, picked) {
    row.classList.toggle("picked", picked);
    const [name, ...cells] = row.children;
    set_text(name.firstElementChild, words[0]);
    name.firstElementChild.setAttribute("aria-pressed", picked);
    for (const [i, cell] of cells.entries()) {
      set_text(cell, words[i + 1]);
      cell.classList.toggle("best", best[i + 1]);
    }
  }

  #show = when_changed((table) => {
    const { title, head, rows, best, sorted, picked } = this.#now = table;
    this.#lay_out(head, rows.length);
    this.#node.setAttribute("aria-label", title);
    this.#show_head(head, sorted);
    for (const [i, words] of rows.entries()) this.#show_row(this.#body.children[i], words, best[i], i === picked);
  });

  /** table: undefined where nothing can stand in the stage's place. */
  update(table) {
    const seen = Boolean(table?.sorts.length);
    set_hidden(this.#node, !seen);
    if (seen) this.#show(table);
  }
}
