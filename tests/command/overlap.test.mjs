// `snug overlap`: every pair of volumes, every form of them, and every way in which they can be wrong.
import assert from "node:assert/strict";
import { test } from "node:test";
import { good, json_lines, read, refused as refused_command, snug, write } from "./support.mjs";

/** The answers to lines, given as objects. */
function answers(lines, ...args) {
  return json_lines(good(["overlap", ...args], lines.map((line) => JSON.stringify(line)).join("\n")));
}
const answer = (a, b, ...args) => answers([{ a, b }], ...args)[0];

/** Refused with a line that names file and line. */
function refused(text, what, line = 1, ...args) {
  refused_command(["overlap", ...args], what instanceof RegExp ? what : `-:${line}: ${what}`, typeof text === "string" ? text : JSON.stringify(text));
}

const sphere = { sphere: { center: [0, 0, 0], radius: 1 } };
const with_sphere = (b) => ({ a: sphere, b });

/** A volume of each kind that reaches from x - 1 to x + 1, and there at y = z = 0. */
const space = {
  sphere: (x) => ({ center: [x, 0, 0], radius: 1 }),
  aabb: (x) => ({ min: [x - 1, -1, -1], max: [x + 1, 1, 1] }),
  obb: (x) => ({ center: [x, 0, 0], axes: [[0, 1, 0], [0, 0, 1], [1, 0, 0]], half_extents: [2, 3, 1] }),
  capsule: (x) => ({ a: [x, -1, 0], b: [x, 1, 0], radius: 1 }),
  lozenge: (x) => ({ origin: [x, -1, -1], edges: [[0, 2, 0], [0, 0, 2]], radius: 1 }),
  kdop: (x) => ({ k: 14, min: [x - 1, -1, -1, x - 2, x - 2, x - 2, -x - 2], max: [x + 1, 1, 1, x + 2, x + 2, x + 2, -x + 2] }),
  hull: (x) => ({ points: [[x - 1, 0, 0], [x + 1, 0, 0], [x, 1, 0], [x, -1, 0], [x, 0, 1], [x, 0, -1], [x, 0, 0]] }),
};
const plane = {
  sphere: (x) => ({ center: [x, 0], radius: 1 }),
  aabb: (x) => ({ min: [x - 1, -1], max: [x + 1, 1] }),
  obb: (x) => ({ center: [x, 0], axes: [[0, 1], [-1, 0]], half_extents: [2, 1] }),
  capsule: (x) => ({ a: [x, -1], b: [x, 1], radius: 1 }),
  lozenge: (x) => ({ origin: [x - 0.5, -1], edges: [[1, 0], [0, 2]], radius: 0.5 }),
  kdop: (x) => ({ k: 8, min: [x - 1, -1, x - 1.5, x - 1.5], max: [x + 1, 1, x + 1.5, x + 1.5] }),
  hull: (x) => ({ points: [[x - 1, 0], [x + 1, 0], [x, 1], [x, -1]] }),
};
const kinds = Object.keys(space);

/** Pairs of which touching is told from overlapping. */
const exactly_told = ["sphere sphere", "sphere aabb", "aabb aabb", "aabb obb", "obb obb"];

for (const [dim, of] of [[3, space], [2, plane]])
  for (const scalar of ["double", "float"])
    test(`every pair of volumes, apart, touching and overlapping, ${dim}-D ${scalar}`, () => {
      const small = 2 ** (scalar === "float" ? -12 : -40);
      const cases = kinds.flatMap((a) => kinds.flatMap((b) => [0.25, small, 0, -small, -1].flatMap((gap) =>
        [1, -1].map((side) => ({ a, b, gap, side })))));
      const results = answers(cases.map(({ a, b, gap, side }) => ({ a: { [a]: of[a](0) }, b: { [b]: of[b](side * (2 + gap)) } })),
        "--scalar", scalar);
      assert.equal(results.length, cases.length);
      results.forEach((result, i) => {
        const { a, b, gap, side } = cases[i];
        const about = `${a} ${b} ${gap} ${side}: ${JSON.stringify(result)}`;
        assert.deepEqual(Object.keys(result), ["overlap", "distance", "separating_axis", "tests", "test", "touching", "nearest", "penetration"], about);
        assert.equal(result.overlap, gap <= 0, about);
        assert.ok(Number.isInteger(result.tests) && result.tests > 0, about);
        assert.ok(Math.abs(result.distance - Math.max(0, gap)) < 1e-6, about);
        assert.equal(result.touching, gap > 0 || exactly_told.some((pair) => pair === `${a} ${b}` || pair === `${b} ${a}`) ? gap === 0 : null, about);
        const ends = gap > 0 ? result.nearest : result.penetration;
        assert.equal(gap > 0 ? result.penetration : result.nearest, null, about);
        const along = gap > 0 ? result.separating_axis.direction : result.penetration.direction;
        if (gap <= 0) assert.ok(result.penetration.depth >= 0 && result.penetration.depth <= -gap + 1e-6, about);
        // Both ends lie on both sides of the gap, or of the depth.
        const moved = ends.b.map((x, i) => x - ends.a[i] - along[i] * (gap > 0 ? result.distance : -result.penetration.depth));
        assert.ok(Math.hypot(...moved) < (gap > 0 ? 2e-3 : 1e-5), about);
        if (gap <= 0) return assert.equal(result.separating_axis, null, about);
        const { kind, direction, gap: found } = result.separating_axis;
        assert.deepEqual(Object.keys(result.separating_axis), ["kind", "direction", "gap"], about);
        assert.ok(["centers", "closest_points", "slab", "face_a", "face_b", "edge_edge"].includes(kind), about);
        assert.equal(direction.length, dim, about);
        assert.ok(Math.abs(Math.hypot(...direction) - 1) < 1e-6, about);
        assert.ok(Math.abs(direction[0] - side) < 1e-3, about);
        assert.ok(found > 0 && found <= gap + 1e-6, about);
      });
    });

test("an AABB is the same in its three forms, and never smaller than it was given", () => {
  const forms = [{ min: [1, 0, 0], max: [2, 1, 1] }, { min: [1, 0, 0], widths: [1, 1, 1] }, { center: [1.5, 0.5, 0.5], half_extents: [0.5, 0.5, 0.5] }];
  for (const aabb of forms) {
    assert.equal(answer(sphere, { aabb }).overlap, true);
    assert.equal(answer({ sphere: { center: [0, 0, 0], radius: 1 - 2 ** -53 } }, { aabb }).overlap, false);
  }
  // The rounded sum of 0.1 and 0.7 lies below the exact one; the box must not end there.
  const beyond = { aabb: { min: [0.8, 0, 0], max: [1, 1, 1] } };
  assert.ok(0.1 + 0.7 < 0.8);
  assert.equal(answer({ aabb: { min: [0.1, 0, 0], widths: [0.7, 1, 1] } }, beyond).overlap, true);
  assert.equal(answer({ aabb: { center: [0.1, 0, 0], half_extents: [0.7, 1, 1] } }, beyond).overlap, true);
});

test("scales and far offsets keep their digits", () => {
  for (const scale of [2 ** -330, 1, 2 ** 330])
    for (const a of kinds)
      for (const b of kinds) {
        const scaled = (value) => (typeof value === "number" ? value * scale : Array.isArray(value) ? value.map(scaled)
          : Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, key === "k" || key === "axes" ? inner : scaled(inner)])));
        const [apart, meeting] = answers([2.25, 1.75].map((x) => ({ a: { [a]: scaled(space[a](0)) }, b: { [b]: scaled(space[b](x)) } })));
        assert.equal(apart.overlap, false, `${a} ${b} ${scale}`);
        assert.ok(Math.abs(apart.separating_axis.gap / scale - 0.25) < 0.01, `${a} ${b} ${scale}`);
        assert.equal(meeting.overlap, true, `${a} ${b} ${scale}`);
      }
  const far = answer({ capsule: { a: [1e8, 0, 0], b: [1e8, 1, 0], radius: 0.5 } }, { capsule: { a: [1e8 + 2, 0, 0], b: [1e8 + 2, 0, 5], radius: 0.5 } });
  assert.equal(far.distance, 1);
});

test("a 6-DOP is of the other's dimension, or of --dim, or in space", () => {
  const kdop = { kdop: { k: 6, min: [0, 0, 0.5], max: [1, 1, 1.5] } };
  assert.equal(answer(kdop, { sphere: { center: [3, 0.5], radius: 1 } }).separating_axis.direction.length, 2);
  assert.equal(answer({ sphere: { center: [3, 0.5, 1], radius: 1 } }, kdop).separating_axis.direction.length, 3);
  const other = { kdop: { k: 6, min: [2, 0, 2.5], max: [3, 1, 3.5] } };
  assert.equal(answer(kdop, other).separating_axis.direction.length, 3);
  assert.equal(answer(kdop, other, "--dim", "2").separating_axis.direction.length, 2);
});

test("lines come from a file or standard input, and empty ones are passed over", () => {
  const line = JSON.stringify({ a: sphere, b: sphere });
  write("pairs.jsonl", `${line}\r\n\n  \n${line}\n`);
  const { out, status } = snug(["overlap", "pairs.jsonl"]);
  assert.equal(status, 0);
  assert.equal(out.split("\n").length, 3);
  assert.equal(snug(["overlap", "-"], line).out.split("\n").length, 2);
  assert.deepEqual(snug(["overlap"]), { out: "", err: "", status: 0 });
  const missing = snug(["overlap", "nowhere.jsonl"]);
  assert.equal(missing.err, "snug: nowhere.jsonl: cannot be opened: No such file or directory\n");
  assert.equal(missing.status, 2);
  write("bad.jsonl", `${line}\n${line}\n{}\n`);
  const bad = snug(["overlap", "bad.jsonl"]);
  assert.deepEqual(bad, { out: "", err: "snug: bad.jsonl:3: a is missing\n", status: 2 });
});

test("axes and edges as rough as float makes them are taken, and rougher ones are not", () => {
  const c = Math.fround(Math.SQRT1_2);
  const box = (axes) => ({ obb: { center: [0, 0, 0], axes, half_extents: [1, 1, 1] } });
  assert.equal(answer(box([[c, c, 0], [-c, c, 0], [0, 0, 1]]), sphere).overlap, true);
  assert.equal(answer(box([[0.7071068, 0.7071068, 0], [-0.7071068, 0.7071068, 0], [0, 0, 1]]), sphere).overlap, true);
  const rough = with_sphere(box([[0.7071, 0.7071, 0], [-0.7071, 0.7071, 0], [0, 0, 1]]));
  refused(rough, "b.obb.axes[0] is not of unit length", 1, "--strict");
  refused(with_sphere(box([[0.707, 0.707, 0], [-0.707, 0.707, 0], [0, 0, 1]])), "b.obb.axes[0] is not of unit length");
});

test("axes of four digits are made unit and perpendicular, and one warning counts them", () => {
  const far = { sphere: { center: [5, 0, 0], radius: 1 } };
  const rough = { a: far, b: { obb: { center: [0, 0, 0], axes: [[0.7071, 0.7071, 0], [-0.7071, 0.7071, 0], [0, 0, 1]], half_extents: [1, 1, 1] } } };
  const lozenge = { a: { lozenge: { origin: [9, 0, 0], edges: [[1, 0, 0], [0.0001, 1, 0]], radius: 1 } }, b: far };
  const { out, err, status } = snug(["overlap"], [{ a: far, b: far }, rough, lozenge].map((line) => JSON.stringify(line)).join("\n"));
  assert.equal(status, 0);
  assert.equal(err, "snug: -:2: warning: b.obb.axes (and 1 more) are only unit and perpendicular to about four digits, and were made so exactly\n");
  assert.ok(Math.abs(json_lines(out)[1].distance - (4 - Math.SQRT2)) < 1e-14);
});

test("how deep and how near: what is known comes out, and names may stand beside a 6-DOP", () => {
  const deep = answer({ aabb: { min: [0, 0, 0], max: [1, 1, 1] } }, { aabb: { min: [0.75, 0.5, -0.25], max: [2, 2, 2] } });
  assert.deepEqual([deep.distance, deep.nearest, deep.touching, deep.penetration.depth, deep.penetration.direction], [0, null, false, 0.25, [1, 0, 0]]);
  const near = answer({ aabb: { min: [0, 0, 0], max: [1, 1, 1] } }, { aabb: { min: [4, 5, 0], max: [5, 6, 1] } });
  assert.deepEqual([near.distance, near.nearest.a.slice(0, 2), near.nearest.b.slice(0, 2), near.penetration], [5, [1, 1], [4, 5], null]);
  // The intervals of these two overlap, the bodies do not.
  const [a, b] = [{ hull: { points: [[0, 0], [4, 0], [0, 4]] } }, { kdop: { k: 4, min: [2.5, 2.5], max: [3, 3] } }];
  assert.ok(Math.abs(answer(a, b).distance - Math.SQRT1_2) < 1e-12);
  const named = { name: "mine", kdop: { k: 6, min: [0, 0, 0.5], max: [1, 1, 1.5] } };
  assert.equal(answer(named, { sphere: { center: [3, 0.5], radius: 1 } }).nearest.a.length, 2);
});

test("a volume that is wrong is refused by the name of its field", () => {
  const obb = (changed) => with_sphere({ obb: { center: [0, 0, 0], axes: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], half_extents: [1, 1, 1], ...changed } });
  const lozenge = (changed) => with_sphere({ lozenge: { origin: [0, 0, 0], edges: [[1, 0, 0], [0, 1, 0]], radius: 1, ...changed } });
  const kdop = (changed) => with_sphere({ kdop: { k: 14, min: [0, 0, 0, 0, -1, -1, -1], max: [1, 1, 1, 3, 2, 2, 2], ...changed } });
  for (const [line, what] of [
    [with_sphere({ sphere: { center: [0, 0, 0], radius: -1 } }), "b.sphere.radius is negative"],
    [with_sphere({ sphere: { center: [0, 0, 0] } }), "b.sphere.radius is missing"],
    [with_sphere({ sphere: { center: [0, 0, 0], radius: 1, colour: 3 } }), 'b.sphere has an unknown field "colour"; it takes center, radius'],
    [with_sphere({ sphere: { center: [0, 0, 0], radius: "NaN" } }), "b.sphere.radius is not a number"],
    [with_sphere({ sphere: { center: [0, 0, 0], radius: null } }), "b.sphere.radius is not a number"],
    [with_sphere({ sphere: { center: [0, "inf", 0], radius: 1 } }), "b.sphere.center[1] is not a number"],
    [with_sphere({ sphere: { center: [0, 1e153, 0], radius: 1 } }), "b.sphere.center[1] is larger than this program can take (8.3e152)"],
    [with_sphere({ sphere: { center: 0, radius: 1 } }), "b.sphere.center is not a list of numbers"],
    [with_sphere({ sphere: { center: [0, 0, 0, 0], radius: 1 } }), "b.sphere.center has 4 numbers instead of 2 or 3"],
    [with_sphere({ sphere: { center: [0], radius: 1 } }), "b.sphere.center has 1 number instead of 2 or 3"],
    [with_sphere({ sphere: { center: [0, 0], radius: 1 } }), "a is 3-D and b is 2-D"],
    [with_sphere({ sphere: 3 }), "b.sphere is not an object"],
    [with_sphere({ ball: {} }), 'b is not a known kind: "ball"; known: sphere, aabb, obb, capsule, lozenge, kdop, hull'],
    [with_sphere({}), "b is not an object with a field that names its kind: sphere, aabb, obb, capsule, lozenge, kdop, hull"],
    [with_sphere({ ...sphere, aabb: {} }), "b is of two kinds: sphere and aabb"],
    [with_sphere([]), "b is not an object with a field that names its kind: sphere, aabb, obb, capsule, lozenge, kdop, hull"],
    [with_sphere({ aabb: { min: [0, 2, 0], max: [1, 1, 1] } }), "b.aabb.min[1] is above max[1]"],
    [with_sphere({ aabb: { min: [0, 2, 0], widths: [1, 1, -1] } }), "b.aabb.widths[2] is negative"],
    [with_sphere({ aabb: { center: [0, 2, 0], half_extents: [-1, 1, 1] } }), "b.aabb.half_extents[0] is negative"],
    [with_sphere({ aabb: { min: [0, 2, 0] } }), "b.aabb.max is missing"],
    [with_sphere({ aabb: { min: [0, 0, 0], max: [1, 1, 1], widths: [1, 1, 1] } }), 'b.aabb has an unknown field "max"; it takes min, widths'],
    [with_sphere({ aabb: { min: [0, 0, 0], max: [1, 1] } }), "b.aabb.max has 2 numbers instead of 3"],
    [obb({ axes: [[2, 0, 0], [0, 1, 0], [0, 0, 1]] }), "b.obb.axes[0] is not of unit length"],
    [obb({ axes: [[1, 0, 0], [0, 0, 0], [0, 0, 1]] }), "b.obb.axes[1] is not of unit length"],
    [obb({ axes: [[1, 0, 0], [0, 1, 0], [0, 0.6, 0.8]] }), "b.obb.axes[1] and [2] are not perpendicular"],
    [obb({ axes: [[1, 0, 0], [0, 1, 0], [0, 0, -1]] }), "b.obb.axes are left-handed"],
    [obb({ axes: [[1, 0, 0], [0, 1, 0]] }), "b.obb.axes has 2 rows instead of 3"],
    [obb({ half_extents: [1, -1, 1] }), "b.obb.half_extents[1] is negative"],
    [with_sphere({ capsule: { a: [0, 0, 0], b: [1, 0], radius: 1 } }), "b.capsule.b has 2 numbers instead of 3"],
    [with_sphere({ capsule: { a: [0, 0, 0], b: [1, 0, 0], radius: -0.5 } }), "b.capsule.radius is negative"],
    [lozenge({ radius: -1 }), "b.lozenge.radius is negative"],
    [lozenge({ edges: [[1, 0, 0], [1, 1, 0]] }), "b.lozenge.edges are not perpendicular"],
    [lozenge({ edges: [[1, 0, 0]] }), "b.lozenge.edges has 1 row instead of 2"],
    [lozenge({ edges: [[1, 0, 0], 5] }), "b.lozenge.edges[1] is not a list of numbers"],
    [kdop({ k: 7 }), "b.kdop.k is not one of 6, 14, 18, 26, in 2-D 4, 6, 8"],
    [kdop({ k: 14.5 }), "b.kdop.k is not one of 6, 14, 18, 26, in 2-D 4, 6, 8"],
    [kdop({ k: "14" }), "b.kdop.k is not one of 6, 14, 18, 26, in 2-D 4, 6, 8"],
    [kdop({ min: [0, 0, 0] }), "b.kdop.min has 3 numbers, and a 14-DOP has 7 slabs"],
    [kdop({ max: [1, 1, 1, 3, 2, -2, 2] }), "b.kdop.min[5] is above max[5]"],
    [kdop({ min: [0, 0, 0, 4, -1, -1, -1], max: [1, 1, 1, 5, 2, 2, 2] }), "b.kdop.min and max leave no point that is in all slabs"],
    [with_sphere({ hull: { points: [] } }), "b.hull.points has no points"],
    [with_sphere({ hull: { points: [[0, 0, 0], [1, 0]] } }), "b.hull.points[1] has 2 numbers instead of 3"],
    [with_sphere({ hull: { points: 3 } }), "b.hull.points is not a list of points"],
    [{ a: sphere }, "b is missing"],
    [[1, 2], "the line is not an object with the fields a and b"],
  ])
    refused(line, what);
});

test("it takes what snug fit prints, and passes over names; one JSON value over several lines is told apart from JSON Lines", () => {
  const fit = JSON.parse(good(["fit", "--volume", "obb", "--algorithm", "pca", write("fitted.xyz", "0 0 0\n4 0 0\n0 2 0\n0 0 1\n4 2 1\n")]));
  const pair = { name: "a pair", a: { ...fit, name: "mine" }, b: { sphere: { center: [9, 0, 0], radius: 1 } } };
  assert.equal(JSON.parse(good(["overlap"], JSON.stringify(pair))).overlap, false);
  refused_command(["overlap", write("pretty.json", JSON.stringify(pair, null, 2))], "pretty.json:1: this is one JSON value over several lines: write each object in a line of its own");
});

test("a line that is no JSON is refused with its number", () => {
  const good = JSON.stringify({ a: sphere, b: sphere });
  refused(`${good}\n{"a":`, /^snug: -:2: not JSON: parse error/);
  refused(`${good}\n\nnothing`, /^snug: -:3: not JSON: parse error/);
  refused(good.replace(/"radius":1/, '"radius":NaN'), /^snug: -:1: not JSON: parse error/);
  refused(good.replace(/"radius":1/, '"radius":1e999'), /^snug: -:1: not JSON: number overflow/);
  refused(good.replace(/"radius":1/, '"radius":1,"radius":2'), 'the key "radius" appears twice');
  refused(`${good} ${good}`, /^snug: -:1: not JSON: parse error/);
  refused(`${good}\0and more`, /^snug: -:1: not JSON: it has a NUL byte/);
  refused("[".repeat(100000), /^snug: -:1: not JSON: parse error/);
});

test("what float cannot take, and bad usage, is refused", () => {
  refused(with_sphere({ sphere: { center: [1e30, 0, 0], radius: 1 } }), "b.sphere.center[0] is larger than this program can take (1.1e18 in float)", 1, "--scalar", "float");
  refused(with_sphere(sphere), "a.sphere.center has 3 numbers instead of 2", 1, "--dim", "2");
  refused({ a: { kdop: { k: 14, min: [], max: [] } }, b: {} }, "a.kdop.k is not one of 4, 6, 8 in 2-D", 1, "--dim", "2");
  for (const args of [["--scalar", "half"], ["--dim", "4"], ["a", "b"], ["--jsonl"]]) {
    const { out, err, status } = snug(["overlap", ...args]);
    assert.equal(out, "");
    assert.match(err, /^snug: [^\n]+\n$/);
    assert.equal(status, 2);
  }
});

test("help says what the contract says", () => {
  const { out } = snug(["overlap", "--help"]);
  for (const word of ["--scalar", "--dim", "FILE", "sphere", "aabb", "widths", "half_extents", "obb", "axes", "capsule", "lozenge",
    "edges", "kdop", "hull", "points", "overlap", "distance", "separating_axis", "tests", "Exit status"])
    assert.ok(out.includes(word), word);
  assert.ok(snug(["--help"]).out.includes("overlap"));
});

/** The steps of lines, given as objects, one list for each. */
function traces(lines, ...args) {
  const results = answers(lines, "--steps", "overlap.jsonl", ...args);
  const steps = json_lines(read("overlap.jsonl"));
  return results.map((result, i) => ({ result, steps: steps.filter((step) => step.pair === i + 1) }));
}

for (const [dim, of] of [[3, space], [2, plane]])
  test(`every pair's test tells its steps, and they come to its answer, ${dim}-D`, () => {
    const cases = kinds.flatMap((a) => kinds.flatMap((b) => [1, -1].flatMap((gap) => [1, -1].map((side) => ({ a: { [a]: of[a](0) }, b: { [b]: of[b](side * (2 + gap)) } })))));
    for (const scalar of ["double", "float"])
      for (const [i, { result, steps }] of traces(cases, "--scalar", scalar).entries()) {
        const about = JSON.stringify([cases[i], result, steps]);
        assert.ok(steps.length > 0, about);
        const last = steps.at(-1);
        if (last.test === "slabs") assert.equal(last.separates, !result.overlap, about);
        if (last.test === "distance") assert.equal(last.apart, !result.overlap, about);
        if (last.test === "separating_axes") assert.deepEqual([last.step, last.overlap, last.tests], ["verdict", result.overlap, result.tests], about);
        if (last.test === "gjk") assert.equal(last.step, "distance_found", about);
        if (steps.every((step) => step.test === "slabs")) assert.equal(steps.length, result.tests, about);
        const ordered = steps.every((step) => step.first === steps[0].first && Number.isInteger(step.line));
        assert.ok(ordered && ["a", "b"].includes(steps[0].first), about);
        for (const vector of [last.direction, last.on_a].filter(Boolean)) assert.equal(vector.length, dim, about);
      }
  });

test("a slab's step has both intervals, a distance's both points", () => {
  const [boxes, spheres] = traces([
    { a: { aabb: { min: [0, 0, 0], max: [1, 2, 3] } }, b: { aabb: { min: [0.5, 4, 0], max: [2, 5, 1] } } },
    { a: { sphere: { center: [5, 0, 0], radius: 1 } }, b: { sphere: { center: [0, 0, 0], radius: 2 } } }]);
  assert.deepEqual(boxes.steps.map(({ direction, least_a, greatest_a, least_b, greatest_b, separates }) => [direction, least_a, greatest_a, least_b, greatest_b, separates]),
    [[[1, 0, 0], 0, 1, 0.5, 2, false], [[0, 1, 0], 0, 2, 4, 5, true]]);
  assert.equal(spheres.steps.length, 1);
  const { on_a, on_b, distance, radii, apart, first } = spheres.steps[0];
  const given = first === "a" ? [on_a, on_b] : [on_b, on_a];
  assert.deepEqual([...given, distance, radii, apart], [[5, 0, 0], [0, 0, 0], 5, 3, true]);
});

test("a trace that cannot be written, or is half done, leaves nothing", () => {
  const { err, status } = snug(["overlap", "--steps", "nowhere/t.jsonl"], JSON.stringify(with_sphere(sphere)));
  assert.match(err, /^snug: nowhere\/t\.jsonl: [^\n]+\n$/);
  assert.equal(status, 2);
  refused_command(["overlap", "--steps", "half.jsonl"], /^snug: -:2: /, `${JSON.stringify(with_sphere(sphere))}\n{}`);
  assert.throws(() => read("half.jsonl"));
});

test("random pairs: every pair is counted once, by its seed", () => {
  for (const [dim, rows] of [[2, 4], [3, 15]]) {
    const [counts] = json_lines(good(["overlap", "--random", "500", "--seed", "3", "--dim", String(dim)]));
    assert.deepEqual([counts.pairs, counts.seed, counts.dim, counts.rows.length], [500, 3, dim, rows]);
    assert.equal(counts.overlap + counts.rows.reduce((sum, { first }) => sum + first, 0), 500);
    assert.ok(counts.rows.every(({ first, separates }) => first <= separates));
    assert.ok(counts.tests_first_gap < counts.tests_all);
    assert.equal(counts.edges_alone, counts.rows.slice(2 * dim).reduce((sum, { first }) => sum + first, 0));
    const [again] = json_lines(good(["overlap", "--random", "500", "--seed", "3", "--dim", String(dim)]));
    assert.deepEqual(again, counts);
  }
  assert.equal(json_lines(good(["overlap", "--random", "10"]))[0].dim, 3);
});

test("costs: a line for each of the 28 pairs, with its test", () => {
  const rows = json_lines(good(["overlap", "--costs", "--dim", "2"]));
  assert.equal(rows.length, 28);
  assert.equal(new Set(rows.map(({ a, b }) => `${a} ${b}`)).size, 28);
  assert.ok(rows.every(({ time_ns, scene_ns, gjk_ns, apart, source }) => time_ns.median > 0 && scene_ns.median > 0 && gjk_ns.median > 0 && apart > 0 && apart < 1 && source.length > 10));
  assert.deepEqual(rows.filter(({ conservative }) => conservative).map(({ a, b }) => `${a} ${b}`), ["aabb kdop", "kdop kdop"]);
  assert.equal(rows.find(({ a, b }) => a === "aabb" && b === "kdop").test, "slabs");
  // As the lesson has it: tests/browser/volume_pair.test.mjs.
  assert.deepEqual(rows.map(({ apart }) => Math.round(96 * apart)), [19, 28, 26, 29, 31, 33, 37, 49, 44, 46, 46, 49, 54, 41, 43, 42, 47, 54, 46, 45, 46, 55, 45, 47, 55, 53, 57, 62], "of 96 pairs of bodies");
});
