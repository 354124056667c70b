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
    by_id("veil-bar").setAttribute("aria-label", "Loading");
    set_hidden(by_id("veil-bar"), false);
  },
  /** retry: null if it would be pointless.
   *  @param {string} text @param {(() => void) | null} retry */
  failed(text, retry) {
    show_veil(text);
    if (retry) offer("Try again", retry);
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

/** Why an edit was refused that the user has cancelled. */
export const kCancelled = "it was cancelled";

const kSlice = 100; // milliseconds: after so long the page draws

/** Goes on with an edit that takes long, and says over the page what is done and how far, until it is there, is refused
 *  or is cancelled: by the button or Escape. Returns why it is refused, or "".
 *  @param {Door} door @returns {Promise<Refusal>} */
export async function work(door) {
  const before = /** @type {HTMLElement | null} */ (document.activeElement);
  let refused = /** @type {Refusal} */ ("");
  let cancelled = false;
  const cancel = () => (cancelled = true);
  const keys = (/** @type {KeyboardEvent} */ event) => {
    if (event.key === "Escape") cancel();
    if (!["Tab", "Enter", " "].includes(event.key)) event.stopPropagation(); // the stage's keys wait
  };
  addEventListener("keydown", keys, true);
  show_veil("");
  set_hidden(by_id("veil-bar"), false);
  offer("Cancel", cancel);
  for (let now = door.preparing(); now && !cancelled; now = door.preparing()) {
    set_text(by_id("veil-text"), now.says);
    by_id("veil-bar").setAttribute("aria-label", now.says);
    veil.progress(now.share);
    await painted();
    if (!cancelled) refused = door.go_on(kSlice);
  }
  removeEventListener("keydown", keys, true);
  if (cancelled) door.give_up();
  by_id("work").inert = by_id("bar").inert = false;
  before?.focus({ preventScroll: true });
  return cancelled ? kCancelled : refused;
}

/** Once the page was drawn; one in the background draws nothing. */
const painted = () =>
  new Promise((done) => {
    requestAnimationFrame(() => setTimeout(done, 0));
    setTimeout(done, 100);
  });

/** A button on the veil, with the focus.
 *  @param {string} words @param {() => void} press */
function offer(words, press) {
  const button = by_id("veil-retry");
  set_hidden(button, false);
  set_text(button, words);
  button.onclick = press;
  button.focus();
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

/** A notice, which can be closed and disappears by itself. more: what stands after its text, as a link.
 *  @param {string} text @param {"wrong" | "told"} kind @param {...Node} more */
export function notice(text, kind = "wrong", ...more) {
  const box = element("div", { class: `notice ${kind}` }, element("p", {}, text, ...more));
  const away = () => box.remove();
  box.append(element("button", { type: "button", class: "away", "aria-label": "Dismiss", onclick: away }, "×"));
  const list = by_id("notices");
  for (const old of [...list.children]) if (old.firstChild?.firstChild?.textContent === text) old.remove();
  for (const old of [...list.children].slice(0, 1 - kShownMost)) old.remove();
  list.append(box);
  // It stays while the pointer or the focus is on it.
  const leave = () => (box.matches(":hover, :focus-within") ? setTimeout(leave, kStays[kind]) : away());
  setTimeout(leave, kStays[kind]);
}
