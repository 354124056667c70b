// What a sheet over the page needs: its style, loaded once, and a dialog that goes away when it is closed.
import { element } from "./dom.js";

/** Resolves once the style sheet is there, or has failed. @param {string} href */
export async function bring_style(href) {
  if (document.querySelector(`link[href="${href}"]`)) return;
  const link = element("link", { rel: "stylesheet", href });
  await new Promise((done) => {
    link.onload = link.onerror = done;
    document.head.append(link);
  });
}

/** @param {string} kind its class @param {string} title @param {...(Node | false | null)} children */
export function show_dialog(kind, title, ...children) {
  const heading = element("h2", { id: `${kind}-title`, tabindex: -1 }, title);
  const dialog = element("dialog", { class: kind, "aria-labelledby": `${kind}-title` }, heading, ...children);
  dialog.addEventListener("close", () => dialog.remove());
  dialog.addEventListener("keydown", (event) => event.stopPropagation()); // the stage's keys do nothing meanwhile
  document.body.append(dialog);
  dialog.showModal();
  return dialog;
}
