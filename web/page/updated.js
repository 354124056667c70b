// The site was updated while this page was loading, or while the browser kept a part of it: then the page is loaded
// anew, once. The entry of the history knows of it, and no storage, which a frame may not have.
import { notice } from "./messages.js";

const kTwo = "Parts of this page are of two versions of Snug. Load it again later.";
const say = (/** @type {string} */ words) => void window.snug.ready.then(() => notice(words, "told"));

/** mixed: whether the program is of another build than the page. Loads the page anew, with every file asked of the
 *  host; where that was done already, says how it went.
 *  @param {boolean} mixed */
export async function load_anew(mixed) {
  const was = Boolean(history.state?.loaded_anew);
  history.replaceState(mixed && !was ? { loaded_anew: true } : null, "");
  if (was) return say(mixed ? kTwo : "Snug was updated, so this page was loaded anew.");
  const links = [...document.querySelectorAll("link[href], script[src]")];
  const paths = links.map((link) => link.getAttribute("href") ?? link.getAttribute("src") ?? "");
  paths.push(...["snug.js", "snug.wasm", "sizes.json"].map(window.snug.at));
  await Promise.all(paths.map((path) => fetch(path, { cache: "reload" })));
  location.reload();
  return new Promise(() => {}); // nothing more happens here
}
