// Theme, text size, motion and presentation mode, for the page and the canvas.
import { by_id, is_within, set_hidden, set_text } from "./dom.js";

const kThemes = ["light", "dark", "contrast", "projector"];
/** @type {Record<string, string>} */
const kNames = { light: "Light", dark: "Dark", contrast: "High contrast", projector: "Projector" };
const kTextScales = [1, 1.15, 1.3, 1.5];
const kProjectorScale = 1.2; // the same as in app/palette.hpp: the canvas applies it by itself
export const kPresentingScale = 1.3;
const kLow = 690; // pixels, for words of the size that they are made for
const kScreen = { width: 1280, height: 720 }; // on a larger one everything that is presented is larger
const kLeast = { height: 1 / 40, width: 3 / 160 }; // no word is lower then, unless the window is no projector's
const kSurePatience = 6000; // milliseconds for which a press waits for a second one
const asks = (/** @type {string} */ query) => matchMedia(query);

function remembered(/** @type {string} */ name) {
  try {
    return localStorage.getItem(`snug-${name}`);
  } catch {
    return null; // a page in a frame may have no storage
  }
}

/** @param {string} name @param {string | number} value */
function remember(name, value) {
  try {
    localStorage.setItem(`snug-${name}`, String(value));
  } catch {
    // then the next visit starts like the first
  }
}

function first_theme() {
  const kept = remembered("theme") ?? "";
  if (kThemes.includes(kept)) return kept;
  if (asks("(prefers-contrast: more)").matches) return "contrast";
  return asks("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

export class Settings {
  #changed = () => {};
  #erase = () => {};
  #sure = 0; // the timer of the second press
  #before_presenting = ""; // the theme

  constructor() {
    this.theme = first_theme();
    this.text = kTextScales.includes(Number(remembered("text"))) ? Number(remembered("text")) : 1;
    this.presenting = false;
    this.larger = 1; // how many times larger a demo wants its words than a lesson that is presented
    this.motion = asks("(prefers-reduced-motion: reduce)");
    this.motion.addEventListener("change", () => this.#apply());
    by_id("theme").addEventListener("click", () => this.#next_theme());
    by_id("text-size").addEventListener("click", () => this.#next_text());
    by_id("theme-too").addEventListener("click", () => this.#next_theme());
    by_id("text-size-too").addEventListener("click", () => this.#next_text());
    this.#listen_to_panel();
    by_id("present").addEventListener("click", () => this.present(true));
    by_id("leave").addEventListener("click", () => this.present(false));
    // In full screen, the browser takes Escape for itself.
    addEventListener("resize", () => this.presenting && this.#apply());
    addEventListener("fullscreenchange", () => document.fullscreenElement || this.present(false));
    this.#apply();
  }

  /** changed: called now and after each change. */
  on_change(/** @type {() => void} */ changed) {
    const before = this.#changed;
    this.#changed = () => (before(), changed());
    changed();
  }

  // ---- the panel ----------------------------------------------------------------------------------------------

  /** erase: erases the kept answers. */
  on_erase(/** @type {() => void} */ erase) {
    this.#erase = erase;
  }

  #listen_to_panel() {
    by_id("settings").addEventListener("click", () => this.#show_panel(Boolean(by_id("settings-panel").hidden)));
    by_id("erase").addEventListener("click", () => this.#press_erase());
    const kAround = ".settings"; // the button and its panel
    addEventListener("pointerdown", ({ target }) => is_within(target, kAround) || this.#show_panel(false));
    const around = by_id("settings").closest(kAround);
    around?.addEventListener("focusout", (event) => {
      const { relatedTarget: to } = /** @type {FocusEvent} */ (event);
      if (to && !is_within(to, kAround)) this.#show_panel(false);
    });
    around?.addEventListener("keydown", (event) => {
      if (/** @type {KeyboardEvent} */ (event).key === "Escape") {
        this.#show_panel(false);
        by_id("settings").focus();
      }
      event.stopPropagation(); // the stage's keys do nothing while the panel is open
    });
  }

  #show_panel(/** @type {boolean} */ open) {
    if (by_id("settings-panel").hidden === !open) return;
    set_hidden(by_id("settings-panel"), !open);
    by_id("settings").setAttribute("aria-expanded", open);
    if (open) import("./offline.js").then(({ show_offline }) => show_offline()).catch(() => {});
    this.#ask_to_erase(false);
    set_text(by_id("erase-says"), "Your answers and your place in each lesson are kept on this device alone.");
  }

  #ask_to_erase(/** @type {boolean} */ sure) {
    clearTimeout(this.#sure);
    this.#sure = sure ? setTimeout(() => this.#ask_to_erase(false), kSurePatience) : 0;
    set_text(by_id("erase"), sure ? "Press again to erase them" : "Erase my answers");
    by_id("erase").classList.toggle("sure", sure);
  }

  #press_erase() {
    if (!this.#sure) {
      set_text(by_id("erase-says"), "This erases your answers and your place in every lesson from this device.");
      return this.#ask_to_erase(true);
    }
    this.#ask_to_erase(false);
    this.#erase();
    set_text(by_id("erase-says"), "Your answers are erased.");
  }

  // ---- theme and text -----------------------------------------------------------------------------------------

  #next_theme() {
    this.theme = kThemes[(kThemes.indexOf(this.theme) + 1) % kThemes.length];
    remember("theme", this.theme);
    this.#apply();
  }

  #next_text() {
    this.text = kTextScales[(kTextScales.indexOf(this.text) + 1) % kTextScales.length];
    remember("text", this.text);
    this.#apply();
  }

  enlarge(/** @type {number} */ larger) {
    if (larger === this.larger) return;
    this.larger = larger;
    this.#apply();
  }

  /** Presentation mode: a projector's theme, larger, without what only a reader at a desk needs. */
  present(/** @type {boolean} */ on) {
    if (on === this.presenting) return;
    this.presenting = on;
    if (on) this.#before_presenting = this.theme;
    this.theme = on ? "projector" : this.#before_presenting;
    this.#apply();
    this.#fill_screen(on);
    const focused = document.activeElement;
    if (!on) by_id("present").focus();
    else if (focused instanceof HTMLElement) focused.blur();
  }

  /** Enters or leaves full screen, if the browser allows it; a presentation also works in a window. */
  async #fill_screen(/** @type {boolean} */ on) {
    if (on) await document.documentElement.requestFullscreen?.().catch(() => {});
    if (!this.presenting && document.fullscreenElement) document.exitFullscreen();
  }

  get text_scale() {
    const scale = this.text * (this.theme === "projector" ? kProjectorScale : 1);
    const screen = Math.max(1, Math.min(innerWidth / kScreen.width, innerHeight / kScreen.height));
    return this.presenting ? Math.max(scale, kPresentingScale * this.larger * screen) : scale;
  }

  /** The least height of words, pixels: what the last row of a hall reads. */
  get least() {
    return this.presenting ? Math.min(innerHeight * kLeast.height, innerWidth * kLeast.width) : 0;
  }

  #apply() {
    const root = document.documentElement;
    root.dataset.theme = this.theme;
    root.classList.toggle("presenting", this.presenting);
    root.classList.toggle("low", innerHeight < kLow * this.text_scale);
    root.style.setProperty("--text-scale", String(this.text_scale));
    root.style.setProperty("--least", `${this.least}px`);
    set_text(by_id("theme-name"), kNames[this.theme]);
    by_id("theme").setAttribute("aria-label", `Theme: ${kNames[this.theme]}`);
    by_id("theme").title = "Theme";
    by_id("text-size").setAttribute("aria-label", `Text size: ${Math.round(this.text * 100)} %`);
    by_id("text-size").title = `Text size: ${Math.round(this.text * 100)} %`;
    set_text(by_id("text-size-too"), `Text size: ${Math.round(this.text * 100)} %`);
    set_text(by_id("theme-too"), `Theme: ${kNames[this.theme]}`);
    set_hidden(by_id("leave"), !this.presenting);
    this.#changed();
  }

  /** The arguments of web/main.cpp's set_settings. */
  for_door() {
    const panel = getComputedStyle(document.documentElement).getPropertyValue("--panel").trim();
    const ground = [1, 3, 5].map((i) => parseInt(panel.slice(i, i + 2), 16) / 255);
    const scale = this.text_scale / (this.theme === "projector" ? kProjectorScale : 1);
    const whole = { labels: true, grounded: true }; // a picture may do without
    return { theme: this.theme, textScale: scale, leastWords: this.least, reducedMotion: this.motion.matches, ground,
      ...whole };
  }
}
