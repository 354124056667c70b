// The tools of what is no set of points: every number of it that can be typed, scatter and reset.
import { button, by_id, element, other_seed, set_text, when_changed } from "./dom.js";
import { answer_edit } from "./messages.js";

/** A row's fields, and what shows numbers in them.
 *  @typedef {{ element: HTMLElement, show: (values: number[]) => void }} Fields
 *  @typedef {(values: number[]) => void} Set */

const rounded = (/** @type {number} */ number) => String(Number(number.toPrecision(6)));
const number_field = (/** @type {Record<string, any>} */ properties) =>
  element("input", { type: "number", step: "any", inputmode: "decimal", ...properties });
const label_of = (/** @type {NumberRow} */ { words, unit }) =>
  element("span", {}, unit ? `${words}, ${unit}` : words);

/** Fields for the numbers of a row.
 *  @param {NumberRow} row @param {string} of @param {Set} set @returns {Fields} */
function row_of_fields(row, of, set) {
  const unit = row.unit && ` in ${row.unit}`;
  /** @type {HTMLInputElement[]} */
  const fields = row.values.map((_, i) => {
    const name = [row.words, row.names[i]].filter(Boolean).join(" ");
    const onchange = () => set(fields.map((field) => field.valueAsNumber));
    return number_field({ onchange, "aria-label": `${name} of ${of}${unit}` });
  });
  /** @param {number[]} values */
  const show = (values) => values.forEach((value, i) => (fields[i].value = rounded(value)));
  const label = label_of(row);
  if (row.names.length === 0)
    return { show, element: element("div", { class: "row" }, element("label", { class: "turn" }, label, ...fields)) };
  label.className = "label";
  const named = fields.map((field, i) => element("label", {}, element("span", {}, row.names[i]), field));
  return { show, element: element("div", { class: "coordinates" }, label, ...named) };
}

/** A field for how far it turns, about which axis.
 *  @param {NumberRow} row @param {string} of @param {Set} set @returns {Fields} */
function row_of_turns(row, of, set) {
  const amount = number_field({ value: row.turn, "aria-label": `${row.words} of ${of} in ${row.unit}` });
  const which = element("select", { "aria-label": `Axis that ${of} rotates about` },
    ...row.names.map((name, i) => element("option", { value: i }, name)),
  );
  const add = button(row.words, () =>
    set(row.names.map((_, i) => (i === Number(which.value) ? amount.valueAsNumber : 0))),
  );
  return {
    show: () => {},
    element: element("div", { class: "row" },
      element("label", { class: "turn" }, label_of(row), amount),
      element("span", { class: "row" }, element("span", {}, "about"), which, add),
    ),
  };
}

export class NumberTools {
  #door;
  #act;
  #rows = /** @type {Fields[][]} */ ([]); // of each group
  #seed = element("input", { type: "number", min: 0, max: Number.MAX_SAFE_INTEGER, step: 1, inputmode: "numeric" });
  #section;
  #title = element("h2", {});
  #groups = element("div", {});
  #numbers = /** @type {NumberGroup[]} */ ([]); // as they stand

  /** @param {Door} door @param {Act} act */
  constructor(door, act) {
    this.#door = door;
    this.#act = act;
    const scatter = (/** @type {Event} */ event) => {
      event.preventDefault();
      act(() => door.scatter(other_seed(this.#seed, this.#seed_now)));
    };
    this.#section = element("div", { class: "number-tools", hidden: true },
      this.#title,
      this.#groups,
      element("form", { class: "fields", onsubmit: scatter },
        element("label", {}, element("span", {}, "Seed"), this.#seed),
        element("button", { type: "submit", class: "button" }, "Scatter"),
        button("Reset", () => act(() => door.command("reset_points"))),
      ),
    );
    by_id("points").append(this.#section);
  }

  open(/** @type {Lesson} */ { tools }) {
    this.#section.hidden = tools.points;
  }

  /** @param {number} group @param {number} row @param {number[]} values */
  #set(group, row, values) {
    if (values.every(Number.isFinite))
      this.#act(() => answer_edit(this.#door.set_numbers(group, row, values)));
    this.#show(); // what was not taken, too
  }

  /** Anew where there are others: what is typed keeps its field. */
  #lay_out = when_changed((/** @type {NumberGroup[]} */ groups) => {
    this.#rows = groups.map(({ name, rows }, g) =>
      rows.map((row, r) =>
        (row.turn > 0 ? row_of_turns : row_of_fields)(row, name, (values) => this.#set(g, r, values)),
      ),
    );
    this.#groups.replaceChildren(
      ...groups.map(({ heading }, g) =>
        element("fieldset", { class: "group" },
          element("legend", {}, heading),
          ...this.#rows[g].map((row) => row.element),
        ),
      ),
    );
  });

  #show() {
    this.#numbers.forEach(({ rows }, g) => rows.forEach(({ values }, r) => this.#rows[g][r].show(values)));
  }

  #seed_now = 0;
  #show_seed = when_changed((/** @type {string} */ _lesson, /** @type {number} */ seed) => {
    this.#seed_now = seed;
    this.#seed.value = String(seed);
  });
  #show_numbers = when_changed((/** @type {NumberGroup[]} */ numbers) => {
    this.#numbers = numbers;
    this.#lay_out(
      numbers.map(({ heading, name, rows }) => ({
        heading,
        name,
        rows: rows.map((row) => ({ ...row, values: row.values.map(() => 0) })),
      })),
    );
    this.#show();
  });

  update(/** @type {View} */ view) {
    set_text(this.#title, this.#section.hidden ? "" : view.toolsTitle); // a situation may have another body
    this.#show_seed(view.lesson, view.seed);
    this.#show_numbers(view.numbers);
  }
}
