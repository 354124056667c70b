// What an address asks the page for. The place in a lesson that it names is the core's to read and to write.

/** The address that the page has now. What is packed stands after a #: servers refuse long addresses, and do not see
 *  that part. */
export const here = () => location.search + (location.hash.startsWith("#packed=") ? location.hash : "");

/** Each mistake in it is left out, and gets a sentence in `problems`.
 *  @param {string} search */
export function read_address(search) {
  const given = new URLSearchParams(search.replace("#", "&"));
  const problems = /** @type {string[]} */ ([]);

  const whole = (/** @type {string} */ name) => {
    const text = given.get(name);
    if (text === null) return null;
    if (/^\d+$/.test(text) && Number.isSafeInteger(Number(text))) return Number(text);
    problems.push(`The address has ${name} "${text.slice(0, 40)}", which must be a whole number.`);
    return null;
  };
  const exercise = given.get("exercise");
  return {
    lesson: given.get("lesson"),
    place: search,
    exercise,
    seed: exercise === null ? null : whole("seed"), // a lesson's is part of the place
    level: whole("level"),
    practice: given.get("practice") === "1",
    demo: given.get("demo"),
    state: whole("state"),
    notes: given.get("notes") === "1",
    embed: given.get("embed") === "1",
    mark: given.get("mark"),
    problems,
  };
}

/** Without a seed it leads to the attempt that was left, or to the student's own instance.
 *  @param {string} id @param {Terms} [terms] */
export function exercise_link(id, { seed, level = 0, practice = false } = {}) {
  const parts = [`exercise=${encodeURIComponent(id)}`];
  if (seed !== undefined) parts.push(`seed=${seed}`);
  if (level > 0) parts.push(`level=${level}`);
  if (practice) parts.push("practice=1");
  return `?${parts.join("&")}`;
}

/** @param {ShownExercise} exercise @returns {Terms} */
export const terms_of = ({ seed, level, practises }) => ({ seed, level, practice: practises });

/** An address with one more key. @param {string} address @param {string} pair */
export function with_pair(address, pair) {
  const [search, packed] = address.split("#");
  return `${search}&${pair}${packed === undefined ? "" : `#${packed}`}`;
}
