// Makes HTML of the lesson's texts, and keeps the figures of the run in them as they are now.
import { element, set_text, whole_axes, whole_names } from "./dom.js";

/** Shows a figure, or says why it is not shown: its sign alone would be read as nothing. */
function fill(/** @type {HTMLElement} */ node, { text, says } = { text: "…", says: "" }) {
  if (node.textContent === text + says) return;
  node.classList.toggle("untold", says !== "");
  if (says === "") return set_text(node, text);
  node.replaceChildren(element("span", { "aria-hidden": "true" }, text), element("span", { class: "unseen" }, says));
}

/** @param {ParentNode} within @param {string} selector */
const all_in = (within, selector) => /** @type {HTMLElement[]} */ ([...within.querySelectorAll(selector)]);
/** Of the figure that is told there. */
const name_of = (/** @type {HTMLElement} */ node) => node.dataset.figure ?? "";

/** What ends a phrase. After a button, which is a box of its own in a line, it would begin the next line. */
const kStops = /^[.,:;?!)]+/;

/** Makes a link of its text.
 *  @typedef {(text: string, link: Link) => Node} MakeLink */

export class Words {
  #formulas;
  #figures = /** @type {View["proseFigures"]} */ ({});

  /** formulas: MathML by TeX. */
  constructor(/** @type {Record<string, string>} */ formulas) {
    this.#formulas = formulas;
  }

  /** The figures in every text that is on the page. */
  update(/** @type {View} */ { proseFigures }) {
    this.#figures = proseFigures;
    for (const node of all_in(document, "[data-figure]")) fill(node, proseFigures[name_of(node)]);
    for (const node of all_in(document, ".sentence")) this.#leave_out(node);
  }

  /** A paragraph's nodes. link: only where there may be links.
   *  @param {Stretch[]} stretches @param {MakeLink} link */
  of(stretches, link = (text) => new Text(text)) {
    const stops = stretches.map(({ link: linked }, i) => {
      const next = stretches[i + 1];
      if (!linked || !next || next.tex || next.figure || next.link || next.code) return "";
      return kStops.exec(next.text)?.[0] ?? "";
    });
    return stretches.map((stretch, i) => {
      const text = stretch.text.slice(stops[i - 1]?.length ?? 0);
      const node = this.#stretch({ ...stretch, text }, link);
      return stops[i] ? element("span", { class: "kept" }, node, stops[i]) : node;
    });
  }

  /** A sentence that tells a figure, while that has no value yet. */
  #leave_out(/** @type {HTMLElement} */ sentence) {
    sentence.hidden = all_in(sentence, "[data-figure]").some((node) => this.#figures[name_of(node)]?.known === false);
  }

  /** The nodes of stretches, each sentence that tells a figure as one.
   *  @param {Stretch[]} stretches @param {(Node | string)[]} nodes */
  #in_sentences(stretches, nodes) {
    const telling = new Set(stretches.filter(({ figure }) => figure).map(({ sentence }) => sentence));
    /** @type {Map<number, HTMLElement>} */
    const wholes = new Map();
    return nodes.flatMap((node, i) => {
      const { sentence } = stretches[i];
      if (sentence === undefined || !telling.has(sentence)) return [node];
      const begun = wholes.get(sentence);
      begun?.append(node);
      if (begun) return [];
      const whole = element("span", { class: "sentence" }, node);
      wholes.set(sentence, whole);
      return [whole];
    });
  }

  /** A paragraph, a list or a table.
   *  @param {Block} block @param {MakeLink} link */
  block({ kind, rows, right }, link) {
    const of = (/** @type {Stretch[]} */ cell) => this.of(cell, link);
    if (kind === "bullets" || kind === "numbers")
      return element(kind === "bullets" ? "ul" : "ol", {}, ...rows.map(([item]) => element("li", {}, ...of(item))));
    if (kind === "table") return this.#table(rows, right, of);
    const [[stretches]] = rows;
    if (stretches.length !== 1 || !stretches[0].tex) {
      const paragraph = element("p", {}, ...this.#in_sentences(stretches, of(stretches)));
      for (const node of all_in(paragraph, ".sentence")) this.#leave_out(node);
      return paragraph;
    }
    const [{ text, tex }] = stretches; // without other words it is on its own line
    return element("p", { class: "display" }, this.#formula(tex, text, `$$${tex}$$`));
  }

  /** @param {Block["rows"]} rows @param {boolean[]} right @param {(cell: Stretch[]) => (Node | string)[]} of */
  #table([head, ...rows], right, of) {
    const at = (/** @type {number} */ i) => ({ class: right[i] ? "right" : null });
    const heads = head.map((cell, i) =>
      cell.length > 0 ? element("th", { scope: "col", ...at(i) }, ...of(cell)) : element("td"),
    );
    const lines = rows.map((cells) => element("tr", {}, ...cells.map((cell, i) => element("td", at(i), ...of(cell)))));
    return element("table", {}, element("thead", {}, element("tr", {}, ...heads)), element("tbody", {}, ...lines));
  }

  /** @param {Stretch} stretch @param {MakeLink} make_link @returns {Node | string} */
  #plain({ text, tex, link, figure }, make_link) {
    if (tex) return this.#formula(tex, text);
    if (figure) return this.#figure(figure);
    return link ? make_link(text, link) : whole_axes(whole_names(text));
  }

  /** @param {Stretch} stretch @param {MakeLink} make_link */
  #stretch(stretch, make_link) {
    const { strong, emphasis, code, script } = stretch;
    let node = this.#plain(stretch, make_link);
    if (code) node = element("code", {}, node);
    if (script) node = element(script, {}, node);
    if (emphasis) node = element("em", {}, node);
    return strong ? element("strong", {}, node) : node;
  }

  /** It follows every drag, too often to be said each time. */
  #figure(/** @type {string} */ name) {
    const node = element("span", { class: "figure", "data-figure": name, "aria-live": "off" });
    fill(node, this.#figures[name]);
    return node;
  }

  /** The formula as typeset when the page was built; if it was not, on one line.
   *  @param {string} tex @param {string} plain */
  #formula(tex, plain, alone = tex) {
    const typeset = this.#formulas[alone] ?? this.#formulas[tex];
    const math = typeset && new DOMParser().parseFromString(typeset, "text/html").querySelector("math");
    if (!math) return element("span", { class: "formula" }, plain);
    math.setAttribute("aria-label", plain.replaceAll("\u00a0", " "));
    return math;
  }
}
