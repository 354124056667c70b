// The way from any lesson to the course's playground, with the points that stand on its stage, and back.
import { button, by_id, element, set_hidden, set_text } from "./dom.js";
import { notice } from "./messages.js";

export class Playground {
  #door;
  #id;
  #lessons;
  #go_to;
  #open = ""; // the lesson that is open
  #from = /** @type {CourseLesson | null} */ (null); // the one that the points came from
  #carries = false;
  #button = button("", () => this.#go(), { class: "button" });
  #node = element("p", { class: "playground" }, this.#button);

  /** id: of the lesson that takes the points of all others; "" for none. lessons: the course's.
   *  @param {Door} door @param {string} id @param {CourseLesson[]} lessons @param {GoTo} go_to */
  constructor(door, id, lessons, go_to) {
    this.#door = door;
    this.#id = id;
    this.#lessons = lessons;
    this.#go_to = go_to;
    by_id("task").after(this.#node);
  }

  #go() {
    if (this.#open === this.#id) return this.#from && this.#go_to(this.#from.id);
    this.#from = this.#lessons.find(({ id }) => id === this.#open) ?? null;
    this.#door.carry_points();
    this.#carries = true;
    this.#go_to(this.#id);
  }

  open(/** @type {Lesson} */ { id }) {
    this.#open = id;
  }

  /** Once a lesson stands as its address wants it: puts down what was carried there. */
  arrived() {
    const carries = this.#carries && this.#open === this.#id;
    this.#carries = false;
    if (!carries) return;
    const error = this.#door.put_down_points(this.#from?.id ?? "points");
    if (error) notice(`${error}.`);
  }

  update() {
    const there = this.#open === this.#id;
    set_hidden(this.#node, !this.#id || (there && !this.#from));
    if (this.#node.hidden) set_text(this.#button, "");
    else set_text(this.#button, there ? `Back to ${this.#from?.title}` : this.#door.playground_says());
  }
}
