// The questions, at the bottom of the stage: each question, its outcome, and at the end a summary of all of them.
// Every sentence comes from the program, so that the window has the same ones.
import { by_id, button, element, followed_here, is_within, set_text, spelled } from "./dom.js";
import { link_of } from "./lesson_menu.js";
/** @import { Exercise } from "./exercise.js"
 *  @import { Words } from "./words.js" */

const kMarks = { right: "✓", wrong: "✕", skipped: "–", open: "?" };

/** Of a text only its words count, whose figures follow the run without being laid out anew. */
const as_laid_out = (/** @type {string} */ key, /** @type {unknown} */ value) =>
  key === "prompt" || key === "because" || key === "isNow" ? undefined : value;
/** @param {string} words @param {string} place */
const kicker = (words, place = "", kind = "") =>
  element("h2", { class: `kicker ${kind}` }, words, place && element("span", { class: "place-of" }, ` · ${place}`));
/** Whether the choices are lines of code. */
const are_code = (/** @type {string[]} */ choices) => choices.some((words) => /[;={}]/.test(words));
/** @param {...(HTMLElement | false | null)} children */
const row = (...children) => element("div", { class: "commit" }, ...children);
/** @param {string} words @param {() => void} onclick */
const quiet = (words, onclick) => element("button", { type: "button", class: "quiet", onclick }, words);

export class QuestionCard {
  #door;
  #act;
  #words;
  #texts;
  #after;
  #exercise;
  #shown = "";
  #choices = /** @type {HTMLElement[]} */ ([]);
  #ordered = false; // whether they are put into an order
  #many = false; // whether several choices can be right
  #says = element("p", { class: "says", role: "status" });
  #commit;

  /** texts: what makes HTML of prompts and reasons. after: where one may go from here. next(id): to the lesson that
   *  follows or undefined; title(id): a lesson's; show_task: null where the task is not on the page. exercise: what an
   *  exercise has beyond questions.
   *  @param {Door} door @param {Act} act @param {Words} texts
   *  @param {{ next: (id: string) => CourseLesson | undefined, go: GoTo, title: (id: string) => string | undefined,
   *    show_task: (() => void) | null }} after
   *  @param {Exercise} exercise */
  constructor(door, act, texts, after, exercise) {
    this.#exercise = exercise;
    this.#door = door;
    this.#act = act;
    this.#texts = texts;
    this.#after = after;
    this.#words = door.words();
    this.#commit = button(this.#words.answer, () => this.#do("commit_answer"), { class: "button primary" });
    // Any press while the skipped steps are played ends the playing, and does nothing else.
    addEventListener("pointerdown", (event) => {
      if (this.#watching && !is_within(event.target, ".place")) this.#do("continue");
    }, { capture: true });
  }

  /** @type {Lesson} */
  #lesson;
  #watching = false;
  #waiting = /** @type {string[]} */ ([]); // the algorithms that the card offers

  open(/** @type {Lesson} */ lesson) {
    this.#lesson = lesson;
  }

  update(/** @type {View} */ view) {
    const { lesson, asked, outcome, deciding, exercise, outcomes, score } = view;
    this.#watching = Boolean(deciding);
    // Those of this situation: the score below counts no others.
    const told = view.cover?.decided
      ? outcomes.filter(({ question }) => view.predictions.some(({ id }) => id === question))
      : [];
    const question = asked && { ...asked, picked: null, ready: false, says: "" };
    // While a stage is edited, the card stays as it is.
    const waiting = view.waiting.length > 0 ? view.waiting : this.#waiting;
    const ends = view.summary && [view.tasksDone, waiting, view.situationsWaiting];
    const now = JSON.stringify([lesson, question, outcome, deciding, told, score, ends, exercise], as_laid_out);
    if (now !== this.#shown) {
      this.#shown = now;
      this.#lay_out(view, told);
    }
    if (asked) this.#show_picked(asked);
    this.#exercise.show_now(exercise);
  }

  #card_of(/** @type {View} */ view) {
    const { asked, outcome, deciding, exercise, summary } = view;
    if (asked) return this.#asked_card(asked, view);
    if (deciding) return this.#deciding_card(deciding);
    if (outcome) return exercise ? this.#marked_card(outcome, exercise) : this.#outcome_card(outcome);
    if (exercise?.run === "right") return this.#exercise.right_card(exercise);
    if (exercise?.finished) return this.#exercise.summary(exercise, this.#after.title);
    if (exercise?.build)
      return this.#exercise.build_card(exercise, exercise.build, this.#texts.of(exercise.build.promptWords));
    if (exercise) return this.#exercise.back_card(exercise);
    return summary ? this.#summary_card(view) : null;
  }

  /** @param {View} view @param {Outcome[]} told */
  #lay_out(view, told) {
    const { asked, score } = view;
    const box = by_id("ask");
    const had_focus = box.contains(document.activeElement);
    const card = this.#card_of(view);
    this.#waiting = view.waiting;
    if (!asked) this.#choices = [];
    if (card && view.exercise && !view.exercise.practises) this.#exercise.say_saved(card);
    box.replaceChildren(...(card ? [card] : []));
    const prompt_of = (/** @type {Outcome} */ { question }) =>
      view.predictions.find(({ id }) => id === question)?.prompt ?? "";
    by_id("told").replaceChildren(
      ...told.map((each) => this.#told_card(each, prompt_of(each))),
      ...(score && this.#lesson.measures ? [this.#score_card(score)] : []),
    );
    box.scrollTop = 0;
    if (had_focus) (first_in(box) ?? by_id("canvas")).focus({ preventScroll: true });
    if (card && !had_focus) show_both(box);
  }

  /** Shows the choice that is not committed yet. The card and the focus stay as they are. */
  #show_picked(/** @type {Asked} */ { picked, ready, tried, says, how }) {
    for (const [i, choice] of this.#choices.entries()) {
      const place = picked?.choices.indexOf(i) ?? -1;
      choice.setAttribute("aria-pressed", place >= 0);
      if (this.#ordered) choice.dataset.place = place >= 0 ? String(place + 1) : "";
    }
    set_text(this.#says, says || how);
    this.#says.classList.toggle("chosen", says !== "");
    this.#says.classList.toggle("wrong", Boolean(tried) && !picked);
    this.#commit.disabled = !ready;
  }

  /** Scrolls to the open question, which the player waits for. */
  show() {
    by_id("ask").querySelector(".predict")?.scrollIntoView({ block: "nearest" });
  }

  /** Chooses by a digit key. Returns whether it chose something. */
  choose(/** @type {number} */ digit) {
    const choice = this.#choices[digit - 1];
    const had_focus = by_id("ask").contains(document.activeElement);
    choice?.click();
    // Enter commits this choice, not the one that had the focus before; of several choices or an order, all of it.
    const card = /** @type {HTMLElement | null | undefined} */ (choice?.closest(".card"));
    if (had_focus) (this.#many || this.#ordered ? card : choice)?.focus({ preventScroll: true });
    return Boolean(choice);
  }

  #do(/** @type {string} */ command) {
    this.#act(() => this.#door.command(command));
  }

  /** @param {Asked} asked @param {View} view */
  #asked_card({ promptWords, choices, field, ordered, many, place, tried }, { exercise, outcomes }) {
    this.#ordered = ordered;
    this.#many = many;
    const first = choices.findIndex((_, i) => ordered || !tried?.choices.includes(i));
    const kind = `${ordered ? " ordered" : ""}${are_code(choices) ? " of-code" : ""}`;
    this.#choices = choices.map((words, i) => {
      const was = !ordered && tried?.choices.includes(i);
      const pick = (/** @type {MouseEvent} */ { detail }) => {
        // In an exercise the second click of a double one would decide what is asked next.
        if (!exercise || many || ordered || detail < 2) this.#act(() => this.#door.pick_choice(i));
      };
      return button(words, pick, {
        class: `button${was ? " tried" : ""}${kind}`,
        "aria-label": was ? `${words}, not that one` : null,
        "aria-pressed": "false",
        "data-first": i === first,
      });
    });
    const pass = exercise ? this.#exercise.tools(exercise) : [quiet(this.#words.skip, () => this.#do("skip_question"))];
    const [head, where] = exercise ? this.#exercise.place(exercise) : [this.#words.prediction, place];
    const commits = !exercise || many || ordered; // else a tap decides
    return element("div", { class: "card predict", tabindex: "-1" },
      kicker(head, where),
      exercise && this.#exercise.before(exercise, outcomes, tried),
      element("p", { class: "prompt" }, ...this.#texts.of(promptWords)),
      ...(exercise ? this.#exercise.hints(exercise) : []),
      element("div", { class: "answering" },
        choices.length > 0 && element("div", { class: "choices" }, ...this.#choices),
        row(this.#says, field ? this.#answer_form(field) : commits && this.#commit, ...pass),
      ),
      !exercise && element("p", { class: "foot presented" }, "Page Down twice skips"),
    );
  }

  /** A field for a number, or to name handles without pointing at them. */
  #answer_form(/** @type {Asked["field"]} */ label) {
    const field = element("input", {
      type: "text",
      required: true,
      autocomplete: "off",
      autocapitalize: "characters",
      spellcheck: "false",
      inputmode: label === "Number" ? "decimal" : "text",
      maxlength: 80,
      "aria-label": label,
      placeholder: label,
      "data-first": true,
    });
    const onsubmit = (/** @type {Event} */ event) => {
      event.preventDefault();
      this.#act(() => {
        if (field.value === "") this.#door.command("commit_answer"); // what was tapped
        else if (this.#door.pick_name(field.value)) this.#door.command("commit_answer");
      });
      field.select();
    };
    return element("form", { class: "name", onsubmit, novalidate: true }, field,
      element("button", { type: "submit", class: "button primary" }, this.#words.answer));
  }

  /** What was predicted; nothing of a question that was skipped. */
  #said(/** @type {Outcome} */ { skipped, predicted }, word = this.#words.prediction) {
    if (skipped) return null;
    return element("p", { class: "said" }, `${word}: `, element("b", {}, ...spelled(predicted)));
  }

  /** The right order, line by line, each with the place that it had in the prediction. */
  #order(/** @type {Told} */ { says, choices, given, rightChoices, right: all }, word = this.#words.prediction) {
    const [heading] = says.split(": ");
    const places = given?.choices ?? [];
    const lines = rightChoices.map((choice, i) => {
      const place = places.indexOf(choice);
      const right = all || choices[places[i]] === choices[choice]; // equal ones may stand either way round
      const kind = right ? "right" : "wrong";
      return element("li", {},
        element("span", { class: are_code(choices) ? "of-code" : "" }, choices[choice]),
        place >= 0 && element("b", { class: kind }, `${kMarks[kind]} ${place + 1}`),
      );
    });
    return [
      element("p", { class: "order-head" },
        `${heading}:`,
        places.length > 0 && element("b", {}, word),
      ),
      element("ol", { class: "order" }, ...lines),
    ];
  }

  /** The card while the steps up to the outcome are played: it tells nothing yet. */
  #deciding_card(/** @type {Told} */ deciding) {
    return element("div", { class: "card deciding", tabindex: "-1" },
      kicker(this.#words.prediction, deciding.place),
      element("p", { class: "prompt" }, ...this.#texts.of(deciding.promptWords)),
      this.#said(deciding),
      element("p", { class: "says" }, this.#words.watching),
    );
  }

  /** The card with the outcome, until it is dismissed. */
  #outcome_card(/** @type {Told} */ outcome) {
    const { says, ordered, shown, canShow, rightChoices, happened, choices } = outcome;
    // An order is told as a list: there is nothing left to be shown.
    if (ordered && rightChoices.length > 0) return this.#told(outcome, this.#order(outcome), null);
    const chips = shown && choices.length > 0; // which say what was predicted, too
    const what = [chips ? this.#chips(outcome) : this.#said(outcome), element("p", {}, ...spelled(says))];
    if (!canShow || chips) return this.#told(outcome, what, null);
    // In its button's place, so that nothing moves.
    const answer = shown
      ? element("p", { class: "said right" }, `${kMarks.right} ${happened}`)
      : button(this.#words.show, () => this.#do("show_answer"));
    return this.#told(outcome, what, answer);
  }

  /** The same in an exercise, where the step is shown at once; with the rule that was followed, if it is known.
   *  @param {Told} outcome @param {ShownExercise} exercise */
  #marked_card(outcome, exercise) {
    const decided = outcome.ordered && outcome.rightChoices.length > 0
      ? this.#order(outcome, this.#words.decision)
      : [this.#said(outcome, this.#words.decision), element("p", {}, ...spelled(outcome.says))];
    const [place] = this.#exercise.place(exercise);
    return this.#told({ ...outcome, place, canWatch: false }, [
      ...decided,
      exercise.rule ? element("p", { class: "rule" }, exercise.rule) : null,
    ], null, exercise.run === "own" && this.#exercise.in_own_run(exercise));
  }

  /** The choices with a mark at those that are right, and at one that was chosen and is not. */
  #chips(/** @type {Told} */ { choices, given, rightChoices }) {
    const chips = choices.map((words, i) => {
      const mark = rightChoices.includes(i) ? "right" : given?.choices.includes(i) ? "wrong" : "";
      return element("span", { class: `chip ${mark}` }, mark ? `${kMarks[mark]} ${words}` : words);
    });
    return element("div", { class: "choices" }, ...chips);
  }

  /** on: where one may go on to, if not to what comes next.
   *  @param {Told} outcome @param {(HTMLElement | null)[]} what @param {HTMLElement | null} show
   *  @param {HTMLElement[] | false} on */
  #told({ verdict, kind, promptWords, place, becauseWords, canWatch }, what, show, on = false) {
    return element("div", { class: `card outcome ${kind}`, tabindex: "-1" },
      kicker(`${kMarks[kind]} ${verdict}`, place, kind),
      element("p", { class: "asked" }, ...this.#texts.of(promptWords)),
      ...what,
      element("p", {}, ...this.#texts.of(becauseWords)),
      row(
        show,
        canWatch && button(this.#words.watch, () => this.#do("watch_outcome")),
        element("span", { class: "gap" }),
        ...(on || [
          button(this.#words.go_on, () => this.#do("continue"), { class: "button primary", "data-first": true }),
        ]),
      ),
    );
  }

  /** The card at the lesson's end: each prediction leads back to its reason. */
  #summary_card(/** @type {View} */ view) {
    const { score, predictions, lesson, grade, tasksDone, waiting, situationsWaiting, canPractise } = view;
    // While questions wait, the main button leads to them, and not to the next lesson.
    const [first, ...others] = [
      ...waiting.map((name) => ({ title: this.#title_of(name), go: () => this.#ask(name) })),
      ...situationsWaiting.map((name) => ({ title: this.#situation_of(name), go: () => this.#show_situation(name) })),
    ];
    const lines = predictions.map((prediction) => element("li", {}, this.#line_of(prediction)));
    const next = this.#after.next(lesson);
    const { show_task } = this.#after;
    const task_words = tasksDone ? `${kMarks.right} ${this.#words.task}` : this.#words.to_task;
    const main = { class: "button primary", "data-first": true };
    return element("div", { class: "card summary", tabindex: "-1" },
      element("div", { class: "head" },
        kicker(this.#words.summary),
        quiet(this.#words.close, () => this.#do("close_summary")),
      ),
      element("p", { class: "prompt" }, score),
      element("ol", { class: "lines-of" }, ...lines),
      others.length > 0 &&
        element("div", { class: "commit waiting" },
          element("span", {}, this.#words.waiting),
          ...others.map(({ title, go }) => button(title, go)),
        ),
      row(
        quiet(this.#words.again, () => this.#do("predict_again")),
        canPractise && quiet(this.#words.practise, () => this.#do("practise")),
        element("span", { class: "gap" }),
        grade && show_task && button(task_words, show_task, { class: "button to-task" }),
        next ? this.#way_to(next, first ? { class: "button" } : main) : null,
        first &&
          button(`${this.#words.go_on_with} ${first.title}`, first.go, { ...main, class: "button primary waiting" }),
      ),
    );
  }

  /** A line of the summary. */
  #line_of(/** @type {Prediction} */ { id, short, kind, standing }) {
    const onclick = () => this.#do(`review:${id}`);
    return element("button", { type: "button", class: `line ${kind}`, onclick },
      element("span", { class: "mark", "aria-hidden": "true" }, kMarks[kind]),
      element("span", { class: "what" }, ...spelled(short)),
      element("b", {}, standing),
    );
  }

  /** @param {CourseLesson} next @param {Record<string, any>} how */
  #way_to({ id, title }, how) {
    const onclick = followed_here(() => this.#after.go(id));
    return element("a", { href: link_of(id), title, onclick, ...how }, this.#words.next_lesson);
  }

  #title_of(/** @type {string} */ name) {
    return this.#lesson.algorithms.find((algorithm) => algorithm.name === name)?.title ?? name;
  }

  #situation_of(/** @type {string} */ name) {
    return this.#lesson.situations.find((situation) => situation.name === name)?.title ?? name;
  }

  #show_situation(/** @type {string} */ name) {
    this.#act(() => this.#door.show_situation(name));
  }

  /** Runs the lesson again from its first step, with its other questions. */
  #ask(/** @type {string} */ name) {
    this.#act(() => {
      this.#door.choose(0, name);
      this.#door.command("first");
    });
  }

  /** Where all are decided at once: one line each, with the reason, to fold.
   *  @param {Outcome} outcome @param {string} prompt */
  #told_card(outcome, prompt) {
    const { verdict, right, kind, pending, happened, says, becauseWords, skipped } = outcome;
    const head = element("h2", { class: "kicker" }, verdict);
    if (pending) return element("div", { class: "card outcome skipped" }, head, element("p", {}, says));
    // Beside "Not quite", what happened alone would read as the prediction.
    const line = right ? happened : `${this.#words.answer}: ${happened}`;
    return element("div", { class: `card outcome told ${kind}` },
      element("details", { open: !skipped },
        element("summary", {}, kicker(skipped ? verdict : `${kMarks[kind]} ${verdict}`), ` · ${line}`),
        element("p", { class: "asked" }, ...spelled(prompt)),
        this.#said(outcome),
        element("p", {}, ...spelled(says)),
        element("p", {}, ...this.#texts.of(becauseWords)),
      ),
    );
  }

  #score_card(/** @type {string} */ score) {
    return element("div", { class: "card score" },
      element("p", {}, score),
      button(this.#words.again, () => this.#do("predict_again")),
    );
  }
}

/** Where the keyboard goes on in the card. To a finger a field would bring up a keyboard of its own, over the stage. */
function first_in(/** @type {HTMLElement} */ box) {
  const fingers = document.documentElement.classList.contains("fingers");
  const first = box.querySelector(`[data-first]:not(:disabled${fingers ? ", input" : ""})`);
  return /** @type {HTMLElement | null} */ (first ?? box.querySelector("[tabindex]"));
}

/** On a phone, where the card is below the stage, scrolls until both are visible. */
function show_both(/** @type {HTMLElement} */ box) {
  if (document.documentElement.dataset.layout !== "phone") return;
  const [stage, card] = [by_id("stage"), box].map((node) => node.getBoundingClientRect());
  if (stage.top < 0) scrollBy({ top: stage.top });
  else if (card.bottom > innerHeight) scrollBy({ top: Math.min(stage.top, card.bottom - innerHeight) });
}
