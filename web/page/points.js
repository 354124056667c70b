// The tools for points: choose a set, add, delete, scatter, reset, load a file, and a point's coordinates.
import { button, by_id, capital, element, other_seed, set_text, when_changed } from "./dom.js";
import { result_as_csv } from "./result.js";
import { answer_edit, at_work, clear_notices, notice, veil } from "./messages.js";

const kAxes = ["x", "y", "z"];
const kMostBytes = 64e6;
const kMostMeasured = 256e6; // bytes: two million points, written out

const label = (words, field) => element("label", {}, element("span", {}, words), field);
/** A coordinate, with as many digits as fit in its field. */
const short = (value) => Number(value.toPrecision(6));

export class PointTools {
  #door;
  #act;
  #bring_mesh;
  #view = null;
  #lesson = null;
  #sets_of; // the situation whose sets are offered
  #own = "own"; // the source of its own points
  #names = ["point", "points"]; // singular and plural
  #section;
  #title = element("h2", {});
  #point_words = element("span", {});
  #says = element("p", { class: "label", id: "points-heading" });
  #set = element("select", { onchange: () => this.#choose_set() });
  #count = element("input", { type: "number", min: 1, max: 5000, step: 1, value: 26, inputmode: "numeric" });
  #seed = element("input", { type: "number", min: 0, max: Number.MAX_SAFE_INTEGER, step: 1, inputmode: "numeric" });
  #point = element("input", { type: "number", min: 0, step: 1, inputmode: "numeric", placeholder: "none", "aria-label": "Selected point" });
  #axes = kAxes.map((axis) => element("input", { type: "number", step: "any", inputmode: "decimal", "aria-label": `${axis} of the selected point` }));
  #file = element("input", { type: "file", class: "unseen", tabindex: "-1", "aria-hidden": "true", accept: ".xyz,.csv,.txt,.obj,.ply,.stl,.off,.json" });
  #delete = button("Delete", () => this.#command("delete_point"));
  #count_label = label("How many", this.#count);

  /** bring_mesh(name): the mesh's bytes. */
  constructor(door, act, bring_mesh) {
    this.#door = door;
    this.#act = act;
    this.#bring_mesh = bring_mesh;
    const scatter = (event) => {
      event.preventDefault();
      this.#scatter(other_seed(this.#seed, this.#view.seed));
    };
    this.#section = element("div", {},
      this.#title, this.#says,
      element("form", { class: "fields", onsubmit: scatter }, label("Set", this.#set), this.#count_label,
        label("Seed", this.#seed), element("button", { type: "submit", class: "button" }, "Scatter")),
      element("div", { class: "row" }, button("Add", () => this.#command("add_point")), this.#delete,
        button("Reset", () => this.#command("reset_points")), button("Open file…", () => this.#file.click()), this.#file),
      element("div", { class: "coordinates" }, element("label", {}, this.#point_words, this.#point), ...kAxes.map((axis, i) => label(axis, this.#axes[i]))));
    by_id("points").append(this.#section);
    this.#point.addEventListener("change", () => this.#select());
    for (const field of this.#axes) field.addEventListener("change", () => this.#move());
    this.#file.addEventListener("change", () => {
      if (this.#file.files[0]) this.load(this.#file.files[0]);
      this.#file.value = "";
    });
    this.#accept_drops();
  }

  open(lesson) {
    this.#section.hidden = !lesson.tools.points;
    this.#names = lesson.handleWords;
    this.#title.textContent = capital(this.#names[1]);
    this.#point_words.textContent = capital(this.#names[0]);
    this.#lesson = lesson;
    this.#sets_of = undefined;
  }

  /** The sets to choose from. The situation's own is the first. */
  #show_sets(situation) {
    if (this.#sets_of === situation) return;
    this.#sets_of = situation;
    const { situations, generators, meshes } = this.#lesson;
    const { mesh, generate, count } = situations.find(({ name }) => name === situation) ?? this.#lesson;
    const own = mesh ? capital(mesh) : generate ? capital(generate) : "The lesson’s";
    const others = (names, kind, own_name) => names.filter((name) => name !== own_name)
      .map((name) => element("option", { value: `${kind}:${name}` }, capital(name)));
    this.#set.replaceChildren(element("option", { value: "" }, own), ...others(generators, "generate", generate), ...others(meshes, "mesh", mesh));
    this.#count.value = count || 26;
    this.#count_label.hidden = true;
    this.#own = mesh || generate || "own";
  }

  #command(name) {
    this.#act(() => this.#door.command(name) || notice(`That cannot be done now${name === "delete_point" ? ": select a point first; the last one cannot be deleted" : ""}.`));
  }

  #choose_set() {
    const [kind, name] = this.#set.value.split(":");
    this.#count_label.hidden = kind !== "generate";
    if (kind === "mesh") return this.bring(name);
    if (kind === "generate") return this.#scatter(Number(this.#seed.value));
    if (kind === "") this.#command("reset_points");
  }

  async #scatter(seed) {
    const [kind, name] = this.#set.value.split(":"), count = Number(this.#count.value);
    const veiled = kind === "generate" && (await at_work(count));
    this.#act(() => answer_edit(kind === "generate" ? this.#door.set_generator(name, count, seed) : this.#door.scatter(seed)));
    if (veiled) veil.lift();
  }

  /** Selects the option of the points' source. The student's own file gets its own option. */
  #show_source = when_changed((source, size) => {
    const value = source === this.#own ? "" : (["generate", "mesh"].map((kind) => `${kind}:${source}`).find((kind) => this.#option(kind)) ?? `other:${source}`);
    this.#set.querySelector("option[value^='other:']")?.remove();
    if (!this.#option(value)) this.#set.append(element("option", { value }, source === "task" ? "The task’s" : source));
    this.#set.value = value;
    this.#count_label.hidden = !value.startsWith("generate:");
    if (!this.#count_label.hidden) this.#count.value = size;
  });
  #option(value) {
    return [...this.#set.options].find((option) => option.value === value);
  }

  /** Loads a mesh by its name. */
  async bring(name) {
    try {
      const bytes = await this.#bring_mesh(name);
      this.#use(bytes, name);
    } catch {
      notice(`The mesh “${name}” could not be loaded. Check the connection, then choose it again.`);
    }
  }

  /** Returns whether the file was taken; a notice says why not. */
  async load(file) {
    const most = this.#view.cover ? kMostMeasured : kMostBytes;
    if (file.size > most) return void notice(`${file.name} is larger than ${most / 1e6} MB, which is more than a page should hold.`);
    return this.#use(new Uint8Array(await file.arrayBuffer()), file.name);
  }

  #use(bytes, name) {
    let error = "";
    this.#act(() => {
      error = this.#take(bytes, name);
      if (error) notice(`That file cannot be used. ${error}.`);
      else clear_notices();
    });
    return !error;
  }

  /** Uses a file: points, or a result to draw over the chart. */
  #take(bytes, name) {
    try {
      const result = result_as_csv(bytes);
      return this.#door.load_file(result ?? bytes, name);
    } catch {
      return `${name} is not a complete result`;
    }
  }

  #select() {
    const point = this.#point.value === "" ? -1 : Number(this.#point.value);
    if (point >= this.#view.size) {
      notice(`There is no point ${point}: the last is ${this.#view.size - 1}.`);
      return this.#show_place(this.#view.selected, this.#view.coordinates);
    }
    this.#act(() => this.#door.select_point(point));
  }

  #move() {
    if (this.#view.selected === null) return;
    const fields = this.#axes.slice(0, this.#view.coordinates.length);
    // An emptied field has no number: the point stays, and its coordinates are shown again.
    if (fields.some((field) => !Number.isFinite(field.valueAsNumber))) return this.#show_place(this.#view.selected, this.#view.coordinates);
    // A coordinate that was not edited keeps the digits that its field has no room for.
    const to = this.#axes.map((field, i) => {
      const at = this.#view.coordinates[i] ?? 0;
      return i < fields.length && field.valueAsNumber !== short(at) ? field.valueAsNumber : at;
    });
    this.#act(() => {
      const error = this.#door.move_point(this.#view.selected, ...to);
      if (error) notice(/too large/.test(error) ? "That number is too large for the stage." : `${capital(error)}.`);
      else clear_notices();
    });
    this.#show_place(this.#view.selected, this.#view.coordinates);
  }

  #accept_drops() {
    const carries_file = (event) => [...(event.dataTransfer?.types ?? [])].includes("Files");
    const show = (on) => (by_id("drop").hidden = !on);
    addEventListener("dragover", (event) => {
      if (!carries_file(event)) return;
      event.preventDefault();
      show(true);
    });
    addEventListener("dragleave", (event) => event.relatedTarget || show(false));
    addEventListener("drop", (event) => {
      if (!carries_file(event)) return;
      event.preventDefault();
      show(false);
      this.#take_dropped([...event.dataTransfer.files]);
    });
  }

  /** Takes the first of several files, and says what became of each. */
  async #take_dropped([first, ...others]) {
    if (!first) return;
    const taken = await this.load(first);
    if (taken) notice(`${first.name} is open.`, "told");
    if (others.length > 0) notice(`One file is taken at a time; not opened: ${others.map(({ name }) => name).join(", ")}.`);
  }

  #show_place(selected, coordinates) {
    const none = selected === null;
    this.#point.value = none ? "" : selected;
    this.#axes.forEach((field, i) => {
      field.disabled = none || i >= coordinates.length;
      field.value = field.disabled ? "" : short(coordinates[i]);
    });
    this.#axes[2].parentElement.hidden = this.#view?.dim !== 3;
    this.#delete.disabled = none;
  }

  #show_seed = when_changed((_lesson, seed) => (this.#seed.value = seed));
  #show_selected = when_changed((_lesson, selected, coordinates) => this.#show_place(selected, coordinates));

  update(view) {
    this.#view = view;
    set_text(this.#says, `${view.size.toLocaleString("en")} ${this.#names[view.size === 1 ? 0 : 1]}${view.edited ? ", changed" : ""}${view.scalar === "float" ? ", rounded to float" : ""}`);
    this.#point.max = view.size - 1;
    this.#show_seed(view.lesson, view.seed);
    this.#show_sets(view.situation);
    this.#show_source(view.source, view.size, view.lesson, view.situation);
    this.#show_selected(view.lesson, view.selected, view.coordinates);
    by_id("undo").disabled = !view.canUndo;
    by_id("redo").disabled = !view.canRedo;
  }
}
