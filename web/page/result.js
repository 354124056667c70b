// What `snug cost` wrote, in either of its forms.

const quoted = (/** @type {string} */ text) => (/[,"#\r\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text);
const field = (/** @type {unknown} */ value) => (value === null ? "" : quoted(String(value)));
const kUntimed = { median: null, min: null, spread: null, repeats: null, batch: null, trusted: null };
/** @param {string} name @param {any} value */
const filled = (name, value) =>
  value === null && /^(time|overlap|scene_overlap|update)_ns$/.test(name) ? kUntimed : value;
/** {a: {b: 1}} as [["a.b", 1]]; a time that was not taken, null, has its columns all the same
 *  @param {object} object @returns {[string, unknown][]} */
const flat = (object, prefix = "") => Object.entries(object).flatMap(([name, value]) => {
  const own = filled(name, value);
  return own !== null && typeof own === "object" ? flat(own, `${prefix}${name}.`) : [[prefix + name, own]];
});

/** A result in JSON as the CSV that the program reads; null where the bytes are no result. Throws where they are
 *  broken.
 *  @param {Uint8Array} bytes */
export function result_as_csv(bytes) {
  const start = new TextDecoder().decode(bytes.subarray(0, 40));
  if (start.startsWith("# snug table:")) return new TextDecoder().decode(bytes);
  if (!/^\s*\{\s*"table"/.test(start)) return null;
  const { table, provenance, rows } = JSON.parse(new TextDecoder().decode(bytes));
  const lines = [`# snug table: ${table}`, ...flat(provenance).map(([name, value]) => `# ${name}: ${field(value)}`)];
  const columns = flat(rows[0] ?? {}).map(([name]) => name);
  return [...lines, columns.join(","), ...rows.map((/** @type {object} */ row) => {
    const values = Object.fromEntries(flat(row));
    return columns.map((name) => field(values[name] ?? null)).join(",");
  })].join("\n");
}
