// Presentation mode: keys and buttons lead from lesson to lesson, and the lesson's text is shown only on request.
import { by_id, is_within, kWrites } from "./dom.js";
/** @import { Settings } from "./settings.js" */

export class Presentation {
  #settings;
  #door;
  #lessons;
  #go_to;
  #shows;
  #here = 0; // the index of the open lesson
  #hall = /** @type {typeof import("./hall.js").hall | null} */ (null); // once something of it was used here

  /** shows(): called when the text is shown.
   *  @param {Settings} settings @param {Door} door @param {CourseLesson[]} lessons @param {GoTo} go_to
   *  @param {() => void} shows */
  constructor(settings, door, lessons, go_to, shows) {
    this.#settings = settings;
    this.#door = door;
    this.#lessons = lessons;
    this.#go_to = go_to;
    this.#shows = shows;
    by_id("previous-lesson").addEventListener("click", () => this.#move(-1));
    by_id("next-lesson").addEventListener("click", () => this.#move(1));
    by_id("text-shown").addEventListener("click", () => this.#show_text());
    document.addEventListener("keydown", (event) => this.#key(event));
    settings.on_change(() => settings.presenting || this.#end());
  }

  open(/** @type {Lesson} */ lesson) {
    this.#here = this.#lessons.findIndex(({ id }) => id === lesson.id);
    by_id("previous-lesson").disabled = !this.#lessons[this.#here - 1];
    // A case of the gallery stands in no order.
    by_id("next-lesson").disabled = this.#here < 0 || !this.#lessons[this.#here + 1];
  }

  #move(/** @type {number} */ by) {
    const to = this.#lessons[this.#here + by];
    if (to && this.#here >= 0) this.#go_to(to.id);
  }

  #show_text(shown = !document.documentElement.classList.contains("text-shown")) {
    document.documentElement.classList.toggle("text-shown", shown);
    by_id("text-shown").setAttribute("aria-pressed", shown);
    if (shown) this.#shows();
  }

  #end() {
    this.#show_text(false);
    if (document.querySelector(".hall")) import("./hall.js").then(({ hall }) => (hall.put_away(), hall.lift()));
  }

  async #point(/** @type {string} */ key) {
    this.#hall ??= (await import("./hall.js")).hall;
    this.#hall.answer_key(key, this.#door);
  }

  #key(/** @type {KeyboardEvent} */ event) {
    if (!this.#settings.presenting || event.defaultPrevented) return;
    if (event.ctrlKey || event.metaKey || event.altKey || is_within(event.target, kWrites)) return;
    const key = event.key.toLowerCase();
    if (this.#hall?.black) key === "shift" || this.#hall.darken(false); // any key, which then does nothing else
    else if (key === "n") this.#move(1);
    else if (key === "p") this.#move(-1);
    else if (key === "t") this.#show_text();
    else if (["l", "w", "r", "b", ".", "f"].includes(key)) this.#point(key);
    else if (key !== "escape" || !this.#hall?.put_away()) return;
    event.preventDefault();
  }
}
