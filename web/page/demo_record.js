// Adds what stands on the page to a demo: a file that grows by a state with each press. Loaded by that press alone.
import { save_file } from "./dom.js";
import { notice } from "./messages.js";

const kKept = "snug-recorded";
const kHead = 'version = 1\ntitle = "My demo"\nlecture = "My lecture"\n';

/** Adds a state to those that were recorded in this tab, and saves all of them.
 *  @param {Door} door */
export function record(door) {
  /** @type {string[]} */
  const states = JSON.parse(sessionStorage.getItem(kKept) ?? "[]");
  states.push(door.demo_state());
  sessionStorage.setItem(kKept, JSON.stringify(states));
  save_file([kHead, ...states].join("\n"), "demo.toml");
  notice(`demo.toml is saved, with ${states.length === 1 ? "this state" : `${states.length} states`}.`, "told");
}
