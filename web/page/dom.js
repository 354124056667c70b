// Small helpers for making and changing HTML.

/** An element that index.html or another module has laid out.
 *  @template {string} K @param {K} id
 *  @returns {K extends keyof PageElements ? PageElements[K] : HTMLElement} */
export const by_id = (id) => /** @type {any} */ (document.getElementById(id));

/** An element with properties (on… are listeners, the rest attributes) and children: elements or text. What is
 *  null, undefined or false is left out.
 *  @template {keyof HTMLElementTagNameMap} K @param {K} tag
 *  @param {Record<string, any>} properties @param {...(Node | string | null | undefined | false)} children */
export function element(tag, properties = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (value === true) made.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) made.setAttribute(name, value);
  }
  made.append(...children.filter((child) => child !== null && child !== undefined && child !== false));
  return made;
}

/** What takes keys to write with. */
export const kWrites = "input, select, textarea, [contenteditable]";

/** Whether an event's target is in an element that the selector matches.
 *  @param {EventTarget | null} target @param {string} selector */
export const is_within = (target, selector) => target instanceof Element && target.closest(selector) !== null;

export const capital = (/** @type {string} */ word) => word[0].toUpperCase() + word.slice(1);

/** A button with its words.
 *  @param {string} words @param {((event: MouseEvent) => void) | null} onclick */
export const button = (words, onclick, properties = {}) =>
  element("button", { type: "button", class: "button", onclick, ...properties }, words);

/** What a button listens to that lights something up while it is pointed at or has the focus.
 *  @param {() => void} on @param {() => void} off */
export const lights = (on, off) => ({
  onpointerenter: on,
  onpointerleave: off,
  onfocus: on,
  onblur: off,
  oncontextmenu: (/** @type {Event} */ event) => event.preventDefault(), // which a long press would open
});

/** A corner's name is its signs, −+−, and a p-vertex one word: a line that ended within would make two of it. */
export const whole_names = (/** @type {string} */ text) =>
  text.replace(/([+−])(?=[+−])|\b([pn]-)(?=vert)/g, "$&\u2060");

/** The name of an axis stays on one line: A x, B y, A x × B y. */
export const whole_axes = (/** @type {string} */ text) =>
  text.replace(/\b([AB]) ([xyz])\b(?: × ([AB]) ([xyz])\b)?/g, (name) => name.replaceAll(" ", "\u00a0"));

/** A link that is opened here, without loading the page anew; with a key held, the browser opens it elsewhere. */
export const followed_here = (/** @type {() => void} */ follow) => (/** @type {MouseEvent} */ event) => {
  if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
  event.preventDefault();
  follow();
};

/** Words as they are read: their names whole, r_A with a subscript and p^T with a superscript, as on the canvas, and
 *  "5 %" on one line. */
export const spelled = (/** @type {string} */ text) =>
  whole_names(text)
    .split(/((?<!\w)[A-Za-z]_[A-Za-z0-9]{1,3}(?!\w)|(?<=[\w)])\^[A-Z](?!\w)|\d %)/)
    .filter(Boolean)
    .flatMap((piece) => {
      const name = /^([A-Za-z])_([A-Za-z0-9]{1,3})$/.exec(piece);
      if (name) return [name[1], element("sub", {}, name[2])];
      if (/^\d %$/.test(piece)) return [element("span", { class: "kept" }, piece)];
      return /^\^[A-Z]$/.test(piece) ? [element("sup", {}, piece[1])] : [piece];
    });

const text_in = (/** @type {string | Node} */ piece) => (typeof piece === "string" ? piece : piece.textContent);

/** Writes only what differs, so that a live region does not speak twice and nothing is laid out for naught.
 *  @param {Element} node @param {string} text */
export function set_text(node, text) {
  const pieces = spelled(text);
  if (node.textContent !== pieces.map(text_in).join("")) node.replaceChildren(...pieces);
}

/** @param {HTMLElement} node @param {boolean} hidden */
export function set_hidden(node, hidden) {
  if (node.hidden !== hidden) node.hidden = hidden;
}

let opened = 0;

/** Makes everything anew at its next call: what it was made for is replaced. */
export const make_anew = () => void (opened += 1);

/** Calls make only when what it is made from has changed.
 *  @template {any[]} From @param {(...from: From) => void} make @returns {(...from: From) => void} */
export function when_changed(make) {
  let last = "";
  return (...from) => {
    const now = JSON.stringify([opened, from]);
    if (now === last) return;
    last = now;
    make(...from);
  };
}

/** To scatter is to have something else: by the seed that was typed, or by the next one.
 *  @param {HTMLInputElement} field @param {number} now */
export function other_seed(field, now) {
  const typed = Number(field.value);
  return typed !== now ? typed : typed < Number.MAX_SAFE_INTEGER ? typed + 1 : 0;
}

/** Saves a file as the browser does.
 *  @param {BlobPart} what @param {string} name */
export function save_file(what, name, type = "application/json") {
  const href = URL.createObjectURL(new Blob([what], { type }));
  element("a", { href, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(href), 10_000);
}
