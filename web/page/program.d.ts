// What the program gives the page, for tsc: no browser loads this, and the site is built without it. The tests compare it
// with the objects themselves (tests/browser/state.test.mjs) and with web/main.cpp's list of functions.

// ---- web/view.cpp, view_object: what changes -----------------------------------------------------------------

interface View extends Answers {
  lesson: string;
  step: number;
  steps: number;
  caption: string;
  section: number | null;
  lit: { mark: string; handles: string[]; words: string[] };
  invitation: ({ words: string } & Rectangle) | null;
  closeUp: ({ at: number[]; size: number; times: number } & Rectangle) | null;
  invited: number;
  playing: boolean;
  speed: number;
  previewing: boolean;
  exercise: ShownExercise | null;
  preparing: Preparing | null;
  framesDrawn: number;
  cover: Cover | null;
  algorithm: string;
  beside: string | null;
  codeTitle: string;
  code: string[];
  line: number;
  rivals: { name: string; title: string; size: number | null; excess: number | null }[];
  readout: Record<string, number>;
  figures: ShownFigure[];
  panels: Panel[];
  proseFigures: Record<string, ProseFigure>;
  numbers: NumberGroup[];
  toolsWord: string;
  toolsTitle: string;
  size: number;
  dim: number;
  edited: boolean;
  source: string;
  seed: number;
  scalar: Scalar | null;
  canUndo: boolean;
  canRedo: boolean;
  selected: number | null;
  selectedName: string | null;
  coordinates: number[] | null;
  situation: string | null;
  sliders: ShownSlider[];
  stored: StoredVolume[];
  file: { own: string; runs: string; typed: string; heading: string; mistakes: string[] } | null;
  effects: Effect[];
}

type Scalar = "float" | "double";
/** Says what is being computed, and how much of it is done: 0 to 1. */
type Preparing = { says: string; share: number };
type Rectangle = { x: number; y: number; width: number; height: number };
type ShownFigure = { key: string; name: string; text: string };
type Panel = { title: string; head: string[]; rows: string[][]; says: string; button: CoverButton | null };
type ShownSlider = { number: number; title: string; value: number; text: string; place: number; places: number };
type StoredMember = { declared: string; text: string; mark: string };
type StoredForm = {
  name: string;
  bytes: string;
  members: StoredMember[];
  operations: { name: string; says: string; least: boolean }[];
};
type StoredVolume = { title: string; forms: StoredForm[] };
type Effect = {
  effect: string;
  on: boolean;
  constructed: number;
  run: number;
  skipped: number;
  microseconds: string;
  called: boolean;
  says: string;
};

// ---- web/numbers.cpp -----------------------------------------------------------------------------------------

type NumberRow = { words: string; unit: string; turn: number; names: string[]; values: number[] };
type NumberGroup = { heading: string; name: string; rows: NumberRow[] };

// ---- web/answers.cpp, set_answers ----------------------------------------------------------------------------

interface Answers {
  asked: Asked | null;
  questions: number;
  outcome: Told | null;
  deciding: Told | null;
  predictions: Prediction[];
  tally: { right: number; second: number; wrong: number; skipped: number; open: number };
  summary: boolean;
  waiting: string[];
  canPractise: boolean;
  situationsWaiting: string[];
  outcomes: Outcome[];
  score: string;
  grade: Grade | null;
  tasks: (Grade & { was: boolean; kept: boolean })[];
  task: number;
  tasksDone: boolean;
  progress: { begun: boolean; answered: number; done: boolean };
}

type Answer = { choices: number[]; handle: string | null };
type Kind = "right" | "wrong" | "skipped" | "open";
type Prediction = { id: string; prompt: string; short: string; kind: Kind; standing: string };
type Grade = { done: boolean; points: number; excess: number; says: string };

interface Asked {
  id: string;
  prompt: string;
  promptWords: Stretch[];
  step: number;
  choices: string[];
  many: boolean;
  ordered: boolean;
  field: "Name" | "Names" | "Number" | "";
  onStage: boolean;
  place: string;
  how: string;
  picked: Answer | null;
  tried: Answer | null;
  ready: boolean;
  says: string;
}

interface Outcome {
  kind: Kind;
  tries: number;
  question: string;
  on: number;
  fromStep: number;
  step: number;
  right: boolean;
  skipped: boolean;
  passed: boolean;
  pending: boolean;
  verdict: string;
  predicted: string;
  happened: string;
  says: string;
  because: string;
  becauseWords: Stretch[];
}

/** told_object */
interface Told extends Outcome {
  prompt: string;
  promptWords: Stretch[];
  place: string;
  choices: string[];
  ordered: boolean;
  given: Answer | null;
  canWatch: boolean;
  canShow: boolean;
  shown: boolean;
  rightChoices: number[];
}

// ---- web/exercise.cpp ----------------------------------------------------------------------------------------

type ExerciseRow = { id: string; short: string; kind: Kind; hints: number; mark: number };

/** What is built, and how far it is. targets: what may be moved. */
interface Build {
  heading: string;
  prompt: string;
  promptWords: Stretch[];
  claim: string;
  levels: { words: string; now: boolean; best: boolean }[];
  isNow: string;
  targets: string[];
  adds: boolean;
  canGoBack: boolean;
  canFinish: boolean;
}

/** exercise_object. mark: null until it is told, and where it is practice. */
interface ShownExercise {
  exercise: string;
  kind: "carry_out" | "number" | "order" | "build" | "break_it";
  lesson: string;
  seed: number;
  level: number;
  practises: boolean;
  leadsOn: boolean;
  build: Build | null;
  decision: number;
  decisions: number;
  mark: number | null;
  of: number;
  told: boolean;
  tellsAtOnce: boolean;
  countKnown: boolean;
  finished: boolean;
  hints: string[];
  hint: string;
  rule: string;
  followed: string[];
  run: "" | "own" | "right"; // at the end, the one that is looked at
  compared: string;
  firstDifference: string;
  canTakeBack: boolean;
  rows: ExerciseRow[];
}

/** attempt_object: as a result file has it. */
interface Attempt {
  exercise: string;
  hash: string;
  seed: number;
  level?: number;
  decisions: string[];
  hints: number;
  mark: number;
  of: number;
  seconds: number;
}

// ---- web/cover.cpp -------------------------------------------------------------------------------------------

type CoverButton = { command: string; words: string; chosen: boolean; enabled: boolean };
type CoverFormat = "csv" | "json" | "svg" | "png";

interface CoverTableNow {
  head: string[];
  rows: string[][];
  title: string;
  sorts: string[];
  sorted: number;
  picks: string[];
  picked: number;
  best: boolean[][];
}

interface Cover {
  choices: CoverButton[];
  work: CoverButton[];
  button: CoverButton;
  shown: boolean;
  running: boolean;
  progress: number;
  decided: boolean;
  says: string;
  table: CoverTableNow;
  formats: CoverFormat[];
  any: boolean;
}

// ---- web/prose.cpp -------------------------------------------------------------------------------------------

type Link = { kind: "lesson" | "mesh" | "algorithm" | "step" | "mark" | "situation"; target: string };
type ProseFigure = { text: string; says: string; known: boolean };

interface Stretch {
  text: string;
  strong?: true;
  emphasis?: true;
  code?: true;
  script?: "sub" | "sup";
  tex?: string;
  link?: Link;
  figure?: string;
  sentence?: number;
}

/** Of a paragraph or a list each row has one cell. */
type Block = { kind: "paragraph" | "bullets" | "numbers" | "table"; rows: Stretch[][][]; right: boolean[] };

// ---- web/lesson_object.cpp: what stays while a lesson is open ------------------------------------------------

/** set_points */
type PointSet = { generate: string; count: number; mesh: string; scalar: Scalar };
type LessonAlgorithm = { name: string; title: string; source: string; maxPoints: number };
type Situation = { name: string; title: string } & PointSet;

interface Lesson extends PointSet {
  id: string;
  minutes: number;
  title: string;
  summary: string;
  sections: { title: string; situation: string; blocks: Block[] }[];
  algorithms: LessonAlgorithm[];
  stepWord: "step" | "frame";
  measures: boolean;
  tools: { word: string; title: string; points: boolean };
  stageSays: string;
  handleWords: string[];
  situations: Situation[];
  dim: number;
  seed: number;
  meshes: string[];
  generators: string[];
  compare: string;
  tasks: { heading: string; prompt: Stretch[]; hint: Stretch[]; algorithm: string; points: number; start: string }[];
}

/** words_object */
type SharedWords = Record<
  | "answer" | "skip" | "prediction" | "decision" | "watch" | "again" | "practise" | "task" | "hint" | "go_on" | "show"
  | "summary"
  | "go_on_with" | "waiting" | "to_task" | "next_lesson" | "close" | "watching" | "hand_in" | "another" | "to_lesson"
  | "take_back" | "your_mark" | "finish" | "start_again" | "back_to_best" | "back_to_solution" | "show_model" | "harder"
  | "without_mark" | "for_mark" | "right_run" | "your_run" | "both_runs" | "next_decision",
  string
>;

// ---- web/main.cpp: what it binds, in its order; web/deeds.hpp and web/canvas.hpp say what each does ----------

/** A sentence that says why something could not be done; "" if it was done. */
type Refusal = string;
type Bytes = string | Uint8Array;

interface Door {
  give_font(name: string, bytes: Bytes): void;
  start(selector: string, smooth: boolean, processor: string): Refusal;
  start_graphics(): Refusal;
  stop_graphics(): void;
  set_layout(layout: StageLayout): void;
  set_settings(settings: StageSettings): void;
  frame(now: number): void;
  seconds_until_due(now: number): number;
  menu_open(): boolean;
  figures_height(): number;
  figures_fill(): boolean;
  pointer_moved(x: number, y: number, source: string): void;
  pointer_left(): void;
  forget_input(): void;
  pointer_button(button: number, down: boolean, source: string): void;
  wheel_turned(x: number, y: number): void;
  pinch(factor: number, x: number, y: number, dx: number, dy: number): void;
  modifiers_held(shift: boolean, control: boolean, alt: boolean): void;
  cursor(): string;
  read_lesson(toml: string, name: string): LessonRead;
  open_lesson(mesh: Bytes, anew: boolean): Refusal;
  lesson(): Lesson | null;
  view(): View | null;
  handles(): Handle[];
  place_named(name: string): Point | null;
  command(name: string): boolean;
  command_of_key(key: string, shift: boolean, control: boolean): string;
  key_rows(): string[][];
  pick_choice(choice: number): void;
  pick_name(name: string): boolean;
  targets(): string[];
  trace(): string | null;
  words(): SharedWords;
  go(step: number): void;
  jump(step: number): void;
  kept_answers(): string;
  keep_answers(lesson: string, kept: string): void;
  erase_answers(): void;
  choose(slot: number, name: string): Refusal;
  select_point(point: number): void;
  move_point(point: number, x: number, y: number, z: number): Refusal;
  set_numbers(group: number, row: number, values: number[]): Refusal;
  set_file(text: string): Refusal;
  end_typing(): void;
  place(bare: boolean): { address: string; whole: boolean };
  demo_state(): string;
  read_place(address: string): { mistakes: string[]; bare: boolean; step: number | null; mesh: string };
  lend_mesh(bytes: Bytes): Refusal;
  go_along(): { done: boolean; refused: Refusal };
  show_situation(name: string): Refusal;
  hold_slider(held: boolean): Refusal;
  slide(slider: number, place: number): Refusal;
  scatter(seed: number): void;
  preparing(): Preparing | null;
  go_on(milliseconds: number): Refusal;
  give_up(): void;
  set_generator(kind: string, count: number, seed: number): Refusal;
  set_float(in_float: boolean): Refusal;
  read_exercise(toml: string, name: string): Refusal;
  open_exercise(seed: number, level: number, practises: boolean): Refusal;
  take_up_attempt(decisions: string[]): Refusal;
  attempt(): Attempt | null;
  seed_of_name(name: string): number;
  light(mark: string): void;
  invite(followed: number): void;
  start_task(task: number): void;
  solve_again(task: number): Refusal;
  load_file(bytes: Bytes, name: string): Refusal;
  measure(milliseconds: number): void;
  measuring(): boolean;
  measured(): number;
  cover_file(format: CoverFormat, address: string): { name: string; text: string };
  draw_cover(width: number, height: number, scale: number): boolean;
  draw_picture(width: number, height: number, scale: number): boolean;
  picture_svg(width: number, height: number, address: string): string;
  playground_says(): string;
  carry_points(): void;
  put_down_points(name: string): Refusal;
}

// ---- web/lecture/main.cpp ------------------------------------------------------------------------------------

interface Lecture {
  vote_key(state: number, key: string, choices: string[], places: string[]): boolean;
  vote_of(state: number): Vote | null;
  qr_code(text: string): QrCode | null;
  fingerprint(trace: string): string;
}
type VoteRow = { name: string; words: string; text: string; percents: number[] };
type Vote = { hidden: string; told: string; rows: VoteRow[] };
type QrCode = { size: number; quiet: number; dark: string };

type Handle = { id: string; x: number; y: number };
type LessonRead = { draws: boolean; mesh: string; error: string };
type StageSettings = {
  theme: string;
  textScale: number;
  leastWords: number;
  reducedMotion: boolean;
  labels: boolean;
  grounded: boolean;
  ground: number[];
};
type StageLayout = {
  width: number;
  height: number;
  scale: number;
  fingers: boolean;
  tools: number;
  foot: number;
  stage: Rectangle;
  timeline: Rectangle;
  inspector: Rectangle;
};
