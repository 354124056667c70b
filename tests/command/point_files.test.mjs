// What the commands that read point files say of what they pass over.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { root, snug, write } from "./support.mjs";

const commands = [
  ["fit", "--volume", "sphere", "--algorithm", "welzl"],
  ["update", "--volume", "aabb", "--strategy", "rebuild", "--frames", "1"],
  ["cost", "--volume", "aabb", "--repeat", "3"],
];
const coloured = write("coloured.xyz", "0 0 0 255\n4 0 0 0\n9 9 9 1\n");
const torn = write("torn.obj", "v 0 0 0\nv 4 0 0\nv 9 9 9\nf 1 2 9\nf a b c\nf 1 2 3\n");
const holes = write("holes.xyz", "0 0 0\nnan nan nan\n4 0 0\n9 9 9\n");

test("what is passed over is a warning with its count, and --strict refuses it", () => {
  const says = "passed over: 3 lines with more columns than three\n";
  for (const command of commands) {
    const { err, status } = snug([...command, coloured]);
    assert.equal(err, `snug: coloured.xyz: warning: ${says}`);
    assert.equal(status, 0);
    const strict = snug([...command, "--strict", coloured]);
    assert.deepEqual(strict, { out: "", err: `snug: coloured.xyz: ${says}`, status: 2 });
  }
});

test("--skip-nan counts the points that it passes over", () => {
  for (const command of commands) {
    assert.equal(snug([...command, holes]).status, 2);
    const { err, status } = snug([...command, "--skip-nan", holes]);
    assert.match(err, /passed over: 1 point with a coordinate that is not finite\n$/);
    assert.equal(status, 0);
    assert.equal(snug([...command, "--skip-nan", "--strict", holes]).status, 2);
  }
});

test("faces that are damaged refuse no points", () => {
  for (const command of commands) {
    for (const [file, faces] of [[torn, "2 damaged faces"], [join(root, "tests/corpus/points/face_out_of_range.ply"), "1 damaged face"]]) {
      const { err, status } = snug([...command, file]);
      assert.ok(err.endsWith(`: warning: passed over: ${faces}\n`), err);
      assert.equal(status, 0);
    }
  }
});
