// The card of keys: what each does in a lesson, in a presentation, and in a demo, with those of a clicker.
import { button, element } from "./dom.js";
import { bring_style, show_dialog } from "./sheet.js";

const kPage = [
  ["Shift D", "add what stands here to a demo’s file"],
  ["Q", "this state as a code that a phone scans"],
  ["F5, Shift P", "present, and end the presentation"],
];
const kPresenting = [
  ["N  P", "the next lesson, the previous one"],
  ["T", "the lesson’s text"],
  ["L", "the pointer as a spotlight"],
  ["W", "the pointer as a pen, whose strokes fade"],
  ["R", "a ruler for the height of type"],
  ["B  .", "black, and the picture again by any key"],
  ["F", "the picture is frozen while you prepare another"],
  ["Tab, Enter", "to the next button or link, and press it"],
  ["Esc", "puts the pointers away; then ends the presentation"],
];
const kDemo = [
  ["Page Down, →", "the next reveal, or the next state"],
  ["Page Up, ←", "back, to what was shown then"],
  ["Home, H", "this state as it was, after any drag; so does a key for next or back that is held"],
  ["B  .", "black, and the picture again"],
  ["F", "the picture is frozen while you prepare another"],
  ["S", "the notes, in a second window"],
  ["F5", "the whole screen"],
  ["V, a number", "a vote: the hands for each answer, Enter after each; or “B 31”. V again: the second vote"],
  ["L  W  R  Q", "spotlight, pen, ruler, and the code to scan"],
  ["Tab, Enter", "to the next button or link, and press it"],
  ["Esc", "puts the pointers away; then leaves the demo, and the lesson stays"],
];

const list = (/** @type {string} */ title, /** @type {string[][]} */ rows) =>
  [element("h3", {}, title), element("dl", {}, ...rows.flatMap(([keys, does]) =>
    [element("dt", {}, keys), element("dd", {}, does)]))];

/** lesson: the rows of the program, which every door has. @param {string[][]} lesson */
export function show_keys(lesson) {
  if (document.querySelector(".keys-card")) return;
  bring_style("hall.css");
  const lists = [list("In a lesson", [...lesson, ...kPage]), list("In a presentation", kPresenting),
    list("In a demo", kDemo)];
  const { classList } = document.documentElement;
  const first = classList.contains("demo") ? 2 : classList.contains("presenting") ? 1 : 0; // what one is in
  lists.unshift(...lists.splice(first, 1));
  const dialog = show_dialog("keys-card", "Keys",
    ...lists.flat(),
    button("Close", () => dialog.close(), { class: "button primary" }));
  dialog.addEventListener("keydown", (event) => event.key === "?" && dialog.close());
  dialog.querySelector("h2")?.focus(); // not the button at its end, which would scroll there
}
