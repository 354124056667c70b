// The figures that lessons show are those of `snug cost`, `snug update`, `snug overlap` and `snug cull` on the same input,
// digit for digit.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { axis_and_degrees, body_and_frustum, field, obb, objects, query_frustum, volume } from "./stage_input.mjs";
import { good, json_lines, program, root, write } from "./support.mjs";

const toml = (file) => JSON.parse(spawnSync("python3", ["-c", "import json, sys, tomllib; print(json.dumps(tomllib.load(open(sys.argv[1], 'rb'))))", file], { encoding: "utf8" }).stdout);
const lessons = readdirSync(join(root, "lessons")).filter((name) => name.endsWith(".toml") && name !== "course.toml")
  .map((name) => ({ id: name.slice(0, -5), file: join(root, "lessons", name), ...toml(join(root, "lessons", name)) }));
const lesson_of = (name) => lessons.find(({ id }) => id === name);
const facts_of = (() => {
  const told = {};
  return ({ file }) => told[file] ??= json_lines(good(["lesson", "facts", file]));
})();
/** What is told of each algorithm's run in a situation: its steps, and then its end. */
const facts = (lesson, situation = "own") => facts_of(lesson).filter((line) => (line.situation ?? "own") === situation);
/** The figures at the end of each algorithm's run. */
const ends = (lesson, situation) => facts(lesson, situation).filter(({ step }) => step === undefined);
const end_of = (lesson, algorithm, situation) => ends(lesson, situation).find((end) => end.algorithm === algorithm).figures;
/** A table of the lesson's own and of each situation, with the situations' names. */
const situations = (lesson, table) => [["own", lesson[table]], ...(lesson.situation ?? []).map((one) => [one.name, one[table]])]
  .filter(([, held]) => held !== undefined);
/** Whether a slider moves what stands there from where the file has it. */
const is_driven = ({ slider = [] }, name) => slider.some(({ drives, situation = name }) =>
  situation === name && ["count", "offset", "jitter", "scale", "angle", "squeeze"].includes(drives));
/** Equal in all digits that are shown, and in many more. */
const same = (a, b, says) => assert.equal(a.toPrecision(9), b.toPrecision(9), says);
/** The same of signed numbers that may be as good as 0. */
const near = (a, b, says) => assert.ok(Math.abs(a - b) < 1e-9, `${says}: ${a} and ${b}`);

test("sizes and counted operations are those of snug cost", () => {
  const kinds = ["sphere", "aabb", "obb", "capsule", "lozenge", "kdop", "hull"];
  const compared = { runs: 0, in_space: 0, sizes: 0 };
  for (const lesson of lessons) {
    const { seed = 1, chart, algorithms } = lesson;
    const own = lesson.volume ?? (algorithms[0].includes("/") ? algorithms[0].split("/")[0] : "sphere");
    if ((chart && chart !== "criteria") || !kinds.includes(own)) continue;
    for (const [name, points] of situations(lesson, "points")) {
      if (points.mesh || points.scalar === "float" || is_driven(lesson, name)) continue;
      const dim = points.dim ?? 2;
      const from = points.list ? [write(`${lesson.id}.xyz`, points.list.map((point) => point.join(" ")).join("\n"))]
        : ["--generate", `${points.generate}:${points.count}`];
      for (const { algorithm, size, figures } of ends(lesson, name)) {
        const [kind, fitter] = algorithm.includes("/") ? algorithm.split("/") : [own, algorithm];
        if (fitter.endsWith("by_hand") || size === undefined) continue;
        const [row] = JSON.parse(good(["cost", ...from, "--dim", `${dim}`, "--seed", `${seed}`, "--volume", kind, "--algorithms", fitter, "--repeat", "1", "--json"])).rows;
        const says = `${lesson.id}, ${name}, ${algorithm}`;
        if (row.points < row.of) continue; // a limit of its own would stop the run: fewer points are measured
        if (kind === "sphere") same(figures.radius, row.size, `${says}: radius`), ++compared.sizes;
        else if (figures.measure !== undefined) same(figures.measure, row.size, `${says}: size`), ++compared.sizes;
        for (const [count, value] of Object.entries(row.operations))
          if (figures[count] !== undefined) assert.equal(figures[count], value, `${says}: ${count}`);
        ++compared.runs;
        if (dim === 3) ++compared.in_space;
      }
    }
  }
  assert.ok(compared.runs > 100 && compared.in_space > 30 && compared.sizes > 90, JSON.stringify(compared));
});

/** A lesson's file with a list of points in place of generated ones, which the command cannot print. They lie in pairs
 *  about the origin, because a scene's body rotates about its centroid. */
function with_list(id) {
  const half = Array.from({ length: 30 }, (_, i) => [1, 2, 3].map((k) => k * Math.round(1e4 * Math.sin(k * i * 1.7 + k)) / 1e4));
  const body = [...half, ...half.map((point) => point.map((x) => -x))];
  const text = readFileSync(lesson_of(id).file, "utf8").replace(/generate = "\w+"\ncount = \d+/, `list = ${JSON.stringify(body)}`);
  return { lesson: { file: write(`${id}.toml`, text) }, cloud: write("body.xyz", body.map((point) => point.join(" ")).join("\n")) };
}

test("looseness in each frame is that of snug update", () => {
  const strategies = {
    "scene-updates": [["aabb", "rotated_box", "rotated_box"], ["aabb", "rebuild", "rebuild"], ["aabb", "hill_climb", "hill_climb"], ["aabb", "loose", "loose"]],
    "kdop-update": [["kdop", "k14", "k14_hill_climb"], ["kdop", "k14_rebuild", "k14_rebuild"], ["kdop", "k14_rotated", "k14_rotated"],
      ["kdop", "k14_loose", "k14_loose"], ["kdop", "k26", "k26_hill_climb"], ["obb", "obb", "transform"], ["sphere", "sphere", "transform"]],
  };
  for (const [id, updates] of Object.entries(strategies)) {
    const { lesson, cloud } = with_list(id);
    const { effect, frames } = lesson_of(id).scene;
    const spin = effect.find((one) => one.effect === "spin");
    for (const [kind, algorithm, strategy] of updates) {
      const own = facts(lesson).filter((line) => line.fact === "frame_taken" && line.algorithm === algorithm).map(({ figures }) => figures);
      const told = json_lines(good(["update", "--volume", kind, "--strategy", strategy, "--axis", spin.axis.join(","),
        "--degrees", `${spin.turns_per_second * 360 / 60 * frames}`, "--frames", `${frames}`, cloud]));
      const pairs = own.filter(({ frame }) => told[frame] !== undefined).map((figures) => [figures, told[figures.frame]]);
      assert.equal(pairs.length, frames - 1);
      for (const [figures, frame] of pairs) {
        same(figures.over_hull, frame.over_hull, `${id}, ${algorithm}, frame ${frame.frame}: over the hull`);
        same(1 + figures.slack / 100, 1 + frame.slack, `${id}, ${algorithm}, frame ${frame.frame}: looseness`);
      }
    }
  }
});

test("one update is that of snug update", () => {
  const lesson = lesson_of("aabb-updates");
  const half = Array.from({ length: 20 }, (_, i) => [1, 2, 3].map((k) => Math.round(1e4 * Math.sin(k * i * 2.3 + k)) / 1e4));
  const text = readFileSync(lesson.file, "utf8").replace(/generate = "\w+"\ncount = \d+/, `list = ${JSON.stringify(half)}`);
  const listed = { file: write("one-update.toml", text) };
  let compared = 0;
  for (const [name, points, { turn }] of [["own", lesson.points.list, lesson.body], ["space", half, lesson.situation[0].body]]) {
    const dim = points[0].length, cloud = write("turned.xyz", points.map((point) => point.join(" ")).join("\n"));
    const { axis, degrees } = axis_and_degrees(turn);
    for (const { algorithm, figures } of ends(listed, name)) {
      const [told] = json_lines(good(["update", "--volume", "aabb", "--strategy", algorithm, "--dim", `${dim}`, "--frames", "1",
        "--degrees", `${dim === 2 ? turn : degrees}`, ...(dim === 3 ? ["--axis", axis.join(",")] : []), cloud]));
      const says = `${name}, ${algorithm}`;
      same(figures.measure, told.measure, `${says}: size`);
      near(figures.slack / 100, told.slack, `${says}: looseness`);
      ++compared;
    }
  }
  assert.equal(compared, 8);
});

test("distances and numbers of tests are those of snug overlap", () => {
  const compared = {};
  for (const lesson of lessons.filter(({ volume: kind }) => kind === "volume_pair"))
    for (const [name, { dim = 2, a, b }] of situations(lesson, "volumes")) {
      const [answer] = json_lines(good(["overlap", "--dim", `${dim}`], JSON.stringify({ a: volume(a), b: volume(b) })));
      const told = ends(lesson, name), { figures } = told.find(({ algorithm }) => algorithm !== "gjk") ?? told[0]; // the pair's own test
      const says = `${lesson.id}, ${name}`;
      const counts_features = [a, b].some(({ lozenge }) => lozenge); // the command counts the pairs of edges and faces as well
      if (!counts_features) assert.equal(figures.tests, answer.tests, `${says}: tests`);
      const gap = ["slabs", "separating_axes"].includes(answer.test) ? answer.separating_axis?.gap : answer.distance; // the lesson tells its axis's
      if (gap) same(figures.gap, gap, `${says}: distance`);
      for (const kind of [a, b].map((held) => Object.keys(held)[0])) compared[kind] = (compared[kind] ?? 0) + 1;
    }
  for (const [name, least] of Object.entries({ sphere: 3, aabb: 8, obb: 1, capsule: 4, lozenge: 6, kdop: 8, hull: 2 }))
    assert.ok(compared[name] >= least, JSON.stringify(compared));
});

test("the separating axis of two oriented boxes is that of snug overlap", () => {
  let compared = 0;
  for (const lesson of lessons.filter(({ volume: kind }) => kind === "box_pair"))
    for (const [name, { center, half_extents, turn }] of situations(lesson, "boxes")) {
      const [end] = ends(lesson, name).filter(({ algorithm }) => algorithm === "sat");
      if (!end) continue;
      const [a, b] = [0, 1].map((i) => obb(center[i], half_extents[i], turn[i]));
      const [answer] = json_lines(good(["overlap", "--dim", `${center[0].length}`], JSON.stringify({ a, b })));
      assert.equal(end.figures.tests, answer.tests, `${lesson.id}, ${name}: tests`);
      if (answer.separating_axis) same(end.figures.gap, answer.separating_axis.gap, `${lesson.id}, ${name}: separation`);
      ++compared;
    }
  assert.ok(compared >= 3, `${compared} pairs were compared`);
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

test("what a frustum sees of a body is what snug cull says", () => {
  let compared = 0;
  const classes = ["inside", "intersecting", "outside"];
  for (const lesson of lessons.filter(({ boxes }) => boxes?.taper))
    for (const [name, boxes] of situations(lesson, "boxes")) {
      const line = body_and_frustum(boxes);
      const [answer] = json_lines(good(["cull"], JSON.stringify(line)));
      for (const algorithm of ["p_n_vertex", "grown_planes", "half_spaces"]) {
        const told = facts(lesson, name).filter((one) => one.algorithm === algorithm);
        if (told.length === 0) continue;
        const says = `${lesson.id}, ${name}, ${algorithm}`;
        assert.equal(classes[told.at(-1).figures.verdict], answer.class, `${says}: the class`);
        const planes = told.filter(({ fact }) => fact === "plane_tested").map(({ figures }) => figures);
        assert.equal(planes.length, told.at(-1).figures.planes_tested, says);
        planes.forEach((figures, i) => {
          const { p_distance, n_distance } = answer.planes[i];
          if (figures.p_distance !== undefined) near(figures.p_distance, p_distance, `${says}: plane ${i}, p-vertex`);
          if (figures.n_distance !== undefined) near(figures.n_distance, n_distance, `${says}: plane ${i}, n-vertex`);
          if (figures.distance !== undefined) near(figures.distance, (p_distance + n_distance) / 2, `${says}: plane ${i}`);
        });
        const rejects = answer.planes.findIndex(({ side }) => side === "outside");
        assert.equal(planes.length, rejects < 0 ? answer.planes.length : rejects + 1, `${says}: planes tested`);
        ++compared;
      }
    }
  assert.ok(compared >= 7, `${compared} bodies were compared`);
});

test("what a camera sees of a field, and how many planes that takes, is what snug cull says", () => {
  const lesson = lesson_of("frustum-field"), stage = { ...lesson.field, objects: 10000 };
  const { boxes, frustum } = field(stage, lesson.seed);
  const lines = boxes.map((box) => JSON.stringify({ frustum, volume: box })).join("\n");
  const answers = json_lines(good(["cull", "--tree", "median"], lines)), { by_tree, one_by_one } = answers.pop();
  const seen = (name) => answers.filter((answer) => answer.class === name).length;
  for (const { algorithm, figures } of ends(lesson))
    assert.deepEqual([figures.objects, figures.inside, figures.intersecting, figures.outside],
      [boxes.length, seen("inside"), seen("intersecting"), seen("outside")], algorithm);
  assert.equal(end_of(lesson, "p_n_vertex").planes, one_by_one.planes_tested);
  assert.equal(end_of(lesson, "tree_masking").planes, by_tree.planes_tested);
});

test("trees over boxes, and the tests of a frustum query, are those of snug cull", () => {
  const rules = { top_down_median: "median", top_down_sah: "surface_area", bottom_up: "bottom_up", insertion: "insertion" };
  const culled = (boxes, frustum, rule) => json_lines(good(["cull", "--dim", "2", "--leaf", "1", "--tree", rule],
    boxes.map((box) => JSON.stringify({ frustum, volume: box })).join("\n")));
  const build = lesson_of("bvh-build"), anywhere = query_frustum({ from: [-3, 0], to: [3, 0] });
  for (const [algorithm, rule] of Object.entries(rules)) {
    const { nodes, depth, cost } = culled(objects(build.objects), anywhere, rule).at(-1);
    const figures = end_of(build, algorithm);
    assert.deepEqual([figures.nodes, figures.depth], [nodes, depth], algorithm);
    same(figures.cost, cost, `${algorithm}: cost`);
  }
  const traverse = lesson_of("bvh-traverse");
  for (const [name, held] of situations(traverse, "objects")) {
    const query = situations(traverse, "query").find(([one]) => one === name)[1];
    const answers = culled(objects(held), query_frustum(query), rules[query.tree ?? "top_down_sah"]);
    const { nodes_visited, by_tree } = answers.pop(), figures = end_of(traverse, "frustum_query", name);
    assert.deepEqual([figures.visited, figures.tests, figures.found],
      [nodes_visited, by_tree.volume_tests, answers.filter((answer) => answer.class !== "outside").length], name);
  }
});

test("what lessons answer about the lectures' claims is what snug cost --trials counts", () => {
  let compared = 0;
  for (const { id, question = [] } of lessons.filter(({ chart }) => chart === "claims")) {
    const played = json_lines(good(["lesson", "play", id])).flatMap(({ questions = [] }) => questions);
    for (const { id: name, claim } of question.filter((one) => one.claim)) {
      const { rows } = JSON.parse(good(["cost", "--trials", claim, "--json"]));
      const held = rows.filter(({ holds }) => holds).length;
      const verdict = held === rows.length ? /^It holds on every cloud/ : 2 * held > rows.length ? /^It holds typically/ : /^It is false/;
      assert.match(played.find((one) => one.question === name).answer, verdict, `${id}, ${name}: ${held} of ${rows.length}`);
      ++compared;
    }
  }
  assert.ok(compared >= 5, `${compared} claims were compared`);
});

test("the survey of a lesson's frustum counts what tests/core/lesson/subjects/frustum/survey.test.cpp holds the lesson to", () => {
  const lesson = lesson_of("frustum-sphere");
  const counts = Object.fromEntries(situations(lesson, "boxes").map(([name, boxes]) => {
    const [told] = json_lines(good(["cull", "--survey", "1000000", "--seed", `${lesson.seed}`], JSON.stringify(body_and_frustum(boxes))));
    return [name, [told.inside, told.intersecting, told.outside, told.near_edges ?? 0, told.near_vertices]];
  }));
  assert.deepEqual(counts.own, [157719, 548001, 294280, 0, 6168]);
  assert.deepEqual(counts.vertex, counts.own); // around the same frustum, with the same radius
  assert.deepEqual(counts.edge, [60035, 510409, 429556, 9939, 7049]);
});

test("around meshes, how large a 14-DOP is over the smallest OBB is what snug fit measures", () => {
  const { text } = lesson_of("kdop-space").section.find(({ title }) => title === "Tightness");
  for (const mesh of ["bunny", "teapot", "dragon"]) {
    const file = join(dirname(program), "assets", "meshes", `${mesh}.ply`);
    const size = (kind, algorithm) => JSON.parse(good(["fit", "--volume", kind, "--algorithm", algorithm, "--repeat", "1", file])).measure;
    const ratio = (size("kdop", "k14") / size("obb", "exact")).toFixed(2);
    assert.ok(text.includes(`[${mesh}](mesh:${mesh}) | ${ratio} |`), `${mesh}: ${ratio}`);
  }
});
