// The canvas: draws frames only when they are due, passes input on, and recovers from a lost context.
import { button, by_id } from "./dom.js";
import { arrange, watch_layout } from "./layout.js";
import { stage_message } from "./messages.js";

const kButtonsOfImgui = [0, 1, 2];
const kFramesTimed = 600;
const kPatience = 5000; // milliseconds until the page says that a lost context will not come back
// A first finger presses nothing until it moves, stays or lifts: the second of a pinch comes a little later.
const kFingerWaits = 120; // milliseconds
const kFingerTrembles = 6; // pixels

/** What draws the stage, as its driver names it.
 *  @returns {string} */
function renderer() {
  const probe = document.createElement("canvas").getContext("webgl2");
  if (!probe) return "";
  const info = probe.getExtension("WEBGL_debug_renderer_info");
  const name = probe.getParameter(info?.UNMASKED_RENDERER_WEBGL ?? probe.RENDERER);
  probe.getExtension("WEBGL_lose_context")?.loseContext();
  return name ?? "";
}

const kNoWebgl =
  "This browser does not give the page WebGL 2, which the stage needs. The text, the steps and the numbers work " +
  "without it. A current Firefox, Chrome, Edge or Safari draws the stage, unless hardware acceleration is switched " +
  "off in its settings.";

/** Whether the processor draws instead of a graphics card: several samples per pixel then cost a third of a frame. */
const drawn_by_processor = (/** @type {string} */ name) =>
  /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
/** Whether the browser lays the page's layers over each other on the processor as well. */
const composited_by_processor = (/** @type {string} */ name) => /swiftshader|basic render/i.test(name);

export class Stage {
  #door;
  #canvas = by_id("canvas");
  #after_frame;
  #due = 0;
  #alarm = 0; // the timer of the next frame that is due
  #moved = true;
  /** Whether a button or a finger is down on the canvas. */
  pressed = false;
  #touches = /** @type {Map<number, Point>} */ (new Map());
  #waiting = /** @type {(Point & { timer: number }) | null} */ (null); // a finger that has not pressed yet
  #pinched = false; // until every finger has lifted
  #lost_timer = 0;
  /** When each of the last frames began, and the milliseconds that the program took for it. */
  times = /** @type {FrameTime[]} */ ([]);

  /** after_frame: called after each frame.
   *  @param {Door} door @param {() => void} after_frame */
  constructor(door, after_frame) {
    this.#door = door;
    this.#after_frame = after_frame;
    const name = renderer();
    document.documentElement.classList.toggle("software", composited_by_processor(name));
    const error = door.start("#canvas", !drawn_by_processor(name), `${navigator.hardwareConcurrency ?? "?"} cores`);
    if (error) this.#cannot_draw(error);
    else this.#listen();
    watch_layout(() => {
      this.#moved = true;
      this.request();
    });
  }

  #cannot_draw(/** @type {Refusal} */ error) {
    stage_message(error === "no WebGL 2" ? kNoWebgl : `The stage cannot be drawn here: ${error}`);
    document.documentElement.classList.add("no-stage");
  }

  /** Requests a frame. Several requests before it comes count as one. */
  request() {
    if (this.#due === 0) this.#due = requestAnimationFrame((time) => this.#draw(time / 1000));
  }

  #draw(/** @type {number} */ now) {
    this.#due = 0;
    if (this.#moved) this.#arrange();
    const start = performance.now();
    this.#door.frame(now);
    this.times.push({ at: start, cost: performance.now() - start });
    if (this.times.length > kFramesTimed) this.times.shift();
    this.#after_frame();
    by_id("stage").style.cursor = by_id("timeline").style.cursor = by_id("numbers").style.cursor = this.#door.cursor();
    by_id("caption").classList.toggle("away", this.#door.menu_open());
    by_id("ask").classList.toggle("aside", this.#door.menu_open());
    this.#wait(this.#door.seconds_until_due(now));
  }

  /** Sleeps until the next frame is due; input wakes the stage anyway. */
  #wait(/** @type {number} */ seconds) {
    clearTimeout(this.#alarm);
    if (seconds <= 0) this.request();
    else if (Number.isFinite(seconds)) this.#alarm = setTimeout(() => this.request(), seconds * 1000);
  }

  /** What `take` takes of what `draw` draws on the canvas, at a size of its own; the next frame draws the stage again.
   *  Null if it cannot be drawn.
   *  @template T @param {number} width @param {number} height @param {number} scale @param {Door["draw_picture"]} draw
   *  @param {(canvas: HTMLCanvasElement) => T} take */
  picture(width, height, scale, draw, take) {
    [this.#canvas.width, this.#canvas.height] = [width * scale, height * scale];
    const taken = draw(width, height, scale) ? take(this.#canvas) : null;
    this.#moved = true; // its own size comes back
    this.request();
    return taken;
  }

  #arrange() {
    this.#moved = false;
    const layout = arrange(this.#canvas);
    const [across, down] = [Math.round(layout.width * layout.scale), Math.round(layout.height * layout.scale)];
    if (this.#canvas.width !== across) this.#canvas.width = across;
    if (this.#canvas.height !== down) this.#canvas.height = down;
    this.#door.set_layout(layout);
  }

  /** Converts a position on the canvas to one in the page's viewport.
   *  @param {Point} on_canvas @returns {Point} */
  on_page({ x, y }) {
    const { left, top } = this.#canvas.getBoundingClientRect();
    return { x: left + x, y: top + y };
  }

  #on_canvas(/** @type {MouseEvent} */ event) {
    const { left, top } = this.#canvas.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  }

  #listen() {
    for (const surface of [this.#canvas, by_id("stage"), by_id("timeline"), by_id("numbers")]) {
      /** @template {keyof HTMLElementEventMap} Name
       *  @param {Name} name @param {(event: HTMLElementEventMap[Name]) => void} act */
      const on = (name, act) => surface.addEventListener(name, (event) => {
        if (event.target !== surface) return; // HTML on top of the stage handles its own input
        act(event);
        this.request();
      }, { passive: false });
      on("pointerdown", (event) => this.#down(event, surface));
      on("pointermove", (event) => this.#move(event));
      on("pointerup", (event) => this.#up(event));
      on("pointercancel", (event) => this.#up(event));
      on("pointerleave", () => this.#touches.size === 0 && this.#door.pointer_left());
      on("wheel", (event) => this.#wheel(event));
      on("contextmenu", (event) => event.preventDefault());
    }
    // A pointer gives the canvas the focus too, but only keyboard users have to see where the focus is.
    const pointed = (/** @type {boolean} */ on) => document.documentElement.classList.toggle("pointed", on);
    addEventListener("pointerdown", () => pointed(true), { capture: true });
    addEventListener("keydown", ({ key }) => key === "Tab" && pointed(false), { capture: true });
    this.#canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault(); // so that the browser may restore it
      this.#lose();
    });
    this.#canvas.addEventListener("webglcontextrestored", () => this.#restore());
  }

  /** @param {PointerEvent} event @param {HTMLElement} surface */
  #down(event, surface) {
    event.preventDefault(); // so that a drag does not select the page's text
    this.#canvas.focus({ preventScroll: true });
    surface.setPointerCapture(event.pointerId);
    this.pressed = true;
    const [x, y] = this.#on_canvas(event);
    this.#door.modifiers_held(event.shiftKey, event.ctrlKey || event.metaKey, event.altKey);
    if (event.pointerType === "touch") return this.#finger_down(event.pointerId, x, y);
    this.#door.pointer_moved(x, y, event.pointerType);
    if (kButtonsOfImgui.includes(event.button)) this.#door.pointer_button(event.button, true, event.pointerType);
  }

  /** @param {number} id @param {number} x @param {number} y */
  #finger_down(id, x, y) {
    this.#touches.set(id, { x, y });
    if (this.#touches.size > 1) {
      // Ends a drag where it is.
      if (!this.#stop_waiting() && !this.#pinched) this.#door.pointer_button(0, false, "touch");
      this.#pinched = true;
      return;
    }
    this.#pinched = false;
    this.#door.pointer_moved(x, y, "touch");
    this.#waiting = { x, y, timer: setTimeout(() => this.#finger_presses(), kFingerWaits) };
  }

  #finger_presses() {
    if (!this.#stop_waiting()) return;
    this.#door.pointer_button(0, true, "touch");
    this.request();
  }

  /** Stops waiting. Returns whether a finger was waiting. */
  #stop_waiting() {
    if (!this.#waiting) return false;
    clearTimeout(this.#waiting.timer);
    this.#waiting = null;
    return true;
  }

  #move(/** @type {PointerEvent} */ event) {
    const [x, y] = this.#on_canvas(event);
    if (this.#touches.size >= 2) return this.#pinch(event.pointerId, { x, y });
    if (this.#pinched && event.pointerType === "touch") return; // the remaining finger drags nothing
    if (this.#touches.has(event.pointerId)) this.#touches.set(event.pointerId, { x, y });
    if (this.#waiting && Math.hypot(x - this.#waiting.x, y - this.#waiting.y) > kFingerTrembles) this.#finger_presses();
    if (this.#waiting) return;
    this.#door.modifiers_held(event.shiftKey, event.ctrlKey || event.metaKey, event.altKey);
    this.#door.pointer_moved(x, y, event.pointerType);
  }

  #up(/** @type {PointerEvent} */ event) {
    this.pressed = this.#touches.size > 1;
    if (event.pointerType === "touch") return this.#finger_up(event);
    this.#door.pointer_button(kButtonsOfImgui.includes(event.button) ? event.button : 0, false, event.pointerType);
  }

  #finger_up(/** @type {PointerEvent} */ event) {
    if (!this.#touches.delete(event.pointerId) || this.#pinched) return;
    if (event.type === "pointerup") this.#finger_presses(); // the tap was shorter than the wait
    this.#stop_waiting(); // otherwise the browser has turned it into scrolling
    this.#door.pointer_button(0, false, "touch");
    this.#door.pointer_left(); // a lifted finger hovers over nothing
  }

  /** @param {number} id @param {Point} to */
  #pinch(id, to) {
    if (!this.#touches.has(id)) return;
    const spread = () => {
      const [a, b] = [...this.#touches.values()];
      return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, apart: Math.hypot(a.x - b.x, a.y - b.y) };
    };
    const before = spread();
    this.#touches.set(id, to);
    const now = spread();
    this.#door.pinch(before.apart > 0 ? now.apart / before.apart : 1, now.x, now.y, now.x - before.x, now.y - before.y);
  }

  #wheel(/** @type {WheelEvent} */ event) {
    if (event.target === by_id("timeline")) return; // lets the page scroll
    event.preventDefault();
    const pixels = [1, 16, 400][event.deltaMode];
    const [x, y] = this.#on_canvas(event);
    const [across, down] = [(-event.deltaX * pixels) / 100, (-event.deltaY * pixels) / 100];
    if (event.ctrlKey) return this.#door.pinch(Math.exp(down), x, y, 0, 0); // a touchpad's pinch
    this.#door.pointer_moved(x, y, "mouse");
    this.#door.wheel_turned(across, down);
  }

  #lose() {
    this.#door.stop_graphics();
    stage_message("The stage has lost its graphics. They should come back by themselves in a moment.");
    this.#lost_timer = setTimeout(() => {
      const reload = button("Reload", () => location.reload());
      stage_message("The stage’s graphics have not come back. The address keeps your work: reload the page.", reload);
    }, kPatience);
  }

  #restore() {
    clearTimeout(this.#lost_timer);
    const error = this.#door.start_graphics();
    if (error) return this.#cannot_draw(error);
    stage_message("");
    this.request();
  }
}
