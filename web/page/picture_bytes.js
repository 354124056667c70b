// The bytes of pictures: the address of what they show, and the opacity of one without a ground.

const kHeader = 33; // bytes of a PNG: the signature, and the first chunk

const kTable = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let bit = 0; bit < 8; ++bit) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n;
});
const crc = (/** @type {Uint8Array} */ bytes) =>
  ~bytes.reduce((sum, byte) => kTable[(sum ^ byte) & 0xff] ^ (sum >>> 8), 0xffffffff) >>> 0;

/** The file with a text: the address of what it shows, under "Source".
 *  @param {Uint8Array} png @param {string} address */
export function with_source(png, address) {
  const chunk = new TextEncoder().encode(`tEXtSource\0${address}`);
  const whole = (/** @type {number} */ value) => [24, 16, 8, 0].map((shift) => (value >>> shift) & 0xff);
  return Uint8Array.from([...png.subarray(0, kHeader), ...whole(chunk.length - 4), ...chunk, ...whole(crc(chunk)),
    ...png.subarray(kHeader)]);
}

/** An animation with the address of what it shows, as a comment before its first image.
 *  @param {Uint8Array} gif @param {string} address */
export function with_comment(gif, address) {
  const text = new TextEncoder().encode(address);
  const blocks = Array.from({ length: Math.ceil(text.length / 255) }, (_, i) => text.subarray(255 * i, 255 * (i + 1)));
  const comment = [0x21, 0xfe, ...blocks.flatMap((block) => [block.length, ...block]), 0];
  const head = 13 + (gif[10] & 0x80 ? 6 << (gif[10] & 7) : 0); // with the colours of all images
  return new Blob([gif.slice(0, head), Uint8Array.from(comment), gif.slice(head)]);
}

/** What was drawn without a ground, from how it looks over black and over white: where these differ it is clear. The
 *  canvas has no opacity of its own.
 *  @param {Uint8ClampedArray<ArrayBuffer>} black @param {Uint8ClampedArray<ArrayBuffer>} white four bytes a pixel */
export function cut_out(black, white) {
  for (let i = 0; i < black.length; i += 4) {
    const alpha = 255 - Math.max(0, white[i + 1] - black[i + 1]);
    for (let channel = i; alpha > 0 && channel < i + 3; ++channel) black[channel] = black[channel] * 255 / alpha;
    black[i + 3] = alpha;
  }
  return black;
}
