// What to do first: three invitations on the stage of the course's first lesson, one at a time, each gone once it was
// followed, and never shown again.
import { by_id, element, set_hidden, set_text } from "./dom.js";

const kRoom = 8; // pixels between an invitation and what it points at
const kBelow = 96; // pixels at the stage's foot that belong to its sentence

export class Invitations {
  #kept;
  #first; // the course's first lesson
  #handles;
  #here = false;
  #name = null; // of the point to drag
  #step = null; // where the one that stands was shown
  #box = element("p", { class: "invitation", role: "status", hidden: true });

  /** handles(): as window.snug.handles() gives them. */
  constructor(kept, first, handles) {
    this.#kept = kept;
    this.#first = first;
    this.#handles = handles;
    by_id("stage").append(this.#box);
  }

  open(lesson) {
    this.#here = lesson.id === this.#first && !document.documentElement.classList.contains("embed");
    this.#name = this.#step = null;
  }

  update(view) {
    if (!this.#here || this.#kept.invited > 2) return set_hidden(this.#box, true);
    if (this.#followed(view)) {
      this.#kept.keep_invited(this.#kept.invited + 1);
      this.#step = null;
    }
    const shown = this.#kept.invited <= 2 && !view.asked && !view.outcome && !view.deciding && !view.summary && !view.previewing && (this.#kept.invited > 0 || view.step === 0) && this.#place(view);
    set_hidden(this.#box, !shown);
  }

  #followed({ edited, step, playing }) {
    if (this.#kept.invited === 0) return this.#name !== null && edited;
    if (this.#kept.invited === 1) return this.#step !== null && step > this.#step;
    return playing || (this.#step !== null && step > this.#step + 1); // where it plays on within a moment
  }

  /** Whether there is room to say it. */
  #place({ step }) {
    const stage = by_id("stage").getBoundingClientRect();
    if (document.documentElement.classList.contains("presenting") || stage.height < 200) return false;
    if (this.#kept.invited === 0) return this.#point_at_handle(stage);
    this.#step ??= step;
    set_text(this.#box, this.#kept.invited === 1 ? "Now press Step" : "Press Play: it stops where it asks you");
    set_hidden(this.#box, false);
    this.#box.dataset.side = "above";
    const x = stage.width / 2 + (this.#kept.invited === 1 ? -26 : 76); // where the buttons of app/timeline.cpp stand
    const timeline = by_id("timeline").getBoundingClientRect();
    this.#move(stage, x, timeline.top - stage.top + 52 - this.#box.offsetHeight - kRoom);
    return true;
  }

  #point_at_handle(stage) {
    const handles = this.#handles().filter(({ x, y }) => x > stage.left && x < stage.right && y > stage.top && y < stage.bottom);
    const chosen = handles.find(({ id }) => id === this.#name) ?? handles.sort((a, b) => b.x - a.x)[0];
    if (!chosen) return false;
    this.#name = chosen.id;
    set_text(this.#box, `Drag ${chosen.id}`);
    set_hidden(this.#box, false);
    const [x, y] = [chosen.x - stage.left, chosen.y - stage.top];
    const below = y + 60 < stage.height - kBelow;
    this.#box.dataset.side = below ? "below" : "above";
    this.#move(stage, x, below ? y + 16 + kRoom : y - 16 - kRoom - this.#box.offsetHeight);
    return true;
  }

  #move(stage, x, y) {
    const half = this.#box.offsetWidth / 2;
    const left = Math.min(Math.max(x - half, 8), stage.width - 2 * half - 8);
    this.#box.style.transform = `translate(${Math.round(left)}px, ${Math.round(y)}px)`;
    this.#box.style.setProperty("--tip", `${Math.round(x - left)}px`);
  }
}
