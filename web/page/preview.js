// The preview of lessons that are being written (./run --lessons FOLDER): follows their files, and says what is wrong
// with them in a strip over the stage. A static host never loads this.
import { by_id, element, set_hidden, set_text, when_changed } from "./dom.js";

const kLook = 250; // milliseconds between looks at the files
const kAgain = 2000; // the same after a look that failed: the server may be gone for a while

/** @type {DraftSays} */
const nothing = { heading: "", lines: [] };
const lost = {
  heading: "The lessons cannot be reached.",
  lines: [
    { text: "Their folder, or the program that serves it, is gone. The lesson is shown as it was.", warning: false },
  ],
};

export class Preview {
  #stamps; // by the files' names
  #lesson = nothing;
  #course = nothing;
  #files = nothing;

  /** of: the course's "preview": the files' stamps as the course was made, and what is wrong with its own file.
   *  @param {PreviewOf} of */
  constructor(of) {
    this.#stamps = of.files;
    this.course_says(of);
  }

  /** Calls changed(names) whenever files have changed, and waits for it.
   *  @param {(names: string[]) => Promise<void>} changed */
  async follow(changed) {
    for (;;) {
      await new Promise((go_on) => setTimeout(go_on, kLook));
      const names = await this.#look().catch(() => null);
      this.#files = names ? nothing : lost;
      this.#show(this.says);
      if (names && names.length > 0) await changed(names).catch((failed) => console.warn(failed));
      if (names === null) await new Promise((go_on) => setTimeout(go_on, kAgain));
    }
  }

  /** The names of the files that have changed since the last look. */
  async #look() {
    const now = await (await fetch("preview.json", { cache: "no-store" })).json();
    const before = this.#stamps;
    this.#stamps = now;
    return Object.keys({ ...before, ...now }).filter((name) => before[name] !== now[name]);
  }

  /** Whether there was a file of that name at the last look. */
  has(/** @type {string} */ name) {
    return Object.hasOwn(this.#stamps, name);
  }

  /** says: of the lesson that is shown; null for none.
   *  @param {DraftSays | null} says */
  lesson_says(says) {
    this.#lesson = says ?? nothing;
    this.#show(this.says);
  }

  /** Says what is wrong with the lesson that is shown. Its checks, which may take seconds, are no part of the page.
   *  @param {string} id @param {() => boolean} shown whether it is still shown */
  async check(id, shown) {
    const says = await fetch(`checks/${id}.json`, { cache: "no-store" }).then((answer) => answer.ok && answer.json());
    if (says && shown()) this.lesson_says(says);
  }

  /** of: the course's "preview".
   *  @param {PreviewOf} of */
  course_says({ mistake }) {
    this.#course = mistake
      ? { heading: "course.toml: 1 mistake", lines: [{ text: mistake, warning: false }] }
      : nothing;
    this.#show(this.says);
  }

  /** What the strip says, part by part. */
  get says() {
    return [this.#files, this.#lesson, this.#course].filter(({ lines }) => lines.length > 0);
  }

  #show = when_changed((/** @type {DraftSays[]} */ parts) => {
    const strip = by_id("strip");
    set_hidden(strip, parts.length === 0);
    strip.classList.toggle(
      "wrong",
      parts.some(({ lines }) => lines.some(({ warning }) => !warning)),
    );
    strip.replaceChildren(
      ...parts.flatMap(({ heading, lines }) => [
        element("h2", {}, heading),
        element("ul", {},
          ...lines.map(({ text, warning }) => element("li", { class: warning ? null : "wrong" }, text)),
        ),
      ]),
    );
    set_text(
      by_id("strip-told"),
      parts.map(({ heading }) => heading).join(" ") || "Nothing is wrong with the lesson’s file.",
    );
  });
}
