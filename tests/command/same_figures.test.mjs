// The figures that lessons show are those of `snug cost`, `snug update` and `snug overlap` on the same input, digit for digit.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { good, json_lines, root, write } from "./support.mjs";

const toml = (file) => JSON.parse(spawnSync("python3", ["-c", "import json, sys, tomllib; print(json.dumps(tomllib.load(open(sys.argv[1], 'rb'))))", file], { encoding: "utf8" }).stdout);
const lessons = readdirSync(join(root, "lessons")).filter((name) => name.endsWith(".toml") && name !== "course.toml")
  .map((name) => ({ id: name.slice(0, -5), file: join(root, "lessons", name), ...toml(join(root, "lessons", name)) }));
/** The figures at the end of each algorithm's run in the lesson's own situation. */
const ends = ({ file }) => json_lines(good(["lesson", "facts", file]))
  .filter((line) => line.step === undefined && (line.situation ?? "own") === "own");
/** Equal in all digits that are shown, and in many more. */
const same = (a, b, says) => assert.equal(a.toPrecision(9), b.toPrecision(9), says);

test("sizes and counted operations are those of snug cost", () => {
  const kinds = ["sphere", "aabb", "obb", "capsule", "lozenge", "kdop", "hull"];
  let compared = 0;
  for (const lesson of lessons) {
    const { points, seed = 1, chart, algorithms } = lesson;
    const volume = lesson.volume ?? (algorithms[0].includes("/") ? algorithms[0].split("/")[0] : "sphere");
    if (!points || points.mesh || chart || points.scalar === "float" || volume === "scene" || lesson.slider) continue;
    const dim = points.dim ?? 2;
    const from = points.list ? [write(`${lesson.id}.xyz`, points.list.map((point) => point.join(" ")).join("\n"))]
      : ["--generate", `${points.generate}:${points.count}`];
    for (const { algorithm, size, figures } of ends(lesson)) {
      const [kind, name] = algorithm.includes("/") ? algorithm.split("/") : [volume, algorithm];
      if (!kinds.includes(kind) || name.endsWith("by_hand") || size === undefined) continue;
      const [row] = JSON.parse(good(["cost", ...from, "--dim", `${dim}`, "--seed", `${seed}`, "--volume", kind, "--algorithms", name, "--repeat", "1", "--json"])).rows;
      if (!algorithm.includes("/") && !lesson.reference) same(size, row.size, `${lesson.id}, ${algorithm}: size`);
      for (const [count, value] of Object.entries(row.operations))
        if (figures[count] !== undefined) assert.equal(figures[count], value, `${lesson.id}, ${algorithm}: ${count}`);
      ++compared;
    }
  }
  assert.ok(compared > 30, `${compared} runs were compared`);
});

test("looseness in each frame is that of snug update", () => {
  // The lesson with a list of points in place of the generated ones, which the command cannot print.
  // Its points lie in pairs about the origin, because a scene's body rotates about its centroid.
  const half = Array.from({ length: 30 }, (_, i) => [1, 2, 3].map((k) => k * Math.round(1e4 * Math.sin(k * i * 1.7 + k)) / 1e4));
  const body = [...half, ...half.map((point) => point.map((x) => -x))];
  const { scene } = lessons.find(({ id }) => id === "scene-updates");
  const text = readFileSync(join(root, "lessons/scene-updates.toml"), "utf8");
  const file = write("updates.toml", text.replace(/generate = "stick"\ncount = \d+/, `list = ${JSON.stringify(body)}`));
  const cloud = write("body.xyz", body.map((point) => point.join(" ")).join("\n"));
  const spin = scene.effect.find(({ effect }) => effect === "spin");
  const frames = json_lines(good(["lesson", "facts", file])).filter(({ fact, situation }) => fact === "frame_taken" && situation === "own");
  for (const strategy of ["rotated_box", "rebuild", "hill_climb", "loose"]) {
    const own = frames.filter(({ algorithm }) => algorithm === strategy).map(({ figures }) => figures);
    const told = json_lines(good(["update", "--volume", "aabb", "--strategy", strategy, "--axis", spin.axis.join(","),
      "--degrees", `${spin.turns_per_second * 360 / 60 * 120}`, "--frames", "120", cloud]));
    const pairs = own.filter(({ frame }) => told[frame] !== undefined).map((figures) => [figures, told[figures.frame]]);
    assert.equal(pairs.length, 119);
    for (const [figures, frame] of pairs) {
      same(figures.over_hull, frame.over_hull, `${strategy}, frame ${frame.frame}: over the hull`);
      same(1 + figures.slack / 100, 1 + frame.slack, `${strategy}, frame ${frame.frame}: looseness`);
    }
  }
});

test("distances and numbers of tests are those of snug overlap", () => {
  const plain = ["sphere", "aabb", "capsule", "kdop", "hull"]; // an oriented box and a lozenge are written by angles
  let compared = 0;
  for (const lesson of lessons.filter(({ volume }) => volume === "volume_pair"))
    for (const [name, { dim = 2, a, b }] of [["own", lesson.volumes], ...(lesson.situation ?? []).map((one) => [one.name, one.volumes])]) {
      if (![a, b].every((volume) => plain.includes(Object.keys(volume)[0]))) continue;
      const [answer] = json_lines(good(["overlap", "--dim", `${dim}`], JSON.stringify({ a, b })));
      const runs = json_lines(good(["lesson", "facts", lesson.file])).filter((line) => line.step === undefined && (line.situation ?? "own") === name);
      const [test] = runs; // the first algorithm is the test of the pair
      const says = `${lesson.id}, ${name}`;
      assert.equal(test.figures.tests, answer.tests, `${says}: tests`);
      if (answer.distance) same(test.figures.gap, answer.distance, `${says}: distance`);
      ++compared;
    }
  assert.ok(compared >= 5, `${compared} pairs were compared`);
});

test("counts over random pairs are those of snug overlap --random", () => {
  let compared = 0;
  for (const lesson of lessons.filter(({ boxes }) => boxes?.random_pairs)) {
    const { boxes: { dim = 2, random_pairs }, seed = 1 } = lesson;
    const [told] = json_lines(good(["overlap", "--random", `${random_pairs}`, "--seed", `${seed}`, "--dim", `${dim}`]));
    const [{ figures }] = ends(lesson);
    assert.deepEqual(
      [figures.random_pairs, figures.random_overlap, figures.random_apart, figures.random_edges, figures.random_first],
      [told.pairs, told.overlap, told.apart, told.edges_alone, told.rows[0].first], lesson.id);
    same(figures.random_tests, told.tests_first_gap / told.pairs, `${lesson.id}: mean of the tests`);
    ++compared;
  }
  assert.ok(compared >= 1, `${compared} lessons count`);
});
