// The named cases: listed, and taken by name in place of a file.
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { good, json_lines, refused, root, snug } from "./support.mjs";

const cases = json_lines(good(["cases"]));

test("cases lists every file of their folder, with a sentence and what takes it", () => {
  const files = readdirSync(join(root, "lessons/cases")).filter((name) => name !== "course.toml").map((name) => name.replace(".toml", ""));
  assert.deepEqual(cases.map((one) => one.case).sort(), files.sort());
  for (const { title, says, chapter, command, algorithms, source } of cases) {
    assert.ok(title && chapter && algorithms.length > 0);
    assert.match(says, /\.$/);
    assert.ok(["fit", "overlap", "cull"].includes(command), command);
    if (source) assert.match(source, / https:\/\/\S+$/);
  }
  assert.ok(cases.filter(({ source }) => source).length >= 10, "known programs failed on most of them");
});

test("every case is taken by name by the command that it says", () => {
  for (const { case: name, command } of cases) {
    const { out, err, status } = snug([command, "--case", name]);
    assert.equal(err, "", name);
    assert.ok(status === 0 || (status === 1 && command === "fit"), `${name}: ${status}`);
    assert.equal(json_lines(out).length, 1, name);
  }
});

test("of a case's points the scalar is its own unless one is named, and so is the algorithm", () => {
  const twins = JSON.parse(snug(["fit", "--case", "twins"]).out);
  assert.equal(twins.points, 9);
  assert.equal(twins.certificate.contains, false);
  const careful = JSON.parse(good(["fit", "--case", "twins", "--volume", "sphere", "--algorithm", "welzl"]));
  assert.deepEqual(careful.certificate, { contains: true, on_boundary: true, optimal: true });
  const of = (scalar) => JSON.parse(good(["fit", "--case", "far-sphere", "--volume", "sphere", "--algorithm", "welzl", ...scalar])).sphere.radius;
  assert.equal(of([]), of(["--scalar", "float"]));
  assert.equal(of([]), Math.fround(of([])));
});

test("a box that the planes of the matrix lose in float is kept by the camera's own", () => {
  const [{ class: verdict }] = json_lines(good(["cull", "--case", "far-plane"]));
  assert.notEqual(verdict, "outside");
});

test("what is no case, or one of something else, is refused", () => {
  refused(["fit", "--case", "nowhere"], "there is no case \"nowhere\"; `snug cases` lists them");
  refused(["fit", "--case", "wide-box"], /is not about points; `snug cases` says which command takes it/);
  refused(["overlap", "--case", "twins"], /is not about two volumes/);
  refused(["cull", "--case", "twins"], /is not about a frustum/);
  refused(["fit", "--case", "twins", "points.xyz"], /either --case or a file, not both/);
  refused(["fit", "--volume", "sphere", "--algorithm", "welzl"], "FILE is required");
});
