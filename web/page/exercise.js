// What an exercise has beyond a question: the count of decisions and marks, hints, and at its end the mark, what was
// decided, and the result file.
import { button, by_id, element, followed_here, set_hidden, spelled } from "./dom.js";
import { link_of } from "./lesson_menu.js";
/** @import { Kept } from "./kept.js" */

const kMarks = { right: "✓", wrong: "✕", skipped: "–", open: "·" };
const kEnd = 2 ** 30; // a step after all others: the player stops at what is open
const kMostSeed = 2 ** 32;
const kVersion = 1; // of the result file

/** Without a seed it leads to the attempt that was left, or to the student's own instance.
 *  @param {string} id @param {number} [seed] */
export const exercise_link = (id, seed) =>
  `?exercise=${encodeURIComponent(id)}${seed === undefined ? "" : `&seed=${seed}`}`;
export const fresh_seed = () => crypto.getRandomValues(new Uint32Array(1))[0] % kMostSeed;

/** The text of a result file. student: a name, or "".
 *  @param {string} student @param {Attempt[]} attempts @param {string} version */
export const result_text = (student, attempts, version) =>
  `${JSON.stringify({ snug_result: kVersion, version, student, attempts }, null, 1)}\n`;

/** @param {string} text @param {string} name */
export function save_file(text, name) {
  const href = URL.createObjectURL(new Blob([text], { type: "application/json" }));
  element("a", { href, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(href), 1000);
}

const hint_words = (/** @type {number} */ price) =>
  price >= 1 ? "for the whole mark" : `for ${price} of the mark`;
const hint_count = (/** @type {number} */ hints) => (hints === 1 ? "1 hint" : `${hints} hints`);

export class Exercise {
  #door;
  #act;
  #kept;
  #go;
  #again;
  #hand_in;
  #exercises;

  /** exercises: the course's. again: on another instance. hand_in: saves the result.
   *  @param {Door} door @param {Act} act
   *  @param {{ exercises: ExerciseEntry[], kept: Kept, go: GoTo, again: () => void, hand_in: () => void }} of */
  constructor(door, act, { exercises, kept, go, again, hand_in }) {
    this.#door = door;
    this.#act = act;
    this.#kept = kept;
    this.#go = go;
    this.#again = again;
    this.#hand_in = hand_in;
    this.#exercises = exercises;
  }

  #do(/** @type {string} */ command) {
    return () => this.#act(() => this.#door.command(command));
  }

  /** How many decisions there are would tell where a test ends. */
  place(/** @type {ShownExercise} */ { decision, decisions, countKnown, mark }) {
    const so_far = mark === null ? "told at the end" : `mark ${mark}`;
    return [`Decision ${decision + 1}${countKnown ? ` of ${decisions}` : ""}`, so_far];
  }

  /** Where the player stands before what was decided last. */
  back_card(/** @type {ShownExercise} */ { decision }) {
    const back = button(`Back to decision ${decision + 1}`, () => this.#act(() => this.#door.go(kEnd)),
      { class: "button primary", "data-first": true });
    return element("div", { class: "card", tabindex: "-1" }, element("div", { class: "commit" }, back));
  }

  /** The exercises of the lesson that was opened, at the end of its text. */
  open(/** @type {Lesson} */ { id: open_id }) {
    const own = this.#exercises.filter(({ lesson }) => lesson === open_id);
    set_hidden(by_id("practise"), own.length === 0);
    const link = (/** @type {ExerciseEntry} */ { id, title }) => {
      const to = { href: exercise_link(id), onclick: followed_here(() => this.#go(id)) };
      return element("a", { class: "button", ...to }, `Practise: ${title}`);
    };
    by_id("practise").replaceChildren(...own.map(link));
  }

  /** What became of the decision before, if it was right: it is told beside the next one.
   *  @param {ShownExercise} exercise @param {Outcome[]} outcomes @param {Answer | null} tried */
  before({ tellsAtOnce }, outcomes, tried) {
    const last = outcomes[outcomes.length - 1];
    if (!tellsAtOnce || !last?.right || tried) return null;
    return element("p", { class: "before" }, element("b", {}, `${kMarks.right} `), ...spelled(last.says));
  }

  /** The rule that a wrong decision followed, and the hints taken. */
  hints(/** @type {ShownExercise} */ { hints, rule }) {
    const taken = hints.map((hint) => element("p", { class: "hint" }, element("b", {}, "Hint: "), ...spelled(hint)));
    return rule ? [element("p", { class: "rule" }, rule), ...taken] : taken;
  }

  /** The ways back, and to the next hint. */
  tools(/** @type {ShownExercise} */ { nextPrice, canTakeBack }) {
    const back = canTakeBack && button("Take back", this.#do("take_back"), { class: "quiet", title: "Backspace" });
    const words = `Hint ${hint_words(nextPrice)}`;
    return [back, nextPrice > 0 && button(words, this.#do("hint"), { class: "quiet", title: "H" })];
  }

  /** The card at its end. title_of: of a lesson, undefined if the course has none of that id.
   *  @param {ShownExercise} exercise @param {(id: string) => string | undefined} title_of */
  summary({ exercise, mark, of, rows, followed, lesson }, title_of) {
    const kept = this.#kept.exercise(exercise);
    const best = kept?.best && kept.tries > 1
      ? `Best ${kept.best.mark} of ${kept.best.of} in ${kept.tries} tries`
      : null;
    const to_lesson = { href: link_of(lesson), onclick: followed_here(() => this.#go(lesson)) };
    return element("div", { class: "card summary exercise-end", tabindex: "-1" },
      element("h2", { class: "kicker" }, "Your mark"),
      element("p", { class: "mark-line" }, element("b", {}, String(mark)), ` of ${of}`),
      best && element("p", { class: "label" }, best),
      ...followed.map((says) => element("p", { class: "rule" }, says)),
      element("ol", { class: "lines-of" }, ...rows.map((row) => element("li", {}, this.#line_of(row)))),
      element("div", { class: "commit" },
        button("Hand in", this.#hand_in, { title: "Saves a result file" }),
        element("span", { class: "gap" }),
        title_of(lesson) && element("a", { class: "button", ...to_lesson }, "To the lesson"),
        button("Another instance", this.#again, { class: "button primary", "data-first": true }),
      ),
    );
  }

  /** A line of the summary: it leads back to the decision. */
  #line_of(/** @type {ExerciseRow} */ { id, short, kind, mark, hints }) {
    return element("button", { type: "button", class: `line ${kind}`, onclick: this.#do(`review:${id}`) },
      element("span", { class: "mark", "aria-hidden": "true" }, kMarks[kind]),
      element("span", { class: "what" }, ...spelled(short)),
      element("b", {}, hints > 0 ? `${mark}, ${hint_count(hints)}` : String(mark)),
    );
  }
}
