// The situations and the sliders of a lesson, under its stage: what they change is in sight.
import { by_id, element, set_hidden, set_text } from "./dom.js";
import { answer_edit } from "./messages.js";

/** One slider. hold(held): whether it is in hand; slide(place): moves it. */
class Slider {
  #text = element("output", {});
  #title = element("span", {});
  #input = element("input", { type: "range", min: 0, step: 1 });
  node = element("label", { class: "slider" }, this.#title, this.#input, this.#text);

  /** @param {(held: boolean) => void} hold @param {(place: number) => void} slide */
  constructor(hold, slide) {
    const input = this.#input;
    input.addEventListener("input", () => slide(input.valueAsNumber));
    input.addEventListener("pointerdown", () => hold(true));
    input.addEventListener("keydown", ({ repeat }) => repeat || hold(true)); // a key that is held goes on moving it
    for (const sign of ["keyup", "blur"]) input.addEventListener(sign, () => hold(false));
  }

  show(/** @type {ShownSlider} */ { title, text, place, places }) {
    set_text(this.#title, title);
    set_text(this.#text, text);
    this.#input.max = String(places);
    if (this.#input.valueAsNumber !== place) this.#input.value = String(place);
    this.#input.setAttribute("aria-valuetext", text);
  }
}

export class SituationTools {
  #door;
  #act;
  #situations = element("fieldset", { class: "segments", "aria-label": "Situation" });
  #sliders = element("div", { class: "sliders" });
  #shown = /** @type {Map<number, Slider>} */ (new Map()); // the sliders that are there, by their number
  #held = false;

  /** @param {Door} door @param {Act} act */
  constructor(door, act) {
    this.#door = door;
    this.#act = act;
    by_id("controls").append(this.#situations, this.#sliders);
    // A finger or a mouse may let go anywhere.
    for (const sign of ["pointerup", "pointercancel"])
      addEventListener(sign, () => this.#hold(false), { capture: true });
  }

  open(/** @type {Lesson} */ { situations }) {
    this.#situations.replaceChildren(
      ...situations.map(({ name, title }) => {
        const chosen = { value: name, onchange: () => this.#show(name) };
        return element("label", {}, element("input", { type: "radio", name: "situation", ...chosen }), title);
      }),
    );
    set_hidden(this.#situations, situations.length === 0);
    this.#shown.clear();
    this.#sliders.replaceChildren();
  }

  #show(/** @type {string} */ name) {
    this.#act(() => answer_edit(this.#door.show_situation(name)));
  }

  #hold(/** @type {boolean} */ held) {
    if (held === this.#held) return;
    this.#held = held;
    this.#act(() => answer_edit(this.#door.hold_slider(held)));
  }

  /** @param {number} number @param {number} place */
  #slide(number, place) {
    this.#act(() => answer_edit(this.#door.slide(number, place)));
  }

  #lay_out(/** @type {ShownSlider[]} */ sliders) {
    /** @param {number} number */
    const slider_of = (number) =>
      new Slider(
        (held) => this.#hold(held),
        (place) => this.#slide(number, place),
      );
    this.#shown = new Map(sliders.map(({ number }) => [number, slider_of(number)]));
    this.#sliders.replaceChildren(...[...this.#shown.values()].map(({ node }) => node));
  }

  update(/** @type {View} */ { situation, sliders, cover }) {
    for (const input of this.#situations.querySelectorAll("input")) input.checked = input.value === situation;
    if (sliders.length !== this.#shown.size || sliders.some(({ number }) => !this.#shown.has(number)))
      this.#lay_out(sliders);
    for (const slider of sliders) this.#shown.get(slider.number)?.show(slider);
    set_hidden(this.#sliders, sliders.length === 0);
    set_hidden(by_id("controls"), situation === null && sliders.length === 0 && !cover?.table.sorts.length);
  }
}
