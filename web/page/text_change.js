// How one text differs from another: what was put in place of one stretch of it. An address has room for that.

/** "where-how many letters go-what comes"; "" where nothing has changed.
 *  @param {string} from @param {string} to */
export function change_of(from, to) {
  if (from === to) return "";
  const most = Math.min(from.length, to.length);
  let at = 0, end = 0;
  while (at < most && from[at] === to[at]) at += 1;
  while (end < most - at && from[from.length - 1 - end] === to[to.length - 1 - end]) end += 1;
  return `${at}-${from.length - at - end}-${to.slice(at, to.length - end)}`;
}

/** The text with such a change; null where it says no change of that text.
 *  @param {string} from @param {string} change */
export function changed(from, change) {
  const [, at, gone, comes] = /^(\d+)-(\d+)-([^]*)$/.exec(change) ?? [];
  if (at === undefined || Number(at) + Number(gone) > from.length) return null;
  return from.slice(0, Number(at)) + comes + from.slice(Number(at) + Number(gone));
}
