// The algorithm, the one beside it, and the pseudocode with the line that the step belongs to.
import { by_id, element, set_text, spelled } from "./dom.js";
import { notice } from "./messages.js";

export class Code {
  #door;
  #act;
  #main = element("select", { id: "algorithm", onchange: () => this.#choose(0, this.#main) });
  #beside = element("select", { id: "beside", onchange: () => this.#choose(1, this.#beside) });
  #fields = element("div", { class: "fields" }, element("label", {}, element("span", {}, "Algorithm"), this.#main),
    element("label", {}, element("span", {}, "Compare with"), this.#beside));
  #lines = element("ol", { class: "lines" });
  #items = /** @type {HTMLElement[]} */ ([]);
  #source = element("p", { class: "source" });

  /** @param {Door} door @param {Act} act */
  constructor(door, act) {
    this.#door = door;
    this.#act = act;
    by_id("code").append(
      element("h2", { class: "unseen", id: "code-heading" }, "Pseudocode"),
      this.#fields,
      this.#lines,
      this.#source,
    );
    new ResizeObserver(() => this.#fit()).observe(this.#lines);
    // After a resize, the highlighted line is where it would be had the panel always had this size.
    new ResizeObserver(() => {
      by_id("code").scrollTop = 0;
      this.#keep_in_view();
    }).observe(by_id("code"));
  }

  #keep_in_view() {
    if (this.#lit) keep_in_view(this.#lit, by_id("code"), this.#fields);
  }

  /** Puts the two selectors one below the other if they are too narrow for a name side by side. */
  #fit() {
    this.#fields.classList.remove("long");
    this.#fields.classList.add("natural");
    const cut = this.#main.offsetWidth > (this.#main.parentElement?.clientWidth ?? 0);
    this.#fields.classList.remove("natural");
    this.#fields.classList.toggle("long", cut);
  }

  open(/** @type {Lesson} */ lesson) {
    const options = lesson.algorithms.map(({ name, title }) => element("option", { value: name }, title));
    this.#main.replaceChildren(...options);
    this.#beside.replaceChildren(
      element("option", { value: "" }, "(none)"),
      ...options.map((option) => option.cloneNode(true)),
    );
    this.#sources = new Map(lesson.algorithms.map(({ name, source }) => [name, source]));
    this.#shown = { algorithm: "", code: "", line: -1 };
    by_id("code").scrollTop = 0;
    this.#fit();
  }

  #sources = /** @type {Map<string, string>} */ (new Map());

  /** @param {number} slot @param {HTMLSelectElement} select */
  #choose(slot, select) {
    this.#act(() => {
      const error = this.#door.choose(slot, select.value);
      if (error) notice(`That algorithm cannot be shown: ${error}.`);
    });
    this.#shown = { algorithm: "", code: "", line: -1 };
  }

  #shown = { algorithm: "", code: "", line: -1 };
  #lit = /** @type {HTMLElement | null} */ (null);

  update(/** @type {View} */ view) {
    if (this.#shown.algorithm !== view.algorithm || this.#main.value !== view.algorithm)
      this.#main.value = view.algorithm;
    if (this.#beside.value !== (view.beside ?? "")) this.#beside.value = view.beside ?? "";
    const code = view.code.join("\n"); // the same algorithm's may come later, or be another lesson's
    if (this.#shown.algorithm !== view.algorithm || this.#shown.code !== code) {
      this.#items = view.code.map((line) => {
        const text = line.trimStart();
        const item = element("li", {}, element("code", {}, ...spelled(text)));
        item.style.setProperty("--depth", String((line.length - text.length) / 2));
        return item;
      });
      this.#lines.replaceChildren(...this.#items);
      set_text(this.#source, this.#sources.get(view.algorithm) ?? "");
      this.#shown = { algorithm: view.algorithm, code, line: -1 };
    }
    if (this.#shown.line === view.line) return;
    this.#items[this.#shown.line]?.removeAttribute("aria-current");
    this.#lit = this.#items[view.line] ?? null;
    this.#lit?.setAttribute("aria-current", "step");
    this.#keep_in_view();
    this.#shown.line = view.line;
  }
}

const kLineBeyond = 1.5; // lines that stay visible before and after the highlighted one, clear of the fade

/** Scrolls only the code panel, never the page. on_top: what may stay there while the lines scroll.
 *  @param {HTMLElement} item @param {HTMLElement} scroller @param {HTMLElement} on_top */
function keep_in_view(item, scroller, on_top) {
  const [line, box] = [item.getBoundingClientRect(), scroller.getBoundingClientRect()];
  const beyond = kLineBeyond * line.height;
  const covered = getComputedStyle(on_top).position === "sticky" ? on_top.offsetHeight : 0;
  const above = line.top - beyond - box.top - covered;
  const below = line.bottom + beyond - box.bottom;
  if (above < 0) scroller.scrollTop += above;
  else if (below > 0) scroller.scrollTop += Math.min(below, above);
}
