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
  #source = element("p", { class: "source" });

  constructor(door, act) {
    this.#door = door;
    this.#act = act;
    by_id("code").append(element("h2", { class: "unseen", id: "code-heading" }, "Pseudocode"), this.#fields, this.#lines, this.#source);
    new ResizeObserver(() => this.#fit()).observe(this.#lines);
    new ResizeObserver(() => { // after a resize, the highlighted line is where it would be had the panel always had this size
      by_id("code").scrollTop = 0;
      if (this.#lit) keep_in_view(this.#lit, by_id("code"));
    }).observe(by_id("code"));
  }

  /** Puts the two selectors one below the other if they are too narrow for a name side by side. */
  #fit() {
    this.#fields.classList.remove("long");
    this.#fields.classList.add("natural");
    const cut = this.#main.offsetWidth > this.#main.parentElement.clientWidth;
    this.#fields.classList.remove("natural");
    this.#fields.classList.toggle("long", cut);
  }

  open(lesson) {
    const options = lesson.algorithms.map(({ name, title }) => element("option", { value: name }, title));
    this.#main.replaceChildren(...options);
    this.#beside.replaceChildren(element("option", { value: "" }, "(none)"), ...options.map((option) => option.cloneNode(true)));
    this.#sources = new Map(lesson.algorithms.map(({ name, source }) => [name, source]));
    this.#shown = {}; // another lesson's algorithm may have the same name but other lines
    by_id("code").scrollTop = 0;
    this.#fit();
  }

  #sources = new Map();

  #choose(slot, select) {
    this.#act(() => {
      const error = this.#door.choose(slot, select.value);
      if (error) notice(`That algorithm cannot be shown: ${error}.`);
    });
    this.#shown = {};
  }

  #shown = {};
  #lit = null;

  update(view) {
    if (this.#shown.algorithm !== view.algorithm || this.#main.value !== view.algorithm) this.#main.value = view.algorithm;
    if (this.#beside.value !== (view.beside ?? "")) this.#beside.value = view.beside ?? "";
    if (this.#shown.algorithm !== view.algorithm) {
      this.#lines.replaceChildren(...view.code.map((line) => {
        const text = line.trimStart();
        const item = element("li", {}, element("code", {}, ...spelled(text)));
        item.style.setProperty("--depth", (line.length - text.length) / 2);
        return item;
      }));
      set_text(this.#source, this.#sources.get(view.algorithm) ?? "");
      this.#shown = { algorithm: view.algorithm, line: -1 };
    }
    if (this.#shown.line === view.line) return;
    this.#lines.children[this.#shown.line]?.removeAttribute("aria-current");
    this.#lit = this.#lines.children[view.line] ?? null;
    this.#lit?.setAttribute("aria-current", "step");
    if (this.#lit) keep_in_view(this.#lit, by_id("code"));
    this.#shown.line = view.line;
  }
}

const kLineBeyond = 1.5; // lines that stay visible before and after the highlighted one, clear of the fade

/** The height of the algorithm selectors, if they stay on top while the lines scroll; otherwise 0. */
function kept_on_top(scroller) {
  const fields = scroller.querySelector(".fields");
  return getComputedStyle(fields).position === "sticky" ? fields.offsetHeight : 0;
}

/** Scrolls only the code panel, never the page. */
function keep_in_view(item, scroller) {
  const [line, box] = [item.getBoundingClientRect(), scroller.getBoundingClientRect()];
  const beyond = kLineBeyond * line.height;
  const above = line.top - beyond - box.top - kept_on_top(scroller);
  const below = line.bottom + beyond - box.bottom;
  if (above < 0) scroller.scrollTop += above;
  else if (below > 0) scroller.scrollTop += Math.min(below, above);
}
