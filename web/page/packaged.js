// A package on a course's site: the marks are handed to the site, and the page says how far they got. `snug package`
// says in course.json what is in it.
import { button, by_id, element, set_text } from "./dom.js";
import { is_complete, pack, score_of } from "./course_text.js";
import { notice } from "./messages.js";
import { Scorm, find_api } from "./scorm.js";
/** @import { Kept } from "./kept.js"
 *  @import { Saving } from "./saving.js" */

const kDecide = "You decide in the algorithm’s place, on an instance of your own. Each decision is marked, a mistake " +
  "is told at once, and a new instance is a tap away.";
const kGoes = "Your marks and decisions go to your course. Your place in each lesson, and what you build or write, " +
  "stay on this device.";
const kRoomSays = "Your course has room for 4,096 characters. Of the oldest attempts it keeps the mark alone: " +
  "save the file to have their decisions as well.";

/** Once the page is seen: opening it takes all notices away. */
const tell = (/** @type {string} */ text) => window.snug.ready.then(() => notice(text, "told"));

/** Two students may share a device: neither reads the other's answers, nor who it was. */
function number_of(/** @type {string} */ student) {
  let hash = 0x811c9dc5;
  for (const byte of new TextEncoder().encode(student)) hash = Math.imul(hash ^ byte, 0x01000193) >>> 0;
  return student && hash.toString(36);
}

/** Whether the course's site answers: a small file of the package is asked for, and not only whether a connection is
 *  there. A page to log in on is another file.
 *  @param {string} name */
const reach = (name) => fetch("reached.txt", { cache: "no-store" })
  .then((answer) => answer.text())
  .then((text) => text.trim() === name, () => false);

class Link {
  #of;
  #kept;
  #scorm;
  #told = ""; // what was told of as given way
  gave_way = /** @type {string[]} */ ([]);

  /** @param {PackageOf} of @param {Kept} kept @param {Scorm | null} scorm */
  constructor(of, kept, scorm) {
    this.#of = of;
    this.#kept = kept;
    this.#scorm = scorm;
  }

  /** @returns {SavedState} */
  get state() {
    if (this.#scorm?.reviews) return "nowhere";
    const state = this.#scorm?.state ?? "device";
    return state === "device" && !this.#kept.works ? "nowhere" : state;
  }

  get words() {
    if (!this.#scorm) return "Not handed to your course";
    if (this.#scorm.reviews) return "You only look at it here: nothing is kept";
    const { state } = this;
    if (state === "seen") return "Seen again in your course";
    if (state === "course") return "Handed to your course";
    const here = state === "device" ? "kept on this device" : "kept nowhere";
    if (this.#scorm.failed) return `Your course cannot be reached: ${here}`;
    return this.#kept.data.count > 0 ? `On the way to your course, ${here}` : "Goes to your course";
  }

  save() {
    this.#scorm?.save(this.#wanted());
  }

  // Another tab may have kept more meanwhile: a session never ends with less than what stands on the device.

  flush() {
    this.#kept.refresh();
    this.#scorm?.flush(this.#wanted());
  }

  finish() {
    this.#kept.refresh();
    this.#scorm?.finish(this.#wanted());
  }

  #wanted() {
    const { data } = this.#kept;
    const { text: body, gave_way } = pack(data, this.#of);
    this.gave_way = gave_way;
    if (gave_way.join() !== this.#told && gave_way.length > 0) tell(kRoomSays);
    this.#told = gave_way.join();
    return { count: data.count, body, score: score_of(data, this.#of), complete: is_complete(data, this.#of) };
  }
}

/** The page of a package is about what is in it alone. Its address leads nobody else there; and what a course has kept
 *  is not the page's to erase.
 *  @param {PackageOf} of */
function lay_out({ kind, title, scorm }) {
  const { classList } = document.documentElement;
  classList.toggle("unshared", scorm || location.protocol === "file:");
  for (const id of ["erase", "erase-says"]) by_id(id).hidden = scorm;
  if (kind === "course") return;
  classList.add("packaged");
  set_text(by_id("course-hero").querySelector("h1") ?? by_id("course-hero"), title);
  if (kind === "lesson") return;
  by_id("exercises").after(element("h2", { class: "teaches" }, "The lessons to it"), by_id("chapters"));
}

/** Nothing of it may be overlooked: what is done here is lost to the course unless the file is handed in. Of a lesson
 *  alone there is none.
 *  @param {PackageOf} of @param {() => void} save_file */
function say_alone({ exercises }, save_file) {
  const save = exercises.length > 0 && button("Save the result file", save_file, { class: "button primary" });
  by_id("strip").before(element("section", { class: "alone", role: "alert" },
    element("p", {}, element("b", {}, "Nothing reaches your course. "),
      "This page was opened without a connection to it: open it from your course. ",
      save && "Or go on here, then save the result file and hand that in."), save));
}

/** Of exercises that were done before and are not in the package any more.
 *  @param {Kept} kept @param {string[]} exercises */
function say_gone(kept, exercises) {
  const gone = Object.keys(kept.data.exercises).filter((id) => !exercises.includes(id));
  if (gone.length > 0)
    tell(`Your course has replaced this package, now without ${gone.join(", ")}. ` +
      "What you did there is kept, and does not count.");
}

/** The session with the course's site, begun; null where there is none.
 *  @param {PackageOf} of @param {() => void} changed */
function begin({ name }, changed) {
  const api = find_api(window);
  if (!api) return null;
  const scorm = new Scorm(api, {
    now: () => performance.now(),
    later: (what, ms) => setTimeout(what, ms),
    forget: (timer) => clearTimeout(timer),
    reach: () => reach(name),
    tell: changed,
  });
  const begun = scorm.begin();
  return begun && { scorm, ...begun };
}

/** Joins what is kept with what the course has of it, and hands over what the course lacks. exercises: all that are in
 *  the package; those of a course that are in no set earn no mark there.
 *  @param {PackageOf} of @param {string[]} exercises @param {Kept} kept @param {Saving} saving
 *  @param {() => void} save_file */
export function join(of, exercises, kept, saving, save_file) {
  lay_out(of);
  if (!of.scorm) return;
  const begun = begin(of, () => saving.show());
  const student = begun?.student || begun?.name || "";
  const own = [of.name, number_of(student)].filter(Boolean).join(".");
  kept.move_to(own, { reads: begun?.scorm.reviews, name: begun?.name });
  const link = new Link(of, kept, begun?.scorm ?? null);
  if (begun?.kept) kept.merge(begun.kept);
  saving.link = link;
  const marked = of.exercises.length > 0;
  by_id(marked ? "exercises-say" : "practise").after(saving.line(marked));
  set_text(by_id("exercises-say"), kDecide);
  set_text(by_id("course-foot-says"), begun ? kGoes : "");
  if (!begun) say_alone(of, save_file);
  say_gone(kept, exercises);
  link.save();
  saving.show();
  addEventListener("online", () => link.flush());
  addEventListener("storage", () => (kept.refresh(), link.save(), saving.show())); // another tab has kept something
  // The session is over with the page: one that comes back is another.
  addEventListener("pageshow", (event) => event.persisted && location.reload());
}
