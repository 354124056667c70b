// Pictures of the stage for slides and papers, with the address of what they show: PNG, finer than the screen; SVG,
// whose words are text; and the steps as an animated GIF, which every program for slides plays by itself.
import { button, element, save_file, set_text } from "./dom.js";
import { bring_style, show_dialog } from "./sheet.js";
/** @import { Stage } from "./stage.js" */

const kWidth = 1280, kHeight = 800; // pixels, at 1x
const kPause = 80, kLastPause = 200; // hundredths of a second between the steps of an animation
const kMostSteps = 200;
const kHeader = 33; // bytes of a PNG: the signature, and the first chunk

const kTable = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let bit = 0; bit < 8; ++bit) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n;
});
const crc = (/** @type {Uint8Array} */ bytes) =>
  ~bytes.reduce((sum, byte) => kTable[(sum ^ byte) & 0xff] ^ (sum >>> 8), 0xffffffff) >>> 0;

/** The file with a text: the address of what it shows, under "Source".
 *  @param {Uint8Array} png @param {string} address */
function with_source(png, address) {
  const chunk = new TextEncoder().encode(`tEXtSource\0${address}`);
  const whole = (/** @type {number} */ value) => [24, 16, 8, 0].map((shift) => (value >>> shift) & 0xff);
  return Uint8Array.from([...png.subarray(0, kHeader), ...whole(chunk.length - 4), ...chunk, ...whole(crc(chunk)),
    ...png.subarray(kHeader)]);
}

/** An animation with the address of what it shows, as a comment before its first image.
 *  @param {Uint8Array} gif @param {string} address */
function with_comment(gif, address) {
  const text = new TextEncoder().encode(address);
  const blocks = Array.from({ length: Math.ceil(text.length / 255) }, (_, i) => text.subarray(255 * i, 255 * (i + 1)));
  const comment = [0x21, 0xfe, ...blocks.flatMap((block) => [block.length, ...block]), 0];
  const head = 13 + (gif[10] & 0x80 ? 6 << (gif[10] & 7) : 0); // with the colours of all images
  return new Blob([gif.slice(0, head), Uint8Array.from(comment), gif.slice(head)]);
}

/** search: the address of what stands here.
 *  @param {Door} door @param {Stage} stage @param {Lesson} lesson @param {string} search */
export function show_pictures(door, stage, lesson, search) {
  bring_style("hall.css");
  const address = new URL(search, location.href).href;
  const step = door.view()?.step ?? 0;
  const name = `${lesson.id}-${step}`;
  const says = element("span", { role: "status" });
  const labels = element("input", { type: "checkbox", checked: true });
  /** @type {Door["draw_cover"]} */
  const draw = (width, height, scale) => door.draw_picture(width, height, scale, labels.checked);
  const png = async (/** @type {number} */ scale) => {
    const blob = await stage.picture(kWidth, kHeight, scale, draw);
    if (!blob) return set_text(says, "The stage cannot be drawn here.");
    const bytes = with_source(new Uint8Array(await blob.arrayBuffer()), address);
    save_file(bytes, `${name}${scale > 1 ? `@${scale}x` : ""}.png`, "image/png");
  };
  const svg = () => {
    const text = door.picture_svg(kWidth, kHeight, labels.checked, address);
    if (!text) return set_text(says, "The stage cannot be drawn here.");
    save_file(text, `${name}.svg`, "image/svg+xml");
  };
  const steps = door.view()?.steps ?? 0;
  const from = element("input", { type: "number", min: 0, max: steps, value: 0, "aria-label": "First step" });
  const to = element("input", { type: "number", min: 0, max: steps, value: steps, "aria-label": "Last step" });
  const gif = async () => {
    const [first, last] = [from, to].map((field) => Math.min(Math.max(Number(field.value) || 0, 0), steps));
    if (last <= first || last - first > kMostSteps)
      return set_text(says, `An animation has 2 to ${kMostSteps} steps, the first before the last.`);
    const bytes = await animation(door, stage, first, last, (at) => set_text(says, `Step ${at}`), draw);
    door.jump(step);
    if (bytes) save_file(with_comment(bytes, address), `${lesson.id}-${first}-${last}.gif`, "image/gif");
    set_text(says, bytes ? "" : "The stage cannot be drawn here.");
  };
  const dialog = show_dialog("pictures", "Pictures of the stage",
    element("p", {}, element("label", {}, labels, " with names and measures")),
    element("p", {}, "PNG",
      ...[1, 2, 4].map((scale) => button(`${kWidth * scale} × ${kHeight * scale}`, () => png(scale)))),
    element("p", {}, "SVG, with words as text", button("Save SVG", svg)),
    steps > 0 && element("p", {}, "GIF, steps", from, "to", to, button("Animate", gif)),
    element("p", {}, says, button("Close", () => dialog.close(), { class: "button primary" })));
}

/** @param {Door} door @param {Stage} stage @param {number} first @param {number} last
 *  @param {(step: number) => void} tell @param {Door["draw_cover"]} draw */
async function animation(door, stage, first, last, tell, draw) {
  // @ts-expect-error: it is taken from its package when the page is built
  const { GIFEncoder, applyPalette, quantize } = await import("./gifenc.js");
  const encoder = GIFEncoder();
  for (let step = first; step <= last; ++step) {
    tell(step);
    door.jump(step);
    const blob = await stage.picture(kWidth, kHeight, 1, draw);
    if (!blob) return null;
    const image = await createImageBitmap(blob);
    const context = new OffscreenCanvas(image.width, image.height).getContext("2d", { willReadFrequently: true });
    context?.drawImage(image, 0, 0);
    const pixels = context?.getImageData(0, 0, image.width, image.height).data;
    if (!pixels) return null;
    const palette = quantize(pixels, 256);
    const delay = 10 * (step === last ? kLastPause : kPause);
    encoder.writeFrame(applyPalette(pixels, palette), image.width, image.height, { palette, delay });
  }
  encoder.finish();
  return encoder.bytes();
}
