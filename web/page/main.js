// The page: loads the program and a lesson, shows the lesson's state, and keeps the address up to date.
import { exercise_link, here, read_address, terms_of, with_pair } from "./address.js";
import { Code } from "./code.js";
import { by_id, element, followed_here, make_anew, save_file, set_text, when_changed } from "./dom.js";
import { open_door, warm_up } from "./door.js";
import { CoverTools } from "./cover.js";
import { Course } from "./course.js";
import { Downloads } from "./download.js";
import { Exercise, fresh_seed, kEnd, result_text, with_times } from "./exercise.js";
import { SceneFile } from "./file.js";
import { Gallery } from "./gallery.js";
import { Invitations } from "./invitations.js";
import { Kept, kMostLevel } from "./kept.js";
import { listen_to_keys } from "./keys.js";
import { name_layout } from "./layout.js";
import { LessonMenu, lesson_links, way_into } from "./lesson_menu.js";
import { answer_edit, clear_notices, kCancelled, notice, notice_all, veil, work } from "./messages.js";
import { NumberTools } from "./numbers.js";
import { PanelWords } from "./panel_words.js";
import { Player } from "./player.js";
import { Playground } from "./playground.js";
import { PointTools } from "./points.js";
import { Presentation } from "./presentation.js";
import { QuestionCard } from "./question.js";
import { Reading } from "./reading.js";
import { Saving } from "./saving.js";
import { ScalarSwitch } from "./scalar.js";
import { Settings } from "./settings.js";
import { Side } from "./side.js";
import { SituationTools } from "./situations.js";
import { Stage } from "./stage.js";
import { Stored } from "./stored.js";
import { Tabs } from "./tabs.js";
import { Words } from "./words.js";
/** @import { Demo } from "./demo.js"
 *  @import { Preview } from "./preview.js"
 *  @typedef {ReturnType<typeof read_address>} Address */

const kAddressDelay = 250; // milliseconds: browsers limit how often the address is replaced
const kFilesDelay = 400; // milliseconds: if a lesson's files take longer, the page says so
const kChanged = "This exercise has changed since you began it, so you begin anew.";
const kNotLoaded = "could not be loaded. Check the connection, then try again.";
// Milliseconds between updates of the HTML during a drag: one in every frame would cost a layout each.
const kPanelsDelay = 250;

/** @param {Attempt | null} attempt */
const made_in = (attempt) => attempt?.decisions.join("\n") ?? "";

export class Page {
  written = /** @type {string | null} */ (null); // the address that the page wrote for the open lesson
  #door;
  #downloads;
  #lessons;
  #exercises;
  #version;
  #gallery;
  #stage;
  #settings;
  #menu;
  #points;
  #question;
  #reading;
  #tabs;
  /** @type {PagePanel[]} */
  #panels;
  /** The lesson that is open, and its state when something has changed last.
   *  @type {Lesson} */
  #lesson;
  /** @type {View} */
  #view;
  #embed;
  #go_to;
  #opens = 0; // counts the calls of open and rest; each cancels the earlier ones
  #working = /** @type {Promise<Refusal> | null} */ (null); // an edit that takes long
  #left_at = /** @type {string | null} */ (null); // the address in whose place one was cancelled
  #opening = true; // whether the page does not show yet what the address asks for
  #kept;
  #erased_at = /** @type {string | null} */ (null); // the address at which the answers were erased
  #reveal = () => {};
  #address_timer = 0;
  #panels_timer = 0;
  #preview;
  #exercise = /** @type {string | null} */ (null); // the id of the one that is open
  #counted = false; // whether it, finished, has counted as a try
  #taken_up = /** @type {string[]} */ ([]); // its decisions that were made before it was opened
  #known = ""; // what is open, as it was kept last: what another tab has kept since is newer
  #demo = /** @type {Demo | null} */ (null); // whose state is open
  /** What could not be opened, because of its file.
   *  @type {{ asked: Address, reveal: () => void } | null} */
  #wanted = null;
  #playground;

  /** preview: where the lessons are being written, else null.
   *  @param {{ door: Door, downloads: Downloads, course: Course, gallery: Gallery | null,
   *    formulas: Record<string, string>, settings: Settings, kept: Kept, saving: Saving, embed: boolean,
   *    preview: Preview | null, go_to: GoTo }} of */
  constructor({ door, downloads, course, gallery, formulas, settings, kept, saving, embed, preview, go_to }) {
    const { lessons, exercises, playground } = course;
    this.#door = door;
    this.#downloads = downloads;
    this.#lessons = lessons;
    this.#exercises = exercises;
    this.#version = course.version;
    this.#gallery = gallery;
    this.#settings = settings;
    this.#kept = kept;
    this.#embed = embed;
    this.#preview = preview;
    /** @type {Act} */
    const act = (what) => this.act(what);
    const next = (/** @type {string} */ id) =>
      this.#is_of_course(id) ? lessons[lessons.findIndex((lesson) => lesson.id === id) + 1] : undefined;
    const texts = new Words(formulas);
    const exercise = new Exercise(door, act, {
      exercises,
      kept,
      go: go_to,
      again: (terms) => go_to(this.#exercise ?? "", { ...terms, seed: fresh_seed() }),
      hand_in: () => this.hand_in(),
      saving,
    });
    const after = {
      next: embed ? () => undefined : next,
      go: go_to,
      title: (/** @type {string} */ id) => (embed ? undefined : lessons.find((lesson) => lesson.id === id)?.title),
      show_task: embed ? null : () => this.#show_task(),
    };
    const question = new QuestionCard(door, act, texts, after, exercise);
    this.#question = question;
    this.#points = new PointTools(door, act, (name) => this.#mesh(name));
    this.#reading = new Reading(door.words(), {
      texts,
      start_task: (task) => this.#to_task(() => door.start_task(task)),
      solve_again: (task) => this.#to_task(() => answer_edit(door.solve_again(task))),
      follow: (link) => this.#follow(link),
      light: (mark) => act(() => door.light(mark)),
      has: (id) => this.#is_of_course(id),
    });
    this.#playground = new Playground(door, embed ? "" : playground, lessons, go_to);
    this.#tabs = new Tabs((id) => id === "read" && this.#reading.bring_section());
    this.#panels = [
      texts,
      this.#reading,
      question,
      exercise,
      this.#playground,
      new PanelWords((command) => act(() => door.command(command))),
      new Code(door, act),
      new Stored((mark) => act(() => door.light(mark))),
      this.#points,
      new NumberTools(door, act),
      new ScalarSwitch(door, act),
      new SceneFile(door, act),
      new SituationTools(door, act),
      new CoverTools(door, act, () => this.#stage, () => this.#place()),
      new Player(door, act),
      this.#tabs,
      new Side(door),
      new Presentation(settings, door, lessons, go_to, () => this.#reading.bring_section()),
      new Invitations(door, kept, lessons[0]?.id, (place) => this.#stage.on_page(place)),
    ];
    this.#menu = new LessonMenu(lessons, go_to);
    this.#stage = new Stage(door, () => this.#show());
    settings.on_change(() => this.#apply_settings());
    listen_to_keys(
      door,
      act,
      (digit) => question.choose(digit),
      () => this.#leave_presentation(),
      {
        record: () => this.#record(),
        present: () => settings.present(!settings.presenting),
        code: () => this.#show_code(),
      },
    );
    for (const command of ["undo", "redo"])
      by_id(command).addEventListener("click", () => act(() => door.command(command)));
    // The timeline has a locked button "Answer" on the canvas.
    by_id("timeline").addEventListener("click", () => this.#view?.asked && question.show());
    by_id("share").addEventListener("click", () => this.#share());
    this.#go_to = go_to;
  }

  /** Follows a link in the prose. */
  #follow(/** @type {Link} */ { kind, target }) {
    if (kind === "lesson") return this.#go_to(target);
    if (kind === "mesh") return this.#points.bring(target);
    const { step } = this.#view;
    this.act(() => {
      if (kind === "step") return this.#door.go(Number(target));
      const error = kind === "algorithm" ? this.#door.choose(0, target) : this.#door.show_situation(target);
      if (error) notice(`${error}.`);
    });
    // The question stops the player here.
    if (kind === "step" && this.#view.asked && this.#view.step === step) this.#question.show();
  }

  /** Wherever one was: the task is at the end of the lesson's text. */
  #show_task() {
    this.#tabs.choose("read");
    this.#reading.bring_task();
  }

  /** Puts something of a task on the stage, and on a phone scrolls to it, for it is far above the task. */
  #to_task(/** @type {() => void} */ put) {
    this.act(put);
    by_id("stage").scrollIntoView({ block: "nearest" });
  }

  /** Does what the user asks for, then shows the result. */
  act(/** @type {() => void} */ what) {
    what();
    this.#show();
    this.#stage.request();
    return this.#working ?? "";
  }

  /** Waits for an edit that takes long. Returns why it was refused, or "".
   *  @returns {Promise<Refusal>} */
  async #finish() {
    if (!this.#door.preparing()) return "";
    const refused = await work(this.#door);
    if (this.#opening) return refused;
    this.#working = null;
    veil.lift();
    if (refused === kCancelled) notice("Cancelled: all is as it was.", "told");
    else if (refused) answer_edit(refused);
    this.act(() => {});
    return refused;
  }

  #apply_settings() {
    this.#door.set_settings(this.#settings.for_door());
    this.#stage.request();
  }

  #leave_presentation() {
    if (!this.#settings.presenting) return false;
    this.#settings.present(false);
    return true;
  }

  #mesh(/** @type {string} */ name) {
    return this.#downloads.bytes(`meshes/${name}.ply`);
  }

  // ---- lessons ------------------------------------------------------------------------------------------------

  /** Keeps the student's place at once. */
  keep_now() {
    this.#write_address();
  }

  /** Keeps the student's place before something else is shown. */
  leave() {
    this.#write_address();
    this.written = null;
  }

  /** Keeps the student's place and stops playing, before the course is shown. */
  rest() {
    this.#opens += 1; // cancels what is still loading
    this.#wanted = null;
    this.#preview?.lesson_says(null);
    this.#door.give_up();
    clearTimeout(this.#address_timer);
    this.#address_timer = 0;
    if (!this.#opening) this.#keep(this.#address());
    this.#opening = true;
    this.#exercise = null;
    if (this.#view?.playing) this.#door.command("play");
  }

  /** Another tab has kept something: where it went on with the attempt that is open here, so does this one. */
  async follow_attempt() {
    const own = this.#opening ? null : this.#attempt(), kept = own && this.#kept.exercise(own.exercise)?.now;
    if (!own || !kept || this.#view.exercise?.practises || made_in(own) !== this.#known) return;
    const same = kept.seed === own.seed && (kept.level ?? 0) === (own.level ?? 0) && kept.hash === own.hash;
    if (!same || made_in(kept) === this.#known) return;
    await this.open(read_address(here()));
    notice("This attempt went on in another tab.", "told");
  }

  /** Erases all answers. The current place is not kept either, until the student continues. */
  erase() {
    this.#door.erase_answers();
    if (this.#opening) return;
    this.#show();
    this.#erased_at = this.#address();
  }

  #is_of_course(/** @type {string} */ id) {
    return this.#lessons.some((lesson) => lesson.id === id);
  }

  /** Where a handle of that name is in the page's viewport. */
  place_named(/** @type {string} */ name) {
    const at = this.#door.place_named(name);
    return at && this.#stage.on_page(at);
  }

  get door() {
    return this.#door;
  }

  /** Opens what an address asks for, or says why it cannot. A later call cancels one that waits for its files.
   *  reveal: shows the page once it has something new. demo: whose state it is: nothing of it is kept.
   *  @param {Address} asked @param {() => void} reveal @param {Demo | null} demo */
  async open(asked, reveal = () => {}, demo = null) {
    const turn = (this.#opens += 1);
    this.#reveal = reveal;
    this.#demo = demo;
    this.#opening = true;
    clearTimeout(this.#address_timer);
    this.#address_timer = 0;
    this.#erased_at = null;
    this.written = null;
    this.#wanted = { asked, reveal };
    document.documentElement.classList.toggle("exercise", asked.exercise !== null);
    this.#exercise = asked.exercise;
    this.#known = "";
    if (asked.exercise !== null) return this.#open_exercise(asked, asked.exercise, turn);
    const id = asked.lesson ?? "";
    const known = this.#is_of_course(id) || (await this.#gallery?.has(id));
    if (turn !== this.#opens) return;
    if (!known) {
      reveal();
      return this.#offer_lessons(id);
    }
    const read = await this.#read(id, turn).catch((failed) => console.warn(failed));
    if (turn !== this.#opens) return;
    reveal();
    if (!read)
      return veil.failed(`The lesson ${kNotLoaded}`, () => this.open(asked, reveal, demo));
    if (demo) this.#door.erase_answers(); // those of its earlier states
    const kept = this.#embed || demo ? null : this.#kept.lesson(id);
    if (kept && read.opens) this.#door.keep_answers(id, kept.answers);
    const error = read.opens ? this.#door.open_lesson(read.bytes, false) : read.error;
    if (error && this.#preview)
      return veil.choose(
        "This lesson cannot be drawn yet: it opens once its file is mended. These are the lessons:",
        lesson_links(this.#lessons, null, this.#go_to),
      );
    if (error) return veil.failed(`This lesson cannot be opened. ${error}.`, null);
    this.#wanted = null;
    this.#show_lesson();
    const { bare, mistakes } = this.#door.read_place(asked.place);
    const back = kept && ((bare && !asked.mark) || [kept.address, window.snug.opens].includes(here()));
    if (!back) asked.problems.push(...mistakes); // of what is kept, the student has written none
    const whole = await this.#restore(back ? kept.address : asked.place, asked.problems, turn);
    if (turn !== this.#opens) return;
    if (back && whole) this.#resume(kept);
    this.#playground.arrived();
    await this.#finish();
    if (turn !== this.#opens) return;
    this.#left_at = null;
    this.#view = this.#now();
    if (!whole) this.#left_at = this.#address();
    this.#opening = false;
    clear_notices();
    notice_all(asked.problems);
    veil.lift();
    this.act(() => {});
    if (asked.mark) await this.#compare(asked.mark).catch(() => {});
  }

  /** Opens an exercise at the instance of the address, of the attempt that was left, of the student's name, or a fresh
   *  one.
   *  @param {Address} asked @param {string} id @param {number} turn */
  async #open_exercise(asked, id, turn) {
    const known = this.#exercises.some((exercise) => exercise.id === id);
    const toml = known ? await this.#downloads.text(`lessons/exercises/${id}.toml`).catch(() => null) : "";
    if (turn !== this.#opens) return;
    this.#reveal();
    if (!known) return veil.failed(`There is no exercise “${id.slice(0, 60)}”.`, null);
    if (toml === null)
      return veil.failed(`The exercise ${kNotLoaded}`, () => this.open(asked));
    this.#counted = false;
    const now = asked.practice ? null : this.#kept.exercise(id)?.now;
    // A level that the address names is the one that counts.
    const left = asked.level === null || (now?.level ?? 0) === asked.level ? now : null;
    const { student } = this.#kept;
    const seed = asked.seed ?? left?.seed ?? (student ? this.#door.seed_of_name(student) : fresh_seed());
    const level = Math.min(asked.level ?? (asked.seed === null ? (left?.level ?? 0) : 0), kMostLevel);
    const error = this.#door.read_exercise(toml, `${id}.toml`) ||
      this.#door.open_exercise(seed, level, asked.practice);
    if (error) return veil.failed(`This exercise cannot be opened. ${error}.`, null);
    this.#wanted = null;
    const goes_on = left?.seed === seed && (left.level ?? 0) === level && left.hash === this.#door.attempt()?.hash;
    this.#taken_up = left && goes_on ? left.decisions : [];
    if (left && goes_on) this.#door.take_up_attempt(left.decisions);
    this.#known = made_in(this.#attempt());
    this.#show_lesson();
    this.#opening = false;
    clear_notices();
    if (left && left.hash !== this.#door.attempt()?.hash && !asked.practice)
      asked.problems.push(this.#kept.exercise(id)?.best ? `${kChanged} Your best mark stays.` : kChanged);
    notice_all(asked.problems);
    veil.lift();
    this.act(() => {});
  }

  /** The attempt that is open. The program times what it takes up as made now. */
  #attempt() {
    const attempt = this.#exercise === null ? null : this.#door.attempt();
    return attempt && with_times(attempt, this.#taken_up);
  }

  /** Saves the attempt as a result file, or the best ones. */
  hand_in() {
    const attempt = this.#attempt();
    save_file(this.result(), attempt ? `${attempt.exercise}-${attempt.seed}.json` : "snug-result.json");
    notice("The result file is saved. It is no signature: it proves that these decisions earn this mark.", "told");
  }

  /** Shows what is constant in the lesson that was just opened. */
  #show_lesson() {
    this.#lesson = /** @type {Lesson} */ (this.#door.lesson());
    this.#menu.show(this.#lesson);
    document.title = `${this.#lesson.title} · Snug`;
    by_id("canvas").setAttribute("aria-label", `Stage: ${this.#lesson.stageSays}`);
    set_text(by_id("figures-caption"), `Numbers at this ${this.#lesson.stepWord}`);
    for (const panel of this.#panels) panel.open?.(this.#lesson);
    make_anew(); // a lesson that is read anew may say the same of other elements
  }

  /** Shows the lesson anew, as it is in the program, where it was scrolled to. */
  #show_anew() {
    const read = by_id("read");
    const [top, page_top] = [read.scrollTop, scrollY];
    this.#show_lesson();
    this.act(() => {});
    read.scrollTop = top;
    scrollTo(0, page_top);
  }

  /** The formulas have been typeset anew. */
  formulas_changed() {
    if (!this.#opening) this.#show_anew();
  }

  /** Asks what is wrong with a lesson that is being written. */
  #check_draft(/** @type {string} */ id, /** @type {number} */ turn) {
    this.#preview?.check(id, () => turn === this.#opens).catch((failed) => console.warn(failed));
  }

  /** Reads a lesson's file for open_lesson: {opens, error, bytes}, the bytes those of its mesh. One that is being
   *  written opens in spite of its mistakes, as far as it can be drawn. Throws if a file does not arrive.
   *  Null if something else is opened meanwhile.
   *  @param {string} id @param {number} turn @returns {Promise<LessonFile | null>} */
  async #read(id, turn) {
    const slow = setTimeout(() => (this.#reveal(), veil.loading()), kFilesDelay);
    try {
      const toml = await this.#downloads.text(`lessons/${this.#is_of_course(id) ? "" : "cases/"}${id}.toml`);
      if (turn !== this.#opens) return null; // the program holds one lesson that it has read
      const { draws, error, mesh } = this.#door.read_lesson(toml, `${id}.toml`);
      this.#check_draft(id, turn);
      const opens = draws && (Boolean(this.#preview) || !error);
      return { opens, error, bytes: opens && mesh ? await this.#mesh(mesh) : "" };
    } finally {
      clearTimeout(slow);
    }
  }

  /** Files of lessons that are being written have changed: opens what could not be opened, and the lesson that stands
   *  here anew, at the same place. What cannot be drawn now leaves it as it was. names: the files'. */
  async files_changed(/** @type {string[]} */ names) {
    for (const name of names) this.#downloads.forget(`lessons/${name}`);
    if (this.#wanted) return this.open(this.#wanted.asked, this.#wanted.reveal);
    const id = this.#lesson?.id;
    if (this.#opening) return;
    if (!names.includes(`${id}.toml`)) return this.#check_draft(id ?? "", this.#opens); // its links
    if (!this.#preview?.has(`${id}.toml`))
      return this.#preview?.lesson_says({
        heading: `${id}.toml is gone.`,
        lines: [{ text: "The lesson is shown as it was.", warning: false }],
      });
    const turn = (this.#opens += 1);
    const read = await this.#read(id, turn);
    if (turn !== this.#opens || !read?.opens) return;
    if (this.#door.open_lesson(read.bytes, true)) return;
    this.#show_anew();
  }

  #offer_lessons(/** @type {string} */ id) {
    const links = lesson_links(this.#lessons, null, this.#go_to);
    veil.choose(
      this.#lessons.length === 0
        ? "There are no lessons here."
        : `There is no lesson “${id.slice(0, 60)}”. These are the lessons:`,
      links,
    );
  }

  /** Goes to the place that the address names, as far as possible. Returns whether nothing of it was cancelled.
   *  @param {string} address @param {string[]} problems @param {number} turn */
  async #restore(address, problems, turn) {
    const door = this.#door;
    const { step, mesh } = door.read_place(address);
    // If it cannot be loaded, the way says so.
    if (mesh) await this.#mesh(mesh).then((bytes) => door.lend_mesh(bytes), () => {});
    for (;;) {
      const { done, refused } = door.go_along();
      if (done) break;
      const why = refused || (await this.#finish());
      if (turn !== this.#opens) return false;
      if (why === kCancelled) return problems.push("Cancelled: the lesson has its own points."), false;
      if (why) problems.push(`Part of the address cannot be used: ${why}.`);
    }
    const { steps, cover } = this.#now();
    if (step !== null && step > steps) door.jump(steps);
    if (step && cover?.shown) door.command(cover.button.command); // a step is of the stage
    return true;
  }

  /** The conversation goes on where it stood: at an outcome that was not read to its end, or before the second try. */
  #resume(/** @type {KeptLesson} */ { told, tried }) {
    if (told) this.#door.command(`review:${told}`);
    if (told || !tried) return;
    if (!this.#now().asked) this.#door.command("measure"); // which asks for the predictions first
    if (tried.question !== this.#now().asked?.id) return;
    if (tried.handle === null) tried.choices.forEach((choice) => this.#door.pick_choice(choice));
    else this.#door.pick_name(tried.handle);
    this.#door.command("commit_answer");
  }

  // ---- what is shown ------------------------------------------------------------------------------------------

  #say_selected = when_changed((/** @type {string | null} */ name) =>
    set_text(by_id("selected-says"), name ? `${name}, selected` : ""),
  );

  /** What stands there, once a lesson is open. */
  #now() {
    return /** @type {View} */ (this.#door.view());
  }

  #show() {
    this.#view = this.#now();
    if (!this.#view) return;
    if (!this.#opening && this.#view.preparing) this.#working ??= this.#finish();
    this.#say_selected(this.#view.selectedName);
    set_text(by_id("caption"), this.#view.caption);
    if (this.#stage?.pressed) {
      this.#panels_timer ||= setTimeout(() => this.#show_panels(), kPanelsDelay);
      return; // the address follows on release, because the browser redraws its address bar for each new one
    }
    this.#show_panels();
    this.#address_timer ||= setTimeout(() => this.#write_address(), kAddressDelay);
  }

  #show_panels() {
    clearTimeout(this.#panels_timer);
    this.#panels_timer = 0;
    for (const panel of this.#panels) panel.update?.(this.#view);
    this.#show_figures(this.#view.figures);
  }

  #show_figures = when_changed((/** @type {ShownFigure[]} */ figures) => {
    by_id("figures").replaceChildren(
      ...figures.map(({ name, text }) =>
        element("tr", {}, element("th", { scope: "row" }, name), element("td", {}, text)),
      ),
    );
  });

  // ---- the address --------------------------------------------------------------------------------------------

  #address() {
    // The step of an exercise is where its decisions have led.
    const address = this.#demo?.address ?? this.#place();
    return this.#embed && !this.#demo ? with_pair(address, "embed=1") : address;
  }

  #write_address() {
    clearTimeout(this.#address_timer);
    this.#address_timer = 0;
    if (this.#opening) return;
    const address = this.#address();
    if (address !== here()) history.replaceState(null, "", address);
    this.written = address;
    if (this.#embed) by_id("whole").href = address.replace("&embed=1", "");
    if (!this.#embed || this.#view.exercise) this.#keep(address);
  }

  /** Keeps the student's place and answers, once the student has done something here. */
  #keep(/** @type {string} */ address) {
    if (this.#view.exercise) return this.#keep_exercise(this.#view.exercise);
    if (this.#demo || !this.#is_of_course(this.#lesson.id)) return; // a case of the gallery is not worked through
    const { outcomes, step, steps, tasksDone, asked, outcome, deciding, progress } = this.#view;
    if ((address === this.#erased_at && outcomes.length === 0) || address === this.#left_at) return;
    this.#erased_at = this.#left_at = null;
    const before = this.#kept.lesson(this.#lesson.id);
    if (!progress.begun && !before) return;
    const entry = {
      address, answers: this.#door.kept_answers(), answered: progress.answered, step, steps,
      done: progress.done,
      task: tasksDone,
      told: (outcome ?? deciding)?.question ?? null,
      tried: asked?.tried ? { question: asked.id, ...asked.tried } : null,
    };
    if (!this.#is_new(JSON.stringify(entry))) return;
    // Once done, a lesson stays done when it is looked at again.
    const done = Boolean(before?.done) || entry.done, task = Boolean(before?.task) || entry.task;
    this.#kept.keep_lesson(this.#lesson.id, { ...entry, done, task });
  }

  /** Whether something was done here since it was kept, and not only in another tab. */
  #is_new(/** @type {string} */ now) {
    const before = this.#known;
    this.#known = now;
    return now !== before;
  }

  #keep_exercise(/** @type {ShownExercise} */ { finished, practises, mark }) {
    if (practises) return;
    const attempt = this.#attempt();
    if (!attempt || attempt.decisions.length === 0 || !this.#is_new(made_in(attempt))) return;
    this.#kept.keep_exercise(attempt, finished, finished && !this.#counted, mark === null);
    this.#counted = finished;
  }

  /** The lesson stays open, and goes on as one that was opened by its own address. */
  leave_demo() {
    this.#demo = null;
    this.act(() => {});
  }

  /** Adds what stands here to a demo's file. */
  async #record() {
    if (this.#opening || this.#view.exercise) return;
    const { record } = await import("./demo_record.js");
    record(this.#door);
  }

  async #share() {
    this.#write_address();
    const { exercise } = this.#view;
    const whole = exercise !== null || this.#door.place(false).whole;
    const { framed, show_share } = await import("./share.js");
    show_share({
      title: this.#lesson.title,
      address: location.href,
      whole,
      code: () => this.#show_code(),
      pictures: exercise ? null : () => this.#pictures(),
      // Each reader of an exercise gets an instance of their own.
      embedded: new URL(framed(exercise ? exercise_link(exercise.exercise) : here()), location.href).href,
      is_exercise: exercise !== null,
    });
  }

  /** The address of what stands here, which is no demo's. */
  #place() {
    const { exercise } = this.#view;
    return exercise ? exercise_link(this.#lesson.id, terms_of(exercise)) : this.#door.place(false).address;
  }

  /** What stands here as a code to scan. */
  async #show_code() {
    if (this.#opening || !this.#view || this.#view.exercise) return;
    const { show_code } = await import("./qr.js");
    await show_code(this.#place(), this.#door.place(true).address, this.#door.trace() ?? "");
  }

  async #pictures() {
    const { show_pictures } = await import("./pictures.js");
    show_pictures(this.#door, this.#stage, this.#lesson, this.#settings, this.#place());
  }

  /** Whether a phone shows what the screen does that its address was scanned from. */
  async #compare(/** @type {string} */ mark) {
    const { compare } = await import("./qr.js");
    await compare(mark, this.#door.trace() ?? "");
  }

  // ---- for scripts and tests ----------------------------------------------------------------------------------

  /** @returns {PageState | null} */
  state() {
    const view = this.#door.view();
    if (!view) return null;
    const asked = view.asked && { ...view.asked, targets: this.#door.targets() };
    const says = this.#preview?.says ?? [];
    const mistakes = says.flatMap(({ heading, lines }) => [heading, ...lines.map(({ text }) => text)]);
    return structuredClone({ ...view, asked, trace: this.#door.trace(), mistakes }); // the script's own
  }

  /** Null while a lesson is open.
   *  @returns {ExerciseState | null} */
  exercise() {
    const view = this.#door.view();
    if (!view?.exercise) return null;
    const { exercise, seed, decision, decisions, mark, of, hints, told, build } = view.exercise;
    return {
      exercise,
      seed,
      decision,
      decisions,
      prompt: view.asked?.prompt ?? build?.prompt ?? null,
      targets: view.asked ? this.#door.targets() : (build?.targets ?? []),
      choices: view.asked?.choices ?? [],
      mark,
      of,
      hints: hints.length,
      told,
    };
  }

  /** The text of the result file: of the attempt that is open, or else of the best ones. */
  result() {
    const open = this.#attempt();
    return result_text(this.#kept.student, open ? [open] : this.#kept.attempts, this.#version);
  }

  forget_answers() {
    this.#door.erase_answers();
  }

  /** Opens a lesson of which the text is given, at its result. Nothing of it is kept.
   *  @param {string} toml @returns {Refusal} */
  open_text(toml) {
    const { error } = this.#door.read_lesson(toml, "case.toml");
    const refused = error || this.#door.open_lesson("", true);
    if (!refused) this.#show_lesson();
    this.act(() => this.#door.go(kEnd));
    return refused;
  }

  handles() {
    return this.#door.handles().map(({ id, ...at }) => ({ id, ...this.#stage.on_page(at) }));
  }

  frame_times() {
    return this.#stage.times;
  }
}

/** Shows the course or, if the address names a lesson, the page with the program. */
class Site {
  #downloads = new Downloads((share) => veil.progress(share));
  #settings = new Settings();
  #kept = new Kept();
  #saving = new Saving(this.#kept, () => this.#save_file());
  /** @type {Course} */
  #course;
  #gallery = /** @type {Gallery | null} */ (null);
  #preview = /** @type {Preview | null} */ (null);
  #typeset = /** @type {Record<string, string>} */ ({}); // the formulas
  #page = /** @type {Page | null} */ (null);
  #written = /** @type {{ state(): ExerciseState, keep_now(): void } | null} */ (null); // the function that is open
  #around = /** @type {Promise<void> | null} */ (null); // what the page around this frame has of an exercise
  #demo = /** @type {Demo | null} */ (null); // that is played
  #shown = ""; // the address that is shown
  #scrolled = 0; // how far the course was scrolled
  #warm = false; // whether the program was asked for ahead of the first lesson

  constructor() {
    name_layout();
    addEventListener("resize", name_layout);
    this.#settings.on_erase(() => this.#erase());
    addEventListener("popstate", () => {
      const stands = document.documentElement.dataset.view === "lesson" && here() === this.#page?.written;
      // The link to the stage, #canvas, changes nothing.
      if (here() !== this.#shown && !stands) this.show({ back: true });
    });
    by_id("home").addEventListener("click", followed_here(() => this.go_to("")));
    const keep = () => (this.#page?.keep_now(), this.#written?.keep_now());
    addEventListener("pagehide", () => (keep(), this.#saving.link?.finish()));
    addEventListener("storage", () => (this.#kept.refresh(), this.#page?.follow_attempt()));
    document.addEventListener("visibilitychange", () => document.hidden && (keep(), this.#saving.link?.flush()));
  }

  /** Shows what the address asks for. */
  async show({ back = false, attempt = 0 } = {}) {
    this.#shown = here();
    this.#demo?.end();
    this.#demo = null;
    const asked = read_address(here());
    document.documentElement.classList.toggle("embed", asked.embed);
    const written = asked.exercise?.startsWith("write:") ? asked.exercise : null;
    const at_lesson = !written && (asked.lesson !== null || asked.exercise !== null || asked.demo !== null);
    if (asked.embed && asked.exercise !== null && parent !== window) this.#around ??= this.#ask_around(asked.exercise);
    try {
      if (asked.demo !== null && asked.notes) {
        const { show_notes } = await import("./demo_notes.js");
        return await show_notes(asked.demo, this.#downloads);
      }
      // The program arrives beside the course and the lesson.
      const door = at_lesson && !this.#page ? open_door(this.#downloads, attempt) : null;
      door?.catch(() => {});
      this.#course ??= await this.#bring_course();
      if (written) {
        await this.#around;
        return await this.#show_written(written);
      }
      if (!at_lesson) return this.#show_course(back);
      if (door) this.#bring_ahead(asked.lesson ?? "");
      if (!this.#page) document.documentElement.dataset.view = "lesson"; // its veil shows the program's progress
      if (door) this.#page ??= await this.#bring_page(asked.embed, door);
      const mixed = door && !(await this.#downloads.of_one_build());
      if (mixed || history.state?.loaded_anew) await (await import("./updated.js")).load_anew(Boolean(mixed));
      if (asked.demo !== null && this.#page && here() === this.#shown) {
        const { bring_demo } = await import("./demo.js");
        this.#demo = await bring_demo(asked.demo, this.#page, this.#settings, this.#downloads);
        await this.#demo?.begin(asked.state ?? 1);
        return dispatchEvent(new Event("snug-ready"));
      }
    } catch (error) {
      console.warn(error);
      document.documentElement.dataset.view = "lesson";
      return veil.failed(`Part of Snug ${kNotLoaded}`, () => this.show({ attempt: attempt + 1 }));
    }
    await this.#around;
    if (here() !== this.#shown) return;
    await this.#page?.open(asked, () => (document.documentElement.dataset.view = "lesson"));
    dispatchEvent(new Event("snug-ready"));
  }

  /** An exercise in which a function is written. */
  async #show_written(/** @type {string} */ id) {
    this.#page?.rest();
    this.#settings.present(false);
    clear_notices();
    const { show_write } = await import("./write.js");
    const title_of = (/** @type {string} */ lesson) => this.#course.lessons.find((own) => own.id === lesson)?.title;
    const { version } = this.#course;
    const shown = () => here() === this.#shown, go = (/** @type {string} */ lesson) => this.#go_into(lesson);
    const around = { downloads: this.#downloads, kept: this.#kept, saving: this.#saving, version, title_of, shown, go };
    this.#written = (await show_write(id, around)) ?? null;
    dispatchEvent(new Event("snug-ready"));
  }

  /** The page around a frame may keep what is done in it. */
  async #ask_around(/** @type {string} */ id) {
    const splice = await import("./splice.js").catch(() => null);
    await splice?.join(id, this.#kept, this.#saving);
  }

  go_to(/** @type {string} */ search) {
    this.#page?.leave();
    if (document.documentElement.dataset.view === "course") this.#scrolled = scrollY;
    history.pushState(null, "", search || location.pathname);
    scrollTo(0, 0);
    return this.show();
  }

  /** What was pressed may be gone with what stood before: then the stage has the keys. */
  /** @param {string} id @param {Terms} [terms] */
  async #go_into(id, terms) {
    this.#page?.leave();
    const framed = document.documentElement.classList.contains("embed") ? "&embed=1" : "";
    await this.go_to(this.#course.is_exercise(id) ? exercise_link(id, terms) + framed : way_into(id, this.#kept));
    if (document.activeElement === document.body) by_id("canvas").focus({ preventScroll: true });
  }

  async #bring_course() {
    /** @type {CourseFile} */
    const made = JSON.parse(await this.#downloads.text("course.json"));
    // The stage of a case is the page in a frame of its own: one session with the course is enough.
    const packaged = made.package && !window.frameElement?.matches(".write-stage") && (await import("./packaged.js"));
    const ids = (made.exercises ?? []).map(({ id }) => id), save_file = () => this.#save_file();
    if (made.package && packaged) packaged.join(made.package, ids, this.#kept, this.#saving, save_file);
    const course = new Course(made, this.#kept, (id) => this.#go_into(id));
    if (made.preview) await this.#follow(made.preview);
    else if (!made.package || made.package.kind === "course")
      this.#gallery = new Gallery(this.#downloads, (id) => this.#go_into(id));
    this.#settings.on_change(() => course.show_theme(["dark", "contrast"].includes(this.#settings.theme)));
    return course;
  }

  /** Where the lessons are being written, the page follows their files. */
  async #follow(/** @type {PreviewOf} */ of) {
    const { Preview } = await import("./preview.js");
    this.#preview = new Preview(of);
    this.#preview.follow((names) => this.#files_changed(names));
  }

  async #files_changed(/** @type {string[]} */ names) {
    for (const path of ["course.json", "formulas.json"]) this.#downloads.forget(path);
    /** @type {CourseFile} */
    const made = JSON.parse(await this.#downloads.text("course.json"));
    this.#course.replace(made);
    if (made.preview) this.#preview?.course_says(made.preview);
    if (document.documentElement.dataset.view === "course") this.#course.show();
    await this.#page?.files_changed(names);
    if (this.#page) await this.#typeset_anew();
  }

  async #typeset_anew() {
    const formulas = await this.#formulas();
    const more = Object.keys(formulas).some((tex) => !Object.hasOwn(this.#typeset, tex));
    Object.assign(this.#typeset, formulas);
    if (more) this.#page?.formulas_changed();
  }

  /** The typeset formulas; without them, formulas are shown on one line.
   *  @returns {Promise<Record<string, string>>} */
  async #formulas() {
    return JSON.parse(await this.#downloads.text("formulas.json").catch(() => "{}"));
  }

  /** Asks for a lesson's file and mesh, which open reads later, while the program still arrives. */
  #bring_ahead(/** @type {string} */ id) {
    if (!this.#course.lessons.some((lesson) => lesson.id === id)) return;
    const mesh_of = (/** @type {string} */ toml) => /^mesh = "([a-z]+)"/m.exec(toml)?.[1];
    const mesh = this.#downloads.text(`lessons/${id}.toml`).then(mesh_of);
    mesh.then((name) => (name ? this.#downloads.bytes(`meshes/${name}.ply`) : null)).catch(() => {});
  }

  /** opened: what open_door promises.
   *  @param {boolean} embed @param {Promise<Door>} opened */
  async #bring_page(embed, opened) {
    veil.loading();
    const [door, formulas] = await Promise.all([opened, this.#formulas()]);
    Object.assign(this.#typeset, formulas);
    return new Page({
      door,
      downloads: this.#downloads,
      course: this.#course,
      gallery: this.#gallery,
      formulas: this.#typeset,
      settings: this.#settings,
      kept: this.#kept,
      saving: this.#saving,
      embed,
      preview: this.#preview,
      go_to: (id, terms) => this.#go_into(id, terms),
    });
  }

  #show_course(/** @type {boolean} */ back) {
    this.#page?.rest();
    this.#settings.present(false);
    clear_notices();
    document.documentElement.dataset.view = "course";
    document.title = "Snug: bounding volumes, by hand and eye";
    veil.lift();
    this.#course.show();
    this.#course.show_theme(["dark", "contrast"].includes(this.#settings.theme));
    scrollTo(0, back ? this.#scrolled : 0);
    dispatchEvent(new Event("snug-ready"));
    if (!this.#warm && !this.#page) warm_up();
    this.#warm = true;
  }

  #erase() {
    this.#kept.erase();
    this.#page?.erase();
    if (document.documentElement.dataset.view === "course") this.#course.show();
  }

  // ---- for scripts and tests ----------------------------------------------------------------------------------

  state() {
    if (document.documentElement.dataset.view === "lesson") return this.#page?.state() ?? null;
    return this.#course ? { lesson: null, course: this.#course.state() } : null;
  }

  exercise() {
    const { view } = document.documentElement.dataset;
    return (view === "lesson" ? this.#page?.exercise() : view === "write" ? this.#written?.state() : null) ?? null;
  }

  result() {
    if (this.#page) return this.#page.result();
    return result_text(this.#kept.student, this.#kept.attempts, this.#course?.version ?? "");
  }

  open_text(/** @type {string} */ toml) {
    return this.#page ? this.#page.open_text(toml) : "no lesson is open";
  }

  /** Where what is done is kept. */
  saved() {
    return this.#saving.state;
  }

  #save_file() {
    if (this.#page) this.#page.hand_in();
    else save_file(this.result(), "snug-result.json");
  }

  /** Opens what an address asks for as if nothing had been answered, without loading the page again. */
  restart(/** @type {string} */ search) {
    this.#kept.erase();
    this.#page?.forget_answers();
    history.pushState(null, "", search || location.pathname);
    return this.show();
  }

  handles() {
    return document.documentElement.dataset.view === "lesson" && this.#page ? this.#page.handles() : [];
  }

  frame_times() {
    return this.#page?.frame_times() ?? [];
  }
}

const site = new Site();
Object.assign(window.snug, {
  state: () => site.state(),
  exercise: () => site.exercise(),
  result: () => site.result(),
  saved: () => site.saved(),
  restart: (/** @type {string} */ search) => site.restart(search),
  open_text: (/** @type {string} */ toml) => site.open_text(toml),
  handles: () => site.handles(),
  frameTimes: () => site.frame_times(),
});
site.show();
