// The tools of two volumes: of boxes and frusta where each is, how large, how turned, in numbers; of all scatter and reset.
import { by_id, button, element, other_seed, when_changed } from "./dom.js";
import { clear_notices, notice } from "./messages.js";

const kAxes = ["x", "y", "z"];
const capital = (word) => word[0].toUpperCase() + word.slice(1);
const kNoBoxes = [{ heading: "", name: "", sizes: "" }, { heading: "", name: "", sizes: "" }]; // of a lesson without
const rounded = (number) => Number(number.toPrecision(6));

class BoxFields {
  #door;
  #act;
  #box;
  #dim = 2;
  #degrees = element("input", { type: "number", step: "any", inputmode: "decimal" });
  #axis = element("select", {}, ...kAxes.map((axis, i) => element("option", { value: i }, axis)));
  #lists = { center: [], half_extents: [] };
  #rest;
  #shown = null;
  #legend = element("legend", {});
  #sizes = element("span", { class: "label" });
  element;

  constructor(door, act, box) {
    this.#door = door;
    this.#act = act;
    this.#box = box;
    const row = (what, label) => element("div", { class: "coordinates" }, label,
      ...kAxes.map((axis, i) => {
        const field = element("input", { type: "number", step: "any", inputmode: "decimal", onchange: () => this.#set(what) });
        this.#lists[what][i] = field;
        return element("label", {}, element("span", {}, axis), field);
      }));
    this.#degrees.addEventListener("change", () => this.#dim === 2 && this.#turn(2, true));
    this.#rest = element("span", { class: "row" }, element("span", {}, "about"), this.#axis, button("Turn", () => this.#turn(Number(this.#axis.value), false)));
    this.element = element("fieldset", { class: "box" }, this.#legend, row("center", element("span", { class: "label" }, "Centre")), row("half_extents", this.#sizes),
      element("div", { class: "row" }, element("label", { class: "turn" }, element("span", {}, "Turn, degrees"), this.#degrees), this.#rest));
  }

  open({ dim, boxes }) {
    this.#dim = dim;
    const { heading, name, sizes } = boxes[this.#box];
    this.#legend.textContent = heading;
    this.#sizes.textContent = sizes;
    for (const [words, list] of [["Centre", this.#lists.center], [sizes, this.#lists.half_extents]])
      list.forEach((field, i) => field.setAttribute("aria-label", `${words} ${kAxes[i]} of ${name}`));
    this.#degrees.setAttribute("aria-label", `Turn of ${name} in degrees`);
    this.#axis.setAttribute("aria-label", `Axis that ${name} is turned about`);
    this.#shown = null;
    for (const list of Object.values(this.#lists)) list[2].parentElement.hidden = dim === 2;
    this.#rest.hidden = dim === 2;
    if (dim === 3) this.#degrees.value = 15;
  }

  #set(what) {
    const values = this.#lists[what].slice(0, this.#dim).map((field) => field.valueAsNumber);
    if (!values.every(Number.isFinite)) return this.#show(this.#shown);
    this.#do(() => this.#door.set_box(this.#box, what, values));
  }

  #turn(axis, to) {
    if (!Number.isFinite(this.#degrees.valueAsNumber)) return this.#show(this.#shown);
    this.#do(() => this.#door.turn_box(this.#box, axis, this.#degrees.valueAsNumber, to));
  }

  #do(what) {
    this.#act(() => {
      const error = what();
      if (error) notice(`${capital(error)}.`);
      else clear_notices();
    });
    this.#show(this.#shown);
  }

  #show(box) {
    for (const [what, list] of Object.entries(this.#lists)) box[what].forEach((number, i) => (list[i].value = rounded(number)));
    if (this.#dim === 2) this.#degrees.value = rounded(box.degrees);
  }

  update(box) {
    if (JSON.stringify(box) === JSON.stringify(this.#shown)) return;
    this.#shown = box;
    this.#show(box);
  }
}

export class BoxTools {
  #door;
  #fields;
  #seed = element("input", { type: "number", min: 0, max: Number.MAX_SAFE_INTEGER, step: 1, inputmode: "numeric" });
  #section;
  #title = element("h2", {});

  constructor(door, act) {
    this.#door = door;
    this.#fields = [0, 1].map((box) => new BoxFields(door, act, box));
    const scatter = (event) => {
      event.preventDefault();
      act(() => door.scatter(other_seed(this.#seed, this.#seed_now)));
    };
    this.#section = element("div", { class: "boxes", hidden: true }, this.#title, ...this.#fields.map((field) => field.element),
      element("form", { class: "fields", onsubmit: scatter }, element("label", {}, element("span", {}, "Seed"), this.#seed),
        element("button", { type: "submit", class: "button" }, "Scatter"), button("Reset", () => act(() => door.command("reset_points")))));
    by_id("points").append(this.#section);
  }

  open(lesson) {
    this.#section.hidden = lesson.hasPoints;
    this.#title.textContent = lesson.hasPoints ? "" : lesson.toolsTitle;
    for (const field of this.#fields) {
      field.element.hidden = !lesson.boxes;
      field.open({ dim: lesson.dim, boxes: lesson.boxes ?? kNoBoxes });
    }
  }

  #seed_now = 0;
  #show_seed = when_changed((_lesson, seed) => (this.#seed.value = this.#seed_now = seed));

  update(view) {
    this.#show_seed(view.lesson, view.seed);
    if (!view.boxes) return;
    view.boxes.forEach((box, i) => this.#fields[i].update(box));
  }
}
