// A state to take along: its address as a code that a phone scans, large enough for the last row, and four letters by
// which one sees that both show the same.
import { element } from "./dom.js";
import { lecture } from "./lecture.js";
import { notice } from "./messages.js";
import { bring_style } from "./sheet.js";

const kSvg = "http://www.w3.org/2000/svg";
const kLost = " It opens this lesson without what was edited here, which is too much for a code.";

/** @param {QrCode} code */
function picture({ size, quiet, dark }) {
  const across = size + 2 * quiet;
  const svg = document.createElementNS(kSvg, "svg");
  svg.setAttribute("viewBox", `0 0 ${across} ${across}`);
  svg.setAttribute("shape-rendering", "crispEdges");
  svg.setAttribute("role", "img");
  svg.setAttribute("aria-label", "A code to scan");
  const path = document.createElementNS(kSvg, "path");
  const modules = [...dark].flatMap((one, i) =>
    one === "1" ? [`M${quiet + (i % size)} ${quiet + Math.floor(i / size)}h1v1h-1z`] : []);
  path.setAttribute("d", modules.join(""));
  svg.append(path);
  return svg;
}

/** Any key or press puts the code away.
 *  @param {string} whole the address of what stands here @param {string} bare without what was edited
 *  @param {string} trace */
export async function show_code(whole, bare, trace) {
  if (document.querySelector(".qr")) return;
  bring_style("hall.css");
  const program = await lecture();
  const letters = program.fingerprint(trace);
  const address = (/** @type {string} */ search) => new URL(search, location.href).href;
  const same = whole.includes("#") ? null : program.qr_code(address(`${whole}&mark=${letters}`));
  const code = same ?? program.qr_code(address(bare));
  if (!code) return notice("The page’s own address is too long for a code.");
  const says = address(same ? whole : bare) + (same ? "" : kLost);
  const compared = same ? [element("p", { class: "letters" }, letters)] : []; // else a phone shows another state
  const how = { class: "qr", role: "dialog", "aria-label": "This state, to take along", tabindex: "-1" };
  const sheet = element("div", how,
    picture(code), ...compared, element("p", { class: "says" }, says));
  const before = document.activeElement;
  const away = (/** @type {Event} */ event) => {
    if (event instanceof KeyboardEvent && ["Shift", "Control", "Alt", "Meta"].includes(event.key)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    removeEventListener("keydown", away, { capture: true });
    sheet.remove();
    if (before instanceof HTMLElement) before.focus({ preventScroll: true });
  };
  addEventListener("keydown", away, { capture: true });
  sheet.addEventListener("pointerdown", away);
  document.body.append(sheet);
  sheet.focus({ preventScroll: true });
}

/** Says whether this page shows what the screen does that its address was scanned from.
 *  @param {string} mark its letters @param {string} trace */
export async function compare(mark, trace) {
  const letters = (await lecture()).fingerprint(trace);
  if (letters === mark) return notice(`This is the state on the screen: ${letters}.`, "told");
  notice(`This is not the state on the screen: here ${letters}, there ${mark.slice(0, 8)}.`);
}
