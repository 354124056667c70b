// What comes next in a demo.

const kSays = {
  caption: "the sentence", prose: "the lesson’s text", numbers: "the numbers", code: "the code",
  steps: "the steps, played", answer: "the answer",
};

/** What the next press does, what is left to reveal in this state, and the next one.
 *  @param {DemoFile} file @param {{ at: number, revealed: number }} standing */
export function next_text(file, { at, revealed }) {
  const says = /** @type {Record<string, string>} */ (kSays);
  const left = file.states[at].reveal.slice(revealed).map((what) => says[what]).join(", then ");
  const last = at + 1 === file.states.length, after = last ? "This is the last state." : file.states[at + 1].slide;
  if (!left) return last ? after : `Next: ${after}`;
  return `Next: ${left}. ${last ? "" : "After that: "}${after}`;
}
