// The class's vote in a demo: no number of it is on the page before the answer is revealed; a place's votes are a dot
// there.
import { element } from "./dom.js";
/** @import { Page } from "./main.js" */

const kLargestDot = 1 / 14; // of the stage's height: the radius of a place that all have voted for

export class Votes {
  #program;
  #page;
  #card = element("div", { class: "demo-vote", role: "status", hidden: true });
  #dots = element("div", { class: "demo-dots", "aria-hidden": "true" });
  #shown = /** @type {Vote | null} */ (null); // whose dots follow their places
  #frame = 0;
  #taken = /** @type {[number, string, string[], string[]][]} */ ([]);
  #kept; // under this name in the tab, where a reload finds it

  /** @param {Lecture} program @param {Page} page @param {HTMLElement} work @param {string} demo */
  constructor(program, page, work, demo) {
    this.#program = program;
    this.#page = page;
    this.#kept = `snug-votes-${demo}`;
    /** @type {[number, string, string[], string[]][]} */
    const before = JSON.parse(sessionStorage.getItem(this.#kept) ?? "[]");
    for (const taken of before) this.#take(...taken);
    work.append(this.#card);
    document.body.append(this.#dots);
  }

  end() {
    sessionStorage.removeItem(this.#kept);
    cancelAnimationFrame(this.#frame);
    this.#card.remove();
    this.#dots.remove();
  }

  /** Returns whether the key was one of the vote on the question that stands open.
   *  @param {number} state @param {string} key */
  take_key(state, key) {
    const asked = this.#page.door.view()?.asked;
    if (!asked || !this.#take(state, key, asked.choices ?? [], this.#page.door.targets())) return false;
    sessionStorage.setItem(this.#kept, JSON.stringify(this.#taken));
    return true;
  }

  /** @param {[number, string, string[], string[]]} taken */
  #take(...taken) {
    return this.#program.vote_key(...taken) && Boolean(this.#taken.push(taken));
  }

  /** What the lecturer reads of it.
   *  @param {number} state */
  told(state) {
    return this.#program.vote_of(state)?.told ?? "";
  }

  /** over: whether its time is over.
   *  @param {number} state @param {boolean} revealed @param {boolean} over */
  show(state, revealed, over) {
    const vote = over ? null : this.#program.vote_of(state);
    // There may be many places: those without votes are left out.
    const rows = vote?.rows.filter(({ words, percents }) => words || percents.some((percent) => percent > 0)) ?? [];
    this.#card.hidden = revealed ? rows.length === 0 : !vote?.hidden;
    this.#shown = vote && revealed ? vote : null;
    this.#card.replaceChildren(...(revealed ? rows.flatMap(row_nodes) : [vote?.hidden ?? ""]));
    cancelAnimationFrame(this.#frame);
    this.#dots.replaceChildren();
    if (this.#shown) this.#follow();
  }

  /** The dots stay with their places, whatever moves. */
  #follow() {
    const vote = this.#shown;
    if (!vote) return;
    const stage = document.getElementById("stage")?.getBoundingClientRect();
    const dots = vote.rows.flatMap(({ name, words, percents }) => {
      const at = words ? null : this.#page.place_named(name); // a choice may be called as a place is
      if (!at || !stage) return [];
      return percents.flatMap((percent, round) => {
        const radius = kLargestDot * stage.height * Math.sqrt(percent / 100);
        if (!(percent > 0)) return [];
        const dot = element("span", { class: round === 0 && percents[1] >= 0 ? "first" : "" });
        const [left, top, size] = [at.x - radius, at.y - radius, 2 * radius].map((pixels) => `${pixels}px`);
        Object.assign(dot.style, { left, top, width: size, height: size });
        return [dot];
      });
    });
    this.#dots.replaceChildren(...dots);
    this.#frame = requestAnimationFrame(() => this.#follow());
  }
}

/** @param {VoteRow} row */
function row_nodes({ words, text, percents }) {
  const bars = percents.flatMap((percent, round) => {
    if (percent < 0) return [];
    const bar = element("i", { class: round === 0 && percents[1] >= 0 ? "first" : "" });
    bar.style.width = `${percent}%`;
    return [bar];
  });
  return [element("p", {}, element("b", {}, text), words && ` ${words}`), ...bars];
}
