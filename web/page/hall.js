// What a lecturer has over the whole page: a spotlight, a pen that fades, a ruler for the height of type; black, and a
// picture that stands.
import { by_id, element } from "./dom.js";
import { bring_style } from "./sheet.js";

const kStays = 3000, kFades = 1500; // milliseconds
const kLight = 0.13; // the spotlight's radius, of the window's height
const kParts = 40; // type of a fortieth of the height is what the last row still reads

class Hall {
  #canvas = element("canvas", { class: "hall", "aria-hidden": "true", hidden: true });
  #on = { l: false, w: false, r: false };
  #at = /** @type {Point | null} */ (null);
  #strokes = /** @type {{ points: Point[], ended: number }[]} */ ([]);
  #writing = false;
  #frame = 0;
  #black = element("div", { class: "hall-black", hidden: true });
  #picture = /** @type {HTMLElement | null} */ (null); // that stands
  changed = () => {}; // called when it gets black or light, or a picture is frozen or goes

  constructor() {
    addEventListener("pointermove", (event) => this.#move(event), { capture: true });
    this.#canvas.addEventListener("pointerdown", (event) => this.#press(event));
    this.#canvas.addEventListener("pointerup", () => (this.#writing = false));
    addEventListener("resize", () => this.#request());
    this.#black.addEventListener("pointerdown", () => this.darken(false));
    document.body.append(this.#canvas, this.#black);
  }

  /** l: the spotlight; w: the pen; r: the ruler; b and a full stop: black; f: the picture is frozen.
   *  @param {string} key @param {Door} door */
  async answer_key(key, door) {
    await bring_style("hall.css");
    if (key === "b" || key === ".") return this.darken(!this.black);
    if (key === "f") return this.freeze(this.frozen ? null : door);
    const name = /** @type {"l" | "w" | "r"} */ (key);
    this.#on[name] = !this.#on[name];
    this.#show();
  }

  /** Returns whether anything was in use. */
  put_away() {
    const any = Object.values(this.#on).includes(true);
    this.#on = { l: false, w: false, r: false };
    this.#show();
    return any;
  }

  get black() {
    return !this.#black.hidden;
  }

  get frozen() {
    return this.#picture !== null;
  }

  darken(/** @type {boolean} */ on) {
    this.#black.hidden = !on;
    this.changed();
  }

  /** A picture of the page lies over it, and lets every press through. door: draws it; null takes it away.
   *  @param {Door | null} door */
  freeze(door) {
    this.#picture?.remove();
    this.#picture = null;
    if (door) this.#lay_over(door);
    this.changed();
  }

  #lay_over(/** @type {Door} */ door) {
    const work = by_id("work");
    const copy = /** @type {HTMLElement} */ (work.cloneNode(true));
    const canvas = copy.querySelector("canvas");
    door.frame(performance.now() / 1000); // what was drawn is there only within the same task
    canvas?.getContext("2d")?.drawImage(by_id("canvas"), 0, 0);
    const { left, top, width, height } = work.getBoundingClientRect();
    Object.assign(copy.style, { left: `${left}px`, top: `${top}px`, width: `${width}px`, height: `${height}px` });
    copy.classList.add("hall-picture");
    copy.inert = true;
    copy.setAttribute("aria-hidden", "true");
    document.body.append(copy);
    this.#picture = copy;
  }

  /** Lets the class see the page again. */
  lift() {
    this.darken(false);
    this.freeze(null);
  }

  #show() {
    this.#canvas.classList.toggle("writes", this.#on.w); // else every press goes through
    this.#request();
  }

  #request() {
    if (this.#frame === 0) this.#frame = requestAnimationFrame((now) => this.#draw(now));
  }

  #move(/** @type {PointerEvent} */ { clientX: x, clientY: y }) {
    this.#at = { x, y };
    if (this.#writing) {
      const stroke = this.#strokes[this.#strokes.length - 1];
      stroke.points.push({ x, y });
      stroke.ended = performance.now();
    }
    if (this.#on.l || this.#on.w) this.#request();
  }

  #press(/** @type {PointerEvent} */ event) {
    event.preventDefault();
    this.#canvas.setPointerCapture(event.pointerId);
    this.#writing = true;
    this.#strokes.push({ points: [{ x: event.clientX, y: event.clientY }], ended: performance.now() });
  }

  #draw(/** @type {number} */ now) {
    this.#frame = 0;
    this.#strokes = this.#strokes.filter(({ ended }) => now - ended < kStays + kFades);
    const used = Object.values(this.#on).includes(true) || this.#strokes.length > 0;
    this.#canvas.hidden = !used;
    const context = this.#canvas.getContext("2d");
    if (!used || !context) return;
    const scale = devicePixelRatio;
    [this.#canvas.width, this.#canvas.height] = [innerWidth * scale, innerHeight * scale];
    context.scale(scale, scale);
    if (this.#on.l && this.#at) draw_spotlight(context, this.#at);
    for (const { points, ended } of this.#strokes)
      draw_stroke(context, points, 1 - Math.max(0, now - ended - kStays) / kFades);
    if (this.#on.w && this.#at) draw_stroke(context, [this.#at, this.#at], 1);
    if (this.#on.r) draw_ruler(context);
    if (this.#strokes.length > 0) this.#request();
  }
}

/** @param {CanvasRenderingContext2D} context @param {Point} at */
function draw_spotlight(context, { x, y }) {
  context.fillStyle = "rgb(0 0 0 / .62)";
  context.beginPath();
  context.rect(0, 0, innerWidth, innerHeight);
  context.arc(x, y, kLight * innerHeight, 0, 2 * Math.PI, true);
  context.fill();
}

/** @param {CanvasRenderingContext2D} context @param {Point[]} points @param {number} alpha */
function draw_stroke(context, points, alpha) {
  context.strokeStyle = `rgb(224 26 26 / ${alpha})`;
  context.lineWidth = Math.max(4, innerHeight / 200);
  context.lineCap = context.lineJoin = "round";
  context.beginPath();
  for (const { x, y } of points) context.lineTo(x, y);
  context.stroke();
}

/** @param {CanvasRenderingContext2D} context */
function draw_ruler(context) {
  const part = innerHeight / kParts, left = innerWidth - 3 * part;
  const words = "1/40: the least that the last row reads";
  context.font = `600 ${part}px Inter, sans-serif`;
  const width = context.measureText(words).width, middle = innerHeight / 2;
  context.fillStyle = "rgb(255 255 255 / .92)";
  context.fillRect(left, 0, 3 * part, innerHeight);
  context.fillRect(left - width - 2 * part, middle - part / 4, width + part, 1.5 * part);
  context.fillStyle = "#111";
  for (let i = 0; i <= kParts; ++i) {
    const long = i % 5 === 0;
    context.fillRect(innerWidth - part * (long ? 1.5 : 0.8), part * i - (long ? 1 : 0.5), part * 1.5, long ? 2 : 1);
  }
  context.textBaseline = "top";
  context.fillText(words, left - width - 1.5 * part, middle);
}

export const hall = new Hall();
