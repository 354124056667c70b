// Readers under limits: small files that promise much, endless ones, and lines without an end are refused with one line,
// in little memory.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { closeSync, existsSync, openSync, writeSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { folder, program, write } from "./support.mjs";

const mebibyte = 1 << 20;

/** Exit 2 with one line, in so much address space; the program alone takes a tenth of the least that is asked here. */
function refused_within(mebibytes, args, says, input = "ignore") {
  const limited = `ulimit -v ${mebibytes * 1024} && exec "$0" "$@"`;
  const done = spawnSync("bash", ["-c", limited, program, ...args], { encoding: "utf8", cwd: folder, timeout: 120_000, stdio: [input, "pipe", "pipe"] });
  assert.equal(done.error, undefined, "it came to an end");
  assert.equal(done.stdout, "");
  assert.match(done.stderr, /^snug: [^\n]+\n$/);
  assert.match(done.stderr, says);
  assert.equal(done.status, 2);
}
const fit = (file) => ["fit", "--volume", "sphere", "--algorithm", "welzl", file];

/** A file of one text, many times over. */
function write_many(name, before, text, times) {
  const file = openSync(join(folder, name), "w");
  writeSync(file, before);
  const block = text.repeat(1024);
  for (let i = 0; i < times / 1024; ++i) writeSync(file, block);
  closeSync(file);
  return name;
}

const ply = (format, header) => `ply\nformat ${format} 1.0\n${header}end_header\n`;
const xyz = "property float x\nproperty float y\nproperty float z\n";

test("headers that promise a billion take no memory for it", () => {
  const promises = [
    ["ascii.ply", ply("ascii", `element vertex 1000000000\n${xyz}`)],
    ["little.ply", ply("binary_little_endian", `element vertex 1000000000\n${xyz}`)],
    ["big.ply", ply("binary_big_endian", `element vertex 4000000000\n${xyz}`)],
    ["most.ply", ply("binary_little_endian", `element vertex 18446744073709551615\n${xyz}`)],
    ["faces.ply", ply("ascii", `element vertex 1\n${xyz}element face 1000000000\nproperty list uchar int vertex_indices\n`) + "0 0 0\n"],
    ["list.ply", ply("binary_little_endian", "element vertex 1\nproperty list uint float x\n") + "\xff\xff\xff\xff"],
    ["long.stl", Buffer.concat([Buffer.alloc(80), Buffer.from([0xff, 0xff, 0xff, 0xff])])],
  ];
  for (const [name, bytes] of promises) refused_within(100, fit(write(name, bytes)), new RegExp(name));
});

test("lines and nests without an end are refused", () => {
  refused_within(400, fit(write_many("digits.xyz", "", "7", 16 * mebibyte)), /digits\.xyz/);
  refused_within(400, fit(write_many("words.obj", "v ", "x ", 8 * mebibyte)), /words\.obj/);
  refused_within(400, fit(write_many("header.ply", "ply\n", "comment and no end\n", mebibyte)), /header\.ply/);
  refused_within(800, ["overlap", write_many("nest.jsonl", "", "[", mebibyte)], /nest\.jsonl:1/);
  refused_within(800, ["cull", write_many("object.jsonl", "", '{"a":', mebibyte)], /object\.jsonl:1/);
});

test("lessons and courses that nest without an end, or are endless, are refused", () => {
  const check = (name, before, text, times, says) => refused_within(400, ["lesson", "check", write_many(name, before, text, times)], says);
  check("long.toml", "version = 2\nx = ", "[", mebibyte, /long\.toml:1.*at most/);
  check("arrays.toml", "version = 2\nx = ", "[", 200 * 1024, /arrays\.toml:2/);
  check("tables.toml", "version = 2\nx = ", "{a=", 80 * 1024, /tables\.toml:2/);
  check("dots.toml", "version = 2\na", ".a", 100 * 1024, /dots\.toml:2:1: a key has more than 64 dots/);
  check("heads.toml", "version = 2\n[a", ".a", 100 * 1024, /heads\.toml:2:1: a key has more than 64 dots/);
  check("course.toml", "a", ".a", 100 * 1024, /course\.toml:1: a key has more than 64 dots/);
});

test("tables of results that nest, or have a line without an end, are refused", () => {
  const against = ["cost", "--generate", "cube:8", "--algorithms", "sphere:ritter", "--repeat", "1", "--against"];
  refused_within(800, [...against, write_many("rows.json", '{"table":"costs","rows":', "[", mebibyte)], /rows\.json/);
  refused_within(800, [...against, write_many("objects.json", "", '{"table":', mebibyte)], /objects\.json/);
  refused_within(800, [...against, write_many("fields.csv", "# snug table: costs\n", "a,", mebibyte)], /fields\.csv:2/);
  refused_within(800, [...against, write_many("quoted.csv", '# snug table: costs\n"', "a,\n", mebibyte)], /quoted\.csv/);
});

test("numbers that promise a billion points or frames are refused", () => {
  refused_within(400, ["cost", "--generate", "cube:1000000000"], /from 1 to/);
  refused_within(400, ["scene", "scene-broad", "--frames", "1000000000"], /from 1 to/);
});

test("files without an end are read up to half a gibibyte", { skip: !existsSync("/dev/zero") }, () => {
  refused_within(2000, fit("/dev/zero"), /\/dev\/zero/);
  refused_within(2000, ["overlap", "/dev/zero"], /\/dev\/zero/);
  refused_within(2000, ["lesson", "check", "/dev/zero"], /\/dev\/zero/);
  const zeros = openSync("/dev/zero");
  for (const args of [fit("-"), ["overlap", "-"], ["cull", "-"]]) refused_within(2000, args, /^snug: -: /, zeros);
  closeSync(zeros);
});
