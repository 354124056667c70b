// A state of a demo as its file has it.

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
