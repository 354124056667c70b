// The stage's keys work anywhere on the page, except where a key has its own meaning.
import { kWrites } from "./dom.js";

const kPresses = "button, a, summary";
const kReads = "#read, #points, #file, #code";
const kPages = new Set(["PageUp", "PageDown"]); // which mean nothing within a line of text
const kScrolls = new Set(["ArrowUp", "ArrowDown", "PageUp", "PageDown", "Home", "End", " "]);

/** Whether the key scrolls the element that contains the focus.
 *  @param {Element} target @param {string} key */
function scrolls(target, key) {
  if (!kScrolls.has(key) || !target.closest(kReads)) return false;
  for (let node = /** @type {Element | null} */ (target); node; node = node.parentElement)
    if (node.scrollHeight > node.clientHeight + 1 && /auto|scroll/.test(getComputedStyle(node).overflowY)) return true;
  return false;
}

/** choose(digit): returns whether it answered a question; leave(): whether there was something to leave; of a lecture:
 *  record() adds what stands there to a demo, present() begins and ends one, code() shows a code to scan.
 *  @param {Door} door @param {Act} act @param {(digit: number) => boolean} choose @param {() => boolean} leave
 *  @param {{ record: () => void, present: () => void, code: () => void }} lecture */
export function listen_to_keys(door, act, choose, leave, lecture) {
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.altKey || event.isComposing) return;
    const target = event.target instanceof Element ? event.target : document.body;
    // Any key ends the playing, and does nothing else.
    if (door.view()?.deciding && !/^(Shift|Control|Alt|Meta)/.test(event.key)) {
      event.preventDefault();
      return act(() => door.command("continue"));
    }
    const control = event.ctrlKey || event.metaKey;
    const nothing_in_it =
      (target.matches("input[type=text]") && kPages.has(event.key)) ||
      (target.matches("input[type=range], input[type=radio]") && control);
    if (target.closest(kWrites) && !nothing_in_it) return;
    if (scrolls(target, event.key) && !control) return;
    if (target.closest(kPresses) && (event.key === "Enter" || event.key === " ")) return;
    // A key that is held goes on stepping, but answers and skips once.
    if (event.repeat && !event.key.startsWith("Arrow")) return;
    if (!control && event.key >= "1" && event.key <= "9" && choose(Number(event.key))) return event.preventDefault();
    if (event.key === "Escape" && leave()) return event.preventDefault();
    const { key, shiftKey } = event;
    const does = key === "F5" || (key === "P" && shiftKey) ? lecture.present
      : key === "D" ? lecture.record
      : key.toLowerCase() === "q" ? lecture.code
      : key === "?" ? () => import("./keys_card.js").then((card) => card.show_keys(door.key_rows()))
      : null;
    if (!control && does) return event.preventDefault(), does();
    const command = door.command_of_key(event.key, event.shiftKey, control);
    if (!command) return;
    event.preventDefault();
    act(() => door.command(command));
  });
}
