// What an exercise has beyond a question: the count of decisions and marks, hints, and at its end the mark, what was
// decided, and the result file.
import { button, by_id, element, followed_here, set_hidden, set_text, spelled } from "./dom.js";
import { exercise_link } from "./address.js";
import { link_of } from "./lesson_menu.js";
/** @import { Kept } from "./kept.js"
 *  @import { Saving } from "./saving.js" */

const kMarks = { right: "✓", wrong: "✕", skipped: "–", open: "·" };
export const kEnd = 2 ** 30; // a step after all others: the player stops at what is open
const kMostSeed = 2 ** 32;
const kVersion = 1; // of the result file

export const fresh_seed = () => crypto.getRandomValues(new Uint32Array(1))[0] % kMostSeed;

/** The text of a result file. student: a name, or "".
 *  @param {string} student @param {Attempt[]} attempts @param {string} version */
export const result_text = (student, attempts, version) =>
  `${JSON.stringify({ snug_result: kVersion, version, student, attempts }, null, 1)}\n`;

/** An attempt whose first decisions have the times at which they were made, and the others come after them.
 *  @param {Attempt} attempt @param {string[]} before @returns {Attempt} */
export function with_times(attempt, before) {
  const times = (/** @type {string} */ decision) => Number(decision.split("@")[1]);
  const from = Math.max(0, ...before.map(times));
  const decisions = attempt.decisions.map((decision, i) => {
    const [made] = decision.split("@");
    return made === before[i]?.split("@")[0] ? before[i] : `${made}@${(from + times(decision)).toFixed(1)}`;
  });
  return { ...attempt, decisions, seconds: Math.max(0, ...decisions.map(times)) };
}

const hint_count = (/** @type {number} */ hints) => (hints === 1 ? "1 hint" : `${hints} hints`);

export class Exercise {
  #door;
  #act;
  #kept;
  #go;
  #again;
  #hand_in;
  #exercises;
  #saving;
  #words;

  /** exercises: the course's. again: on another instance. hand_in: saves the result.
   *  @param {Door} door @param {Act} act
   *  @param {{ exercises: ExerciseEntry[], kept: Kept, go: GoTo, again: (terms?: Terms) => void,
   *    hand_in: () => void, saving: Saving }} of */
  constructor(door, act, { exercises, kept, go, again, hand_in, saving }) {
    this.#saving = saving;
    this.#words = door.words();
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
  place(/** @type {ShownExercise} */ { decision, decisions, countKnown, mark, practises }) {
    const so_far = practises ? "practice, no mark" : mark === null ? "told at the end" : `mark ${mark}`;
    return [`Decision ${decision + 1}${countKnown ? ` of ${decisions}` : ""}`, so_far];
  }

  /** Where it is kept, beside the card's heading. */
  say_saved(/** @type {HTMLElement} */ card) {
    const heading = card.querySelector(".kicker");
    const head = element("div", { class: "card-head" });
    heading?.replaceWith(head);
    if (heading) head.append(heading, this.#saving.line());
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
  tools(/** @type {ShownExercise} */ { hint, canTakeBack }) {
    const back = canTakeBack &&
      button(this.#words.take_back, this.#do("take_back"), { class: "quiet", title: "Backspace" });
    return [back, hint !== "" && button(hint, this.#do("hint"), { class: "quiet", title: "H" })];
  }

  /** What is to be built, the levels with those that are reached, and how far it is.
   *  @param {ShownExercise} exercise @param {Build} build @param {(Node | string)[]} prompt */
  build_card(exercise, { heading, claim, levels, isNow, canGoBack, canFinish }, prompt) {
    const { mark, of, practises } = exercise;
    const back = button(this.#words.back_to_best, this.#do("back_to_best"), { disabled: !canGoBack });
    const finish = { class: "button primary", "data-first": true, disabled: !canFinish };
    return element("div", { class: "card predict build", tabindex: "-1" },
      element("h2", { class: "kicker" }, heading,
        element("span", { class: "place-of" }, practises ? " · practice, no mark" : ` · mark ${mark} of ${of}`)),
      claim && element("blockquote", { class: "claim" }, claim),
      element("p", { class: "prompt" }, ...prompt),
      levels.length > 1 && this.#levels(levels),
      element("p", { class: "says is-now", role: "status" }, isNow),
      ...this.hints(exercise),
      element("div", { class: "commit" },
        ...this.tools(exercise),
        button(this.#words.start_again, this.#do("reset_points"), { class: "quiet" }),
        element("span", { class: "gap" }),
        back,
        button(this.#words.finish, this.#do("finish"), finish),
      ),
    );
  }

  /** What stands on the stage is said while it is dragged; the card stays as it is. */
  show_now(/** @type {ShownExercise | null} */ exercise) {
    const { classList } = document.documentElement;
    classList.toggle("builds", Boolean(exercise?.build));
    classList.toggle("adds", Boolean(exercise?.build?.adds));
    const says = by_id("ask").querySelector(".is-now");
    if (exercise?.build && says) set_text(says, exercise.build.isNow);
  }

  /** A level that the stage reaches now has a full mark, one that was reached before a hollow one. */
  #levels(/** @type {Build["levels"]} */ levels) {
    const level = (/** @type {Build["levels"][0]} */ { words, now, best }) =>
      element("li", { class: now ? "now" : best ? "best" : "" },
        element("span", { "aria-hidden": "true" }, now ? kMarks.right : best ? "○" : kMarks.open),
        ` ${words}`,
        element("span", { class: "unseen" }, now ? ", reached" : best ? ", reached before" : ", not reached"));
    return element("ol", { class: "levels" }, ...levels.map(level));
  }

  /** The levels that were reached, whatever stands on the stage when it is over: a solution may reach more.
   *  @param {Build} build */
  #reached({ levels }) {
    const solves = levels.every(({ now }) => now) && !levels.every(({ best }) => best);
    return [levels.length > 1 && this.#levels(levels.map((level) => ({ ...level, now: level.best }))),
      solves && element("p", { class: "label" }, this.#words.model_stands)];
  }

  /** The card at its end. title_of: of a lesson, undefined if the course has none of that id.
   *  @param {ShownExercise} exercise @param {(id: string) => string | undefined} title_of */
  summary(exercise, title_of) {
    const { mark, of, rows, followed, firstDifference, lesson, practises, build } = exercise;
    const to_lesson = { href: link_of(lesson), onclick: followed_here(() => this.#go(lesson)) };
    return element("div", { class: "card summary exercise-end", tabindex: "-1" },
      element("h2", { class: "kicker" }, practises ? "Practice" : this.#words.your_mark),
      !practises && element("p", { class: "mark-line" }, element("b", {}, String(mark)), ` of ${of}`),
      !practises && this.#best_of(exercise.exercise),
      ...followed.map((says) => element("p", { class: "rule" }, says)),
      !build && element("p", { class: "runs" }, ...spelled(firstDifference), " ",
        button(this.#words.both_runs, this.#do("other_run"), { class: "quiet", title: "R" })),
      ...(build ? this.#reached(build) : []),
      rows.length > 0 &&
        element("ol", { class: "lines-of" }, ...rows.map((row) => element("li", {}, this.#line_of(row, practises)))),
      element("div", { class: "commit" },
        build && button(this.#words.show_model, this.#do("show_model"), { class: "quiet" }),
        this.#other_terms(exercise),
        !practises && button(this.#words.hand_in, this.#hand_in, { title: "Saves a result file" }),
        element("span", { class: "gap" }),
        title_of(lesson) && element("a", { class: "button", ...to_lesson }, this.#words.to_lesson),
        this.#next(exercise),
      ),
    );
  }

  /** The best mark, where one tried more than once. */
  #best_of(/** @type {string} */ id) {
    const kept = this.#kept.exercise(id);
    if (!kept?.best || kept.tries < 2) return null;
    return element("p", { class: "label" }, `Best ${kept.best.mark} of ${kept.best.of} in ${kept.tries} tries`);
  }

  /** Where one may go on to from a decision that is looked at again.
   *  @param {ShownExercise} exercise */
  in_own_run({ decision, decisions }) {
    const last = decision + 1 === decisions;
    const first = { class: "button primary", "data-first": true };
    const to_mark = button(this.#words.your_mark, this.#do("continue"), last ? first : { class: "quiet" });
    const other = button(this.#words.right_run, this.#do("other_run"), { title: "R" });
    return last ? [other, to_mark] : [to_mark, other, button(this.#words.next_decision, this.#do("step"), first)];
  }

  /** While the right run is looked at: what was decided here.
   *  @param {ShownExercise} exercise */
  right_card({ compared }) {
    return element("div", { class: "card", tabindex: "-1" },
      element("h2", { class: "kicker" }, this.#words.right_run),
      element("p", {}, ...spelled(compared)),
      element("div", { class: "commit" },
        button(this.#words.your_mark, this.#do("last"), { class: "quiet" }),
        element("span", { class: "gap" }),
        button(this.#words.your_run, this.#do("other_run"), { title: "R", "data-first": true })));
  }

  /** From a mark to practice without one, and back. */
  #other_terms(/** @type {ShownExercise} */ { level, practises }) {
    const again = () => this.#again({ level, practice: !practises });
    return button(practises ? this.#words.for_mark : this.#words.without_mark, again, { class: "quiet" });
  }

  /** Another instance: a harder one after success. */
  #next(/** @type {ShownExercise} */ { level, leadsOn, practises }) {
    const again = () => this.#again({ level: leadsOn ? level + 1 : level, practice: practises });
    const words = leadsOn ? this.#words.harder : this.#words.another;
    return button(words, again, { class: "button primary", "data-first": true });
  }

  /** A line of the summary: it leads back to the decision. */
  #line_of(/** @type {ExerciseRow} */ { id, short, kind, mark, hints }, /** @type {boolean} */ practises) {
    const earned = [!practises && String(mark), hints > 0 && hint_count(hints)].filter(Boolean).join(", ");
    return element("button", { type: "button", class: `line ${kind}`, onclick: this.#do(`review:${id}`) },
      element("span", { class: "mark", "aria-hidden": "true" }, kMarks[kind]),
      element("span", { class: "what" }, ...spelled(short)),
      element("b", {}, earned),
    );
  }
}
