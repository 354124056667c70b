// Pictures of the stage, or of the chart in its place, for slides and papers, with the address of what they show: PNG,
// finer than the screen and perhaps without a ground; SVG, whose words are text; and the steps as an animated GIF,
// which every program for slides plays by itself.
import { button, element, save_file, set_text } from "./dom.js";
import { cut_out, with_comment, with_source } from "./picture_bytes.js";
import { bring_style, show_dialog } from "./sheet.js";
/** @import { Settings } from "./settings.js"
 *  @import { Stage } from "./stage.js"
 *  @typedef {Door["draw_picture"]} Draw
 *  @typedef {Uint8ClampedArray<ArrayBuffer>} Pixels four bytes for each */

const kWidth = 1280, kHeight = 800; // pixels, at 1x
const kPause = 80, kLastPause = 200; // hundredths of a second between the steps of an animation
const kMostSteps = 200;
const kChartScale = 2; // of the PNG that a chart's own button saves

const png_of = (/** @type {HTMLCanvasElement} */ canvas) =>
  new Promise((/** @type {(blob: Blob | null) => void} */ done) => canvas.toBlob(done, "image/png"));

/** @param {HTMLCanvasElement} canvas @returns {Pixels} */
function pixels_of(canvas) {
  const context = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error("no context");
  context.drawImage(canvas, 0, 0);
  return /** @type {Pixels} */ (context.getImageData(0, 0, canvas.width, canvas.height).data);
}

/** @param {Blob | null} blob @param {string} name @param {string} address */
async function save_png(blob, name, address) {
  if (blob) save_file(with_source(new Uint8Array(await blob.arrayBuffer()), address), name, "image/png");
  return blob !== null;
}

/** The chart that stands in the stage's place, as its own button saves it.
 *  @param {Door} door @param {Stage} stage @param {string} name @param {string} address */
export async function save_chart(door, stage, name, address) {
  /** @type {Draw} */
  const draw = (...size) => door.draw_cover(...size);
  await save_png(await stage.picture(kWidth, kHeight, kChartScale, draw, png_of), name, address);
}

/** search: the address of what stands here.
 *  @param {Door} door @param {Stage} stage @param {Lesson} lesson @param {Settings} settings @param {string} search */
export function show_pictures(door, stage, lesson, settings, search) {
  bring_style("hall.css");
  const address = new URL(search, location.href).href;
  const { step, steps, cover } = /** @type {View} */ (door.view());
  const chart = Boolean(cover?.shown && cover.formats.includes("svg"));
  const name = chart ? door.cover_file("png", address).name.replace(".png", "") : `${lesson.id}-${step}`;
  const says = element("span", { role: "status" });
  const refused = chart ? "The chart is empty: nothing has been measured yet." : "The stage cannot be drawn here.";
  const labels = element("input", { type: "checkbox", checked: true }), clear = element("input", { type: "checkbox" });
  const look = element("select", { "aria-label": "Colours" },
    ...[["", "as on this page"], ["light", "light"], ["dark", "dark"]].map(([value, words]) =>
      element("option", { value }, words)));
  /** @type {Draw} */
  const draw = (...size) => (chart ? Boolean(cover?.any) && door.draw_cover(...size) : door.draw_picture(...size));
  /** Does it in the colours that are chosen. ground: behind a picture that is clear.
   *  @template T @param {() => T} what @param {boolean} grounded @param {number} ground @returns {T} */
  const in_look = (what, grounded, ground = 1) => {
    const own = settings.for_door();
    const theme = look.value || own.theme, chosen = { labels: labels.checked, grounded, leastWords: 0 };
    door.set_settings({ ...own, theme, ...chosen, ground: grounded ? own.ground : [ground, ground, ground] });
    try {
      return what();
    } finally {
      door.set_settings(own);
    }
  };
  /** @template T @param {number} scale @param {(canvas: HTMLCanvasElement) => T} take */
  const picture = (scale, take, grounded = true, ground = 1) =>
    in_look(() => stage.picture(kWidth, kHeight, scale, draw, take), grounded, ground);
  const clear_png = async (/** @type {number} */ scale) => {
    const [black, white] = [0, 1].map((ground) => picture(scale, pixels_of, false, ground));
    if (!black || !white) return null;
    const canvas = new OffscreenCanvas(kWidth * scale, kHeight * scale);
    canvas.getContext("2d")?.putImageData(new ImageData(cut_out(black, white), canvas.width), 0, 0);
    return canvas.convertToBlob({ type: "image/png" });
  };
  const png = async (/** @type {number} */ scale) => {
    const blob = await (clear.checked ? clear_png(scale) : picture(scale, png_of));
    const saved = await save_png(blob, `${name}${scale > 1 ? `@${scale}x` : ""}.png`, address);
    set_text(says, saved ? "" : refused);
  };
  const svg = () => {
    const text = in_look(() => {
      if (!chart) return door.picture_svg(kWidth, kHeight, address);
      stage.picture(kWidth, kHeight, 1, draw, () => {}); // in its colours
      return door.cover_file("svg", address).text;
    }, !clear.checked);
    if (text) save_file(text, `${name}.svg`, "image/svg+xml");
    set_text(says, text ? "" : refused);
  };
  const from = element("input", { type: "number", min: 0, max: steps, value: 0, "aria-label": "First step" });
  const to = element("input", { type: "number", min: 0, max: steps, value: steps, "aria-label": "Last step" });
  const gif = async () => {
    const [first, last] = [from, to].map((field) => Math.min(Math.max(Number(field.value) || 0, 0), steps));
    if (last <= first || last - first > kMostSteps)
      return set_text(says, `An animation has 2 to ${kMostSteps} steps, the first before the last.`);
    const bytes = await animation(door, first, last, (at) => set_text(says, `Step ${at}`), () => picture(1, pixels_of));
    door.jump(step);
    if (bytes) save_file(with_comment(bytes, address), `${lesson.id}-${first}-${last}.gif`, "image/gif");
    set_text(says, bytes ? "" : refused);
  };
  const dialog = show_dialog("pictures", chart ? "Pictures of the chart" : "Pictures of the stage",
    element("p", {}, element("label", {}, "Colours ", look)),
    !chart && element("p", {}, element("label", {}, labels, " with names and measures")),
    element("p", {}, element("label", {}, clear, " transparent, as PNG and SVG")),
    element("p", {}, "PNG",
      ...[1, 2, 4].map((scale) => button(`${kWidth * scale} × ${kHeight * scale}`, () => png(scale)))),
    element("p", {}, "SVG, with words as text", button("Save SVG", svg)),
    !chart && steps > 0 && element("p", {}, "GIF, steps", from, element("span", {}, "to ", to), button("Animate", gif)),
    element("p", {}, says, button("Close", () => dialog.close(), { class: "button primary" })));
}

/** @param {Door} door @param {number} first @param {number} last @param {(step: number) => void} tell
 *  @param {() => Pixels | null} draw */
async function animation(door, first, last, tell, draw) {
  // @ts-expect-error: it is taken from its package when the page is built
  const { GIFEncoder, applyPalette, quantize } = await import("./gifenc.js");
  const encoder = GIFEncoder();
  for (let step = first; step <= last; ++step) {
    tell(step);
    door.jump(step);
    const pixels = draw();
    if (!pixels) return null;
    const palette = quantize(pixels, 256);
    const delay = 10 * (step === last ? kLastPause : kPause);
    encoder.writeFrame(applyPalette(pixels, palette), kWidth, kHeight, { palette, delay });
    await new Promise((done) => setTimeout(done)); // the page answers meanwhile
  }
  encoder.finish();
  return encoder.bytes();
}
