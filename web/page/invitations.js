// What to do first, on the stage of the course's first lesson, beside what it speaks of. The program says what is due;
// the page keeps how many were followed, so that none is shown again.
import { by_id, element, set_hidden, set_text } from "./dom.js";
/** @import { Kept } from "./kept.js" */

const kRoom = 8; // pixels between an invitation and what it points at
const kBelow = 96; // pixels at the bottom of the stage, for its sentence

export class Invitations {
  #door;
  #kept;
  #first; // the course's first lesson
  #on_page;
  #here = false;
  #box = element("p", { class: "invitation", role: "status", hidden: true });

  /** on_page({x, y}): a place on the canvas as one on the page.
   *  @param {Door} door @param {Kept} kept @param {string | undefined} first
   *  @param {(place: Point) => Point} on_page */
  constructor(door, kept, first, on_page) {
    this.#door = door;
    this.#kept = kept;
    this.#first = first;
    this.#on_page = on_page;
    by_id("stage").append(this.#box);
  }

  open(/** @type {Lesson} */ lesson) {
    this.#here = lesson.id === this.#first && !document.documentElement.classList.contains("embed");
    if (this.#here) this.#door.invite(this.#kept.invited);
  }

  update(/** @type {View} */ { invitation, invited }) {
    if (this.#here && invited > this.#kept.invited) this.#kept.keep_invited(invited);
    const stage = by_id("stage").getBoundingClientRect();
    const room = stage.height >= 200 && !document.documentElement.classList.contains("presenting");
    set_hidden(this.#box, !invitation || !room);
    if (!invitation || !room) return;
    set_text(this.#box, invitation.words);
    const { x, y } = this.#on_page(invitation);
    const top = y - stage.top;
    const bottom = top + invitation.height;
    const below = bottom + 44 < stage.height - kBelow;
    this.#box.dataset.side = below ? "below" : "above";
    this.#move(
      stage,
      x - stage.left + invitation.width / 2,
      below ? bottom + kRoom : top - kRoom - this.#box.offsetHeight,
    );
  }

  /** @param {DOMRect} stage @param {number} x @param {number} y */
  #move(stage, x, y) {
    const half = this.#box.offsetWidth / 2;
    const left = Math.min(Math.max(x - half, 8), stage.width - 2 * half - 8);
    this.#box.style.transform = `translate(${Math.round(left)}px, ${Math.round(y)}px)`;
    this.#box.style.setProperty("--tip", `${Math.round(x - left)}px`);
  }
}
