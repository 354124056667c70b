// A state of a demo as its file has it.

/** What a demo's file calls the parts of an address. */
const kKeys = { lesson: "lesson", situation: "situation", a: "algorithm", b: "compare", scalar: "scalar", seed: "seed",
  from: "from", slide: "sliders", moved: "moved", rows: "rows", step: "step" };
const kNumbers = new Set(["seed", "step"]);

/** A state as a demo's file has it. address: of the lesson as it stands; trace: its hash.
 *  @param {string} address @param {string} title @param {string} trace */
export function state_text(address, title, trace) {
  const given = new URLSearchParams(address);
  const quoted = JSON.stringify; // a text of TOML is escaped as one of JSON
  const lines = Object.entries(kKeys).flatMap(([name, key]) => {
    const value = given.get(name);
    return value === null || value === "" ? [] : [`${key} = ${kNumbers.has(key) ? value : quoted(value)}`];
  });
  const own = [`hash = ${quoted(trace)}`, `slide = ${quoted(title)}`, ...lines];
  return ["[[state]]", ...own, 'shows = ["caption", "numbers", "code"]', 'notes = "What you say."', ""].join("\n");
}
