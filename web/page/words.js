// Makes HTML of the lesson's texts, and keeps the figures of the run in them as they are now.
import { element, set_text, whole_names } from "./dom.js";

/** Shows a figure, or says why it is not shown: its sign alone would be read as nothing. */
function fill(node, { text, says } = { text: "…", says: "" }) {
  if (node.textContent === text + says) return;
  node.classList.toggle("untold", says !== "");
  if (says === "") return set_text(node, text);
  node.replaceChildren(element("span", { "aria-hidden": "true" }, text), element("span", { class: "unseen" }, says));
}

/** What ends a phrase. After a button, which is a box of its own in a line, it would begin the next line. */
const kStops = /^[.,:;?!)]+/;

export class Words {
  #formulas;
  #figures = {};

  /** formulas: {TeX: MathML}. */
  constructor(formulas) {
    this.#formulas = formulas;
  }

  /** The figures in every text that is on the page. */
  update({ proseFigures }) {
    this.#figures = proseFigures;
    for (const node of document.querySelectorAll("[data-figure]")) fill(node, proseFigures[node.dataset.figure]);
    for (const node of document.querySelectorAll(".sentence")) this.#leave_out(node);
  }

  /** A paragraph's nodes. link(text, link): makes one. */
  of(stretches, link) {
    const stops = stretches.map(({ link: linked }, i) => {
      const next = stretches[i + 1];
      return linked && next && !next.tex && !next.figure && !next.link && !next.code ? kStops.exec(next.text)?.[0] ?? "" : "";
    });
    return stretches.map((stretch, i) => {
      const node = this.#stretch(stops[i - 1] ? { ...stretch, text: stretch.text.slice(stops[i - 1].length) } : stretch, link);
      return stops[i] ? element("span", { class: "kept" }, node, stops[i]) : node;
    });
  }

  /** A sentence that tells a figure, while that has no value yet. */
  #leave_out(sentence) {
    const unknown = ({ dataset }) => this.#figures[dataset.figure]?.known === false;
    sentence.hidden = [...sentence.querySelectorAll("[data-figure]")].some(unknown);
  }

  /** The nodes of stretches, each sentence that tells a figure as one. */
  #in_sentences(stretches, nodes) {
    const telling = new Set(stretches.filter(({ figure }) => figure).map(({ sentence }) => sentence));
    const wholes = new Map();
    return nodes.flatMap((node, i) => {
      const { sentence } = stretches[i];
      if (sentence === undefined || !telling.has(sentence)) return [node];
      const whole = wholes.get(sentence);
      if (whole) return whole.append(node), [];
      wholes.set(sentence, element("span", { class: "sentence" }, node));
      return [wholes.get(sentence)];
    });
  }

  /** A paragraph, a list or a table. */
  block({ kind, rows, right }, link) {
    const of = (cell) => this.of(cell, link);
    if (kind === "bullets" || kind === "numbers")
      return element(kind === "bullets" ? "ul" : "ol", {}, ...rows.map(([item]) => element("li", {}, ...of(item))));
    if (kind === "table") return this.#table(rows, right, of);
    const [[stretches]] = rows;
    if (stretches.length !== 1 || !stretches[0].tex) {
      const paragraph = element("p", {}, ...this.#in_sentences(stretches, of(stretches)));
      for (const node of paragraph.querySelectorAll(".sentence")) this.#leave_out(node);
      return paragraph;
    }
    const [{ text, tex }] = stretches; // without other words it is on its own line
    return element("p", { class: "display" }, this.#formula(tex, text, `$$${tex}$$`));
  }

  #table([head, ...rows], right, of) {
    const at = (i) => ({ class: right[i] ? "right" : null });
    const heading = (cell, i) => (cell.length > 0 ? element("th", { scope: "col", ...at(i) }, ...of(cell)) : element("td"));
    const cell_of = (cell, i) => element("td", at(i), ...of(cell));
    return element("table", {}, element("thead", {}, element("tr", {}, ...head.map(heading))),
      element("tbody", {}, ...rows.map((cells) => element("tr", {}, ...cells.map(cell_of)))));
  }

  #stretch({ text, strong, emphasis, code, script, tex, link, figure }, make_link) {
    let node = tex ? this.#formula(tex, text) : figure ? this.#figure(figure) : link ? make_link(text, link) : whole_names(text);
    for (const [tag, holds] of [["code", code], [script, script], ["em", emphasis], ["strong", strong]])
      if (holds) node = element(tag, {}, node);
    return node;
  }

  /** It follows every drag, too often to be said each time. */
  #figure(name) {
    const node = element("span", { class: "figure", "data-figure": name, "aria-live": "off" });
    fill(node, this.#figures[name]);
    return node;
  }

  /** The formula as typeset when the page was built; if it was not, on one line. */
  #formula(tex, plain, alone = tex) {
    const typeset = this.#formulas[alone] ?? this.#formulas[tex];
    const math = typeset && new DOMParser().parseFromString(typeset, "text/html").querySelector("math");
    if (!math) return element("span", { class: "formula" }, plain);
    math.setAttribute("aria-label", plain.replaceAll("\u00a0", " "));
    return math;
  }
}
