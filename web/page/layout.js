// Chooses the arrangement that fits, of three, and places the canvas's parts in it.
import { by_id } from "./dom.js";

// In the page's rem, because larger text needs a larger window, however it was made larger.
const kWide = { across: 64, presented: 60, demo: 50, down: 30 }; // presented: the timeline extends below the numbers
const kBeside = 30; // the width, in a window that is wider than high
const kCoarse = matchMedia("(pointer: coarse)");
const kParts = ["stage", "timeline", "numbers"];

/** Keeps data-layout ("wide", "beside" or "phone") on the root, and calls changed when anything has moved.
 *  @param {() => void} changed */
export function watch_layout(changed) {
  const name = () => {
    name_layout();
    changed();
  };
  kCoarse.addEventListener("change", name);
  const moved = new ResizeObserver(changed);
  for (const id of ["work", "column", "ask", ...kParts]) moved.observe(by_id(id));
  addEventListener("resize", name);
  // Text size and presentation change these.
  new MutationObserver(name).observe(document.documentElement, { attributeFilter: ["style", "class"] });
  name();
}

/** Sets it once, for the course, which has no stage. */
export function name_layout() {
  document.documentElement.dataset.layout = fitting();
  document.documentElement.classList.toggle("fingers", has_fingers());
}

function fitting() {
  const rem = parseFloat(getComputedStyle(document.documentElement).fontSize);
  const [across, down] = [innerWidth / rem, innerHeight / rem];
  const is = (/** @type {string} */ name) => document.documentElement.classList.contains(name);
  const wide = is("demo") ? kWide.demo : is("presenting") ? kWide.presented : kWide.across;
  if (across >= wide && down >= kWide.down) return "wide";
  return across >= kBeside && innerWidth > innerHeight ? "beside" : "phone";
}

const has_fingers = () => kCoarse.matches || document.documentElement.dataset.layout === "phone";

/** A part's rectangle in #work, in its pixels; a hidden part's is empty.
 *  @param {string} id */
function measured(id) {
  const work = by_id("work").getBoundingClientRect();
  const { left, top, width, height } = by_id(id).getBoundingClientRect();
  return { x: left - work.left, y: top - work.top, width, height };
}

/** How far the page's own buttons reach into the stage from its left edge. */
function tools_reach() {
  const tools = [...document.querySelectorAll(".stage-tools > :not([hidden])")];
  const shown = tools.map((tool) => tool.getBoundingClientRect()).filter(({ width }) => width > 0);
  if (shown.length === 0) return 0;
  return Math.max(...shown.map(({ right }) => right)) - by_id("stage").getBoundingClientRect().left;
}

/** How much of the bottom of the stage the question covers; 0 if there is room for it elsewhere. */
function foot() {
  const [stage, card] = ["stage", "ask"].map((id) => by_id(id).getBoundingClientRect());
  const beside = card.height === 0 || card.left >= stage.right || card.right <= stage.left;
  return beside ? 0 : Math.max(0, Math.min(stage.bottom, stage.bottom - card.top));
}

let last = /** @type {StageLayout | null} */ (null);

/** Puts the canvas under its parts. Returns the arguments of web/main.cpp's set_layout.
 *  @param {HTMLCanvasElement} canvas */
export function arrange(canvas) {
  const [stage, timeline, inspector] = kParts.map(measured);
  const shown = [stage, timeline, inspector].filter((part) => part.width > 0 && part.height > 0);
  if (shown.length === 0 && last) return last; // the course is shown instead of the lesson
  const left = Math.floor(Math.min(...shown.map((part) => part.x)));
  const top = Math.floor(Math.min(...shown.map((part) => part.y)));
  const width = Math.max(1, Math.ceil(Math.max(...shown.map((part) => part.x + part.width))) - left);
  const height = Math.max(1, Math.ceil(Math.max(...shown.map((part) => part.y + part.height))) - top);
  Object.assign(canvas.style, { left: `${left}px`, top: `${top}px`, width: `${width}px`, height: `${height}px` });
  const within = (/** @type {Rectangle} */ part) => ({ ...part, x: part.x - left, y: part.y - top });
  last = {
    width,
    height,
    scale: devicePixelRatio,
    fingers: has_fingers(),
    tools: tools_reach(),
    foot: foot(),
    stage: within(stage),
    timeline: within(timeline),
    inspector: within(inspector),
  };
  return last;
}
