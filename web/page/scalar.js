// The switch between float and double, for lessons whose methods run in both.
import { by_id, element, when_changed } from "./dom.js";
import { answer_edit } from "./messages.js";

export class ScalarSwitch {
  #choice = element("select", {},
    element("option", { value: "double" }, "double"),
    element("option", { value: "float" }, "float"),
  );
  #section = element("div", { class: "fields", hidden: true },
    element("label", {}, element("span", {}, "Computed in"), this.#choice),
  );

  /** @param {Door} door @param {Act} act */
  constructor(door, act) {
    this.#choice.addEventListener("change", () => act(() => {
      const error = door.set_float(this.#choice.value === "float");
      if (error) this.#choice.value = "double"; // float cannot hold it
      answer_edit(error);
    }));
    by_id("points").append(this.#section);
  }

  #show = when_changed((/** @type {string} */ _lesson, /** @type {Scalar | null} */ scalar) => {
    this.#section.hidden = scalar === null;
    this.#choice.value = scalar ?? "double";
  });

  update(/** @type {View} */ view) {
    this.#show(view.lesson, view.scalar);
  }
}
