// The column at the right of a wide window: the numbers have the room that they want and the pseudocode the rest. Where
// the numbers fill the column, as the fifteen axes do, the pseudocode is a tab beside them. How the volumes are stored
// is a tab as well, in the lessons that show it.
import { by_id } from "./dom.js";
import { TabList } from "./tab_list.js";

const kCode = 17; // rem: the choice of algorithms, and enough lines to follow

export class Side {
  #door;
  #tabs;
  #of = ""; // the lesson and the algorithm
  #since = 0; // frames drawn when they came; figures of before are not theirs
  #stores = false; // whether the lesson shows how volumes are stored
  #most = 0; // pixels that the numbers have wanted at most

  constructor(/** @type {Door} */ door) {
    this.#door = door;
    const names = { stored: "Stored as", numbers: "Numbers", code: "Code" };
    this.#tabs = new TabList(by_id("side-tabs"), names, (id) => this.#choose(id));
    this.#choose("numbers");
    new ResizeObserver(() => this.#fit()).observe(by_id("side"));
  }

  open() {
    this.#of = "";
    this.#choose(this.#stores ? "stored" : "numbers");
  }

  update(/** @type {View} */ { lesson, algorithm, framesDrawn, stored }) {
    if (this.#stores !== stored.length > 0) { // it is what such a lesson is about
      this.#stores = stored.length > 0;
      this.#choose(this.#stores ? "stored" : "numbers");
      this.#fit();
    }
    if (this.#of !== `${lesson} ${algorithm}`) {
      this.#of = `${lesson} ${algorithm}`;
      this.#since = framesDrawn;
      this.#most = 0;
    }
    if (framesDrawn <= this.#since) return;
    const height = Math.ceil(this.#door.figures_height()); // 0 where they are not drawn
    if (height <= this.#most) return;
    this.#most = height; // and never less, so that nothing moves to and fro
    this.#fit();
  }

  #choose(/** @type {string} */ id) {
    document.documentElement.dataset.side = id;
    this.#tabs.mark(id);
  }

  #fit() {
    const side = by_id("side");
    const rem = parseFloat(getComputedStyle(document.documentElement).fontSize);
    side.classList.toggle("tabbed", this.#door.figures_fill() && this.#most > side.clientHeight - kCode * rem);
    side.style.setProperty("--wants", `${this.#most}px`);
  }
}
