// Names for what the page's modules hand to each other, for tsc: no browser loads this, and the site is built without it.

interface Window {
  /** For scripts and tests; web/README.md says what each does. boot.js begins it, main.js fills it in. */
  snug: {
    ready: Promise<unknown>;
    state(): any; // PageState, in a lesson
    handles(): Handle[];
    frameTimes(): FrameTime[];
    restart(search: string): Promise<unknown>;
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
  undo: HTMLButtonElement;
  whole: HTMLAnchorElement;
}

/** A lesson's file and its mesh, as main.js has read them: whether it opens, and its first mistake, "" for none. */
type LessonFile = { toml: string; opens: boolean; error: string; bytes: Bytes };

/** What window.snug.state() tells in a lesson. */
type PageState = Omit<View, "asked"> & {
  asked: (Asked & { targets: string[] }) | null;
  trace: string | null;
  mistakes: string[];
};

type Point = { x: number; y: number };
type FrameTime = { at: number; cost: number };
/** Does what the user asks for, then shows the result. */
type Act = (what: () => void) => void;
/** To another lesson, by its id. */
type GoTo = (id: string) => void;

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
type PreviewOf = { files: Record<string, string>; mistake: string | null; ideas: string[] };
type CourseFile = { playground?: string; chapters: ChapterOf<LessonEntry>[]; preview?: PreviewOf };
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
type KeptData = { version: number; last: string | null; invited: number; lessons: Record<string, KeptLesson> };
