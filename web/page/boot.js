// Runs before anything else has loaded. It is a separate, classic script, because the page's policy forbids inline
// ones.

// A package opens what it is of: some courses' sites drop what an address asks for.
const said_in = (/** @type {string} */ name) =>
  document.querySelector(`meta[name="snug-${name}"]`)?.getAttribute("content") ?? "";
const opens = said_in("opens");
if (opens && !/[?&](lesson|exercise)=/.test(location.search)) history.replaceState(null, "", opens);
const names = said_in("names"); // how a package calls the files: "plain", or "inside" of this one

// The course is shown at once; a lesson stays under the veil until the program is loaded.
const given = new URLSearchParams(location.search);
const asked = given.get("lesson") ?? given.get("exercise");
const to_lesson = asked?.startsWith("write:") ? null : asked; // what is written needs no stage at first
document.documentElement.dataset.view = to_lesson === null ? "course" : "lesson";

/** @param {string} href @param {string} rel @param {string} as */
function ask_for(href, rel, as) {
  const link = document.createElement("link");
  document.head.append(Object.assign(link, { rel, as, href: window.snug.at(href), crossOrigin: "anonymous" }));
}

// Scripts and tests can use this at once; main.js fills it in.
window.snug = {
  ready: new Promise((resolve) => addEventListener("snug-ready", resolve, { once: true })),
  restart: () => window.snug.ready,
  open_text: () => "the page is not ready",
  state: () => null,
  exercise: () => null,
  result: () => "",
  saved: () => "nowhere",
  handles: () => [],
  frameTimes: () => [],
  opens,
  // Servers of courses refuse files of endings that they do not know.
  at: (path) =>
    names === "plain" ? path.replace(/\.(wasm|ply|otf|ttf)$/, "$&.bin").replace(/\.toml$/, "$&.txt") : path,
};

// The largest files are asked for before the page's modules have arrived.
if (to_lesson !== null && names !== "inside") {
  ask_for("snug.wasm", "preload", "fetch");
  ask_for("snug.js", "modulepreload", "script");
  const mono = ["Regular", "Bold"].map((weight) => `fonts/JetBrainsMono-${weight}.ttf`);
  for (const file of ["sizes.json", "formulas.json", ...mono]) ask_for(file, "preload", "fetch");
}

// If the page's own files do not arrive, it must still say so. A script's load error does not bubble, so it is
// captured.
addEventListener("error", ({ target }) => {
  if (!(target instanceof HTMLScriptElement)) return;
  document.documentElement.dataset.view = "lesson";
  const [text, bar, again] = /** @type {HTMLElement[]} */ (
    ["veil-text", "veil-bar", "veil-retry"].map((id) => document.getElementById(id))
  );
  text.textContent = "Some of the page’s own files could not be loaded. Check the connection, then try again.";
  bar.hidden = true;
  again.hidden = false;
  again.onclick = () => location.reload();
}, { capture: true });
