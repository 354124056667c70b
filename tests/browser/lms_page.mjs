// A course's site in a page, for tests: it opens a package in a frame, anew as often as a test wants. It runs in the
// browser, beside the packages (package_support.mjs).
import { Scorm12API } from "./node_modules/scorm-again/dist/esm/scorm12.js";
import { WorstSite, strict } from "../page/lms.mjs";

const kPatience = 20_000; // milliseconds
const wait = (ms) => new Promise((later) => setTimeout(later, ms));

/** SCORM 1.2's own limits, by scorm-again behind them. */
class StrictSite {
  broken = [];
  server = /** @type {any} */ ({});
  #api = null;
  open() {
    this.#api = new Scorm12API({ autocommit: false, logLevel: 5 });
    const core = { student_id: "s-1", student_name: "Lamarr, Hedy", lesson_mode: "normal", ...this.server.core };
    this.#api.loadFromJSON({ ...this.server, core });
    return strict(this.#api, this.broken);
  }
  close() {
    const { suspend_data, core } = this.#api.renderCMIToJSONObject().cmi;
    const { lesson_status, score } = core;
    this.server = { suspend_data, core: { lesson_status, ...(score.raw !== "" && { score: { raw: score.raw } }) } };
  }
  get arrived() {
    const { core } = this.#api.renderCMIToJSONObject().cmi;
    return { score: core.score.raw === "" ? null : Number(core.score.raw), status: core.lesson_status };
  }
}

class WorstOne extends WorstSite {
  broken = [];
  close() {}
  get arrived() {
    const score = this.server["cmi.core.score.raw"];
    return { score: score === undefined ? null : Number(score), status: this.server["cmi.core.lesson_status"] };
  }
}

const site = new URLSearchParams(location.search).get("site") === "worst" ? new WorstOne({}) : new StrictSite();
let frame = null;

/** Until the package's page answers and shows what it opens. */
async function ready() {
  await until(() => frame.contentWindow?.snug?.state(), "the package opens");
  await frame.contentWindow.snug.ready;
  return frame.contentWindow.snug.exercise();
}

async function until(holds, what) {
  for (const late = performance.now() + kPatience; performance.now() < late; await wait(20)) {
    const held = await holds();
    if (held) return held;
  }
  throw new Error(`waited in vain until ${what}: ${frame?.contentDocument?.body.innerText.slice(0, 300)}`);
}

const own = (selector) => frame.contentDocument.querySelector(selector);
const snug = () => frame.contentWindow.snug;
const asks = (decision) => snug().state()?.asked && snug().exercise()?.decision === decision;

/** Decides as a person does: the name is typed, or the button of the choice is pressed. */
async function decide(decision, answer) {
  await until(() => asks(decision), `decision ${decision + 1} stands`);
  const choices = [...frame.contentDocument.querySelectorAll(".ask .choices .button")];
  if (typeof answer === "number") choices[answer].click();
  else {
    own(".ask input").value = answer;
    own(".ask form").requestSubmit();
  }
  await until(() => !asks(decision), `decision ${decision + 1} is made`);
}

const lms = (window.lms = {
  site,
  until,
  /** Opens a package in a new session. */
  async open(path) {
    lms.close();
    window.API = site.open();
    frame = document.createElement("iframe");
    frame.width = "1000";
    frame.height = "700";
    frame.src = path;
    document.body.append(frame);
    return ready();
  },
  /** Goes to an address within the package. */
  async go(search) {
    const id = new URLSearchParams(search).get("exercise");
    frame.contentWindow.history.pushState(null, "", search);
    frame.contentWindow.dispatchEvent(new PopStateEvent("popstate"));
    await until(() => snug().exercise()?.exercise === id, `${id} is open`);
    return snug().exercise();
  },
  /** Leaves the package, as when the site shows something else. */
  close() {
    if (!frame) return;
    frame.remove();
    frame = null;
    site.close();
  },
  async decide_all(answers, from = 0) {
    for (const [i, answer] of answers.entries()) await decide(from + i, answer);
    await wait(300); // until the page has kept it
  },
  says: () => own(".ask .saved span")?.textContent,
  saved: () => snug().saved(),
  exercise: () => snug().exercise(),
  result: () => JSON.parse(snug().result()),
  notices: () => own("#notices").textContent,
  alone: () => own(".alone")?.textContent ?? "",
  finished: () => until(() => snug().state()?.exercise?.finished, "the exercise is finished"),
  state: (state) => until(() => snug().saved() === state, `it is ${state}`),
});
