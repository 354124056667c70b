// An exercise in which the student writes a function: it is tried on random and on hard cases, and judged by the core.
// Only such an exercise loads this, with its editor, the engine that runs the code and the judge.
import { button, element, followed_here, save_file, set_hidden, set_text } from "./dom.js";
import { result_text } from "./exercise.js";
import { link_of } from "./lesson_menu.js";
import { veil } from "./messages.js";
import { bring_style } from "./sheet.js";
import { cost_parts } from "./write_cost.js";
/** @import { Downloads } from "./download.js"
 *  @import { Kept } from "./kept.js"
 *  @import { Saving } from "./saving.js" */

const kPrefix = "write:"; // of its id among the exercises
const kPatience = 60000; // milliseconds; the engine ends long before, unless it has itself failed
const kMostRounds = 40; // of the search for a shorter case
const kTriesToSee = 3; // after so many the solution may be seen
const kSeed = 1; // of the cases
const kDraftDelay = 800; // milliseconds
const kLeave = "Press Tab to leave the editor now, or go on typing.";
const kKeys = "Ctrl+Enter runs the code. Tab indents; to leave the editor by keyboard press Escape, then Tab.";
const kCapped = "If you see it now, your mark for this exercise is at most half from then on. Press again to see it.";

/** The text of a decision: the code, after ? if the solution was seen.
 *  @param {string} code @param {boolean} seen */
const decision_of = (code, seen) => `${seen ? "?" : ""}w${code}`;
/** @param {string | undefined} decision */
function code_of(decision) {
  const found = /^([?]?)w(.*)$/s.exec(decision ?? "");
  return found && { seen: found[1] !== "", code: found[2] };
}

/** What an attempt earns: at most half once the solution was seen.
 *  @param {number} mark @param {number} of @param {boolean} seen */
const capped = (mark, of, seen) => (seen ? Math.min(mark, Math.floor(of / 2)) : mark);

/** The share of all cases that pass. */
const share_of = (/** @type {JudgedRun} */ { kinds }) =>
  kinds.reduce((sum, { passed }) => sum + passed, 0) / kinds.reduce((sum, { of }) => sum + of, 0);

/** Lines of JSON, as texts. */
const lines_of = (/** @type {string} */ text) => text.split("\n").filter(Boolean);

/** @typedef {{ downloads: Downloads, kept: Kept, saving: Saving, version: string,
 *    title_of: (id: string) => string | undefined, shown: () => boolean, go: (id: string) => void }} Around */

/** Shows the exercise. id: as the exercises have it.
 *  @param {string} id @param {Around} around */
export async function show_write(id, around) {
  const { downloads } = around;
  const name = id.slice(kPrefix.length);
  /** @type {WriteFile | null} */
  const file = await downloads.text(`write/${name}.json`).then(JSON.parse, () => null);
  document.documentElement.dataset.view = "lesson";
  if (!file) return veil.failed(`There is no exercise “${name.slice(0, 60)}”, or it could not be loaded.`, null);
  const [{ create_editor }, { default: create_judge }, wasm] = await Promise.all([
    import(window.snug.at("./write/editor.js")), import(window.snug.at("./write/judge.js")),
    downloads.bytes("write/judge.wasm"), bring_style("write.css")]);
  if (!around.shown()) return;
  const judge = await create_judge({ wasmBinary: wasm });
  document.querySelector(".write")?.remove();
  const page = new Write(id, file, around, () => new judge.Trial());
  document.body.append(page.main);
  page.begin(create_editor);
  document.documentElement.dataset.view = "write";
  document.title = `${file.title} · Snug`;
  veil.lift();
  return page;
}

/** A value as JavaScript writes it, with room to break its lines.
 *  @param {string} json */
const in_code = (json) => json.replaceAll(/"(\w+)":/g, "$1: ").replaceAll(/,(?=\S)/g, ", ");

const pair = (/** @type {string} */ term, /** @type {string} */ words) =>
  [element("dt", {}, term), element("dd", {}, in_code(words))];

/** The last value of each of the student's own variables, on the case that is shown.
 *  @param {Record<string, string>} notes */
function variables_of(notes) {
  const values = Object.entries(notes);
  if (values.length === 0) return [];
  return [element("h2", { class: "kicker" }, "Your variables, at their last"),
    element("dl", { class: "write-case" }, ...values.flatMap(([name, value]) => pair(name, value)))];
}

class Write {
  #id;
  #file;
  #around;
  #trial;
  #about;
  #engine;
  #compared; // a trial of its own for the methods beside the student's
  #others = /** @type {Promise<Costed[]> | null} */ (null);
  #editor = /** @type {CodeEditor | null} */ (null);
  #seen = false; // the solution
  #asked_to_see = false;
  #running = false;
  #draft = 0; // a timer, 0 while all that was typed is kept
  #host = element("div", { class: "write-editor" });
  #keys = element("p", { class: "write-hint", role: "status" }, kKeys);
  #run = button("Run", () => this.run(), { class: "button primary", title: "Ctrl+Enter" });
  #hand_in = button("Hand in", () => this.#save(), { title: "Saves a result file", disabled: true });
  #solution = button("Reference solution", () => this.#see(), { hidden: true, class: "quiet" });
  #mark = element("p", { class: "write-mark", role: "status" });
  #results = element("div", { class: "write-column" });
  #cost = element("div", { class: "write-column" });
  #solved = element("div", { class: "write-column" });

  /** @param {string} id @param {WriteFile} file @param {Around} around @param {() => Trial} create_trial */
  constructor(id, file, around, create_trial) {
    this.#id = id;
    this.#file = file;
    this.#around = around;
    this.#trial = create_trial();
    this.#compared = create_trial();
    for (const trial of [this.#trial, this.#compared]) trial.open(id.slice(kPrefix.length));
    this.#about = this.#trial.about();
    this.#engine = new Engine(around.downloads, this.#about);
    const { title, contract, lesson, stub } = file;
    const paragraphs = contract.trim().split(/\n\s*\n/).map((text) => element("p", {}, text));
    const to_lesson = { href: link_of(lesson), onclick: followed_here(() => around.go(lesson)) };
    const left = element("div", { class: "write-column" },
      element("h1", {}, title),
      element("div", { class: "contract" }, ...paragraphs),
      this.#host,
      this.#keys,
      element("div", { class: "write-buttons write-actions" }, this.#run,
        button("Start again", () => this.#editor?.set(stub), { class: "quiet" }),
        element("span", { class: "gap" }),
        around.title_of(lesson) && element("a", { class: "button", ...to_lesson }, "To the lesson"), this.#hand_in),
    );
    const right = element("div", { class: "write-column" }, this.#mark, around.saving.line(), this.#results, this.#cost,
      element("div", { class: "write-buttons" }, this.#solution), this.#solved);
    this.main = element("main", { class: "write", id: "write" }, left, right);
  }

  /** @param {CreateEditor} create_editor */
  begin(create_editor) {
    const { now, best } = this.#kept() ?? { now: null, best: null };
    const left = code_of((now ?? best)?.decisions[0]);
    this.#seen = [now, best].some((attempt) => code_of(attempt?.decisions[0])?.seen);
    this.#editor = create_editor(this.#host, left?.code ?? this.#file.stub, {
      label: `Code of the function ${this.#about.name}`,
      described: kKeys,
      changed: () => this.#keep_draft(),
      run: () => this.run(),
      left: (is_left) => set_text(this.#keys, is_left ? kLeave : kKeys),
    });
    this.#show_mark();
    if (this.#seen) this.#show_solution();
  }

  #kept() {
    return this.#around.kept.exercise(this.#id);
  }

  get #is_full() {
    const best = this.#kept()?.best;
    return best?.mark === best?.of;
  }

  /** The attempt, as a result file has it.
   *  @param {number} mark @returns {Attempt} */
  #attempt(mark) {
    const { hash, of } = this.#about;
    const code = this.#editor?.code() ?? "";
    return { exercise: this.#id, hash, seed: kSeed, decisions: [decision_of(code, this.#seen)],
      hints: this.#seen ? 1 : 0, mark: capped(mark, of, this.#seen), of, seconds: 0 };
  }

  /** Keeps what was typed, so that a reload restores it. */
  #keep_draft() {
    this.#forget_draft();
    this.#draft = setTimeout(() => this.keep_now(), kDraftDelay);
  }

  #forget_draft() {
    clearTimeout(this.#draft);
    this.#draft = 0;
  }

  /** Keeps what was typed last: the page may be left before its time has come. */
  keep_now() {
    if (!this.#draft) return;
    this.#forget_draft();
    this.#around.kept.keep_exercise(this.#attempt(0), false);
  }

  // ---- a run --------------------------------------------------------------------------------------------------

  async run() {
    if (this.#running || !this.#editor) return;
    this.#running = this.#run.disabled = true;
    set_text(this.#mark, "Running …");
    this.#editor.mark(0, "");
    try {
      await this.#try(this.#editor.code());
    } catch (error) {
      console.warn(error);
      this.#show_mark("The engine could not be loaded: run it again.");
    } finally {
      this.#running = this.#run.disabled = false;
    }
  }

  async #try(/** @type {string} */ code) {
    const ran = await this.#engine.run(code, lines_of(this.#trial.cases(kSeed)));
    const judged = this.#trial.judge(`${ran.answers.join("\n")}\n`);
    this.#forget_draft();
    this.#around.kept.keep_exercise(this.#attempt(judged.mark), true);
    this.#around.kept.keep_exercise(this.#attempt(judged.mark), false); // what stands there now may not be the best
    const first = ran.answers.length > 0 ? judged.first : null;
    const found = first && (await this.#shortest(code, first));
    const noted = this.#editor?.code() === code ? this.#editor.noted() : code; // it may have been typed on
    const looked_at = found && (await this.#engine.run(noted, [found.given]));
    this.#show(judged, ran, found, looked_at ?? { ...ran, notes: {} });
    await this.#show_cost(judged, ran);
  }

  /** The reference solution and the other methods, each tried once.
   *  @returns {Promise<Costed[]>} */
  async #beside() {
    const lines = lines_of(this.#compared.cases(kSeed));
    const methods = [{ title: "Reference solution", code: this.#file.model }, ...this.#file.methods];
    const costed = /** @type {Costed[]} */ ([]);
    for (const [i, { title, code }] of methods.entries()) {
      const ran = await this.#engine.run(code, lines);
      const judged = this.#compared.judge(`${ran.answers.join("\n")}\n`);
      const kind = i === 0 ? "model" : "other";
      costed.push({ title, kind, right: share_of(judged), steps: (ran.steps ?? 0) / lines.length });
    }
    return costed;
  }

  /** @param {JudgedRun} judged @param {Ran} ran */
  async #show_cost(judged, { steps, answers }) {
    if (steps === null) return this.#cost.replaceChildren(); // it did not come to its end
    const others = await (this.#others ??= this.#beside());
    const own = { title: "Yours", kind: "yours", right: share_of(judged), steps: steps / answers.length };
    this.#cost.replaceChildren(...cost_parts([.../** @type {Costed[]} */ ([own]), ...others]));
  }

  /** Goes on to shorter inputs that fail, as long as there is one.
   *  @param {string} code @param {FoundCase} first */
  async #shortest(code, first) {
    let found = first;
    for (let round = 0; round < kMostRounds; ++round) {
      const lines = lines_of(this.#trial.shorter());
      if (lines.length === 0) break;
      const next = this.#trial.narrow(`${(await this.#engine.run(code, lines)).answers.join("\n")}\n`);
      if (!next) break;
      found = { ...next, kind: first.kind };
    }
    return found;
  }

  // ---- what is shown ------------------------------------------------------------------------------------------

  #show_mark(says = "") {
    const kept = this.#kept();
    const best = kept?.best;
    const words = best ? `Best mark ${best.mark} of ${best.of}.`
      : `${this.#about.of} marks: one for each kind of cases.`;
    set_text(this.#mark, `${says} ${words}`.trim());
    this.#hand_in.disabled = !best?.decisions.length; // a course's site gives back the mark without the code
    set_hidden(this.#solution, !kept || this.#seen || (!this.#is_full && kept.tries < kTriesToSee) || !best);
  }

  /** looked_at: the run of the case that is shown, with what it printed and its variables.
   *  @param {JudgedRun} judged @param {Ran} ran @param {FoundCase | null} found @param {Ran} looked_at */
  #show(judged, { answers, error }, found, { output, notes }) {
    if (error && error.line > 0) this.#editor?.mark(error.line, error.what);
    const wrong = error && element("p", { class: "write-wrong" },
      `${error.line > 0 ? `Line ${error.line}: ` : ""}${error.what}`);
    const row = (/** @type {JudgedRun["kinds"][0]} */ { name, passed, of }) => {
      const all = passed === of;
      return element("tr", { class: all ? "right" : "wrong" },
        element("th", { scope: "row" }, `${all ? "✓" : "✕"} ${name}`), element("td", {}, `${passed} of ${of}`));
    };
    if (answers.length === 0) { // it could not even be called
      this.#results.replaceChildren(...(wrong ? [wrong] : []));
      return this.#show_mark("It does not run.");
    }
    this.#results.replaceChildren(
      element("p", {}, judged.says),
      ...(wrong ? [wrong] : []),
      element("table", { class: "write-kinds" },
        element("caption", { class: "unseen" }, "Cases that pass, of each kind"), ...judged.kinds.map(row)),
      ...(found ? this.#found_parts(found, judged.first !== null && found.given !== judged.first.given) : []),
      ...variables_of(notes),
      ...(output ? [element("h2", { class: "kicker" }, "What it printed"), element("pre", {}, output)] : []),
    );
    const earned = capped(judged.mark, judged.of, this.#seen);
    const why = earned < judged.mark ? ", at most half: the solution was seen" : "";
    this.#show_mark(`Mark ${earned} of ${judged.of}${why}.`);
  }

  /** @param {FoundCase} found @param {boolean} is_shorter */
  #found_parts({ kind, given, right, yours, lesson, words }, is_shorter) {
    const inputs = Object.entries(JSON.parse(given.replaceAll(/-0(?![.\d])/g, '"-0"')));
    const text = (/** @type {any} */ value) => JSON.stringify(value).replaceAll('"-0"', "-0");
    const heading = `A case on which it differs (${kind}${is_shorter ? ", shortened" : ""})`;
    return [
      element("h2", { class: "kicker" }, heading),
      element("dl", { class: "write-case" }, ...inputs.flatMap(([name, value]) => pair(name, text(value))),
        ...pair("right", right), ...pair("yours", yours || "something else")),
      this.#stage(lesson),
      ...(words ? [element("p", { class: "label" }, words)] : []),
    ];
  }

  /** The case on a stage: the page itself, in a frame.
   *  @param {string} lesson the text of its file */
  #stage(lesson) {
    const frame = element("iframe", { class: "write-stage", title: "The case on the stage",
      src: `?lesson=${this.#file.lesson}&embed=1` }); // a package has no other lesson
    frame.addEventListener("load", async () => {
      const own = /** @type {any} */ (frame.contentWindow)?.snug;
      await own?.ready;
      const error = own?.open_text(lesson);
      const link = frame.contentDocument?.getElementById("whole");
      if (link) link.hidden = true; // it leads to a lesson, which this is not
      if (error) frame.replaceWith(element("p", { class: "label" }, `This case cannot be drawn: ${error}.`));
    });
    return frame;
  }

  // ---- the solution, and the file -----------------------------------------------------------------------------

  #see() {
    if (!this.#is_full && !this.#asked_to_see) {
      this.#asked_to_see = true;
      return this.#solved.replaceChildren(element("p", { role: "status" }, kCapped));
    }
    if (!this.#is_full) {
      this.#seen = true;
      this.#around.kept.keep_exercise(this.#attempt(0), false);
    }
    set_hidden(this.#solution, true);
    this.#show_solution();
  }

  #show_solution() {
    const { model, reasons } = this.#file;
    this.#solved.replaceChildren(element("h2", { class: "kicker" }, "Reference solution"),
      element("pre", {}, model.trim()), element("p", {}, reasons.trim()));
  }

  /** For scripts and tests.
   *  @returns {ExerciseState} */
  state() {
    const kept = this.#kept();
    const prompt = this.#file.contract.trim();
    const { of } = this.#about;
    return { exercise: this.#id, seed: kSeed, decision: 0, decisions: 1, prompt, targets: [], choices: [],
      mark: kept?.best?.mark ?? 0, of, hints: this.#seen ? 1 : 0, told: true };
  }

  #save() {
    const best = this.#kept()?.best;
    if (!best?.decisions.length) return;
    const { kept, version } = this.#around;
    save_file(result_text(kept.student, [best], version), `${this.#file.id}.json`);
    set_text(this.#keys, "The result file is saved. It has your code, which is run again when it is graded.");
  }
}

/** The worker that runs code. One that does not answer in time is ended, and the next run has another. */
class Engine {
  #downloads;
  #about;
  #worker = /** @type {Worker | null} */ (null);
  #wasm = /** @type {WebAssembly.Module | null} */ (null);

  /** @param {Downloads} downloads @param {AboutFunction} about */
  constructor(downloads, about) {
    this.#downloads = downloads;
    this.#about = about;
  }

  /** @param {string} code @param {string[]} lines @returns {Promise<Ran>} */
  async run(code, lines) {
    const bytes = await this.#downloads.bytes("write/quickjs.wasm");
    const wasm = (this.#wasm ??= await WebAssembly.compile(bytes));
    const worker = (this.#worker ??= new Worker("write/worker.js"));
    const { name, gives } = this.#about;
    return new Promise((resolve) => {
      const give_up = (/** @type {string} */ what) => {
        worker.terminate();
        this.#worker = null;
        resolve({ answers: [], output: "", notes: {}, error: { what, line: 0 }, turns: 0, steps: null });
      };
      const timer = setTimeout(() => give_up("it took too long, and was ended"), kPatience);
      worker.onmessage = ({ data }) => {
        clearTimeout(timer);
        resolve(data);
      };
      worker.onerror = () => give_up("the engine could not be loaded");
      worker.postMessage({ wasm, code, name, gives, lines });
    });
  }
}

