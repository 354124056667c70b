// Messages about what went wrong: over the whole page, on the stage, or as notices that disappear.
import { by_id, capital, element, set_hidden, set_text } from "./dom.js";

/** The veil over the page while it loads, and after a failure. */
export const veil = {
  progress(/** @type {number} */ share) {
    by_id("veil-bar").setAttribute("aria-valuenow", Math.round(share * 100));
    by_id("veil-share").style.transform = `scaleX(${share})`;
  },
  loading() {
    show_veil("Loading");
    set_hidden(by_id("veil-bar"), false);
  },
  /** retry: null if it would be pointless.
   *  @param {string} text @param {(() => void) | null} retry */
  failed(text, retry) {
    show_veil(text);
    const again = by_id("veil-retry");
    set_hidden(again, !retry);
    again.onclick = retry;
    if (retry) again.focus();
  },
  /** For a lesson that does not exist: offers the real ones.
   *  @param {string} text @param {HTMLElement} links */
  choose(text, links) {
    show_veil(text);
    by_id("veil-lessons").append(links);
  },
  lift() {
    set_hidden(by_id("veil"), true);
    by_id("work").inert = by_id("bar").inert = false;
  },
};

const kMany = 2_000; // points: fewer are at once on the stage

/** Says over the page that so many points are worked on, which takes a while, and paints that before they are. Returns
 *  whether it said so: then the veil is to be lifted.
 *  @param {number} points */
export async function at_work(points) {
  if (!(points >= kMany)) return false;
  show_veil(`Working on ${points.toLocaleString("en")} points`);
  await new Promise((painted) => {
    requestAnimationFrame(() => setTimeout(painted, 0));
    setTimeout(painted, 100); // a page in the background paints nothing
  });
  return true;
}

function show_veil(/** @type {string} */ text) {
  set_hidden(by_id("veil"), false);
  by_id("work").inert = by_id("bar").inert = true;
  set_text(by_id("veil-text"), text);
  set_hidden(by_id("veil-bar"), true);
  set_hidden(by_id("veil-retry"), true);
  by_id("veil-lessons").replaceChildren();
}

/** Shows a message in place of the stage, and perhaps a button; "" removes it.
 *  @param {string} text @param {HTMLElement[]} actions */
export function stage_message(text, ...actions) {
  const box = by_id("stage-message");
  set_hidden(box, !text);
  box.replaceChildren(...(text ? [element("p", {}, text), ...actions] : []));
}

const kShownMost = 3;
const kStays = { told: 4000, wrong: 15_000 }; // milliseconds

/** Removes the notices, because what they are about is over. */
export function clear_notices() {
  by_id("notices").replaceChildren();
}

/** Shows what an edit was refused for; "" removes the notices. */
export function answer_edit(/** @type {Refusal} */ error) {
  if (error) notice(`${capital(error)}.`);
  else clear_notices();
}

/** One notice for all that went wrong. */
export function notice_all(/** @type {string[]} */ problems) {
  if (problems.length > kShownMost)
    problems = [
      ...problems.slice(0, kShownMost - 1),
      `The address has ${problems.length - kShownMost + 1} more mistakes; the rest of it is shown.`,
    ];
  for (const problem of problems) notice(problem);
}

/** A notice, which can be closed and disappears by itself.
 *  @param {string} text @param {"wrong" | "told"} kind */
export function notice(text, kind = "wrong") {
  const box = element("div", { class: `notice ${kind}` }, element("p", {}, text));
  const away = () => box.remove();
  box.append(element("button", { type: "button", class: "away", "aria-label": "Dismiss", onclick: away }, "×"));
  const list = by_id("notices");
  for (const old of [...list.children]) if (old.firstChild?.textContent === text) old.remove();
  for (const old of [...list.children].slice(0, 1 - kShownMost)) old.remove();
  list.append(box);
  // It stays while the pointer or the focus is on it.
  const leave = () => (box.matches(":hover, :focus-within") ? setTimeout(leave, kStays[kind]) : away());
  setTimeout(leave, kStays[kind]);
}
