// Adds what stands on the page to a demo: a file that grows by a state with each press. Loaded by that press alone.
import { state_text } from "./demo_text.js";
import { save_file } from "./exercise.js";

const kKept = "snug-recorded";
const kHead = 'version = 1\ntitle = "My demo"\nlecture = "My lecture"\n';

/** Adds a state to those that were recorded in this tab, and saves all of them. Returns how many there are.
 *  @param {string} address @param {string} title @param {string} trace */
export function record(address, title, trace) {
  /** @type {string[]} */
  const states = JSON.parse(sessionStorage.getItem(kKept) ?? "[]");
  states.push(state_text(address, title, trace));
  sessionStorage.setItem(kKept, JSON.stringify(states));
  save_file([kHead, ...states].join("\n"), "demo.toml");
  return states.length;
}
