// What can stand in the stage's place: what to show in it, its work in slices between the frames, its table in words,
// its files.
import { CoverTable } from "./cover_table.js";
import { button, by_id, element, save_file, set_hidden, set_text, when_changed } from "./dom.js";
/** @import { Stage } from "./stage.js" */

const kSlice = 4; // milliseconds: beside a frame's own work
const kLongestSlice = 50; // where frames are slow
/** @type {Record<CoverFormat, string>} */
const kTypes = { csv: "text/csv", json: "application/json", svg: "image/svg+xml", png: "image/png" };
const kPercent = { role: "progressbar", "aria-valuemin": 0, "aria-valuemax": 100 };

export class CoverTools {
  #door;
  #act;
  #stage;
  #place;
  #timer = 0;
  #says = element("p", { class: "label", role: "status" });
  #measured = element("div", {});
  #bar = element("div", { class: "veil-bar cover-bar", ...kPercent, "aria-label": "Measured" }, this.#measured);
  #work = ["button primary", "button"].map((kind, i) =>
    button("", () => this.#command(this.#now?.work[i]), { class: kind }),
  );
  #other = button("", () => this.#command(this.#now?.button));
  #files = element("span", { class: "row" });
  #head = element("tr", {});
  #body = element("tbody", {});
  #choices = element("fieldset", { class: "segments" });
  #fields = /** @type {HTMLInputElement[]} */ ([]); // in these
  #saves = /** @type {HTMLButtonElement[]} */ ([]);
  #told = element("div", { class: "unseen" }, element("table", {}, element("caption", {}, "What was measured"),
    element("thead", {}, this.#head), this.#body));
  #seen = new CoverTable((command) => this.#command({ command }));
  #now = /** @type {Cover | null} */ (null);
  #sliced_at = Infinity; // milliseconds
  #section;

  /** stage: function that gives the stage, which draws frames and pictures; place: the address of what is shown.
   *  @param {Door} door @param {Act} act @param {() => Stage} stage @param {() => string} place */
  constructor(door, act, stage, place) {
    this.#door = door;
    this.#act = act;
    this.#stage = stage;
    this.#place = place;
    this.#section = element("section", { class: "cover", "aria-label": "Measurement", hidden: true }, this.#choices,
      element("div", { class: "row" }, ...this.#work, this.#other), this.#bar,
      element("div", { class: "row cover-says" }, this.#says, this.#files), this.#told);
    by_id("told").before(this.#section);
  }

  #command(/** @type {{ command: string } | undefined} */ pressed) {
    if (pressed) this.#act(() => this.#door.command(pressed.command));
  }

  /** A slice between two frames, short enough that none is late; the stage is drawn only where what it shows has
   *  changed. Where frames are slow anyway, as without a graphics card, a slice takes a quarter of a frame: at 4 ms a
   *  frame, measuring would take minutes. */
  #slice() {
    this.#timer = 0;
    this.#door.measure(Math.min(Math.max(kSlice, (performance.now() - this.#sliced_at) / 4), kLongestSlice));
    this.#sliced_at = performance.now();
    this.#show_progress(this.#door.measured());
    if (this.#door.seconds_until_due(performance.now() / 1000) <= 0) this.#stage().request();
    if (this.#door.measuring()) return this.#slice_after_frame();
    this.#sliced_at = Infinity;
    this.#act(() => {});
  }

  #slice_after_frame() {
    if (this.#timer === 0) this.#timer = requestAnimationFrame(() => setTimeout(() => this.#slice(), 0));
  }

  async #save(/** @type {CoverFormat} */ format) {
    const address = new URL(this.#place(), location.href).href;
    const { name, text } = this.#door.cover_file(format, address);
    if (format !== "png") return save_file(text, name, kTypes[format]);
    const { save_chart } = await import("./pictures.js");
    save_chart(this.#door, this.#stage(), name, address);
  }

  #show_progress = when_changed((/** @type {number} */ progress) => {
    this.#bar.setAttribute("aria-valuenow", Math.round(100 * progress));
    this.#measured.style.transform = `scaleX(${progress})`;
  });

  update(/** @type {View} */ { cover }) {
    document.documentElement.classList.toggle("covered", Boolean(cover?.shown)); // the timeline is the stage's
    set_hidden(this.#section, !cover);
    this.#seen.update(cover?.table);
    set_hidden(this.#told, Boolean(cover?.table.sorts.length));
    if (!cover) return;
    if (cover.running) this.#slice_after_frame();
    this.#show(cover);
  }

  /** Radio buttons and files, laid out once a kind of cover: what is pressed keeps the focus. */
  #lay_out = when_changed((/** @type {[string, string][]} */ choices, /** @type {CoverFormat[]} */ formats) => {
    this.#fields = choices.map(([command]) => {
      const onchange = () => this.#command({ command });
      return element("input", { type: "radio", name: "cover", value: command, onchange });
    });
    this.#choices.replaceChildren(
      element("legend", { class: "unseen" }, "Chart"),
      ...choices.map(([, words], i) => element("label", {}, this.#fields[i], words)),
    );
    this.#saves = formats.map((format) => {
      const name = format.toUpperCase();
      return button(name, () => this.#save(format), { class: "quiet", "aria-label": `Save as ${name}` });
    });
    this.#files.replaceChildren(...this.#saves);
  });

  #show = when_changed((/** @type {Cover} */ cover) => {
    this.#now = cover;
    const { choices, work, formats, any, running, progress, says, table } = cover;
    this.#lay_out(choices.map(({ command, words }) => [command, words]), formats);
    for (const [i, { chosen, enabled }] of choices.entries()) {
      const field = this.#fields[i];
      field.checked = chosen;
      field.disabled = !enabled;
      for (const label of field.labels ?? []) label.title = enabled ? "" : says;
    }
    const held = this.#work.findIndex((each) => each === document.activeElement); // what is disabled loses the focus
    for (const [i, { words, enabled }] of work.entries()) {
      set_text(this.#work[i], words);
      this.#work[i].disabled = !enabled;
    }
    if (held >= 0 && this.#work[held].disabled) this.#work[1 - held].focus();
    for (const save of this.#saves) save.disabled = !any;
    set_text(this.#other, cover.button.words);
    set_hidden(this.#bar, !running);
    this.#show_progress(progress);
    set_text(this.#says, says);
    this.#head.replaceChildren(...table.head.map((words) => element("th", { scope: "col" }, words)));
    this.#body.replaceChildren(
      ...table.rows.map(([name, ...cells]) =>
        element("tr", {},
          element("th", { scope: "row" }, name),
          ...cells.map((words) => element("td", {}, words)),
        ),
      ),
    );
  });
}
