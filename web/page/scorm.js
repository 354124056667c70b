// A session with a course's site by SCORM 1.2. No word of such a site is believed, for "true" proves nothing: what it
// did not give back at the next start is set anew.
// Source: ADL, SCORM 1.2 Run-Time Environment, 2001.
import { unpack, whole_text } from "./course_text.js";

const kBetween = 3000; // milliseconds between two commits: more freeze some sites
const kPatience = 10_000; // milliseconds in which a site answers
const kRetry = 20_000; // milliseconds until a site that did not answer is tried again
const kMostWindows = 20;
const kFinal = ["completed", "passed", "failed"];

/** Looks for the API in a window, in those around it, and in those around the one that opened it. A window of another
 *  origin throws.
 *  @param {any} start @returns {Record<string, (...of: string[]) => unknown> | null} */
export function find_api(start) {
  const around = (/** @type {any} */ from) => {
    for (let own = from, i = 0; own && i < kMostWindows; own = own.parent, ++i) {
      try {
        if (own.API) return own.API;
      } catch {
        // one further out may be of the page's own origin
      }
      if (own === own.parent) break;
    }
    return null;
  };
  return around(start) ?? around(opener_of(start)) ?? around(opener_of(start?.top));
}

function opener_of(/** @type {any} */ own) {
  try {
    return own?.opener ?? null;
  } catch {
    return null;
  }
}

const session_time = (/** @type {number} */ ms) => {
  const two = (/** @type {number} */ part) => String(Math.floor(part)).padStart(2, "0");
  const seconds = ms / 1000;
  return `${two(Math.min(seconds / 3600, 9999)).padStart(4, "0")}:${two((seconds / 60) % 60)}:${two(seconds % 60)}`;
};

/** What the site is to have.
 *  @typedef {{ count: number, body: string, score: number | null, complete: boolean }} Wanted */

/** A session with a course's site. Of what was handed over last it knows whether the site took it ("course") or gave it
 *  back at the start ("seen"); of anything newer nothing ("device"). */
export class Scorm {
  #api;
  #with;
  #begun = 0;
  #over = false;
  #writes = false;
  #commits = 0;
  #last = -Infinity; // when it was committed last
  #timer = /** @type {any} */ (null);
  #stood = { status: "", score: 0, body: /** @type {string | null} */ (null) }; // at the start
  #least = 0; // the score that stands there: it never falls
  #handed = ""; // what was handed over last, and what the site took of it
  #taken = "";
  #wanted = /** @type {Wanted} */ ({ count: 0, body: "", score: null, complete: false });
  failed = false; // whether it could not be reached when it was last handed something
  reviews = false; // whether nothing may be written

  /** reach: whether the site answers, asked of it and not of its API. tell: called when the state has changed.
   *  @param {NonNullable<ReturnType<typeof find_api>>} api
   *  @param {{ now: () => number, later: (what: () => void, ms: number) => any, forget: (timer: any) => void,
   *    reach: () => Promise<boolean>, tell: () => void }} with_ */
  constructor(api, with_) {
    this.#api = api;
    this.#with = with_;
  }

  /** Begins the session. Returns null where the API does not take part; else what the site kept, and whose it is. */
  begin() {
    this.#begun = this.#with.now();
    if (!this.#call("LMSInitialize", "")) return null;
    this.reviews = ["review", "browse"].includes(this.#get("cmi.core.lesson_mode"));
    this.#writes = !this.reviews;
    const status = this.#get("cmi.core.lesson_status");
    const kept = unpack(this.#get("cmi.suspend_data"));
    this.#least = Number(this.#get("cmi.core.score.raw")) || 0;
    this.#stood = { status, score: this.#least, body: kept?.body ?? null };
    // Else some sites make "completed" of it at the end; and without "suspend" some keep no data.
    if (this.#writes && ["not attempted", ""].includes(status)) this.#set("cmi.core.lesson_status", "incomplete");
    if (this.#writes) this.#set("cmi.core.exit", "suspend");
    return { kept, student: this.#get("cmi.core.student_id"), name: this.#get("cmi.core.student_name") };
  }

  /** @returns {"device" | "course" | "seen"} */
  get state() {
    const { body, score, complete } = this.#wanted;
    const { status, score: stood, body: given_back } = this.#stood;
    if (body === given_back && (score ?? 0) <= stood && (!complete || kFinal.includes(status))) return "seen";
    return this.#taken === this.#now() ? "course" : "device";
  }

  /** Hands it over, now or in a few seconds.
   *  @param {Wanted} wanted */
  save(wanted) {
    this.#wanted = wanted;
    if (!this.#writes || this.#over || this.state === "seen" || this.#handed === this.#now()) return;
    const wait = this.#last + kBetween - this.#with.now();
    if (wait <= 0) this.#commit();
    else this.#timer ??= this.#with.later(() => this.#commit(), wait);
  }

  /** Hands over what stands now, for the page may never be seen again.
   *  @param {Wanted} wanted */
  flush(wanted = this.#wanted) {
    this.#wanted = wanted;
    if (this.#writes && !this.#over && this.state === "device") this.#commit();
  }

  /** Ends the session, once, with what stands now. It keeps by itself what was set: no commit is made beside it.
   *  @param {Wanted} wanted */
  finish(wanted = this.#wanted) {
    if (this.#over) return;
    this.#with.forget(this.#timer);
    this.#wanted = wanted;
    if (this.#writes) {
      this.#set_all();
      this.#set("cmi.core.session_time", session_time(this.#with.now() - this.#begun));
    }
    this.#over = true;
    this.#call("LMSFinish", "");
  }

  #now() {
    const { body, score, complete } = this.#wanted;
    return JSON.stringify([body, score, complete]);
  }

  // ---- the API --------------------------------------------------------------------------------------------------

  /** Whether it says yes. It may be gone with the window that had it.
   *  @param {string} name @param {...string} of */
  #call(name, ...of) {
    try {
      return String(this.#api[name](...of)) === "true";
    } catch {
      return false;
    }
  }

  #get(/** @type {string} */ name) {
    try {
      return String(this.#api.LMSGetValue(name) ?? "");
    } catch {
      return "";
    }
  }

  /** @param {string} name @param {string} value */
  #set(name, value) {
    return this.#call("LMSSetValue", name, value);
  }

  /** Sites send what differs from what they believe was sent: so each commit says the score and the text otherwise. */
  #set_all() {
    const { count, body, score, complete } = this.#wanted;
    const turn = (this.#commits += 1);
    const all = [this.#set("cmi.suspend_data", whole_text(count, turn, body))];
    if (score !== null) {
      this.#least = Math.max(this.#least, Math.min(score, 100));
      all.push(this.#set("cmi.core.score.min", "0"), this.#set("cmi.core.score.max", "100"));
      all.push(this.#set("cmi.core.score.raw", this.#least.toFixed(1 + (turn % 2))));
    }
    if (complete && !["passed", "failed"].includes(this.#stood.status))
      all.push(this.#set("cmi.core.lesson_status", "completed"));
    return all.every(Boolean);
  }

  /** Whether the site answers in time. */
  #reached() {
    return Promise.race([this.#with.reach(), new Promise((late) => this.#with.later(() => late(false), kPatience))]);
  }

  async #commit() {
    this.#with.forget(this.#timer);
    this.#timer = null;
    this.#last = this.#with.now();
    const handed = (this.#handed = this.#now());
    // A status that was lost is believed to be there: it is taken back first.
    if (this.failed && this.#wanted.complete && this.#set("cmi.core.lesson_status", "incomplete"))
      this.#call("LMSCommit", "");
    const taken = this.#set_all() && this.#call("LMSCommit", "");
    const reached = taken && (await this.#reached());
    if (handed !== this.#handed) return; // a later one says how it stands
    this.failed = !reached;
    if (reached) this.#taken = handed;
    else if (!this.#over) this.#timer ??= this.#with.later(() => this.#commit(), kRetry);
    this.#with.tell();
  }
}
