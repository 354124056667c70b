// `snug update`: every strategy, its promise, and every way in which it can be asked for wrongly.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { folder, good, json_lines, refused, write } from "./support.mjs";

const kStrategies = { sphere: ["transform"], aabb: ["loose", "rebuild", "hill_climb", "rotated_box"], obb: ["transform"],
  kdop: ["k6_hill_climb", "k14_hill_climb", "k18_hill_climb", "k26_hill_climb", "k14_loose", "k14_rebuild", "k14_rotated"] };
const args = (volume, strategy, ...more) => ["update", "--volume", volume, "--strategy", strategy, ...more];
const update = (volume, strategy, ...more) => json_lines(good(args(volume, strategy, ...more)));

const cube = write("cube.xyz", [0, 1, 2, 3, 4, 5, 6, 7].map((c) => `${(c & 1) - 0.5} ${((c >> 1) & 1) - 0.5} ${(c >> 2) - 0.5}`).join("\n"));
const square = write("square.xyz", "-1 -1\n1 -1\n1 1\n-1 1\n0 0\n");

test("every strategy holds the body in every frame, in both scalars", () => {
  for (const [volume, strategies] of Object.entries(kStrategies))
    for (const strategy of strategies)
      for (const scalar of ["double", "float"]) {
        const frames = update(volume, strategy, "--scalar", scalar, "--frames", "7", "--move", "3,0,1e4", cube);
        assert.equal(frames.length, 7);
        frames.forEach((frame, i) => {
          assert.deepEqual(Object.keys(frame), ["frame", "degrees", volume, "measure", "slack", "over_hull", "contains", "steps", "operations"]);
          assert.equal(frame.frame, i);
          assert.ok(Math.abs(frame.degrees - 360 * i / 7) < 1e-9);
          assert.equal(frame.contains, true);
          assert.ok(frame.slack >= 0);
          assert.ok(Math.abs(frame.over_hull - frame.measure) <= 1e-6 * frame.measure, "the cube is its own hull, of volume 1");
        });
      }
});

test("of a cube turned by 45 degrees the boxes are as wide as geometry says", () => {
  const turned = (strategy) => update("aabb", strategy, "--axis", "0,0,1", "--degrees", "90", "--frames", "2", cube)[1];
  assert.ok(Math.abs(turned("rebuild").measure - 2) < 1e-12);
  assert.equal(turned("rebuild").slack, 0);
  assert.deepEqual(turned("hill_climb").aabb, turned("rebuild").aabb);
  assert.ok(Math.abs(turned("rotated_box").measure - 2) < 1e-12);
  assert.ok(Math.abs(turned("loose").measure - Math.sqrt(27)) < 1e-9);
  assert.ok(Math.abs(turned("loose").slack - (Math.sqrt(27) / 2 - 1)) < 1e-9);
  const [box] = update("obb", "transform", "--axis", "0,0,1", "--frames", "1", cube);
  assert.ok(Math.abs(box.measure - 1) < 1e-12 && box.slack < 1e-12);
});

test("hill climbing looks at fewer points than there are, rebuilding at all of them, loose at none", () => {
  const cloud = Array.from({ length: 2000 }, (_, i) => {
    const z = 1 - (2 * i + 1) / 2000, r = Math.sqrt(1 - z * z), turn = i * 2.399963229728653;
    return `${r * Math.cos(turn)} ${r * Math.sin(turn)} ${z}`;
  });
  write("sphere.xyz", cloud.join("\n"));
  const touched = (strategy) => update("aabb", strategy, "--degrees", "10", "--frames", "10", "sphere.xyz").slice(1).map(({ operations }) => operations.points_touched);
  assert.ok(touched("rebuild").every((n) => n === 2000));
  assert.ok(touched("loose").every((n) => n === 0));
  assert.ok(touched("hill_climb").every((n) => n < 1000), "walks are short from frame to frame");
});

test("in the plane the body turns about the origin", () => {
  const [, turned] = update("aabb", "rebuild", "--degrees", "90", "--frames", "2", square);
  assert.ok(Math.abs(turned.measure - 8) < 1e-12);
  assert.equal(update("kdop", "k8_hill_climb", "--frames", "3", square).length, 3);
  assert.equal(update("aabb", "loose", "--move", "1,2", "--frames", "1", square)[0].aabb.min.length, 2);
});

test("the trace has every step of every frame", () => {
  for (const [volume, strategies] of Object.entries(kStrategies))
    for (const strategy of strategies) {
      const frames = update(volume, strategy, "--frames", "4", "--steps", "steps.jsonl", cube);
      const steps = json_lines(readFileSync(join(folder, "steps.jsonl"), "utf8"));
      assert.equal(steps.length, frames.reduce((sum, frame) => sum + frame.steps, 0));
      assert.equal(steps.filter(({ step }) => step === "finished").length, 4);
      assert.ok(steps.every(({ line }) => Number.isInteger(line) && line >= 0));
    }
});

test("lists of numbers may stand apart, and the file is still found", () => {
  const [, wanted] = update("aabb", "rebuild", "--axis", "0,0,-1", "--frames", "2", "--move", "1,2,3", cube);
  const given = (...rest) => update("aabb", "rebuild", ...rest)[1];
  assert.deepEqual(given("--frames", "2", "--move", "1", "2", "3", "--axis", "0", "0", "-1", cube), wanted);
  assert.deepEqual(given("--axis", "0", "0", "-1", cube, "--move", "1", "2", "3", "--frames", "2"), wanted);
  assert.equal(update("aabb", "rebuild", "--move", "1", "-2", square, "--frames", "1").length, 1);
  refused(args("aabb", "loose", "--axis", "1", "2", cube), "--axis takes three numbers");
});

test("what is asked for wrongly is said in one line", () => {
  refused(args("cone", "loose", cube), 'there is no update of "cone"; known: sphere, aabb, obb, kdop');
  refused(args("aabb", "guess", cube), 'there is no update "guess" of aabb; known: loose, rebuild, hill_climb, rotated_box');
  refused(args("kdop", "k14_hill_climb", square), "square.xyz: k14_hill_climb takes points of 3 coordinates, and these have 2");
  refused(args("aabb", "loose", "--axis", "0,0,0", cube), "--axis has no direction: all three numbers are 0");
  refused(args("aabb", "loose", "--axis", "1,2", cube), "--axis takes three numbers");
  refused(args("aabb", "loose", "--move", "1,2", cube), "--move takes 3 numbers for these points");
  refused(args("aabb", "loose", "--degrees", "nan", cube), "--degrees takes a number up to 1e6");
  refused(args("aabb", "loose", "--frames", "0", cube), /--frames/);
  refused(args("aabb", "loose", "nowhere.xyz"), /^snug: nowhere\.xyz: /);
  refused(args("aabb", "loose", "--steps", "no/such/folder.jsonl", cube), /^snug: no\/such\/folder\.jsonl: /);
});
