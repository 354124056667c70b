// The prediction that the player waits for, and what happened beside what was predicted. Every sentence comes from the
// program, which prints the same ones in its window.
import { by_id, button, element, set_hidden, set_text, whole_names } from "./dom.js";

const kLinesShown = 120; // pixels

export class QuestionCard {
  #door;
  #act;
  #words;
  #shown = "";
  #choices = [];
  #says = element("p", { class: "says", role: "status" });
  #commit;
  #opened = false; // a page that has just opened stands at its top

  /** act(what): does it and shows what came of it. */
  constructor(door, act) {
    this.#door = door;
    this.#act = act;
    this.#words = door.words();
    this.#commit = button(this.#words.answer, () => this.#do("commit_answer"), { class: "button primary" });
  }

  open() {
    this.#opened = false;
  }

  update(view) {
    const { asked, outcome, outcomes, score } = view;
    const told = view.costs?.decided ? outcomes : [];
    const question = asked && { ...asked, picked: null, says: "" };
    const now = JSON.stringify([view.lesson, question, outcome, told, score]);
    if (now !== this.#shown) {
      this.#shown = now;
      this.#lay_out(asked, outcome, told, score);
    }
    if (asked) this.#show_picked(asked);
  }

  #lay_out(asked, outcome, told, score) {
    const box = by_id("ask");
    const had_focus = box.contains(document.activeElement);
    const cards = [];
    if (asked) cards.push(this.#asked_card(asked));
    cards.push(...told.map((each) => this.#outcome_card(each, true)));
    if (outcome) cards.push(this.#outcome_card(outcome, Boolean(asked)));
    if (score) cards.push(this.#score_card(score));
    box.replaceChildren(...cards);
    if (had_focus) (box.querySelector("[tabindex]") ?? by_id("canvas")).focus({ preventScroll: true });
    box.scrollTop = 0;
    if (cards.length > 0 && this.#opened) show_top(box);
    this.#opened = true;
  }

  /** What is chosen and not given yet; the card stays as it is, and so does the focus. */
  #show_picked({ picked, says, how }) {
    for (const [i, choice] of this.#choices.entries()) choice.setAttribute("aria-pressed", Boolean(picked?.choices.includes(i)));
    set_text(this.#says, says || how);
    this.#says.classList.toggle("chosen", says !== "");
    set_hidden(this.#commit, !picked);
  }

  /** Brings the question that stands into sight: what the player waits for. */
  show() {
    by_id("ask").querySelector(".predict")?.scrollIntoView({ block: "nearest" });
  }

  /** Whether a digit key chose something. */
  choose(digit) {
    this.#choices[digit - 1]?.click();
    return digit >= 1 && digit <= this.#choices.length;
  }

  #do(command) {
    this.#act(() => this.#door.command(command));
  }

  #asked_card({ prompt, choices, onStage, place }) {
    this.#choices = choices.map((words, i) => button(words, () => this.#act(() => this.#door.pick_choice(i)), { "aria-pressed": "false" }));
    return element("div", { class: "card predict", tabindex: "-1" },
      element("h2", { class: "kicker" }, this.#words.predict),
      element("p", { class: "prompt" }, whole_names(prompt)),
      ...(choices.length > 0 ? [element("div", { class: "choices" }, ...this.#choices)] : []),
      ...(onStage && choices.length === 0 ? [this.#name_form()] : []),
      element("div", { class: "commit" }, this.#says, this.#commit),
      element("p", { class: "foot" }, element("span", {}, element("b", { class: "presented" }, "Page Down skips · "), element("b", {}, place)),
        element("button", { type: "button", class: "quiet", onclick: () => this.#do("skip_question") }, this.#words.skip)));
  }

  /** The way to name a handle without pointing at it. */
  #name_form() {
    const field = element("input", { type: "text", required: true, autocomplete: "off", autocapitalize: "characters", spellcheck: "false", maxlength: 16, "aria-label": "Name" });
    const onsubmit = (event) => {
      event.preventDefault();
      this.#act(() => this.#door.pick_name(field.value) && this.#door.command("commit_answer"));
      field.select();
    };
    return element("form", { class: "choices", onsubmit }, element("span", { class: "label" }, "Name"), field,
      element("button", { type: "submit", class: "button" }, this.#words.answer));
  }

  /** brief: one line, to unfold; the question that stands comes first. */
  #outcome_card({ verdict, right, skipped, pending, predicted, happened, says, because, fromStep, step }, brief) {
    if (pending) return element("div", { class: "card outcome skipped" }, element("h2", { class: "kicker" }, verdict), element("p", {}, says));
    const mark = skipped ? "" : right ? "✓ " : "✕ ";
    const told = [...(skipped ? [] : [element("p", { class: "said" }, `${this.#words.prediction}: `, element("b", {}, predicted))]),
      element("p", {}, whole_names(says)), element("p", {}, whole_names(because)),
      ...(step - fromStep > 1 ? [element("p", {}, button(this.#words.watch, () => this.#do("watch_outcome")))] : [])];
    const kicker = element("h2", { class: "kicker" }, mark + verdict);
    const kind = skipped ? "skipped" : right ? "right" : "wrong";
    if (!brief) return element("div", { class: `card outcome ${kind}`, tabindex: "-1" }, kicker, ...told);
    // Beside "Not quite" it would read as what was predicted.
    const line = right ? happened : `${this.#words.answer}: ${happened}`;
    return element("div", { class: `card outcome told ${kind}` },
      element("details", {}, element("summary", {}, kicker, ` · ${line}`), ...told));
  }

  #score_card(score) {
    const again = () => this.#act(() => {
      this.#door.forget_answers();
      if (this.#door.lesson().asksOfSteps) this.#door.command("first");
    });
    return element("div", { class: "card score" }, element("p", {}, score), button(this.#words.again, again));
  }
}

/** Scrolls to all of the cards, as far as the stage stays in sight, and to their first lines in any case. */
function show_top(box) {
  if (document.documentElement.dataset.layout === "beside") by_id("column").scrollTop = 0; // where the cards stand first
  const { top, bottom } = box.getBoundingClientRect();
  const room = Math.max(0, by_id("stage").getBoundingClientRect().top);
  const below = Math.max(Math.min(bottom - innerHeight, room), top + kLinesShown - innerHeight);
  if (below > 0) scrollBy({ top: below });
}
