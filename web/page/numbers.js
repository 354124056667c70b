// The tools of what is no set of points: every number of it that can be typed, scatter and reset.
import { button, by_id, element, other_seed, set_text, when_changed } from "./dom.js";
import { answer_edit } from "./messages.js";

const rounded = (number) => Number(number.toPrecision(6));
const number_field = (properties) => element("input", { type: "number", step: "any", inputmode: "decimal", ...properties });
const label_of = ({ words, unit }) => (unit ? `${words}, ${unit}` : words);

/** Fields for the numbers of a row. set(values). */
function row_of_fields(row, of, set) {
  const fields = row.values.map((_, i) => number_field({ onchange: () => set(fields.map((field) => field.valueAsNumber)),
    "aria-label": `${[row.words, row.names[i]].filter(Boolean).join(" ")} of ${of}${row.unit ? ` in ${row.unit}` : ""}` }));
  const show = (values) => values.forEach((value, i) => (fields[i].value = rounded(value)));
  if (row.names.length === 0) return { show, element: element("div", { class: "row" }, element("label", { class: "turn" }, element("span", {}, label_of(row)), ...fields)) };
  return { show, element: element("div", { class: "coordinates" }, element("span", { class: "label" }, label_of(row)),
    ...fields.map((field, i) => element("label", {}, element("span", {}, row.names[i]), field))) };
}

/** A field for how far it turns, about which axis. */
function row_of_turns(row, of, set) {
  const amount = number_field({ value: row.turn, "aria-label": `${row.words} of ${of} in ${row.unit}` });
  const which = element("select", { "aria-label": `Axis that ${of} rotates about` }, ...row.names.map((name, i) => element("option", { value: i }, name)));
  const add = button(row.words, () => set(row.names.map((_, i) => (i === Number(which.value) ? amount.valueAsNumber : 0))));
  return { show: () => {}, element: element("div", { class: "row" }, element("label", { class: "turn" }, element("span", {}, label_of(row)), amount),
    element("span", { class: "row" }, element("span", {}, "about"), which, add)) };
}

export class NumberTools {
  #door;
  #act;
  #rows = []; // of each group
  #seed = element("input", { type: "number", min: 0, max: Number.MAX_SAFE_INTEGER, step: 1, inputmode: "numeric" });
  #section;
  #title = element("h2", {});
  #groups = element("div", {});
  #numbers = []; // as they stand

  constructor(door, act) {
    this.#door = door;
    this.#act = act;
    const scatter = (event) => {
      event.preventDefault();
      act(() => door.scatter(other_seed(this.#seed, this.#seed_now)));
    };
    this.#section = element("div", { class: "number-tools", hidden: true }, this.#title, this.#groups,
      element("form", { class: "fields", onsubmit: scatter }, element("label", {}, element("span", {}, "Seed"), this.#seed),
        element("button", { type: "submit", class: "button" }, "Scatter"), button("Reset", () => act(() => door.command("reset_points")))));
    by_id("points").append(this.#section);
  }

  open({ tools }) {
    this.#section.hidden = tools.points;
  }

  #set(group, row, values) {
    if (values.every(Number.isFinite))
      this.#act(() => answer_edit(this.#door.set_numbers(group, row, values)));
    this.#show(); // what was not taken, too
  }

  /** Anew where there are others: what is typed keeps its field. */
  #lay_out = when_changed((groups) => {
    this.#rows = groups.map(({ name, rows }, g) => rows.map((row, r) =>
      (row.turn > 0 ? row_of_turns : row_of_fields)(row, name, (values) => this.#set(g, r, values))));
    this.#groups.replaceChildren(...groups.map(({ heading }, g) =>
      element("fieldset", { class: "group" }, element("legend", {}, heading), ...this.#rows[g].map((row) => row.element))));
  });

  #show() {
    this.#numbers.forEach(({ rows }, g) => rows.forEach(({ values }, r) => this.#rows[g][r].show(values)));
  }

  #seed_now = 0;
  #show_seed = when_changed((_lesson, seed) => (this.#seed.value = this.#seed_now = seed));
  #show_numbers = when_changed((numbers) => {
    this.#numbers = numbers;
    this.#lay_out(numbers.map(({ heading, name, rows }) => ({ heading, name, rows: rows.map((row) => ({ ...row, values: row.values.map(() => 0) })) })));
    this.#show();
  });

  update(view) {
    set_text(this.#title, this.#section.hidden ? "" : view.toolsTitle); // a situation may have another body
    this.#show_seed(view.lesson, view.seed);
    this.#show_numbers(view.numbers);
  }
}
