// What the program gives the page, for tsc: no browser loads this, and the site is built without it. What it tells is in
// told.d.ts. The tests compare it with the objects themselves (tests/browser/state.test.mjs) and with web/main.cpp's list
// of functions.

type Scalar = PointSet["scalar"];
type CoverFormat = Cover["formats"][number];

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
  place(bare: boolean): PlaceNow;
  demo_state(): string;
  read_place(address: string): PlaceRead;
  lend_mesh(bytes: Bytes): Refusal;
  go_along(): WayGone;
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
  cover_file(format: CoverFormat, address: string): CoverFile;
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
