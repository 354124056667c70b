// The situations and the sliders of a lesson, under its stage: what they change is in sight.
import { by_id, element, set_hidden, set_text } from "./dom.js";
import { answer_edit } from "./messages.js";


/** One slider. hold(held): whether it is in hand; slide(place): moves it. */
class Slider {
  #text = element("output", {});
  #title = element("span", {});
  #input = element("input", { type: "range", min: 0, step: 1 });
  node = element("label", { class: "slider" }, this.#title, this.#input, this.#text);

  constructor(hold, slide) {
    const input = this.#input;
    input.addEventListener("input", () => slide(input.valueAsNumber));
    input.addEventListener("pointerdown", () => hold(true));
    input.addEventListener("keydown", ({ repeat }) => repeat || hold(true)); // a key that is held goes on moving it
    for (const sign of ["keyup", "blur"]) input.addEventListener(sign, () => hold(false));
  }

  show({ title, text, place, places }) {
    set_text(this.#title, title);
    set_text(this.#text, text);
    this.#input.max = places;
    if (this.#input.valueAsNumber !== place) this.#input.value = place;
    this.#input.setAttribute("aria-valuetext", text);
  }
}

export class SituationTools {
  #door;
  #act;
  #situations = element("fieldset", { class: "segments", "aria-label": "Situation" });
  #sliders = element("div", { class: "sliders" });
  #shown = new Map(); // the sliders that are there, by their number
  #held = false;

  constructor(door, act) {
    this.#door = door;
    this.#act = act;
    by_id("controls").append(this.#situations, this.#sliders);
    // A finger or a mouse may let go anywhere.
    for (const sign of ["pointerup", "pointercancel"]) addEventListener(sign, () => this.#hold(false), { capture: true });
  }

  open({ situations }) {
    this.#situations.replaceChildren(...situations.map(({ name, title }) =>
      element("label", {}, element("input", { type: "radio", name: "situation", value: name, onchange: () => this.#show(name) }), title)));
    set_hidden(this.#situations, situations.length === 0);
    this.#shown.clear();
    this.#sliders.replaceChildren();
  }

  #show(name) {
    this.#act(() => answer_edit(this.#door.show_situation(name)));
  }

  #hold(held) {
    if (held === this.#held) return;
    this.#held = held;
    this.#act(() => this.#door.hold_slider(held));
  }

  #slide(number, place) {
    this.#act(() => answer_edit(this.#door.slide(number, place)));
  }

  #lay_out(sliders) {
    this.#shown = new Map(sliders.map(({ number }) => [number, new Slider((held) => this.#hold(held), (place) => this.#slide(number, place))]));
    this.#sliders.replaceChildren(...[...this.#shown.values()].map(({ node }) => node));
  }

  update({ situation, sliders, cover }) {
    for (const input of this.#situations.querySelectorAll("input")) input.checked = input.value === situation;
    if (sliders.length !== this.#shown.size || sliders.some(({ number }) => !this.#shown.has(number))) this.#lay_out(sliders);
    for (const slider of sliders) this.#shown.get(slider.number).show(slider);
    set_hidden(this.#sliders, sliders.length === 0);
    set_hidden(by_id("controls"), situation === null && sliders.length === 0 && !cover?.table.sorts.length);
  }
}
