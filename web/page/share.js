// The dialog that says how to hand on what stands here: its address, and what to copy into a page of one's own.
import { button, element, set_text } from "./dom.js";
import { bring_style, show_dialog } from "./sheet.js";

const kBroad = 800, kHigh = 600; // pixels
const kLine = 36, kMostLines = 6; // letters in one

const quoted = (/** @type {string} */ text) => text.replaceAll("&", "&amp;").replaceAll('"', "&quot;");

/** @param {string} address @param {string} title */
const snippet_of = (address, title) => `<iframe src="${quoted(address)}" title="${quoted(title)}" ` +
  `width="${kBroad}" height="${kHigh}" style="border: 0" loading="lazy"></iframe>`;

async function copy(/** @type {string} */ text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false; // the browser does not allow it: the text is selected, for a key to copy it
  }
}

/** An address that shows a figure. */
export const framed = (/** @type {string} */ address) => address.replace(/#|$/, "&embed=1$&");

/** A text to copy, under its label.
 *  @param {string} label @param {string} text @param {string} says */
function row(label, text, says) {
  const rows = Math.min(Math.ceil(text.length / kLine), kMostLines);
  const field = element("textarea", { readonly: true, rows, spellcheck: "false", "aria-label": label });
  field.value = text;
  const take = button("Copy", async () => {
    field.select();
    set_text(take, (await copy(text)) ? "Copied" : "Press Ctrl+C");
  });
  const note = element("p", { class: "label", role: "status" }, says);
  return element("section", {}, element("h3", {}, label), element("div", {}, field, take), note);
}

/** The address is copied at once, unless something is lost by it: then one is told, and copies it if that will do.
 *  embedded: the address of it in a frame. whole: whether it opens what stands here. code, pictures: shows them.
 *  @param {{ title: string, address: string, whole: boolean, embedded: string, is_exercise: boolean, code: () => void,
 *    pictures: (() => void) | null }} of */
export function show_share({ title, address, whole, embedded, is_exercise, code, pictures }) {
  const lost = "It opens this lesson without what was edited here, which is too much for an address.";
  const leads = whole ? "It opens what you see." : lost;
  bring_style("share.css");
  const says = is_exercise
    ? "Each reader decides on an instance of their own. A page that collects marks gets them (SPLICE)."
    : "A figure that is dragged and stepped in place. It needs 400 by 300 pixels at least.";
  const dialog = show_dialog("share", "Share",
    row("Address", address, leads),
    row("To put it into a page of yours", snippet_of(embedded, title), says),
    element("p", { class: "buttons" },
      !is_exercise && button("As a code to scan", () => (dialog.close(), code())),
      pictures && button("As a picture", () => (dialog.close(), pictures())),
      button("Close", () => dialog.close(), { class: "button primary" })));
  dialog.addEventListener("click", ({ target }) => target === dialog && dialog.close()); // beside it
  if (whole) copy(address).then((copied) => copied && dialog.isConnected &&
    set_text(dialog.querySelector(".label") ?? dialog, `The address is copied. ${leads}`));
  dialog.querySelector("button")?.focus();
}
