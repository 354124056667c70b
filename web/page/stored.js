// How the volumes on the stage are stored: each representation with its members and their numbers, its bytes, and what
// each operation takes in it. A member that is pointed at or has the focus is lit on the stage.
import { by_id, element, set_hidden, set_text, when_changed } from "./dom.js";

const kNews = 1500; // milliseconds for which a number that has changed is marked

const laid_out = (volumes) => volumes.map(({ title, forms }) => ({ title, forms: forms.map(({ members, ...form }) =>
  ({ ...form, members: members.map(({ declared, mark }) => ({ declared, mark })) })) }));

export class Stored {
  #light;
  #texts = new Map(); // the node of each member's numbers, by its mark
  #news = new Map(); // what takes the mark of a change away

  /** light(mark): lights it on the stage; "" for none. */
  constructor(light) {
    this.#light = light;
  }

  open() {
    this.#texts.clear();
  }

  update({ lesson, stored }) {
    document.documentElement.classList.toggle("has-stored", stored.length > 0);
    set_hidden(by_id("stored"), stored.length === 0);
    this.#lay_out(lesson, laid_out(stored));
    for (const { forms } of stored)
      for (const { members } of forms) for (const { mark, text } of members) this.#show(this.#texts.get(mark), text);
  }

  #lay_out = when_changed((_lesson, volumes) => {
    this.#texts.clear();
    by_id("stored").replaceChildren(element("h2", { class: "unseen", id: "stored-heading" }, "Stored as"), ...volumes.map((volume) => this.#volume(volume)));
  });

  #volume({ title, forms }) {
    return element("section", {}, element("h3", { class: "label" }, title), ...forms.map((form) => element("section", { class: "form" },
      element("h4", {}, form.name), element("p", { class: "label" }, form.bytes),
      element("ul", {}, ...form.members.map((member) => element("li", {}, this.#member(member)))),
      element("dl", {}, ...form.operations.flatMap(({ name, says, least }) => [element("dt", {}, name),
        element("dd", { class: least && "least" }, says, ...(least ? [element("span", { class: "unseen" }, " (least)")] : []))])))));
  }

  #member({ declared, mark }) {
    const on = () => this.#light(mark), off = () => this.#light("");
    const text = element("span", { class: "numbers-of" });
    this.#texts.set(mark, text);
    return element("button", { type: "button", class: "member", onpointerenter: on, onpointerleave: off, onfocus: on, onblur: off,
      oncontextmenu: (event) => event.preventDefault(), // which a long press would open
    }, element("span", {}, declared), text);
  }

  #show(node, text) {
    const changed = node.textContent !== "" && node.textContent !== text;
    set_text(node, text);
    if (!changed) return;
    node.classList.add("news");
    clearTimeout(this.#news.get(node));
    this.#news.set(node, setTimeout(() => node.classList.remove("news"), kNews));
  }
}
