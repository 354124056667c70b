// Adds what stands on the page to a demo: a file that grows by a state with each press. Loaded by that press alone.
import { has_all, write_address } from "./address.js";
import { save_file } from "./dom.js";
import { state_text } from "./demo_text.js";
import { notice } from "./messages.js";

const kKept = "snug-recorded";
const kHead = 'version = 1\ntitle = "My demo"\nlecture = "My lecture"\n';

/** Adds a state to those that were recorded in this tab, and saves all of them.
 *  @param {View} view @param {Lesson} lesson @param {Door} door */
export async function record(view, lesson, door) {
  /** @type {DemoKeys} */
  const keys = await (await fetch(window.snug.at("demo_keys.json"))).json();
  const shared = door.shared_rows();
  const address = write_address(view, lesson, shared, false);
  /** @type {string[]} */
  const states = JSON.parse(sessionStorage.getItem(kKept) ?? "[]");
  states.push(state_text(keys, address, lesson.title, door.trace() ?? ""));
  sessionStorage.setItem(kKept, JSON.stringify(states));
  save_file([kHead, ...states].join("\n"), "demo.toml");
  const lost = !has_all(shared) || (view.file && view.file.own !== view.file.typed);
  const says = lost ? " What was edited here is too much for it, and is left out." : "";
  notice(`demo.toml is saved, with ${states.length === 1 ? "this state" : `${states.length} states`}.${says}`, "told");
}
