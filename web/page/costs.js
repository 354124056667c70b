// The charts of costs: which is shown, measured in slices between the frames; its controls, its table in words, results as files.
import { by_id, button, element, set_hidden, set_text, when_changed } from "./dom.js";

const kSlice = 4; // milliseconds: beside a frame's own work
const kFormats = { csv: "text/csv", json: "application/json" };

const trusted = (row) => `${row.time}${row.trusted ? "" : ", measured badly"}`;
const power = (number) => (number === null ? "too few points to tell" : number.toFixed(2));
const bound = ({ bound, tight, theory }) => (theory === null ? bound : `${bound}, ${tight ? "" : "at most "}${power(theory)}`);
/** How the choice calls each chart, what its file is called, and its table: a column's heading, and its words for a row. */
const kCharts = {
  accuracy: { title: "Accuracy", file: "costs", columns: [["Algorithm", (row) => row.title],
    ["Time", (row) => `${trusted(row)}${row.points < row.of ? `, on ${row.points} of ${row.of} points` : ""}`],
    ["Times the smallest", (row) => row.size || "not known"], ["On the front", (row) => (row.front ? "yes" : "no")]] },
  growth: { title: "Growth", file: "growth", columns: [["Algorithm", (row) => row.title],
    ["Points at most", (row) => `${row.points.toLocaleString("en")}${row.stopped ? `: ${row.stopped}` : ""}`], ["Time of these", trusted],
    ["Power of n", (row) => power(row.exponent)], ["In theory", bound]] },
  turn: { title: "Looseness in a turn", file: "turn", columns: [["Update", (row) => row.title], ["Least looseness", (row) => row.least],
    ["Most looseness", (row) => row.most], ["Time of one", (row) => row.time || "not measured"]] },
};

const quoted = (text) => (/[,"#\r\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text);
const field = (value) => (value === null ? "" : quoted(String(value)));
const kUntimed = { median: null, min: null, spread: null, repeats: null, batch: null, trusted: null };
const filled = (name, value) => (value === null && /^(time|overlap|update)_ns$/.test(name) ? kUntimed : value);
/** {a: {b: 1}} as [["a.b", 1]]; a time that was not taken, null, has its columns all the same */
const flat = (object, prefix = "") => Object.entries(object).flatMap(([name, value]) => {
  const own = filled(name, value);
  return own !== null && typeof own === "object" ? flat(own, `${prefix}${name}.`) : [[prefix + name, own]];
});

/** A result in JSON as the CSV that the program reads; null where the bytes are no result. Throws where they are broken. */
export function result_as_csv(bytes) {
  const start = new TextDecoder().decode(bytes.subarray(0, 40));
  if (start.startsWith("# snug table:")) return new TextDecoder().decode(bytes);
  if (!/^\s*\{\s*"table"/.test(start)) return null;
  const { table, provenance, rows } = JSON.parse(new TextDecoder().decode(bytes));
  const lines = [`# snug table: ${table}`, ...flat(provenance).map(([name, value]) => `# ${name}: ${field(value)}`)];
  const columns = flat(rows[0] ?? {}).map(([name]) => name);
  return [...lines, columns.join(","), ...rows.map((row) => {
    const values = Object.fromEntries(flat(row));
    return columns.map((name) => field(values[name] ?? null)).join(",");
  })].join("\n");
}

export class CostTools {
  #door;
  #act;
  #request;
  #timer = 0;
  #says = element("p", { class: "label", role: "status" });
  #bar = element("div", { class: "veil-bar costs-bar", role: "progressbar", "aria-label": "Measured", "aria-valuemin": 0, "aria-valuemax": 100 }, element("div", {}));
  #measure = button("Measure", () => this.#command("measure"), { class: "button primary" });
  #stop = button("Stop", () => this.#command("stop_measuring"));
  #view = button("Shape", () => this.#command("toggle_chart"));
  #files = Object.keys(kFormats).map((format) => button(format.toUpperCase(), () => this.#save(format), { class: "quiet", "aria-label": `Save as ${format.toUpperCase()}` }));
  #head = element("tr", {});
  #body = element("tbody", {});
  #choices = Object.entries(kCharts).map(([name, { title }]) => {
    const field = element("input", { type: "radio", name: "chart", value: name, onchange: () => this.#command(`show_${name}`) });
    return [name, field, element("label", {}, field, title)];
  });
  #chart = "accuracy";
  #section;

  /** request: asks for a frame of the stage. */
  constructor(door, act, request) {
    this.#door = door;
    this.#act = act;
    this.#request = request;
    this.#section = element("section", { class: "costs", "aria-label": "Measurement", hidden: true },
      element("fieldset", { class: "segments" }, element("legend", { class: "unseen" }, "Chart"), ...this.#choices.map(([, , label]) => label)),
      element("div", { class: "row" }, this.#measure, this.#stop, this.#view), this.#bar,
      element("div", { class: "row costs-says" }, this.#says, ...this.#files),
      element("div", { class: "unseen" }, element("table", {}, element("caption", {}, "What was measured"),
        element("thead", {}, this.#head), this.#body)));
    by_id("told").before(this.#section);
  }

  open(lesson) {
    set_hidden(this.#section, !lesson.chart);
  }

  #command(name) {
    this.#act(() => this.#door.command(name));
  }

  /** A slice between two frames of the page, so that none is late; the stage is drawn only where the chart has changed. */
  #work() {
    this.#timer = 0;
    this.#door.measure(kSlice);
    this.#show_progress(this.#door.measured());
    if (this.#door.seconds_until_due(performance.now() / 1000) <= 0) this.#request();
    if (this.#door.measuring()) this.#work_after_frame();
    else this.#act(() => {});
  }

  #work_after_frame() {
    this.#timer ||= requestAnimationFrame(() => setTimeout(() => this.#work(), 0));
  }

  #save(format) {
    const blob = new Blob([this.#door.costs_file(format)], { type: kFormats[format] });
    const url = URL.createObjectURL(blob);
    element("a", { href: url, download: `snug-${kCharts[this.#chart].file}.${format}` }).click();
    setTimeout(() => URL.revokeObjectURL(url), 1000);
  }

  #show_progress = when_changed((progress) => {
    this.#bar.setAttribute("aria-valuenow", Math.round(100 * progress));
    this.#bar.firstElementChild.style.transform = `scaleX(${progress})`;
  });

  update({ costs }) {
    if (!costs) return;
    if (costs.running) this.#work_after_frame();
    this.#show(costs);
  }

  #show = when_changed(({ chart, shown, running, progress, ready, rows, says }) => {
    this.#chart = chart;
    for (const [name, field, label] of this.#choices) {
      field.checked = name === chart;
      field.disabled = !ready && name !== "accuracy";
      label.title = field.disabled ? says : "";
    }
    const [before, after] = running ? [this.#measure, this.#stop] : [this.#stop, this.#measure];
    const held = document.activeElement === before; // what is disabled loses the focus
    this.#measure.disabled = running || !ready;
    this.#stop.disabled = !running;
    if (held) after.focus();
    for (const file of this.#files) file.disabled = rows.length === 0;
    set_text(this.#view, shown ? "Shape" : "Chart");
    set_hidden(this.#bar, !running);
    this.#show_progress(progress);
    set_text(this.#says, says);
    const { columns } = kCharts[chart];
    this.#head.replaceChildren(...columns.map(([heading]) => element("th", { scope: "col" }, heading)));
    this.#body.replaceChildren(...rows.map((row) => element("tr", {}, ...columns.map(([, words], i) =>
      (i === 0 ? element("th", { scope: "row" }, words(row)) : element("td", {}, words(row)))))));
  });
}
