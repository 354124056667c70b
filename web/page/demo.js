// A demo: states of lessons in the order of a lecture's slides, led by the keys of a clicker. Only a demo loads this.
import { read_address } from "./address.js";
import { by_id, element, is_within, kWrites, set_text } from "./dom.js";
import { hall } from "./hall.js";
import { lecture } from "./lecture.js";
import { notice, veil } from "./messages.js";
import { kPresentingScale } from "./settings.js";
import { bring_style } from "./sheet.js";
import { Votes } from "./vote.js";
/** @import { Downloads } from "./download.js"
 *  @import { Page } from "./main.js"
 *  @import { Settings } from "./settings.js"
 *  @typedef {{ at: number, revealed: number, black: boolean, frozen: boolean, vote: string }} Standing where the demo
 *  stands */

const kParts = ["caption", "prose", "numbers", "code"];
const kWords = 1.5 / kPresentingScale; // against a lesson's: a demo shows less beside its stage
/** What each key does; a clicker has those of the first lines.
 *  @type {Record<string, string>} */
const kKeys = {
  PageDown: "next", ArrowRight: "next",
  PageUp: "back", ArrowLeft: "back",
  F5: "fill",
  b: "b", ".": "b", // black
  Home: "again", h: "again",
  f: "f", // the picture is frozen
  s: "notes",
  l: "l", w: "w", r: "r", // the spotlight, the pen, the ruler
  n: "nothing", p: "nothing", // which lead to other lessons otherwise
};
const kHeld = 4; // repetitions of a key, a moment after the first: nobody presses a clicker that long by mistake
const kEverywhere = new Set(["PageDown", "PageUp", "F5", "Escape"]); // even while something is typed

/** The channel between the demo and its notes, in another tab. */
export const channel_of = (/** @type {string} */ id) => new BroadcastChannel(`snug-demo-${id}`);

/** Null, and the page says why, if there is none.
 *  @param {string} id @param {Page} page @param {Settings} settings @param {Downloads} downloads */
export async function bring_demo(id, page, settings, downloads) {
  const file = await downloads.text(`demos/${id}.json`).catch(() => null);
  document.documentElement.dataset.view = "lesson";
  if (file !== null) return new Demo(JSON.parse(file), page, settings);
  veil.failed(`There is no demo “${id.slice(0, 60)}”, or it could not be loaded.`, null);
  return null;
}

export class Demo {
  #file;
  #page;
  #settings;
  #at = 0; // the state, counted from 0
  #revealed = 0; // how many of its reveals are shown
  #turn = 0; // counts what was asked for; each cancels what is still opening
  #opening = false;
  #over = false;
  #channel;
  #place = element("p", { class: "demo-place" });
  #before = [0, 0]; // the state and the reveals before the last key that led
  #repeated = 0; // how often that was told again since it was pressed
  #votes = /** @type {Votes | null} */ (null);

  /** @param {DemoFile} file @param {Page} page @param {Settings} settings */
  constructor(file, page, settings) {
    this.#file = file;
    this.#page = page;
    this.#settings = settings;
    this.#channel = channel_of(file.id);
    this.#channel.onmessage = ({ data }) =>
      data.asks ? this.#tell() : data.held ? this.#hold(data.does) : this.#do(data.does);
    addEventListener("keydown", this.#key, { capture: true });
    addEventListener("pagehide", this.#gone);
    hall.changed = () => this.#tell();
  }

  get address() {
    return `?demo=${encodeURIComponent(this.#file.id)}&state=${this.#at + 1}`;
  }

  /** state: counted from 1. */
  async begin(/** @type {number} */ state) {
    await Promise.all(["demo.css", "hall.css"].map(bring_style));
    by_id("work").append(this.#place);
    this.#settings.enlarge(kWords);
    this.#settings.present(true);
    this.#settings.on_change(() => this.#settings.presenting || this.#leave());
    const { length } = this.#file.states;
    lecture().then((program) => {
      if (this.#over) return;
      this.#votes = new Votes(program, this.#page, by_id("work"), this.#file.id);
      this.#show_votes();
      this.#tell();
    }, console.warn); // without it there is no vote
    await this.#show(Math.min(Math.max(state, 1), length) - 1);
    if (state < 1 || state > length) notice(`The address asks for state ${state}; the demo has ${length}.`);
  }

  /** Takes away what it has put on the page. */
  end() {
    if (this.#over) return;
    this.#over = true;
    this.#turn += 1;
    this.#gone();
    this.#channel.close();
    removeEventListener("pagehide", this.#gone);
    removeEventListener("keydown", this.#key, { capture: true });
    this.#settings.enlarge(1);
    document.documentElement.classList.remove("demo", ...kParts.map((part) => `without-${part}`));
    this.#votes?.end();
    this.#place.remove();
    hall.changed = () => {};
    hall.lift();
  }

  /** The lesson stays, as one left it. */
  #leave() {
    if (this.#over) return;
    this.end();
    this.#settings.present(false);
    this.#page.leave_demo();
  }

  get #state() {
    return this.#file.states[this.#at];
  }

  // ---- the keys -----------------------------------------------------------------------------------------------

  #key = (/** @type {KeyboardEvent} */ event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (document.querySelector(".qr, dialog[open]")) return; // which has the keyboard
    const { key } = event;
    if (is_within(event.target, kWrites) && !kEverywhere.has(key)) return;
    if (!hall.black && !this.#answered && this.#votes?.take_key(this.#at, key)) {
      event.preventDefault();
      event.stopImmediatePropagation();
      this.#show_votes();
      return this.#tell();
    }
    const does = key === "Escape" ? "leave" : kKeys[key.length === 1 ? key.toLowerCase() : key];
    if (!does) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    if (event.repeat) this.#hold(does);
    else this.#do(does);
  };

  /** A key is held, and the keyboard tells it again: then what stood there before it was pressed is shown as it was. */
  #hold(/** @type {string} */ does) {
    if (!["next", "back"].includes(does) || ++this.#repeated !== kHeld) return;
    const [at, revealed] = this.#before;
    this.#show(at, revealed);
    this.#tell();
  }

  #do(/** @type {string} */ does) {
    if (does === "notes") return this.#open_notes();
    if (["l", "w", "r", "b", "f"].includes(does)) return void hall.answer_key(does, this.#page.door);
    const { black } = hall;
    this.#repeated = black ? kHeld : 0;
    this.#before = [this.#at, this.#revealed];
    if (black) hall.darken(false); // the first key brings the picture back, and does nothing else
    else if (does === "next") this.#next();
    else if (does === "back") this.#back();
    else if (does === "again") this.#show(this.#at, this.#revealed);
    else if (does === "fill") document.documentElement.requestFullscreen?.().catch(() => {});
    else if (does === "leave") return this.#put_away();
    this.#tell();
  }

  /** The pointers first. */
  #put_away() {
    if (!hall.put_away()) this.#leave();
  }

  #next() {
    if (this.#revealed === this.#state.reveal.length)
      return this.#at + 1 < this.#file.states.length && this.#show(this.#at + 1);
    this.#revealed += 1;
    if (this.#opening) return this.#show(this.#at, this.#revealed);
    this.#reveal(this.#state.reveal[this.#revealed - 1], true);
    this.#show_parts();
  }

  #back() {
    if (this.#revealed > 0) this.#show(this.#at, this.#revealed - 1);
    else if (this.#at > 0) this.#show(this.#at - 1, this.#file.states[this.#at - 1].reveal.length);
  }

  // ---- what is shown ------------------------------------------------------------------------------------------

  /** Shows a state as the file has it, whatever was done to it, with the first reveals.
   *  @param {number} at @param {number} revealed */
  async #show(at, revealed = 0) {
    const turn = (this.#turn += 1);
    this.#at = at;
    this.#revealed = revealed;
    this.#opening = true;
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
    this.#show_parts();
    this.#page.door.forget_input();
    const lesson_view = () => (document.documentElement.dataset.view = "lesson");
    await this.#page.open(read_address(this.#state.address), lesson_view, this);
    if (turn !== this.#turn) return;
    this.#opening = false;
    by_id("stored").scrollTop = 0;
    if (!this.#state.reveal.includes("answer")) this.#page.act(() => this.#page.door.command("pass_questions"));
    for (const what of this.#state.reveal.slice(0, revealed)) this.#reveal(what, false);
    this.#tell();
  }

  /** played: else what it leads to is shown at once. */
  #reveal(/** @type {string} */ what, /** @type {boolean} */ played) {
    const { door } = this.#page;
    const { playing, asked, steps } = /** @type {View} */ (door.view());
    this.#page.act(() => {
      if (what === "steps" && !playing) door.command("pass_questions");
      if (what === "steps" && !played) door.jump(steps);
      if (what === "steps" && played && !playing) door.command("play");
      if (what === "answer" && asked) door.command("reveal_answer");
      if (what === "answer" && asked && played) door.command("watch_outcome");
    });
  }

  #show_parts() {
    const { shows, reveal } = this.#state;
    const shown = [...shows, ...reveal.slice(0, this.#revealed)];
    const root = document.documentElement;
    root.classList.add("demo");
    for (const part of kParts) root.classList.toggle(`without-${part}`, !shown.includes(part));
    root.classList.toggle("text-shown", shown.includes("prose"));
    set_text(this.#place, `${this.#at + 1} of ${this.#file.states.length}`);
    this.#show_votes();
  }

  get #answered() {
    return this.#state.reveal.slice(0, this.#revealed).includes("answer");
  }

  #show_votes() {
    const { reveal } = this.#state;
    const later = reveal.slice(reveal.indexOf("answer") + 1, this.#revealed);
    const covers = this.#answered && later.some((what) => kParts.includes(what)); // what stands in the same corner
    this.#votes?.show(this.#at, this.#answered, covers);
  }

  // ---- the notes, in another tab --------------------------------------------------------------------------------

  /** Tells the notes that nothing is presented any more. */
  #gone = () => this.#channel.postMessage({ gone: true });

  #tell() {
    if (this.#over) return;
    this.#channel.postMessage({
      at: this.#at,
      revealed: this.#revealed,
      black: hall.black,
      frozen: hall.frozen,
      vote: this.#votes?.told(this.#at) ?? "",
    });
  }

  #open_notes() {
    const address = `${location.pathname}?demo=${encodeURIComponent(this.#file.id)}&notes=1`;
    const opened = open(address, `snug-notes-${this.#file.id}`, "popup,width=960,height=720");
    const link = { href: address, target: `snug-notes-${this.#file.id}` };
    if (!opened) notice("The browser blocks the notes. ", "wrong", element("a", link, "Open them in another tab"));
  }
}
