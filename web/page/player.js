// The timeline's buttons, and a scene's effects, as HTML too, for those who cannot see the canvas, and for all if there
// is none. They are hidden until they have the keyboard's focus.
import { button, by_id, element, set_text, when_changed } from "./dom.js";

const kButtons = [["first"], ["back"], ["step"], ["next_mark", "Next mark"], ["play", "Play"], ["last"],
  ["slower", "Slower"], ["faster", "Faster"], ["reset_view", "Show all points"]];

/** @typedef {Lesson["stepWord"]} StepWord
 *  @typedef {Pick<View, "step" | "steps" | "furthest" | "previewing"> & { word: StepWord }} Standing */

/** The names of the player's buttons, if the timeline counts steps and if it counts frames.
 *  @type {Record<StepWord, Record<string, string>>} */
const kWords = { step: { first: "First step", back: "Step back", step: "Step", last: "Last step" },
  frame: { first: "First frame", back: "Previous frame", step: "Next frame", last: "Last frame" } };

export class Player {
  #slider;
  #buttons;
  #place = element("p", { class: "label" });
  #play;
  #step;
  #word = /** @type {StepWord} */ ("step");
  #effects = element("span", { class: "row" });
  #switches = /** @type {HTMLInputElement[]} */ ([]);
  #says = /** @type {HTMLElement[]} */ ([]);
  #names = /** @type {string[]} */ ([]);
  #door;
  #act;

  /** @param {Door} door @param {Act} act */
  constructor(door, act) {
    this.#door = door;
    this.#act = act;
    this.#slider = element("input", { type: "range", min: 0, step: 1,
      oninput: () => act(() => door.go(Number(this.#slider.value))) });
    this.#buttons = kButtons.map(([command, words]) =>
      button(words ?? "", () => act(() => door.command(command)), {
        class: command === "reset_view" ? "button of-stage" : "button",
      }),
    );
    const button_of = (/** @type {string} */ wanted) =>
      this.#buttons[kButtons.findIndex(([command]) => command === wanted)];
    this.#play = button_of("play");
    this.#step = button_of("step");
    by_id("player").append(...this.#buttons, this.#effects, this.#place, this.#slider);
  }

  open(/** @type {Lesson} */ { stepWord: word }) {
    this.#word = word;
    for (const [i, [command]] of kButtons.entries())
      if (kWords[word][command]) set_text(this.#buttons[i], kWords[word][command]);
    this.#slider.setAttribute("aria-label", word === "frame" ? "Frame" : "Step");
  }

  #list_effects = when_changed((/** @type {string[]} */ ...names) => {
    const held = this.#names.find((_, i) => this.#switches[i] === document.activeElement);
    this.#switches = names.map((name) =>
      element("input", { type: "checkbox", onchange: () => this.#act(() => this.#door.command(`turn:${name}`)) }),
    );
    this.#names = names;
    this.#says = names.map(() => element("span", {}));
    this.#effects.replaceChildren(
      ...names.map((name, i) =>
        element("label", {}, this.#switches[i], ` ${name.replaceAll("_", " ")}`, this.#says[i]),
      ),
    );
    this.#switches[names.findIndex((name) => name === held)]?.focus(); // an element each, in whatever order
  });

  #show_step = when_changed((/** @type {Standing} */ { step, steps, furthest, previewing, word }) => {
    set_text(this.#step, previewing ? "From the start" : kWords[word].step);
    this.#slider.max = String(furthest ?? steps);
    this.#slider.value = String(step);
    const place = furthest === null ? `${word} ${step} of ${steps}` : `${word} ${step}`;
    this.#slider.setAttribute("aria-valuetext", place);
    set_text(this.#place, place);
  });

  update(/** @type {View} */ view) {
    const { step, steps, furthest, previewing } = view;
    this.#show_step({ step, steps, furthest, previewing, word: this.#word });
    const effects = view.effects ?? [];
    this.#list_effects(...effects.map(({ effect }) => effect));
    for (const [i, { on, called, says }] of effects.entries()) {
      this.#switches[i].checked = on && called;
      set_text(this.#says[i], says && `: ${says}`);
    }
    set_text(this.#play, view.playing ? "Pause" : "Play");
  }
}
