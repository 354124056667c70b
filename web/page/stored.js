// How the volumes on the stage are stored: each representation with its members and their numbers, its bytes, and what
// each operation takes in it. A member that is pointed at or has the focus is lit on the stage.
import { by_id, element, lights, set_hidden, set_text, when_changed } from "./dom.js";

const kNews = 1500; // milliseconds for which a number that has changed is marked

/** @typedef {ReturnType<typeof laid_out>[0]} LaidOut */

/** What the nodes are made of: all but the members' numbers. */
const laid_out = (/** @type {StoredVolume[]} */ volumes) =>
  volumes.map(({ title, forms }) => ({
    title,
    forms: forms.map((form) => ({ ...form, members: form.members.map(({ declared, mark }) => ({ declared, mark })) })),
  }));

export class Stored {
  #light;
  #texts = /** @type {Map<string, HTMLElement>} */ (new Map()); // the node of each member's numbers, by its mark
  #news = /** @type {Map<HTMLElement, number>} */ (new Map()); // what takes the mark of a change away

  /** light(mark): lights it on the stage; "" for none. */
  constructor(/** @type {(mark: string) => void} */ light) {
    this.#light = light;
  }

  open() {
    this.#texts.clear();
  }

  update(/** @type {View} */ { lesson, stored }) {
    document.documentElement.classList.toggle("has-stored", stored.length > 0);
    set_hidden(by_id("stored"), stored.length === 0);
    this.#lay_out(lesson, laid_out(stored));
    const members = stored.flatMap(({ forms }) => forms).flatMap((form) => form.members);
    for (const { mark, text } of members) this.#show(this.#texts.get(mark), text);
  }

  #lay_out = when_changed((/** @type {string} */ _lesson, /** @type {LaidOut[]} */ volumes) => {
    this.#texts.clear();
    by_id("stored").replaceChildren(
      element("h2", { class: "unseen", id: "stored-heading" }, "Stored as"),
      ...volumes.map((volume) => this.#volume(volume)),
    );
  });

  #volume(/** @type {LaidOut} */ { title, forms }) {
    return element("section", {}, element("h3", { class: "label" }, title), ...forms.map((form) => this.#form(form)));
  }

  #form(/** @type {LaidOut["forms"][0]} */ { name, bytes, members, operations }) {
    const told = operations.flatMap(({ name, says, least }) => [
      element("dt", {}, name),
      element("dd", { class: least && "least" }, says, least && element("span", { class: "unseen" }, " (least)")),
    ]);
    return element("section", { class: "form" },
      element("h4", {}, name),
      element("p", { class: "label" }, bytes),
      element("ul", {}, ...members.map((member) => element("li", {}, this.#member(member)))),
      element("dl", {}, ...told),
    );
  }

  #member(/** @type {{ declared: string, mark: string }} */ { declared, mark }) {
    const text = element("span", { class: "numbers-of" });
    this.#texts.set(mark, text);
    const listens = lights(() => this.#light(mark), () => this.#light(""));
    return element("button", { type: "button", class: "member", ...listens }, element("span", {}, declared), text);
  }

  /** @param {HTMLElement | undefined} node @param {string} text */
  #show(node, text) {
    if (!node) return;
    const changed = node.textContent !== "" && node.textContent !== text;
    set_text(node, text);
    if (!changed) return;
    node.classList.add("news");
    clearTimeout(this.#news.get(node));
    this.#news.set(node, setTimeout(() => node.classList.remove("news"), kNews));
  }
}
