// The tools for points: choose a set, add, delete, scatter, reset, load a file, and a point's coordinates.
import { button, by_id, capital, element, is_within, kWrites, other_seed, set_text, when_changed } from "./dom.js";
import { result_as_csv } from "./result.js";
import { answer_edit, clear_notices, notice } from "./messages.js";

const kAxes = ["x", "y", "z"];
const kPasted = "pasted.csv"; // its ending lets tabs separate numbers
const kMostBytes = 64e6;
const kMostMeasured = 256e6; // bytes: two million points, written out

/** @param {string} words @param {HTMLElement} field */
const label = (words, field) => element("label", {}, element("span", {}, words), field);
/** A coordinate, with as many digits as fit in its field. */
const short = (/** @type {number} */ value) => Number(value.toPrecision(6));

/** The whole numbers of a field. */
const kWhole = { type: "number", min: 0, step: 1, inputmode: "numeric" };

/** @typedef {Pick<View, "source" | "size" | "lesson" | "situation">} SourceNow */

export class PointTools {
  #door;
  #act;
  #bring_mesh;
  /** @type {View} */
  #view;
  /** @type {Lesson} */
  #lesson;
  #sets_of = /** @type {string | null | undefined} */ (undefined); // the situation whose sets are offered
  #own = "own"; // the source of its own points
  #names = ["point", "points"]; // singular and plural
  #section;
  #title = element("h2", {});
  #point_words = element("span", {});
  #says = element("p", { class: "label", id: "points-heading" });
  #set = element("select", { onchange: () => this.#choose_set() });
  #count = element("input", { ...kWhole, min: 1, max: 5000, value: 26 });
  #seed = element("input", { ...kWhole, max: Number.MAX_SAFE_INTEGER });
  #point = element("input", { ...kWhole, placeholder: "none", "aria-label": "Selected point" });
  #axes = kAxes.map((axis) =>
    element("input", {
      type: "number",
      step: "any",
      inputmode: "decimal",
      "aria-label": `${axis} of the selected point`,
    }),
  );
  #file = element("input", {
    type: "file",
    class: "unseen",
    tabindex: "-1",
    "aria-hidden": "true",
    accept: ".xyz,.csv,.txt,.obj,.ply,.stl,.off,.json",
  });
  #delete = button("Delete", () => this.#command("delete_point"), { class: "button adds-or-takes" });
  #count_label = label("How many", this.#count);
  #axis_labels = kAxes.map((axis, i) => label(axis, this.#axes[i]));

  /** bring_mesh(name): the mesh's bytes.
   *  @param {Door} door @param {Act} act @param {(name: string) => Promise<Bytes>} bring_mesh */
  constructor(door, act, bring_mesh) {
    this.#door = door;
    this.#act = act;
    this.#bring_mesh = bring_mesh;
    const scatter = (/** @type {Event} */ event) => {
      event.preventDefault();
      this.#scatter(other_seed(this.#seed, this.#view.seed));
    };
    this.#section = element("div", {},
      this.#title,
      this.#says,
      element("form", { class: "fields", onsubmit: scatter },
        label("Set", this.#set),
        this.#count_label,
        label("Seed", this.#seed),
        element("button", { type: "submit", class: "button" }, "Scatter"),
      ),
      element("div", { class: "row" },
        button("Add", () => this.#command("add_point"), { class: "button adds-or-takes" }),
        this.#delete,
        button("Reset", () => this.#command("reset_points")),
        button("Open file…", () => this.#file.click()),
        this.#file,
      ),
      element("div", { class: "coordinates" },
        element("label", {}, this.#point_words, this.#point),
        ...this.#axis_labels,
      ),
    );
    by_id("points").append(this.#section);
    this.#point.addEventListener("change", () => this.#select());
    for (const field of this.#axes) field.addEventListener("change", () => this.#move());
    this.#file.addEventListener("change", () => {
      const [file] = this.#file.files ?? [];
      if (file) this.load(file);
      this.#file.value = "";
    });
    this.#accept_drops();
    this.#accept_pastes();
  }

  open(/** @type {Lesson} */ lesson) {
    this.#section.hidden = !lesson.tools.points;
    this.#names = lesson.handleWords;
    this.#title.textContent = capital(this.#names[1]);
    this.#point_words.textContent = capital(this.#names[0]);
    this.#lesson = lesson;
    this.#sets_of = undefined;
  }

  /** The sets to choose from. The situation's own is the first. */
  #show_sets(/** @type {string | null} */ situation) {
    if (this.#sets_of === situation) return;
    this.#sets_of = situation;
    const { situations, generators, meshes } = this.#lesson;
    const { mesh, generate, count } = situations.find(({ name }) => name === situation) ?? this.#lesson;
    const own = mesh ? capital(mesh) : generate ? capital(generate) : "The lesson’s";
    const others = [
      ...generators.filter((name) => name !== generate).map((name) => ({ name, value: `generate:${name}` })),
      ...meshes.filter((name) => name !== mesh).map((name) => ({ name, value: `mesh:${name}` })),
    ];
    this.#set.replaceChildren(
      element("option", { value: "" }, own),
      ...others.map(({ name, value }) => element("option", { value }, capital(name))),
    );
    this.#count.value = String(count || 26);
    this.#count_label.hidden = true;
    this.#own = mesh || generate || "own";
  }

  #command(/** @type {string} */ name) {
    const why = name === "delete_point" ? ": select a point first; the last one cannot be deleted" : "";
    this.#act(() => this.#door.command(name) || notice(`That cannot be done now${why}.`));
  }

  #choose_set() {
    const [kind, name] = this.#set.value.split(":");
    this.#count_label.hidden = kind !== "generate";
    if (kind === "mesh") return this.bring(name);
    if (kind === "generate") return this.#scatter(Number(this.#seed.value));
    if (kind === "") this.#command("reset_points");
  }

  #scatter(/** @type {number} */ seed) {
    const [kind, name] = this.#set.value.split(":");
    const count = Number(this.#count.value);
    this.#act(() => {
      if (kind === "generate") return answer_edit(this.#door.set_generator(name, count, seed));
      this.#door.scatter(seed);
      clear_notices();
    });
  }

  /** Selects the option of the points' source. The student's own file gets its own option. */
  #show_source = when_changed((/** @type {SourceNow} */ { source, size }) => {
    const listed = [`generate:${source}`, `mesh:${source}`].find((value) => this.#option(value));
    const value = source === this.#own ? "" : (listed ?? `other:${source}`);
    this.#set.querySelector("option[value^='other:']")?.remove();
    if (!this.#option(value)) this.#set.append(element("option", { value }, source === "task" ? "The task’s" : source));
    this.#set.value = value;
    this.#count_label.hidden = !value.startsWith("generate:");
    if (!this.#count_label.hidden) this.#count.value = String(size);
  });
  #option(/** @type {string} */ value) {
    return [...this.#set.options].find((option) => option.value === value);
  }

  /** Loads a mesh by its name. */
  async bring(/** @type {string} */ name) {
    try {
      const bytes = await this.#bring_mesh(name);
      await this.#use(bytes, name);
    } catch {
      notice(`The mesh “${name}” could not be loaded. Check the connection, then choose it again.`);
    }
  }

  /** Returns whether the file was taken; a notice says why not. */
  async load(/** @type {File} */ file) {
    const most = this.#view.cover ? kMostMeasured : kMostBytes;
    if (file.size > most) {
      notice(`${file.name} is larger than ${most / 1e6} MB, which is more than a page should hold.`);
      return false;
    }
    return this.#use(new Uint8Array(await file.arrayBuffer()), file.name);
  }

  /** @param {Bytes} bytes @param {string} name */
  async #use(bytes, name) {
    let error = "";
    const refused = await this.#act(() => {
      error = this.#take(bytes, name);
      const what = name === kPasted ? "Those rows" : "That file";
      // What is wrong with the file itself begins with its name.
      if (error.startsWith(name)) notice(`${what} cannot be used. ${error}.`);
      else answer_edit(error);
    });
    return !error && !refused;
  }

  /** Uses a file: points, or a result to draw over the chart.
   *  @param {Bytes} bytes @param {string} name */
  #take(bytes, name) {
    try {
      const result = typeof bytes === "string" ? null : result_as_csv(bytes);
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
    const { selected, coordinates } = this.#view;
    if (selected === null || coordinates === null) return;
    const fields = this.#axes.slice(0, coordinates.length);
    // An emptied field has no number: the point stays, and its coordinates are shown again.
    if (fields.some((field) => !Number.isFinite(field.valueAsNumber))) return this.#show_place(selected, coordinates);
    // A coordinate that was not edited keeps the digits that its field has no room for.
    const [x, y, z] = this.#axes.map((field, i) => {
      const at = coordinates[i] ?? 0;
      return i < fields.length && field.valueAsNumber !== short(at) ? field.valueAsNumber : at;
    });
    this.#act(() => {
      const error = this.#door.move_point(selected, x, y, z);
      if (error) notice(/too large/.test(error) ? "That number is too large for the stage." : `${capital(error)}.`);
      else clear_notices();
    });
    this.#show_place(this.#view.selected, this.#view.coordinates);
  }

  #accept_drops() {
    const carries_file = (/** @type {DragEvent} */ { dataTransfer }) => Boolean(dataTransfer?.types.includes("Files"));
    const show = (/** @type {boolean} */ on) => (by_id("drop").hidden = !on);
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
      this.#take_dropped([...(event.dataTransfer?.files ?? [])]);
    });
  }

  /** Rows of numbers, as spreadsheets copy them, wherever nobody writes. */
  #accept_pastes() {
    document.addEventListener("paste", (event) => {
      const text = event.clipboardData?.getData("text/plain") ?? "";
      if (is_within(event.target, kWrites) || !/\d/.test(text)) return;
      event.preventDefault();
      this.load(new File([text], kPasted));
    });
  }

  /** Takes the first of several files, and says what became of each. */
  async #take_dropped(/** @type {File[]} */ [first, ...others]) {
    if (!first) return;
    const taken = await this.load(first);
    if (taken) notice(`${first.name} is open.`, "told");
    if (others.length > 0)
      notice(`One file is taken at a time; not opened: ${others.map(({ name }) => name).join(", ")}.`);
  }

  /** @param {number | null} selected @param {number[] | null} coordinates */
  #show_place(selected, coordinates) {
    this.#point.value = selected === null ? "" : String(selected);
    this.#axes.forEach((field, i) => {
      const at = coordinates?.[i];
      field.disabled = at === undefined;
      field.value = at === undefined ? "" : String(short(at));
    });
    this.#axis_labels[2].hidden = this.#view.dim !== 3;
    this.#delete.disabled = selected === null;
  }

  #show_seed = when_changed((/** @type {Pick<View, "lesson" | "seed">} */ { seed }) => {
    this.#seed.value = String(seed);
  });
  #show_selected = when_changed((/** @type {Pick<View, "lesson" | "selected" | "coordinates">} */ now) =>
    this.#show_place(now.selected, now.coordinates),
  );

  update(/** @type {View} */ view) {
    this.#view = view;
    const { lesson, size, seed, source, situation, selected, coordinates } = view;
    const changed = view.edited ? ", changed" : "";
    const rounded = view.scalar === "float" ? ", rounded to float" : "";
    set_text(this.#says, `${size.toLocaleString("en")} ${this.#names[size === 1 ? 0 : 1]}${changed}${rounded}`);
    this.#point.max = String(size - 1);
    this.#show_seed({ lesson, seed });
    this.#show_sets(situation);
    this.#show_source({ source, size, lesson, situation });
    this.#show_selected({ lesson, selected, coordinates });
    by_id("undo").disabled = !view.canUndo;
    by_id("redo").disabled = !view.canRedo;
  }
}
