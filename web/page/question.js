// The prediction that the player waits for, and what happened beside what was predicted.
import { by_id, button, element } from "./dom.js";

const kLinesShown = 120; // pixels

export class QuestionCard {
  #door;
  #act;
  #shown = "";
  #opened = false; // a page that has just opened stands at its top

  /** act(what): does it and shows what came of it. */
  constructor(door, act) {
    this.#door = door;
    this.#act = act;
  }

  open() {
    this.#opened = false;
  }

  update(view) {
    const { asked, outcome, outcomes, questions } = view;
    const pending = outcomes.some((each) => each.pending);
    const ended = (view.costs ? outcomes.length > 0 && view.costs.decided : view.step === view.steps && !view.previewing) && !asked;
    const given = outcomes.filter((each) => !each.passed);
    const now = JSON.stringify([view.lesson, asked, outcome, questions, ended && given, pending]);
    if (now === this.#shown) return;
    this.#shown = now;
    const box = by_id("ask");
    const had_focus = box.contains(document.activeElement);
    const cards = [];
    if (asked) cards.push(this.#asked_card(asked, questions));
    if (view.costs && ended) cards.push(...outcomes.map((each) => this.#outcome_card(each, true)));
    if (outcome) cards.push(this.#outcome_card(outcome, Boolean(asked)));
    if (ended && given.length > 0) cards.push(this.#score_card(given));
    box.replaceChildren(...cards);
    if (had_focus) (box.querySelector("[tabindex]") ?? by_id("canvas")).focus({ preventScroll: true });
    box.scrollTop = 0;
    if (cards.length > 0 && this.#opened) show_top(box);
    this.#opened = true;
  }

  /** Brings the question that stands into sight: what the player waits for. */
  show() {
    by_id("ask").querySelector(".predict")?.scrollIntoView({ block: "nearest" });
  }

  /** Whether a digit key chose something. */
  choose(digit) {
    const choices = [...by_id("ask").querySelectorAll(".choices button")];
    choices[digit - 1]?.click();
    return digit >= 1 && digit <= choices.length;
  }

  #answer(kind, value) {
    this.#act(() => this.#door.answer(kind, value));
  }

  #asked_card(asked, questions) {
    const choices = asked.choices.map((words, i) => button(words, (event) => (asked.many ? toggle(event.currentTarget) : this.#answer("choice", i)),
      asked.many ? { "aria-pressed": "false" } : {}));
    const pressed = () => choices.reduce((bits, choice, i) => bits | (choice.getAttribute("aria-pressed") === "true") << i, 0);
    if (asked.many) choices.push(button("Answer", () => this.#answer("choice", pressed()), { class: "button primary" }));
    return element("div", { class: "card predict", tabindex: "-1" },
      element("h2", { class: "kicker" }, "Predict"),
      element("p", { class: "prompt" }, asked.prompt),
      ...(choices.length > 0 ? [element("div", { class: "choices" }, ...choices)] : []),
      ...(asked.onStage && choices.length === 0 ? [this.#point_form()] : []),
      element("p", { class: "foot" }, element("span", {}, asked.onStage ? "Tap it on the stage or here" : "Answer to go on",
        " · ", element("b", { class: "presented" }, "Page Down skips · "), element("b", {}, `${asked.number} of ${questions}`)),
        element("button", { type: "button", class: "quiet", onclick: () => this.#answer("skip", 0) }, "Skip")));
  }

  /** The way to name a point without pointing at it. */
  #point_form() {
    const field = element("input", { type: "number", min: 0, step: 1, required: true, inputmode: "numeric", "aria-label": "Point number" });
    const onsubmit = (event) => {
      event.preventDefault();
      this.#answer("point", Number(field.value));
    };
    return element("form", { class: "choices", onsubmit }, element("span", { class: "label" }, "Point"), field,
      element("button", { type: "submit", class: "button" }, "Answer"));
  }

  /** brief: one line, to unfold; the question that stands comes first. */
  #outcome_card({ right, skipped, pending, predicted, happened, because, says, fromStep, step }, brief) {
    if (pending) return element("div", { class: "card outcome skipped" }, element("h2", { class: "kicker" }, "Not decided"), element("p", {}, says));
    const word = skipped ? "Skipped" : right ? "✓ As you predicted" : "✕ Not as you predicted";
    const rows = skipped ? [["It was", happened]] : [["You predicted", predicted], ["It was", happened]];
    const told = [element("dl", {}, ...rows.map(([name, value]) => element("div", {}, element("dt", {}, name), element("dd", {}, value)))),
      element("p", {}, because),
      ...(step - fromStep > 1 ? [element("p", {}, button("Watch how", () => this.#act(() => this.#door.command("watch_outcome"))))] : [])];
    const kicker = element("h2", { class: "kicker" }, word);
    const kind = skipped ? "skipped" : right ? "right" : "wrong";
    if (!brief) return element("div", { class: `card outcome ${kind}`, tabindex: "-1" }, kicker, ...told);
    return element("div", { class: `card outcome told ${kind}` },
      element("details", {}, element("summary", {}, kicker, ` · It was ${happened}`), ...told));
  }

  #score_card(outcomes) {
    const right = outcomes.filter((outcome) => outcome.right).length;
    const again = () => this.#act(() => {
      this.#door.forget_answers();
      if (!this.#door.lesson().measures) this.#door.command("first");
    });
    return element("div", { class: "card score" },
      element("p", {}, `The end: ${right} of ${outcomes.length} ${outcomes.length === 1 ? "prediction" : "predictions"} right.`),
      button("Predict again", again));
  }
}

const toggle = (choice) => choice.setAttribute("aria-pressed", choice.getAttribute("aria-pressed") !== "true");

/** Scrolls no further than the first lines need: the stage is to stay in sight. */
function show_top(box) {
  if (document.documentElement.dataset.layout === "beside") by_id("column").scrollTop = 0; // where the cards stand first
  const below = box.getBoundingClientRect().top + kLinesShown - innerHeight;
  if (below > 0) scrollBy({ top: below });
}
