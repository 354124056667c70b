// `snug scene`: the counts of both lessons' effects, and every way in which a scene can be declared wrongly.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { good, json_lines, mistake, refused, root, snug, write } from "./support.mjs";

const scene = (...args) => json_lines(good(["scene", ...args]));
/** Without its links to lessons, which are not beside a test's own file. */
const lesson = (id) => readFileSync(join(root, "lessons", `${id}.toml`), "utf8").replace(/\[([^\]]*)\]\(lesson:[^)]*\)/g, "$1");
const counts = (lines) => Object.fromEntries(lines.slice(0, -1).map(({ effect, constructed, run, skipped }) => [effect, [constructed, run, skipped]]));

test("each lesson's scene runs just what it calls for", () => {
  const broad = scene("scene-broad", "--frames", "120");
  assert.deepEqual(counts(broad), { spin: [1, 120, 0], orbit: [1, 120, 0], refit: [1, 120, 0], broad_phase: [1, 120, 0], narrow_phase: [1, 120, 0] });
  const updates = scene("scene-updates", "--frames", "120");
  assert.deepEqual(counts(updates), { "spin body": [1, 120, 0], refit: [1, 120, 0] });
  for (const lines of [broad, updates]) {
    assert.ok(lines.slice(0, -1).every(({ microseconds }) => microseconds > 0));
    assert.equal(lines.at(-1).frames_drawn, 121);
    assert.equal(lines.at(-1).frames_skipped, 0);
  }
});

test("every effect is called for in some lesson of the course", () => {
  const table = readFileSync(join(root, "lessons/README.md"), "utf8").split("| effect | needs | its keys |")[1].split("\n\n")[0];
  const known = [...table.matchAll(/^\| `(\w+)` \|/gm)].map(([, name]) => name);
  assert.equal(known.length, 14);
  const lessons = readdirSync(join(root, "lessons")).filter((name) => name.endsWith(".toml") && name !== "course.toml");
  const called = new Set(lessons.flatMap((name) => [...readFileSync(join(root, "lessons", name), "utf8").matchAll(/^effect = "(\w+)"/gm)].map(([, effect]) => effect)));
  if (called.has("fall")) called.add("move"); // which comes with it
  assert.deepEqual(known.filter((effect) => !called.has(effect)), []);
});

test("the pile sleeps while the crane moves, and then nothing runs", () => {
  const at = (frames) => counts(scene("scene-effects", "--frames", String(frames)));
  const [moving, later, rest, end] = [at(189), at(190), at(201), at(260)];
  for (const [effect, [, run, skipped]] of Object.entries(later))
    assert.deepEqual([run, skipped], effect === "fall" ? [moving.fall[1], moving.fall[2] + 1] : [190, 0], effect);
  for (const [effect, [, run]] of Object.entries(end)) assert.equal(run, rest[effect][1], effect);
});

test("a push wakes the body's island alone, as on the page, and the scene comes to rest again", () => {
  const at = (frames, ...pushes) => scene("scene-effects", "--frames", String(frames), ...pushes.flatMap((push) => ["--push", push])).at(-1);
  assert.equal(at(241).awake, 0);
  const { awake } = at(241, "240:P0");
  assert.equal(awake, 4, "as on the page: tests/browser/effects.test.mjs");
  assert.equal(at(241, "240:P0", "240:P7").awake, at(241, "240:P7").awake + awake);
  const rest = at(390, "240:P0");
  assert.deepEqual([rest.awake, rest.resting], [0, true]);
  assert.notEqual(rest.hash, at(390).hash);
  assert.equal(at(240, "200:P0").hash, at(240, "200:P0").hash);
});

test("a push that cannot be is refused", () => {
  const push = (text, says) => refused(["scene", "scene-effects", "--frames", "100", "--push", text], says);
  for (const text of ["P1", "0:P1", "2.5:P1", "x:P1", ":P1"]) push(text, `--push ${text}: must be a frame from 1 on and the name of a body, as 240:P1`);
  push("100:P1", "--push 100:P1: frame 100 is the last one that is run");
  push("50:P99", '--push 50:P99: the scene has no body "P99"');
  push("50:", '--push 50:: the scene has no body ""');
  for (const name of ["floor", "crane"]) push(`50:${name}`, `--push 50:${name}: velocities do not move this body`);
});

test("a lesson that declares no scene stands still", () => {
  const all = json_lines(good(["lesson", "list"])).map((line) => line.lesson).filter((id) => !lesson(id).includes("\n[scene]"));
  assert.ok(all.length > 8);
  for (const id of all) {
    const lines = scene(id, "--frames", "30");
    assert.equal(lines.length, 1, `${id} has no effects`);
    assert.deepEqual([lines[0].lesson, lines[0].resting, lines[0].frames_drawn, lines[0].frames_skipped], [id, true, 1, 30]);
  }
});

test("the funnel narrows, whichever way pairs are looked for, to the same pairs", () => {
  const frames = (algorithm) => scene("scene-broad", "--algorithm", algorithm, "--every", "--frames", "50").slice(0, 50);
  const [sweep, tree, grid, all] = ["sweep_and_prune", "tree", "grid", "all_pairs"].map(frames);
  assert.ok(all.every(({ compared }) => compared === 780));
  assert.ok(sweep.every(({ compared, after_broad }) => compared < 780 && compared >= after_broad));
  const found = (lines) => lines.map(({ compared, swaps, ...others }) => others);
  assert.deepEqual(found(tree), found(sweep));
  assert.deepEqual(found(grid), found(sweep));
  assert.deepEqual(found(all), found(sweep));
  for (const lines of [tree, grid]) assert.ok(lines.every(({ compared, after_broad, swaps }) => compared < 780 && compared >= after_broad && swaps === 0));
  // From frame to frame little changes in the order: after the first, a few swaps at most.
  assert.ok(sweep[0].swaps > 100 && sweep.slice(1).every(({ swaps }) => swaps < 40), sweep.map(({ swaps }) => swaps).join());
  for (const { all_pairs, after_broad, after_loose, touching } of sweep) {
    assert.equal(all_pairs, 780);
    assert.ok(after_broad <= all_pairs && after_loose <= after_broad && touching <= after_loose);
  }
});

test("the updates differ in slack and cost as geometry says", () => {
  const at = (algorithm) => scene("scene-updates", "--algorithm", algorithm, "--every", "--frames", "40")[39];
  const [rotated, rebuilt, climbed, loose] = ["rotated_box", "rebuild", "hill_climb", "loose"].map(at);
  assert.equal(rebuilt.slack, 0);
  assert.equal(rebuilt.cost, 80);
  assert.ok(climbed.slack < 1e-6 && climbed.cost > 0);
  assert.ok(rotated.slack > 0 && rotated.cost === 0);
  assert.ok(loose.slack > rotated.slack && loose.cost === 0);
});

test("looseness and the volume over the hull's are those of snug update", () => {
  const points = [[1, 0.2, 0], [0.1, 2, 0.3], [0.3, 0, 3], [0.5, 0.5, -0.5]].flatMap((p) => [p, p.map((x) => -x)]); // about the origin, which the body rotates about
  write("own.xyz", points.map((row) => row.join(" ")).join("\n"));
  write("own.toml", lesson("scene-updates").replace('generate = "stick"\ncount = 80', `list = ${JSON.stringify(points)}`).replace(/\[\[question\]\][^]*/, ""));
  const near = (a, b) => assert.ok(Math.abs(a - b) <= 1e-9 * Math.max(1, Math.abs(b)), `${a} is ${b}`);
  for (const [algorithm, volume, strategy] of [["rotated_box", "aabb", "rotated_box"], ["rebuild", "aabb", "rebuild"], ["loose", "aabb", "loose"],
    ["sphere", "sphere", "transform"], ["obb", "obb", "transform"], ["k14", "kdop", "k14_hill_climb"]]) {
    const frame = scene("own", "--lessons", ".", "--algorithm", algorithm, "--every", "--frames", "40")[39];
    const turned = json_lines(good(["update", "--volume", volume, "--strategy", strategy, "--axis=1,2,3", "--degrees", "360", "--frames", "120", "own.xyz"]))[40];
    near(frame.slack, 100 * turned.slack);
    near(frame.over_hull, turned.over_hull);
    assert.ok(frame.over_hull > 1, algorithm);
  }
});

test("a scene that comes to rest runs nothing more, and draws nothing", () => {
  const still = write("still.toml", lesson("scene-updates").replace("turns_per_second = 0.5", "turns_per_second = 0.5\ndegrees = 30").replace(/\[\[question\]\][^]*/, ""));
  assert.equal(snug(["lesson", "check", still]).err, "");
  const lines = scene("still", "--lessons", ".", "--frames", "300");
  const { "spin body": spin, refit } = counts(lines);
  assert.ok(spin[1] < 15 && spin[1] + spin[2] === 300);
  assert.deepEqual(refit, spin);
  assert.equal(lines.at(-1).resting, true);
  assert.equal(lines.at(-1).frames_drawn, 1 + spin[1]);
  assert.equal(lines.at(-1).frames_skipped, 300 - spin[1]);
});

test("the same bits every time", () => {
  const hash = () => scene("scene-broad", "--frames", "77").at(-1).hash;
  assert.match(hash(), /^[0-9a-f]{16}$/);
  assert.equal(hash(), hash());
});

test("what a lesson declares wrongly is refused with file and line", () => {
  const broken = (id, from, to, message) => {
    const text = lesson(id), changed = text.replace(from, to);
    assert.notEqual(changed, text);
    const line = changed.slice(0, changed.indexOf(message.at)).split("\n").length;
    refused(["lesson", "check", write(`${id}.toml`, changed)], mistake(`${id}.toml`, line, message.says));
  };
  const broad = (from, to, at, says) => broken("scene-broad", from, to, { at, says });
  const body = "[[scene.body]]";
  broad('effect = "refit"\nstrategy = "rotated_box"', 'effect = "trail"', '[[scene.effect]]\neffect = "broad_phase"', "broad_phase reads volumes, which no effect of the scene makes: refit would");
  broad('effect = "orbit"', 'effect = "fly"', 'effect = "fly"', '"effect" is none of spin, orbit, path, fall,');
  broad('effect = "orbit"', 'effect = "orbi"', 'effect = "orbi"', '"effect" is none of');
  broad("at_points = true", "at_points = true\nmass = 0", body, "body 0: its mass is 0: call it fixed instead");
  for (const mass of ['"heavy"', "[1]", "true"]) broad("at_points = true", `at_points = true\nmass = ${mass}`, "mass = ", '"mass" must be a number');
  broad("frames = 120", 'frames = 120\nstep = "fast"', "step = ", '"step" must be a number');
  broad("at_points = true", "at_points = true\nmass = -2", body, "body 0: its mass is negative");
  broad("at_points = true", "at_points = true\nmass = inf", body, "body 0: its mass is infinite: call it fixed instead");
  broad("at_points = true", "at_points = true\nposition = [nan, 0, 0]", body, "body 0: its position is not finite, or too large");
  broad("frames = 120", "frames = 120\nstep = 0", "[scene]", "the scene's step must be above 0");
  broad("vary = 0.9", "vary = 9", "vary = 9", 'orbit: "vary" is out of range');
  broad("vary = 0.9", "wobble = 9", "wobble = 9", 'orbit: has no setting "wobble"');
  broad('shape = "box"', 'shape = "cone"', 'shape = "cone"', '"shape" is none of sphere, box, capsule, points or mesh: cone');
  broken("scene-updates", 'shape = "points"', 'shape = "mesh"', { at: 'shape = "mesh"', says: '"shape" is a mesh, and [points] names none' });
  broken("scene-updates", 'after_nth = 90', 'after_nth = 0', { at: "after_nth = 0", says: '"after_nth" must be from 1 to 100000' });
  broken("scene-updates", 'after = "frame_taken"\n', "", { at: "after_nth = 1", says: '"after_nth" needs "after", whose steps it counts' });
  broad("half_extents = [0.30, 0.07, 0.12]", "half_extents = [0.3, 0.1]", "half_extents", '"half_extents" must be three numbers');
  broad("bounds = [20, 120, 400]", "bounds = [20, 20]", "bounds = [20, 20]", '"bounds" must be numbers that rise');
  broad('figure = "after_broad"\nbounds', 'figure = "beauty"\nbounds', 'figure = "beauty"', '"figure" is none of all_pairs, compared,');
  broad("bounds = [20, 120, 400]", "bounds = [nan]", "bounds = [nan]", '"bounds" must be numbers that rise');
  broad("bounds = [20, 120, 400]", "bounds = [20, nan, 400]", "bounds = [20, nan", '"bounds" must be numbers that rise');
  broad("bounds = [20, 120, 400]", "bounds = [20, inf]", "bounds = [20, inf", '"bounds" must be numbers that rise');
  broad("bounds = [20, 120, 400]", "bounds = [[20], [120]]", "bounds = [[20", '"bounds" must be a number or numbers');
  broad('"all_pairs"]', '"all_pairs", "tree"]', "algorithms = ", '"algorithms" names tree twice');
  for (const half of ["[0, 0, 0]", "[0.3, 0, 0.1]", "[0.3, -1, 0.1]", "[0.3, nan, 0.1]", "[0.3, inf, 0.1]"])
    broad("half_extents = [0.30, 0.07, 0.12]", `half_extents = ${half}`, "half_extents", '"half_extents" must be above 0 and at most 1000000000');
  const box = 'shape = "box"\nhalf_extents = [0.30, 0.07, 0.12]';
  broad(box, 'shape = "sphere"', body, '[[scene.body]] lacks the key "radius"');
  broad(box, 'shape = "capsule"\nhalf_length = 1', body, '[[scene.body]] lacks the key "radius"');
  broad(box, 'shape = "sphere"\nradius = 0', "radius = 0", '"radius" must be above 0 and at most 1000000000');
  const wall = (mass) => `[[scene.body]]\nname = "wall"\nshape = "sphere"\nradius = 1\nfixed = true\nmass = ${mass}\n\n[[scene.body]]`;
  for (const mass of ["0", "inf"]) broad(body, wall(mass), body, "wall: its mass is 0 or infinite: a body that is fixed needs none");
  broad(body, wall("nan"), body, "wall: its mass is not a number");
  broad(body, wall("-1"), body, "wall: its mass is negative");
  broad("dim = 3", "dim = 2", "[scene]", 'a scene is in space: "dim" of [points] must be 3');
});

test("places are lists of three numbers, and no two effects drive the same of a body", () => {
  const own = '[[scene.body]]\nname = "a"\nshape = "sphere"\nradius = 0.1\n\n';
  const fault = (effect, at, says, mistakes = 1) => {
    const text = lesson("scene-broad").replace("[[scene.effect]]", `${own}${effect}\n\n[[scene.effect]]`);
    const line = text.slice(0, text.indexOf(at)).split("\n").length;
    refused(["lesson", "check", write("a.toml", text)], mistake("a.toml", line, says), undefined, mistakes);
  };
  const path = (places) => `[[scene.effect]]\neffect = "path"\nbody = "a"\nplaces = ${places}`;
  for (const places of ["[0, 0, 0, 1, 0, 0]", "[[0, 0], [0, 1, 0, 0]]", "[[0, 0, 0, 1, 0, 0]]", "[[0, 0, 0], [1, 0]]", "[[0, 0, 0], [1, nan, 0]]"])
    fault(path(places), "places", 'each of "places" must be a point of 3 finite numbers: [x, y, z]');
  fault(path("[]"), "places", '"places" must be a list of points');
  fault(path("[[0, 0, 0], [1, 0, 0]]"), '[[scene.effect]]\neffect = "orbit"', "path and orbit would both drive a: one undoes the other");
  fault('[[scene.effect]]\neffect = "spin"', '[[scene.effect]]\neffect = "spin"\naxis', "spin and spin would both drive every body: one undoes the other");
  fault('[[scene.effect]]\neffect = "drag"\nbody = "a"', '[[scene.effect]]\neffect = "orbit"', "drag and orbit would both drive a: one undoes the other", 2); // spin, too
});

test("a scene with too many frames of too many bodies is refused before it is run", () => {
  const text = lesson("scene-broad").replace(/\[\[question\]\][^]*/, "");
  const line = text.slice(0, text.indexOf("frames = ")).split("\n").length;
  const of = (bodies, frames) => write("many.toml", text.replace("count = 40", `count = ${bodies}`).replace("frames = 120", `frames = ${frames}`));
  const too_long = "too many frames of too many bodies: one times the other may be at most 250000, and 10 places of a trail count as a body";
  const start = performance.now();
  for (const [bodies, frames] of [[100000, 120], [2100, 120], [126, 2000]])
    refused(["lesson", "check", of(bodies, frames)], mistake("many.toml", line, too_long));
  const trails = write("trails.toml", text.replace("count = 40", "count = 125").replace("frames = 120", "frames = 2000").replace("[[scene.effect]]", '[[scene.effect]]\neffect = "trail"\nlength = 10000\n\n[[scene.effect]]'));
  refused(["lesson", "check", trails], mistake("trails.toml", line, too_long));
  assert.ok(performance.now() - start < 5000);
});

test("a scene with too many pairs is refused with the line of what looks for them", () => {
  const text = lesson("scene-broad").replace(/\[\[question\]\][^]*/, "").replace("count = 40", "count = 500").replace("frames = 120", "frames = 500").replace(/half_extents = .*/, "half_extents = [50, 50, 50]");
  const line = text.slice(0, text.indexOf('[[scene.effect]]\neffect = "broad_phase"')).split("\n").length;
  refused(["lesson", "check", write("pairs.toml", text)], mistake("pairs.toml", line, "too many pairs: those of all frames together may be at most 12500000, which are reached at frame 101"));
});

test("more points than a method takes are refused with their line", () => {
  const text = lesson("scene-broad").replace(/\[\[question\]\][^]*/, "").replace("count = 40", "count = 4001").replace("frames = 120", "frames = 20");
  const line = text.slice(0, text.indexOf("[points]")).split("\n").length;
  refused(["lesson", "check", write("crowd.toml", text)], mistake("crowd.toml", line, "Sort and sweep takes at most 4000 points"), undefined, 2); // and there are too many pairs
});

test("a mesh is a body: it is run, and impulses refuse it with file and line", () => {
  const meshy = lesson("scene-updates").replace('generate = "stick"\ncount = 80', 'mesh = "bunny"').replace('shape = "points"', 'shape = "mesh"').replace(/\[\[question\]\][^]*/, "");
  const more = (...effects) => meshy.replace('effect = "refit"\n', (own) => own + effects.map((name) => `\n[[scene.effect]]\neffect = "${name}"\n`).join(""));
  assert.equal(snug(["lesson", "check", write("meshy.toml", more("cull", "shadow", "trail"))]).err, "");
  const lines = scene("meshy", "--lessons", ".", "--frames", "20");
  assert.deepEqual(Object.values(counts(lines)), Array(5).fill([1, 20, 0]));
  assert.ok(lines.at(-1).slack > 0);
  const solid = more("broad_phase", "narrow_phase", "bounce");
  const line = solid.slice(0, solid.indexOf('"bounce"')).split("\n").length - 1;
  refused(["lesson", "check", write("solid.toml", solid)], `solid.toml:${line}:1: bounce: has impulses for spheres and boxes alone; give body such a shape`);
});

test("what is asked for wrongly is said in one line", () => {
  refused(["scene", "scene-broad", "--algorithm", "guess"], 'scene-broad does not offer "guess"');
  refused(["scene", "scene-broad", "--frames", "0"], /--frames/);
  refused(["scene", "nowhere"], /nowhere/);
});
