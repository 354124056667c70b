// What a function costs: a chart of accuracy against steps, with the reference solution and other methods on the same
// cases. Below it stands what the marks are, which is all that it says.
import { element } from "./dom.js";

const kWide = 440, kHigh = 200; // of the chart, in its own units
const kLeft = 44, kRight = 14, kTop = 12, kBottom = 34; // room for the axes' words
const kRoom = 1.08; // beyond the costliest
const kSays = "A step is a call, a condition or a turn of a loop: the engine counts them, on the same cases.";
const kSpace = "http://www.w3.org/2000/svg";

/** An element of a picture.
 *  @param {string} tag @param {Record<string, string | number>} properties @param {...(Node | string)} children */
function drawn(tag, properties, ...children) {
  const made = document.createElementNS(kSpace, tag);
  for (const [name, value] of Object.entries(properties)) made.setAttribute(name, String(value));
  made.append(...children);
  return made;
}

/** A method's mark: the reference solution is a disc, one's own method a ring, the others have a letter.
 *  @param {Costed} of @param {string} letter @param {number} x @param {number} y */
function mark_of({ kind }, letter, x, y) {
  if (kind === "yours") return drawn("circle", { class: "yours", cx: x, cy: y, r: 8 });
  if (kind === "model") return drawn("circle", { class: "model", cx: x, cy: y, r: 4.5 });
  return drawn("g", { class: "other" }, drawn("circle", { cx: x, cy: y, r: 7 }),
    drawn("text", { x, y: y + 3.5, "text-anchor": "middle" }, letter));
}

/** A round number of steps between two lines of the grid. */
function apart(/** @type {number} */ most) {
  const power = 10 ** Math.floor(Math.log10(most / 3));
  return [1, 2, 5, 10].map((times) => times * power).find((step) => most / step <= 5) ?? most;
}

const in_words = (/** @type {number} */ count) => count.toLocaleString("en");
/** All is 100 %, and nothing else is. */
const per_cent = (/** @type {number} */ share) =>
  `${share === 1 ? 100 : Math.min(Math.round(1000 * share) / 10, 99.9)} %`;
const steps_text = (/** @type {number} */ steps) => (steps < 100 ? steps.toFixed(1) : in_words(Math.round(steps)));

/** @param {Costed[]} methods in the order of their steps */
function chart(methods) {
  const most = Math.max(...methods.map(({ steps }) => steps)) * kRoom, step = apart(most);
  const x_of = (/** @type {number} */ steps) => kLeft + (kWide - kLeft - kRight) * steps / most;
  const y_of = (/** @type {number} */ share) => kTop + (kHigh - kTop - kBottom) * (1 - share);
  const parts = [0, 0.5, 1].flatMap((share) => [
    drawn("line", { x1: kLeft, x2: kWide - kRight, y1: y_of(share), y2: y_of(share) }),
    drawn("text", { x: kLeft - 8, y: y_of(share) + 4, "text-anchor": "end" }, `${100 * share} %`)]);
  for (let at = 0; at <= most; at += step)
    parts.push(drawn("text", { x: x_of(at), y: kHigh - kBottom + 16, "text-anchor": "middle" }, in_words(at)));
  parts.push(drawn("text", { x: kWide - kRight, y: kHigh - 3, "text-anchor": "end" }, "steps a case →"));
  // One's own ring lies around what stands at the same place.
  const own = (/** @type {Costed} */ { kind }) => kind === "yours";
  const shown = [...methods.filter((one) => !own(one)), ...methods.filter(own)];
  const marks = shown.map((one) => mark_of(one, letter_of(one, methods), x_of(one.steps), y_of(one.right)));
  const picture = { class: "cost-chart", viewBox: `0 0 ${kWide} ${kHigh}`, "aria-hidden": "true" };
  return drawn("svg", picture, ...parts, ...marks);
}

/** @param {Costed} one @param {Costed[]} methods */
const letter_of = (one, methods) =>
  "abcdefgh"[methods.filter(({ kind }) => kind === "other").indexOf(one)] ?? "";

/** The chart with its table. methods: in any order.
 *  @param {Costed[]} methods */
export function cost_parts(methods) {
  const sorted = [...methods].sort((a, b) => a.steps - b.steps);
  const mark = (/** @type {Costed} */ one) =>
    drawn("svg", { viewBox: "0 0 20 20", "aria-hidden": "true" }, mark_of(one, letter_of(one, sorted), 10, 10));
  const row = (/** @type {Costed} */ one) => element("tr", { class: one.kind },
    element("th", { scope: "row" }, mark(one), one.title),
    element("td", {}, per_cent(one.right)), element("td", {}, steps_text(one.steps)));
  return [
    element("h2", { class: "kicker" }, "Its cost in steps"),
    chart(sorted),
    element("table", { class: "write-methods" },
      element("thead", {}, element("tr", {},
        ...["Method", "Cases right", "Steps a case"].map((words) => element("th", { scope: "col" }, words)))),
      element("tbody", {}, ...sorted.map(row))),
    element("p", { class: "label" }, kSays),
  ];
}
