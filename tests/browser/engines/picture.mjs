// A browser's screenshot as pixels. The page is not asked to decode it: its content-security policy need not let it.
import { inflateSync } from "node:zlib";

/** PNG (W3C, third edition) of 8 bits a channel, not interlaced, RGB or RGBA. at(x, y): the pixel as one number. */
export function read_png(bytes) {
  const [width, height, bits, kind, interlaced] = [
    bytes.readUInt32BE(16),
    bytes.readUInt32BE(20),
    bytes[24],
    bytes[25],
    bytes[28],
  ];
  const wide = { 2: 3, 6: 4 }[kind];
  if (bits !== 8 || !wide || interlaced) throw new Error(`a picture of kind ${kind} with ${bits} bits`);
  const packed = [];
  for (let at = 8; at < bytes.length; at += 12 + bytes.readUInt32BE(at))
    if (bytes.toString("latin1", at + 4, at + 8) === "IDAT")
      packed.push(bytes.subarray(at + 8, at + 8 + bytes.readUInt32BE(at)));
  const rows = unfiltered(inflateSync(Buffer.concat(packed)), width * wide, height, wide);
  return { width, height, at: (x, y) => {
    const i = (y * width + x) * wide;
    return rows[i] << 16 | rows[i + 1] << 8 | rows[i + 2];
  } };
}

/** Each row begins with the number of its filter, which says what its bytes are differences to. */
function unfiltered(data, stride, height, wide) {
  const rows = Buffer.alloc(stride * height);
  const none = Buffer.alloc(stride);
  for (let y = 0, up = none; y < height; ++y) {
    const from = y * (stride + 1) + 1, row = rows.subarray(y * stride, (y + 1) * stride);
    const filter = data[from - 1];
    for (let i = 0; i < stride; ++i) {
      const left = i < wide ? 0 : row[i - wide];
      const guess =
        filter === 0
          ? 0
          : filter === 1
            ? left
            : filter === 2
              ? up[i]
              : filter === 3
                ? (left + up[i]) >> 1
                : paeth(left, up[i], i < wide ? 0 : up[i - wide]);
      row[i] = data[from + i] + guess;
    }
    up = row;
  }
  return rows;
}

function paeth(left, up, corner) {
  const a = Math.abs(up - corner), b = Math.abs(left - corner), c = Math.abs(left + up - 2 * corner);
  return a <= b && a <= c ? left : b <= c ? up : corner;
}

/** Of a part: its colours, each with how often it is there, the most frequent first. part: {x, y, width, height}. */
export function colors_of(picture, { x, y, width, height }) {
  const counts = new Map();
  for (let row = Math.ceil(y); row < Math.min(y + height, picture.height); ++row)
    for (let column = Math.ceil(x); column < Math.min(x + width, picture.width); ++column) {
      const color = picture.at(column, row);
      counts.set(color, (counts.get(color) ?? 0) + 1);
    }
  return [...counts].sort((a, b) => b[1] - a[1]);
}

/** How many pixels of a part are not alike in both. */
export function difference(one, other, { x, y, width, height }) {
  let count = 0;
  for (let row = Math.ceil(y); row < Math.min(y + height, one.height, other.height); ++row)
    for (let column = Math.ceil(x); column < Math.min(x + width, one.width, other.width); ++column)
      if (one.at(column, row) !== other.at(column, row)) count += 1;
  return count;
}
