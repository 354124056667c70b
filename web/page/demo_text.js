// A state of a demo as its file has it, and what comes next in one.

const kSays = {
  caption: "the sentence", prose: "the lesson’s text", numbers: "the numbers", code: "the code",
  steps: "the steps, played", answer: "the answer",
};

/** A state as a demo's file has it. keys: demo_keys.json. address: of the lesson as it stands; trace: its hash.
 *  @param {DemoKeys} keys @param {string} address @param {string} title @param {string} trace */
export function state_text(keys, address, title, trace) {
  const given = new URLSearchParams(address.replace("#", "&"));
  const quoted = JSON.stringify; // a text of TOML is escaped as one of JSON
  const lines = keys.flatMap(([in_file, in_address, is_number]) => {
    const value = given.get(in_address);
    return value === null || value === "" ? [] : [`${in_file} = ${is_number ? value : quoted(value)}`];
  });
  const own = [`hash = ${quoted(trace)}`, `slide = ${quoted(title)}`, ...lines];
  return ["[[state]]", ...own, 'shows = ["caption", "numbers", "code"]', 'notes = "What you say."', ""].join("\n");
}

/** What the next press does, what is left to reveal in this state, and the next one.
 *  @param {DemoFile} file @param {{ at: number, revealed: number }} standing */
export function next_text(file, { at, revealed }) {
  const says = /** @type {Record<string, string>} */ (kSays);
  const left = file.states[at].reveal.slice(revealed).map((what) => says[what]).join(", then ");
  const last = at + 1 === file.states.length, after = last ? "This is the last state." : file.states[at + 1].slide;
  if (!left) return last ? after : `Next: ${after}`;
  return `Next: ${left}. ${last ? "" : "After that: "}${after}`;
}
