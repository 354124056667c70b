// Where what a student does is kept, in a line on the card of an exercise or under a lesson: on this device, or as a
// course's site or the page around this one has it (packaged.js, splice.js).
import { element, set_text } from "./dom.js";
/** @import { Kept } from "./kept.js" */

export class Saving {
  #kept;
  #save_file;
  #lines = /** @type {HTMLElement[]} */ ([]);
  link = /** @type {SavingLink | null} */ (null);

  /** save_file: saves the result file.
   *  @param {Kept} kept @param {() => void} save_file */
  constructor(kept, save_file) {
    this.#kept = kept;
    this.#save_file = save_file;
    kept.on_change(() => (this.link?.save(), this.show()));
  }

  get state() {
    return this.link?.state ?? (this.#kept.works ? "device" : "nowhere");
  }

  get #words() {
    if (this.link) return this.link.words;
    return this.#kept.works ? "Kept on this device" : "Kept nowhere: save the file before you leave";
  }

  /** A line that stays true. file: whether there are marks, which a file can hold. */
  line(file = true) {
    const says = element("span", { role: "status" }, this.#words);
    const to_file = { type: "button", class: "quiet", onclick: this.#save_file };
    this.#lines = [...this.#lines.filter((line) => line.isConnected), says];
    return element("p", { class: "saved" }, says, file && " ", file && element("button", to_file, "Save the file"));
  }

  show() {
    for (const line of this.#lines) set_text(line, this.#words);
  }
}
