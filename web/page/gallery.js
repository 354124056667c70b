// The gallery of hard cases, at the end of the course's page. Its list is fetched when it is opened, or when an address
// names a lesson that the course does not have.
import { by_id, element, followed_here, whole_names } from "./dom.js";
import { link_of } from "./lesson_menu.js";
/** @import { Downloads } from "./download.js" */

export class Gallery {
  #downloads;
  #choose;
  #brought = /** @type {Promise<ChapterOf<CaseEntry>[]> | null} */ (null);

  /** choose(id): called in place of loading the page anew.
   *  @param {Downloads} downloads @param {GoTo} choose */
  constructor(downloads, choose) {
    this.#downloads = downloads;
    this.#choose = choose;
    const gallery = by_id("gallery");
    gallery.hidden = false;
    gallery.addEventListener("toggle", () => gallery.open && this.#lay_out());
  }

  /** The chapters with their cases; none where they do not arrive.
   *  @returns {Promise<ChapterOf<CaseEntry>[]>} */
  #bring() {
    return (this.#brought ??= this.#downloads.text("cases.json").then(
      (text) => JSON.parse(text).chapters,
      () => ((this.#brought = null), []),
    ));
  }

  async has(/** @type {string} */ id) {
    return (await this.#bring()).some(({ lessons }) => lessons.some((one) => one.id === id));
  }

  async #lay_out() {
    const chapters = await this.#bring();
    by_id("cases").replaceChildren(...chapters.map((chapter) => this.#chapter(chapter)));
    if (chapters.length === 0)
      by_id("cases").append(element("p", {}, "The list could not be loaded. Close the gallery, then open it again."));
  }

  #chapter(/** @type {ChapterOf<CaseEntry>} */ { title, lessons }) {
    return element("section", {},
      element("h3", {}, title),
      element("ul", {}, ...lessons.map((one) => this.#case(one))),
    );
  }

  #case(/** @type {CaseEntry} */ { id, title, summary, source }) {
    const [words, address] = source.split(/ (?=https:)/);
    const to = { href: address, target: "_blank", rel: "noopener noreferrer" };
    return element("li", {},
      element("a", { href: `${link_of(id)}&step=0`, onclick: followed_here(() => this.#choose(id)) },
        element("b", {}, whole_names(title)),
        element("span", {}, summary),
      ),
      source && element("p", { class: "label" }, "Seen in ", element("a", to, words.replace(/\.$/, ""))),
    );
  }
}
