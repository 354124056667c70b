// The notes of a demo, in a tab of their own: what is said now, what comes next, and the time. The tab follows the demo
// through a channel, and leads it; if it is closed or loaded anew, nothing of the demo is lost.
import { button, element, set_text } from "./dom.js";
import { channel_of } from "./demo.js";
import { next_text } from "./demo_text.js";
import { bring_style } from "./sheet.js";
/** @import { Downloads } from "./download.js"
 *  @import { Standing } from "./demo.js" */

const kTick = 1000; // milliseconds

const two = (/** @type {number} */ number) => String(Math.floor(number)).padStart(2, "0");

/** The time of day, and how long ago that was.
 *  @param {Date} now @param {Date} since */
function clock_text(now, since) {
  const seconds = Math.max(0, (now.getTime() - since.getTime()) / 1000);
  const ago = `${Math.floor(seconds / 60)}:${two(seconds % 60)}`;
  return `${two(now.getHours())}:${two(now.getMinutes())} · ${ago}`;
}

/** @param {string} id @param {Downloads} downloads */
export async function show_notes(id, downloads) {
  /** @type {DemoFile | null} */
  const file = await downloads.text(`demos/${id}.json`).then(JSON.parse, () => null);
  bring_style("demo.css");
  document.documentElement.dataset.view = "notes";
  const place = element("p", { class: "label" }), slide = element("h1"), notes = element("p", { class: "says" });
  const vote = element("p", { class: "vote", role: "status" });
  const next = element("p", { class: "next" }), clock = element("p", { class: "clock" });
  const waits = "Waiting for the demo, in another tab of this browser.";
  const state = element("p", { class: "label", role: "status" }, waits);
  const channel = channel_of(id);
  const does = (/** @type {string} */ words, /** @type {string} */ what) =>
    button(words, () => channel.postMessage({ does: what }));
  const buttons = element("div", { class: "buttons" },
    does("Back", "back"), does("Next", "next"), does("This state again", "again"), does("Black", "b"),
    does("Freeze", "f"),
  );
  const says = [clock, place, slide, notes, vote, next, buttons, state];
  const parts = file ? says : [`There is no demo “${id.slice(0, 60)}”.`];
  document.body.replaceChildren(element("main", { class: "demo-notes" }, ...parts));
  if (!file) return;
  document.title = `Notes · ${file.title}`;
  let began = new Date();
  const tick = () => set_text(clock, clock_text(new Date(), began));
  clock.addEventListener("click", () => ((began = new Date()), tick())); // the lecture begins now
  setInterval(tick, kTick);
  tick();
  /** @type {(standing: Standing) => void} */
  const show = (standing) => {
    const shown = file.states[standing.at];
    set_text(place, `${standing.at + 1} of ${file.states.length} · ${file.title}`);
    set_text(slide, shown.slide);
    set_text(notes, shown.notes);
    set_text(vote, standing.vote);
    set_text(next, next_text(file, standing));
    set_text(state, standing.black ? "The screen is black." : standing.frozen ? "The picture is frozen." : "");
  };
  channel.onmessage = ({ data }) => {
    if ("at" in data) show(data);
    else if ("gone" in data) set_text(state, waits);
  };
  /** @type {Record<string, string>} */
  const keys = { PageDown: "next", ArrowRight: "next", PageUp: "back", ArrowLeft: "back", Home: "again", b: "b",
    ".": "b", f: "f" };
  addEventListener("keydown", (event) => {
    if (!keys[event.key]) return;
    event.preventDefault();
    channel.postMessage({ does: keys[event.key], held: event.repeat });
  });
  channel.postMessage({ asks: true });
}
