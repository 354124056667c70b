// Small helpers for making and changing HTML.

export const by_id = (id) => document.getElementById(id);

/** An element with properties (on… are listeners, the rest attributes) and children (elements or text). */
export function element(tag, properties = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (value === true) made.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
}

export const capital = (word) => word[0].toUpperCase() + word.slice(1);

/** A button with its words. */
export const button = (words, onclick, properties = {}) =>
  element("button", { type: "button", class: "button", onclick, ...properties }, words);

/** A corner's name is its signs, −+−, and a p-vertex one word: a line that ended within would make two of it. */
export const whole_names = (text) => text.replace(/([+−])(?=[+−])|\b([pn]-)(?=vert)/g, "$&\u2060");

/** A link that is opened here, without loading the page anew; with a key held, the browser opens it elsewhere. */
export const followed_here = (follow) => (event) => {
  if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
  event.preventDefault();
  follow(event);
};

/** Words as they are read: their names whole, r_A with a subscript and p^T with a superscript, as on the canvas, and "5 %"
 *  on one line. */
export const spelled = (text) =>
  whole_names(text).split(/((?<!\w)[A-Za-z]_[A-Za-z0-9]{1,3}(?!\w)|(?<=[\w)])\^[A-Z](?!\w)|\d %)/).filter(Boolean).flatMap((piece) => {
    const name = /^([A-Za-z])_([A-Za-z0-9]{1,3})$/.exec(piece);
    if (name) return [name[1], element("sub", {}, name[2])];
    if (/^\d %$/.test(piece)) return [element("span", { class: "kept" }, piece)];
    return /^\^[A-Z]$/.test(piece) ? [element("sup", {}, piece[1])] : [piece];
  });

/** Writes only what differs, so that a live region does not speak twice and nothing is laid out for naught. */
export function set_text(node, text) {
  const pieces = spelled(text);
  if (node.textContent !== pieces.map((piece) => piece.textContent ?? piece).join("")) node.replaceChildren(...pieces);
}

export function set_hidden(node, hidden) {
  if (node.hidden !== hidden) node.hidden = hidden;
}

let opened = 0;

/** Makes everything anew at its next call: what it was made for is replaced. */
export const make_anew = () => void (opened += 1);

/** Calls make only when what it is made from has changed. */
export function when_changed(make) {
  let last;
  return (...from) => {
    const now = JSON.stringify([opened, from]);
    if (now === last) return;
    last = now;
    make(...from);
  };
}

/** To scatter is to have something else: by the seed that was typed, or by the next one. */
export function other_seed(field, now) {
  const typed = Number(field.value);
  return typed !== now ? typed : typed < Number.MAX_SAFE_INTEGER ? typed + 1 : 0;
}
