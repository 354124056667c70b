// The file of what is on the stage, edited here and checked as one types: the stage follows each text without a
// mistake, and what was typed stays.
import { by_id, element, set_hidden, set_text, when_changed } from "./dom.js";
import { answer_edit } from "./messages.js";

const kFewestRows = 8;

export class SceneFile {
  #door;
  #act;
  #text = element("textarea", {
    id: "file-text",
    rows: kFewestRows,
    spellcheck: "false",
    autocomplete: "off",
    autocapitalize: "off",
    "aria-labelledby": "file-heading",
    "aria-describedby": "file-says",
    oninput: () => this.#type(),
    onblur: () => this.#door.end_typing(),
  });
  #heading = element("p", { class: "file-heading", role: "status" });
  #mistakes = element("ul", { class: "file-mistakes" });

  /** @param {Door} door @param {Act} act */
  constructor(door, act) {
    this.#door = door;
    this.#act = act;
    by_id("file").append(
      element("h2", { id: "file-heading" }, "The stage’s file"),
      element("p", { class: "label", id: "file-says" },
        "Change a number, add an effect: the stage answers at once. Bodies with at_points stand where you drag them.",
      ),
      this.#text,
      this.#heading,
      this.#mistakes,
    );
  }

  #type() {
    this.#act(() => answer_edit(this.#door.set_file(this.#text.value)));
  }

  /** Puts the cursor where a mistake is.
   *  @param {number} line @param {number} column */
  #show_mistake(line, column) {
    const before = this.#text.value.split("\n").slice(0, line - 1).join("\n").length + (line > 1 ? 1 : 0);
    this.#text.focus();
    this.#text.setSelectionRange(before + column - 1, before + column - 1);
  }

  #say = when_changed((/** @type {string} */ heading, /** @type {string[]} */ mistakes) => {
    set_text(this.#heading, heading);
    this.#text.setAttribute("aria-invalid", String(mistakes.length > 0));
    this.#mistakes.replaceChildren(
      ...mistakes.map((mistake) => {
        const [line, column] = mistake.split(":").map(Number);
        const onclick = () => this.#show_mistake(line, column);
        return element("li", {}, element("button", { type: "button", onclick }, mistake));
      }),
    );
  });

  update(/** @type {View} */ { file }) {
    document.documentElement.classList.toggle("has-file", file !== null);
    set_hidden(by_id("file"), file === null);
    if (file === null) return;
    if (this.#text.value !== file.typed) this.#text.value = file.typed; // undone, or another situation’s
    this.#text.rows = Math.max(kFewestRows, file.typed.split("\n").length + 1);
    this.#say(file.heading, file.mistakes);
  }
}
