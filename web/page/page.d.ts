// Names for what the page's modules hand to each other, for tsc: no browser loads this, and the site is built without it.

interface Window {
  /** For scripts and tests; web/README.md says what each does. boot.js begins it, main.js fills it in. */
  snug: {
    ready: Promise<unknown>;
    state(): any; // PageState, in a lesson
    exercise(): ExerciseState | null;
    result(): string;
    saved(): SavedState;
    at(path: string): string;
    opens: string;
    handles(): Handle[];
    frameTimes(): FrameTime[];
    restart(search: string): Promise<unknown>;
    open_text(toml: string): Refusal;
  };
}

interface Navigator {
  connection?: { saveData: boolean }; // not in every browser
}

/** What the DOM writes as text. */
interface Element {
  setAttribute(name: string, value: number | boolean): void;
}

/** Those elements of index.html of which more is used than every element has, by their ids. */
interface PageElements {
  canvas: HTMLCanvasElement;
  gallery: HTMLDetailsElement;
  "next-lesson": HTMLButtonElement;
  "previous-lesson": HTMLButtonElement;
  redo: HTMLButtonElement;
  search: HTMLInputElement;
  student: HTMLInputElement;
  undo: HTMLButtonElement;
  whole: HTMLAnchorElement;
}

/** A lesson's file and its mesh, as main.js has read them: whether it opens, and its first mistake, "" for none. */
type LessonFile = { opens: boolean; error: string; bytes: Bytes };

/** What window.snug.state() tells in a lesson. */
type PageState = Omit<View, "asked"> & {
  asked: (Asked & { targets: string[] }) | null;
  trace: string | null;
  mistakes: string[];
};

/** Where what a student does is kept: on the device, handed to the course, given back by it, or nowhere. */
type SavedState = "device" | "course" | "seen" | "nowhere";

/** What else keeps what a student does (packaged.js, splice.js). */
interface SavingLink {
  readonly state: SavedState;
  readonly words: string;
  save(): void; // after each change
  flush(): void; // when the page is hidden
  finish(): void; // when it is left
}

/** What window.snug.exercise() tells. */
interface ExerciseState {
  exercise: string;
  seed: number;
  decision: number;
  decisions: number;
  prompt: string | null;
  targets: string[];
  choices: string[];
  mark: number | null;
  of: number;
  hints: number;
  told: boolean;
}

type FrameTime = { at: number; cost: number };
/** Does what the user asks for, then shows the result. */
type Act = (what: () => void) => Refusal | Promise<Refusal>;
/** How an exercise is taken: its instance's seed and level, and whether without a mark. */
type Terms = { seed?: number; level?: number; practice?: boolean };
/** To another lesson or exercise, by its id. */
type GoTo = (id: string, terms?: Terms) => void;

/** What a panel of the page may do when a lesson is opened, and when something has changed. */
interface PagePanel {
  open?(lesson: Lesson): void;
  update?(view: View): void;
}

// ---- course.json and cases.json, which web/describe_site.py and web/drafts.py make ---------------------------

interface LessonEntry {
  id: string;
  title: string;
  summary: string;
  minutes: number;
  questions: number;
  task: boolean;
  words: string;
  picture?: false;
}

type CaseEntry = { id: string; title: string; summary: string; source: string };
type ChapterOf<Entry> = { title: string; lessons: Entry[] };
type ExerciseEntry = { id: string; title: string; summary: string; minutes: number; lesson: string };
type ExerciseSet = { id: string; title: string; lecture: string; exercises: ExerciseEntry[] };
type PreviewOf = { files: Record<string, string>; mistake: string | null };
/** What is wrong with a lesson (web/check/main.cpp). */
type DraftSays = { heading: string; lines: { text: string; warning: boolean }[] };
interface CourseFile {
  playground?: string;
  chapters: ChapterOf<LessonEntry>[];
  preview?: PreviewOf;
  sets?: ExerciseSet[];
  exercises?: ExerciseEntry[];
  demos?: DemoEntry[];
  version?: string;
  package?: PackageOf;
}
/** write/ID.json: an exercise in which a function is written. */
interface WriteFile extends ExerciseEntry {
  contract: string;
  stub: string;
  model: string;
  reasons: string;
  methods: { title: string; code: string }[];
}
/** What a package is about, and what counts in it (`snug package`). */
interface PackageOf {
  name: string;
  kind: "lesson" | "exercise" | "set" | "course";
  id: string;
  title: string;
  lessons: string[];
  exercises: string[];
  scorm: boolean;
}
/** As course.js numbers them. */
type CourseLesson = LessonEntry & { number: number; chapter: string };

// ---- what is kept on the device (kept.js; web/README.md) -----------------------------------------------------

type Tried = Answer & { question: string };
interface KeptLesson {
  address: string;
  answers: string;
  answered: number;
  step: number;
  steps: number;
  done: boolean;
  task: boolean;
  told: string | null;
  tried: Tried | null;
}
/** How many attempts were finished, the best of them, and one that is not; the counter at its last change; and whether
 *  the mark of the one that is not finished is not told yet. */
type KeptExercise = { tries: number; best: Attempt | null; now: Attempt | null; at: number; hides?: boolean };
interface KeptData {
  version: number;
  count: number; // of changes
  last: string | null;
  invited: number;
  lessons: Record<string, KeptLesson>;
  exercises: Record<string, KeptExercise>;
  student: string;
}

// ---- demos/ID.json, which web/describe_site.py makes ---------------------------------------------------------

interface DemoState {
  address: string;
  shows: string[];
  reveal: string[];
  slide: string;
  notes: string;
  hash: string;
}
type DemoEntry = { id: string; title: string; states: number };
type DemoFile = { id: string; title: string; lecture: string; states: DemoState[] };

// ---- code that is written (write.js, and in web/write the editor, the engine and the judge) ------------------

/** web/write/engine.js. answers: a line for each case, numbers, or ! and why there are none. */
interface Ran {
  answers: string[];
  output: string;
  notes: Record<string, string>;
  error: { what: string; line: number } | null;
  turns: number;
  steps: number | null;
}
/** A method on the chart of accuracy against cost. right: the share of cases; steps: a case. */
type Costed = { title: string; kind: "yours" | "model" | "other"; right: number; steps: number };
type AboutFunction = { name: string; gives: string; of: number; hash: string };
type FoundCase = { kind: string; given: string; right: string; yours: string; lesson: string; words: string };
interface JudgedRun {
  kinds: { name: string; passed: number; of: number }[];
  mark: number;
  of: number;
  says: string;
  first: FoundCase | null;
}
/** web/write/judge.cpp */
interface Trial {
  open(id: string): boolean;
  about(): AboutFunction;
  cases(seed: number): string;
  judge(lines: string): JudgedRun;
  shorter(): string;
  narrow(lines: string): FoundCase | null;
}
/** web/write/editor.js */
interface CodeEditor {
  code(): string;
  noted(): string;
  set(text: string): void;
  mark(line: number, message: string): void;
  focus(): void;
}
type CreateEditor = (host: HTMLElement, code: string, of: {
  label: string;
  described: string;
  changed: (code: string) => void;
  run: () => void;
  left: (is_left: boolean) => void;
}) => CodeEditor;
