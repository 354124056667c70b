// An exercise in a frame of another page: that page is told the mark and what was decided, and gives it back when the
// exercise is opened again, by SPLICE's messages (https://cssplice.org). Nothing of the student goes out before that page
// has answered, and then to its origin alone; what others send is not read.
import { score_of, unpack } from "./course_text.js";
import { exercises_in } from "./kept.js";
/** @import { Kept } from "./kept.js"
 *  @import { Saving } from "./saving.js" */

const kPatience = { "SPLICE.getState": 1500, "SPLICE.reportScoreAndState": 10_000 }; // milliseconds for an answer

class Around {
  #origin = /** @type {string | null} */ (null);
  #activity = location.href;
  #waiting = /** @type {Map<string, { subject: string, answer: (data: any) => void }>} */ (new Map());

  constructor() {
    addEventListener("message", ({ source, origin, data }) => {
      const asked = this.#waiting.get(data?.message_id);
      if (source !== parent || !asked || data.subject !== `${asked.subject}.response`) return;
      if (origin !== (this.#origin ?? origin) || origin === "null") return;
      this.#origin = origin;
      asked.answer(data);
    });
  }

  /** Null where no answer comes.
   *  @param {keyof typeof kPatience} subject @returns {Promise<any>} */
  ask(subject, more = {}) {
    const message_id = crypto.getRandomValues(new Uint32Array(4)).join("-");
    return new Promise((resolve) => {
      const answer = (/** @type {any} */ data) => (this.#waiting.delete(message_id), resolve(data));
      this.#waiting.set(message_id, { subject, answer });
      setTimeout(() => answer(null), kPatience[subject]);
      // The first one has nothing in it but this frame's own address.
      parent.postMessage({ subject, message_id, activity_id: this.#activity, ...more }, this.#origin ?? "*");
    });
  }
}

class Link {
  #around;
  #kept;
  #of;
  #tell;
  #seen;
  #least = 0; // the score never falls
  #body = "";
  #taken = /** @type {string | null} */ (null);
  #failed = false;

  /** seen: what the page around gave back.
   *  @param {Around} around @param {Kept} kept @param {string} id @param {string | null} seen
   *  @param {() => void} tell */
  constructor(around, kept, id, seen, tell) {
    this.#around = around;
    this.#kept = kept;
    this.#of = { lessons: [], exercises: [id] };
    this.#seen = seen;
    this.#tell = tell;
  }

  /** @returns {SavedState} */
  get state() {
    if (this.#body === this.#seen) return "seen";
    return this.#body === this.#taken ? "course" : "nowhere";
  }

  get words() {
    if (this.#failed) return "The page around this one does not answer: save the file";
    if (this.state === "seen") return "Seen again in the page around this one";
    if (this.state === "course") return "Handed to the page around this one";
    return this.#body ? "On the way to the page around this one" : "Goes to the page around this one";
  }

  save() {
    const { data } = this.#kept;
    const body = state_text(data, this.#of.exercises[0]);
    if (body === this.#body) return;
    this.#body = body;
    this.#least = Math.max(this.#least, (score_of(data, this.#of) ?? 0) / 100);
    if (this.state !== "seen") this.#report(body, this.#least);
  }

  /** @param {string} state @param {number} score */
  async #report(state, score) {
    const answer = await this.#around.ask("SPLICE.reportScoreAndState", { score, state });
    if (state !== this.#body) return; // a later one says how it stands
    this.#failed = !answer || Boolean(answer.error) || answer.success === false;
    if (!this.#failed) this.#taken = state;
    this.#tell();
  }

  flush() {}
  finish() {}
}

/** What the page around keeps: all of the exercise, with what was built or written, for nothing of it stays here.
 *  @param {Readonly<KeptData>} data @param {string} id */
const state_text = ({ exercises }, id) => (exercises[id] ? JSON.stringify({ exercise: exercises[id] }) : "");

/** The exercise in a state that was given back, which some pages quote once more; null where it has none. States of
 *  earlier versions are those of courses' sites.
 *  @param {unknown} state @param {string} id */
function exercise_of(state, id) {
  try {
    const read = JSON.parse(String(state));
    if (typeof read === "string") return exercise_of(read, id);
    return exercises_in({ exercises: { [id]: read?.exercise } })[id] ?? null;
  } catch {
    return unpack(String(state))?.exercises[id] ?? null;
  }
}

/** Joins what is kept with what the page around has of the exercise. Where that page keeps it, this device does not: it
 *  cannot know who sits there. A page that does not answer collects nothing.
 *  @param {string} id @param {Kept} kept @param {Saving} saving */
export async function join(id, kept, saving) {
  const around = new Around();
  const answer = await around.ask("SPLICE.getState");
  if (!answer || answer.error) return;
  kept.move_to("frame", { reads: true });
  const given = exercise_of(answer.state, id);
  if (given) kept.merge({ count: 0, lessons: {}, exercises: { [id]: given } });
  const seen = given && state_text(kept.data, id);
  const link = new Link(around, kept, id, seen, () => saving.show());
  saving.link = link;
  link.save();
  saving.show();
}
