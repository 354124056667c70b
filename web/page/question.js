// The questions, at the bottom of the stage: each question, its outcome, and at the end a summary of all of them.
// Every sentence comes from the program, so that the window has the same ones.
import { by_id, button, element, followed_here, set_text, spelled } from "./dom.js";

const kMarks = { right: "✓", wrong: "✕", skipped: "–", open: "?" };

/** Of a text only its words count, whose figures follow the run without being laid out anew. */
const as_laid_out = (key, value) => (key === "prompt" || key === "because" ? undefined : value);
const kicker = (words, place, kind = "") =>
  element("h2", { class: `kicker ${kind}` }, words, ...(place ? [element("span", { class: "place-of" }, ` · ${place}`)] : []));
/** Whether the choices are lines of code. */
const are_code = (choices) => choices.some((words) => /[;={}]/.test(words));
const row = (...children) => element("div", { class: "commit" }, ...children);
const quiet = (words, onclick) => element("button", { type: "button", class: "quiet", onclick }, words);

export class QuestionCard {
  #door;
  #act;
  #words;
  #texts;
  #after;
  #shown = "";
  #choices = [];
  #ordered = false; // whether they are put into an order
  #many = false; // whether several choices can be right
  #says = element("p", { class: "says", role: "status" });
  #commit;

  /** act(what): does it and shows what came of it. texts: what makes HTML of prompts and reasons (words.js). after: {next(id): the lesson that follows or undefined, go(id),
   *  show_task(): null where the task is not on the page}. */
  constructor(door, act, texts, after) {
    this.#door = door;
    this.#act = act;
    this.#texts = texts;
    this.#after = after;
    this.#words = door.words();
    this.#commit = button(this.#words.answer, () => this.#do("commit_answer"), { class: "button primary" });
    // Any press while the skipped steps are played ends the playing, and does nothing else.
    addEventListener("pointerdown", (event) => {
      if (this.#watching && !event.target.closest?.(".place")) this.#do("continue");
    }, { capture: true });
  }

  #watching = false;
  #waiting = []; // the algorithms that the card offers

  update(view) {
    const { asked, outcome, deciding, outcomes, score } = view;
    this.#watching = Boolean(deciding);
    // Those of this situation: the score below counts no others.
    const told = view.cover?.decided ? outcomes.filter(({ question }) => view.predictions.some(({ id }) => id === question)) : [];
    const question = asked && { ...asked, picked: null, ready: false, says: "" };
    const waiting = view.waiting.length > 0 ? view.waiting : this.#waiting; // while a stage is edited, the card stays as it is
    const ends = view.summary && [view.tasksDone, waiting, view.situationsWaiting];
    const now = JSON.stringify([view.lesson, question, outcome, deciding, told, score, ends], as_laid_out);
    if (now !== this.#shown) {
      this.#shown = now;
      this.#lay_out(view, told);
    }
    if (asked) this.#show_picked(asked);
  }

  #lay_out(view, told) {
    const { asked, outcome, deciding, score, summary } = view;
    const box = by_id("ask");
    const had_focus = box.contains(document.activeElement);
    const card = asked ? this.#asked_card(asked)
      : deciding ? this.#deciding_card(deciding)
        : outcome ? this.#outcome_card(outcome)
          : summary ? this.#summary_card(view) : null;
    this.#waiting = view.waiting;
    if (!asked) this.#choices = [];
    box.replaceChildren(...(card ? [card] : []));
    const prompt_of = ({ question }) => view.predictions.find(({ id }) => id === question)?.prompt ?? "";
    by_id("told").replaceChildren(...told.map((each) => this.#told_card(each, prompt_of(each))),
      ...(score && !this.#door.lesson().asksOfSteps ? [this.#score_card(score)] : []));
    box.scrollTop = 0;
    if (had_focus) (first_in(box) ?? by_id("canvas")).focus({ preventScroll: true });
    if (card && !had_focus) show_both(box);
  }

  /** Shows the choice that is not committed yet. The card and the focus stay as they are. */
  #show_picked({ picked, ready, tried, says, how }) {
    for (const [i, choice] of this.#choices.entries()) {
      const place = picked?.choices.indexOf(i) ?? -1;
      choice.setAttribute("aria-pressed", place >= 0);
      if (this.#ordered) choice.dataset.place = place >= 0 ? place + 1 : "";
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
  choose(digit) {
    const choice = this.#choices[digit - 1];
    const had_focus = by_id("ask").contains(document.activeElement);
    choice?.click();
    // Enter commits this choice, not the one that had the focus before; where several can be chosen, all of them.
    if (had_focus) (this.#many ? choice?.closest(".card") : choice)?.focus({ preventScroll: true });
    return Boolean(choice);
  }

  #do(command) {
    this.#act(() => this.#door.command(command));
  }

  #asked_card({ promptWords, choices, field, ordered, many, place, tried }) {
    this.#ordered = ordered;
    this.#many = many;
    const first = choices.findIndex((_, i) => ordered || !tried?.choices.includes(i));
    this.#choices = choices.map((words, i) => {
      const was = !ordered && tried?.choices.includes(i);
      return button(words, () => this.#act(() => this.#door.pick_choice(i)),
        { class: `button${was ? " tried" : ""}${ordered ? " ordered" : ""}${are_code(choices) ? " of-code" : ""}`, "aria-label": was ? `${words}, not that one` : null, "aria-pressed": "false", "data-first": i === first });
    });
    const pass = quiet(this.#words.skip, () => this.#do("skip_question"));
    return element("div", { class: "card predict", tabindex: "-1" },
      kicker(this.#words.prediction, place),
      element("p", { class: "prompt" }, ...this.#texts.of(promptWords)),
      element("div", { class: "answering" }, ...(choices.length > 0 ? [element("div", { class: "choices" }, ...this.#choices)] : []),
        row(this.#says, ...(field ? [this.#answer_form(field)] : [this.#commit]), pass)),
      element("p", { class: "foot presented" }, "Page Down twice skips"));
  }

  /** A field for a number, or to name handles without pointing at them. */
  #answer_form(label) {
    const field = element("input", { type: "text", required: true, autocomplete: "off", autocapitalize: "characters", spellcheck: "false", inputmode: label === "Number" ? "decimal" : "text", maxlength: 80, "aria-label": label, placeholder: label, "data-first": true });
    const onsubmit = (event) => {
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

  #said({ skipped, predicted }) {
    return skipped ? [] : [element("p", { class: "said" }, `${this.#words.prediction}: `, element("b", {}, ...spelled(predicted)))];
  }

  /** The right order, line by line, each with the place that it had in the prediction. */
  #order({ says, choices, given, rightChoices, right: all }) {
    const [heading] = says.split(": ");
    const places = given?.choices ?? [];
    const lines = rightChoices.map((choice, i) => {
      const place = places.indexOf(choice);
      const right = all || choices[places[i]] === choices[choice]; // equal ones may stand either way round
      return element("li", {}, element("span", { class: are_code(choices) ? "of-code" : "" }, choices[choice]),
        ...(place >= 0 ? [element("b", { class: right ? "right" : "wrong" }, `${kMarks[right ? "right" : "wrong"]} ${place + 1}`)] : []));
    });
    return [element("p", { class: "order-head" }, `${heading}:`, ...(places.length > 0 ? [element("b", {}, this.#words.prediction)] : [])),
      element("ol", { class: "order" }, ...lines)];
  }

  /** The card while the steps up to the outcome are played: it tells nothing yet. */
  #deciding_card(deciding) {
    return element("div", { class: "card deciding", tabindex: "-1" }, kicker(this.#words.prediction, deciding.place),
      element("p", { class: "prompt" }, ...this.#texts.of(deciding.promptWords)), ...this.#said(deciding),
      element("p", { class: "says" }, this.#words.watching));
  }

  /** The card with the outcome, until it is dismissed. */
  #outcome_card(outcome) {
    const { says, ordered, given, shown, canShow, rightChoices, happened } = outcome;
    if (ordered && rightChoices.length > 0) return this.#ordered_card(outcome);
    const choices = outcome.choices;
    const marked = shown && choices.length > 0 ? [element("div", { class: "choices" }, ...choices.map((words, i) => {
      const mark = rightChoices.includes(i) ? "right" : given?.choices.includes(i) ? "wrong" : "";
      return element("span", { class: `chip ${mark}` }, mark ? `${kMarks[mark]} ${words}` : words);
    }))] : this.#said(outcome); // the chips say what was predicted, too
    // In its button's place, so that nothing moves.
    const show = !canShow ? [] : !shown ? [button(this.#words.show, () => this.#do("show_answer"))]
      : choices.length === 0 ? [element("p", { class: "said right" }, `${kMarks.right} ${happened}`)] : [];
    return this.#told(outcome, [...marked, element("p", {}, ...spelled(says))], show);
  }

  /** The same of an order, which is told as a list: there is nothing left to be shown. */
  #ordered_card(outcome) {
    return this.#told(outcome, this.#order(outcome), []);
  }

  #told({ verdict, kind, promptWords, place, becauseWords, canWatch }, what, show) {
    return element("div", { class: `card outcome ${kind}`, tabindex: "-1" },
      kicker(`${kMarks[kind]} ${verdict}`, place, kind),
      element("p", { class: "asked" }, ...this.#texts.of(promptWords)),
      ...what, element("p", {}, ...this.#texts.of(becauseWords)),
      row(...show,
        ...(canWatch ? [button(this.#words.watch, () => this.#do("watch_outcome"))] : []),
        element("span", { class: "gap" }),
        button(this.#words.go_on, () => this.#do("continue"), { class: "button primary", "data-first": true })));
  }

  /** The card at the lesson's end: each prediction leads back to its reason. */
  #summary_card({ score, predictions, lesson, grade, tasksDone, waiting, situationsWaiting, canPractise }) {
    // While questions wait, the main button leads to them, and not to the next lesson.
    const [first, ...others] = [...waiting.map((name) => [this.#title_of(name), () => this.#ask(name)]),
      ...situationsWaiting.map((name) => [this.#door.lesson().situations.find((one) => one.name === name).title, () => this.#act(() => this.#door.show_situation(name))])];
    const lines = predictions.map(({ id, short, kind, standing }) => element("li", {},
      element("button", { type: "button", class: `line ${kind}`, onclick: () => this.#do(`review:${id}`) },
        element("span", { class: "mark", "aria-hidden": "true" }, kMarks[kind]), element("span", { class: "what" }, ...spelled(short)), element("b", {}, standing))));
    const next = this.#after.next(lesson);
    return element("div", { class: "card summary", tabindex: "-1" },
      element("div", { class: "head" }, kicker(this.#words.summary), quiet(this.#words.close, () => this.#do("close_summary"))),
      element("p", { class: "prompt" }, score), element("ol", { class: "lines-of" }, ...lines),
      ...(others.length > 0 ? [element("div", { class: "commit waiting" }, element("span", {}, this.#words.waiting), ...others.map(([title, go]) => button(title, go)))] : []),
      row(quiet(this.#words.again, () => this.#do("predict_again")), ...(canPractise ? [quiet(this.#words.practise, () => this.#do("practise"))] : []), element("span", { class: "gap" }),
        ...(grade && this.#after.show_task ? [button(tasksDone ? `${kMarks.right} ${this.#words.task}` : this.#words.to_task, this.#after.show_task, { class: "button to-task" })] : []),
        ...(next ? [element("a", { class: first ? "button" : "button primary", href: `?lesson=${encodeURIComponent(next.id)}`, ...(first ? {} : { "data-first": true }), title: next.title,
          onclick: followed_here(() => this.#after.go(next.id)) }, this.#words.next_lesson)] : []),
        ...(first ? [button(`${this.#words.go_on_with} ${first[0]}`, first[1], { class: "button primary waiting", "data-first": true })] : [])));
  }

  #title_of(name) {
    return this.#door.lesson().algorithms.find((algorithm) => algorithm.name === name)?.title ?? name;
  }

  /** Runs the lesson again from its first step, with its other questions. */
  #ask(name) {
    this.#act(() => {
      this.#door.choose(0, name);
      this.#door.command("first");
    });
  }

  /** Where all are decided at once: one line each, with the reason, to fold. */
  #told_card(outcome, prompt) {
    const { verdict, right, kind, pending, happened, says, becauseWords, skipped } = outcome;
    if (pending) return element("div", { class: "card outcome skipped" }, element("h2", { class: "kicker" }, verdict), element("p", {}, says));
    // Beside "Not quite", what happened alone would read as the prediction.
    const line = right ? happened : `${this.#words.answer}: ${happened}`;
    return element("div", { class: `card outcome told ${kind}` },
      element("details", skipped ? {} : { open: true }, element("summary", {}, kicker(skipped ? verdict : `${kMarks[kind]} ${verdict}`), ` · ${line}`),
        element("p", { class: "asked" }, ...spelled(prompt)), ...this.#said(outcome), element("p", {}, ...spelled(says)),
        element("p", {}, ...this.#texts.of(becauseWords))));
  }

  #score_card(score) {
    return element("div", { class: "card score" }, element("p", {}, score), button(this.#words.again, () => this.#do("predict_again")));
  }
}

/** Where the keyboard goes on in the card. To a finger a field would bring up a keyboard of its own, over the stage. */
function first_in(box) {
  const fingers = document.documentElement.classList.contains("fingers");
  return box.querySelector(`[data-first]:not(:disabled${fingers ? ", input" : ""})`) ?? box.querySelector("[tabindex]");
}

/** On a phone, where the card is below the stage, scrolls until both are visible. */
function show_both(box) {
  if (document.documentElement.dataset.layout !== "phone") return;
  const [stage, card] = [by_id("stage"), box].map((node) => node.getBoundingClientRect());
  if (stage.top < 0) scrollBy({ top: stage.top });
  else if (card.bottom > innerHeight) scrollBy({ top: Math.min(stage.top, card.bottom - innerHeight) });
}
