// The address says what is on the page: lesson, situation, step, seed, algorithms, where the sliders stand, and what
// was edited, in rows of numbers, and in a scene's file: as it runs, and as it was typed after that.
import { change_of } from "./text_change.js";

/** The address that the page has now. What is packed stands after a #: servers refuse long addresses, and do not see
 *  that part. */
export const here = () => location.search + (location.hash.startsWith("#packed=") ? location.hash : "");

/** What an address asks for. Each mistake in it is left out, and gets a sentence in `problems`.
 *  @param {string} search */
export function read_address(search) {
  const given = new URLSearchParams(search.replace("#", "&"));
  const problems = /** @type {string[]} */ ([]);

  const whole = (/** @type {string} */ name) => {
    const text = given.get(name);
    if (text === null) return null;
    if (/^\d+$/.test(text) && Number.isSafeInteger(Number(text))) return Number(text);
    problems.push(`The address has ${name} “${text.slice(0, 40)}”, which is not a whole number.`);
    return null;
  };
  /** The last step is any that is too large. */
  const step = () => (given.get("step") === "end" ? Infinity : whole("step"));
  const scalar = () => {
    const text = given.get("scalar");
    if (text === null || text === "float" || text === "double") return text;
    problems.push("The address has a scalar that is neither float nor double.");
    return null;
  };
  const from = () => {
    const text = given.get("from") ?? "";
    if (/^([a-z]+|[a-z]+:[1-9]\d{0,4})?$/.test(text)) return text;
    problems.push("The address moves points that do not exist.");
    return "";
  };
  const number = (/** @type {string} */ text) => (text.trim() === "" ? NaN : Number(text));
  const rows = (/** @type {string[]} */ ...names) => {
    const name = names.find((one) => given.get(one));
    if (!name) return null;
    const read = (given.get(name) ?? "").split(";").map((row) => row.split(",").map(number));
    if (read.every((row) => row.every(Number.isFinite))) return read;
    problems.push(`The numbers that the address gives as ${name} cannot be read.`);
    return null;
  };
  return {
    lesson: given.get("lesson"),
    exercise: given.get("exercise"),
    embed: given.get("embed") === "1",
    situation: given.get("situation"),
    demo: given.get("demo"),
    state: whole("state"),
    notes: given.get("notes") === "1",
    step: step(),
    seed: whole("seed"),
    level: whole("level"),
    practice: given.get("practice") === "1",
    scalar: scalar(),
    from: from(),
    rows: rows("rows", "points", "boxes"), // the last two in links of old
    packed: given.get("packed"),
    mark: given.get("mark"),
    moved: rows("moved"),
    slide: rows("slide")?.[0] ?? null,
    camera: rows("camera")?.[0] ?? null,
    file: given.get("file"),
    draft: given.get("draft"),
    a: given.get("a"),
    b: given.get("b"),
    problems,
  };
}

/** Whether an address has all of what stands here: more points than it can hold are left out.
 *  @param {SharedRows} shared */
export const has_all = ({ rows, packed, how }) => Boolean(rows || packed || how !== undefined);

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

/** The scalar that the lesson's file gives to the situation that is shown.
 *  @param {View} view @param {Lesson} lesson */
const own_scalar = (view, lesson) => (lesson.situations.find(({ name }) => name === view.situation) ?? lesson).scalar;

/** The address of what is on the page. shared: as web/deeds.hpp's shared_rows says it.
 *  @param {View} view @param {Lesson} lesson @param {SharedRows} shared @param {boolean} embed */
export function write_address(view, lesson, shared, embed) {
  const rows = (/** @type {Rows} */ list) => list.map((row) => row.join(",")).join(";");
  if (view.exercise)
    return exercise_link(lesson.id, terms_of(view.exercise)) + (embed ? "&embed=1" : "");
  const parts = [`lesson=${encodeURIComponent(lesson.id)}`];
  if (!view.previewing) parts.push(`step=${view.step}`); // the preview is not a step that anyone chose
  parts.push(`seed=${view.seed}`);
  if (view.situation !== null && view.situation !== lesson.situations[0].name)
    parts.push(`situation=${encodeURIComponent(view.situation)}`);
  if (view.algorithm !== lesson.algorithms[0]?.name) parts.push(`a=${view.algorithm}`);
  if ((view.beside ?? "") !== lesson.compare) parts.push(`b=${view.beside ?? "none"}`);
  if (view.scalar !== null && view.scalar !== own_scalar(view, lesson)) parts.push(`scalar=${view.scalar}`);
  if (shared.how) parts.push(`from=${shared.how}`);
  if (shared.slide) parts.push(`slide=${shared.slide.join(",")}`);
  if (shared.moved?.length) parts.push(`moved=${rows(shared.moved)}`);
  if (shared.rows) parts.push(`rows=${rows(shared.rows)}`);
  if (shared.camera) parts.push(`camera=${shared.camera.join(",")}`);
  if (view.file) {
    const changes = {
      file: change_of(view.file.own, view.file.runs),
      draft: change_of(view.file.runs, view.file.typed),
    };
    for (const [name, change] of Object.entries(changes))
      if (change) parts.push(`${name}=${encodeURIComponent(change)}`);
  }
  if (embed) parts.push("embed=1");
  return `?${parts.join("&")}${shared.packed ? `#packed=${shared.packed}` : ""}`;
}
