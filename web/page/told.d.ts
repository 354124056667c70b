// What the program tells the page, made from app/told by tests/app/told/types.test.cpp, which says how to make it
// anew. No browser loads this, and the site is built without it.

interface Lit {
  mark: string;
  handles: string[];
  words: string[];
}

interface Rectangle {
  x: number;
  y: number;
  width: number;
  height: number;
}

interface Invitation extends Rectangle {
  words: string;
}

interface CloseUp extends Rectangle {
  at: number[];
  size: number;
  times: number;
}

interface Preparing {
  says: string;
  share: number;
}

interface Player {
  lesson: string;
  step: number;
  steps: number;
  furthest: number | null;
  caption: string;
  section: number | null;
  lit: Lit;
  invitation: Invitation | null;
  closeUp: CloseUp | null;
  invited: number;
  playing: boolean;
  speed: number;
  previewing: boolean;
  preparing: Preparing | null;
}

interface Frames {
  framesDrawn: number;
}

interface Rival {
  name: string;
  title: string;
  size: number | null;
  excess: number | null;
}

interface Algorithms {
  algorithm: string;
  beside: string | null;
  codeTitle: string;
  code: string[];
  line: number;
  rivals: Rival[];
}

interface Link {
  kind: "lesson" | "mesh" | "algorithm" | "step" | "mark" | "situation";
  target: string;
}

interface Stretch {
  text: string;
  strong?: boolean;
  emphasis?: boolean;
  code?: boolean;
  script?: "sub" | "sup";
  tex?: string;
  link?: Link;
  figure?: string;
  sentence?: number;
}

interface Answer {
  choices: number[];
  handle: string | null;
}

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
  kind: "right" | "wrong" | "skipped" | "open";
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

interface Conversation {
  asked: Asked | null;
  outcome: Told | null;
  deciding: Told | null;
  summary: boolean;
}

interface Prediction {
  id: string;
  prompt: string;
  short: string;
  kind: "right" | "wrong" | "skipped" | "open";
  standing: string;
}

interface Tally {
  right: number;
  second: number;
  wrong: number;
  skipped: number;
  open: number;
}

interface Progress {
  begun: boolean;
  answered: number;
  done: boolean;
}

interface Log {
  questions: number;
  predictions: Prediction[];
  tally: Tally;
  waiting: string[];
  canPractise: boolean;
  situationsWaiting: string[];
  outcomes: Outcome[];
  score: string;
  progress: Progress;
}

interface Grade {
  done: boolean;
  points: number;
  excess: number;
  says: string;
}

interface TaskGrade extends Grade {
  was: boolean;
  kept: boolean;
}

interface Tasks {
  grade: Grade | null;
  tasks: TaskGrade[];
  task: number;
  tasksDone: boolean;
}

interface Level {
  words: string;
  now: boolean;
  best: boolean;
}

interface Build {
  heading: string;
  prompt: string;
  promptWords: Stretch[];
  claim: string;
  levels: Level[];
  isNow: string;
  targets: string[];
  adds: boolean;
  canGoBack: boolean;
  canFinish: boolean;
}

interface ExerciseRow {
  id: string;
  short: string;
  kind: "right" | "wrong" | "skipped" | "open";
  hints: number;
  mark: number;
}

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
  run: "" | "own" | "right";
  compared: string;
  firstDifference: string;
  canTakeBack: boolean;
  rows: ExerciseRow[];
}

interface Exercise {
  exercise: ShownExercise | null;
}

interface ShownFigure {
  key: string;
  name: string;
  text: string;
}

interface ProseFigure {
  text: string;
  says: string;
  known: boolean;
}

interface Figures {
  readout: Record<string, number>;
  figures: ShownFigure[];
  proseFigures: Record<string, ProseFigure>;
}

interface CoverButton {
  command: string;
  words: string;
  chosen: boolean;
  enabled: boolean;
}

interface Panel {
  title: string;
  head: string[];
  rows: string[][];
  says: string;
  button: CoverButton | null;
}

interface Panels {
  panels: Panel[];
}

interface NumberRow {
  words: string;
  unit: string;
  turn: number;
  names: string[];
  values: number[];
}

interface NumberGroup {
  heading: string;
  name: string;
  rows: NumberRow[];
}

interface Points {
  numbers: NumberGroup[];
  toolsWord: string;
  toolsTitle: string;
  size: number;
  dim: number;
  edited: boolean;
  source: string;
  seed: number;
  scalar: "float" | "double" | null;
  canUndo: boolean;
  canRedo: boolean;
  selected: number | null;
  selectedName: string | null;
  coordinates: number[] | null;
}

interface ShownSlider {
  number: number;
  title: string;
  value: number;
  text: string;
  place: number;
  places: number;
}

interface StoredMember {
  declared: string;
  text: string;
  mark: string;
}

interface StoredOperation {
  name: string;
  says: string;
  least: boolean;
}

interface StoredForm {
  name: string;
  bytes: string;
  members: StoredMember[];
  operations: StoredOperation[];
}

interface StoredVolume {
  title: string;
  forms: StoredForm[];
}

interface StageFile {
  own: string;
  runs: string;
  typed: string;
  heading: string;
  mistakes: string[];
}

interface Effect {
  effect: string;
  on: boolean;
  constructed: number;
  run: number;
  skipped: number;
  microseconds: string;
  called: boolean;
  says: string;
}

interface Parts {
  situation: string | null;
  sliders: ShownSlider[];
  stored: StoredVolume[];
  file: StageFile | null;
  effects: Effect[];
}

interface WordTable {
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
  table: WordTable;
  formats: ("csv" | "json" | "svg" | "png")[];
  any: boolean;
}

interface Covers {
  cover: Cover | null;
}

/** What changes while a lesson is open. */
interface View extends
  Player, Frames, Algorithms, Conversation, Log, Tasks, Exercise, Figures, Panels, Points, Parts, Covers {}

interface PointSet {
  generate: string;
  count: number;
  mesh: string;
  scalar: "float" | "double";
}

interface Block {
  kind: "paragraph" | "bullets" | "numbers" | "table";
  rows: Stretch[][][];
  right: boolean[];
}

interface Section {
  title: string;
  situation: string;
  blocks: Block[];
}

interface LessonAlgorithm {
  name: string;
  title: string;
  source: string;
  maxPoints: number;
}

interface Tools {
  word: string;
  title: string;
  points: boolean;
}

interface Situation extends PointSet {
  name: string;
  title: string;
}

interface LessonTask {
  heading: string;
  prompt: Stretch[];
  hint: Stretch[];
  algorithm: string;
  points: number;
  start: string;
}

interface Lesson extends PointSet {
  id: string;
  minutes: number;
  title: string;
  summary: string;
  sections: Section[];
  algorithms: LessonAlgorithm[];
  stepWord: "step" | "frame";
  measures: boolean;
  tools: Tools;
  stageSays: string;
  handleWords: string[];
  situations: Situation[];
  dim: number;
  seed: number;
  meshes: string[];
  generators: string[];
  compare: string;
  tasks: LessonTask[];
}

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

interface Handle {
  id: string;
  x: number;
  y: number;
}

interface Point {
  x: number;
  y: number;
}

interface LessonRead {
  draws: boolean;
  mesh: string;
  error: string;
}

interface PlaceNow {
  address: string;
  whole: boolean;
}

interface PlaceRead {
  mistakes: string[];
  bare: boolean;
  step: number | null;
  mesh: string;
}

interface WayGone {
  done: boolean;
  refused: string;
}

interface CoverFile {
  name: string;
  text: string;
}

type SharedWords = Record<
  | "answer"
  | "skip"
  | "prediction"
  | "decision"
  | "watch"
  | "again"
  | "practise"
  | "task"
  | "hint"
  | "go_on"
  | "show"
  | "summary"
  | "go_on_with"
  | "waiting"
  | "to_task"
  | "next_lesson"
  | "close"
  | "watching"
  | "hand_in"
  | "another"
  | "to_lesson"
  | "take_back"
  | "your_mark"
  | "finish"
  | "start_again"
  | "back_to_best"
  | "back_to_solution"
  | "show_model"
  | "model_stands"
  | "harder"
  | "without_mark"
  | "for_mark"
  | "right_run"
  | "your_run"
  | "both_runs"
  | "next_decision"
  , string>;
