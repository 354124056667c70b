// `snug cull`: every kind of volume against frusta of either form, and every way in which a line can be wrong.
import assert from "node:assert/strict";
import { test } from "node:test";
import { good, json_lines, read, refused as refused_command, snug, write } from "./support.mjs";

/** The answers to lines, given as objects. */
function answers(lines, ...args) {
  return json_lines(good(["cull", ...args], lines.map((line) => JSON.stringify(line)).join("\n")));
}
const answer = (frustum, volume, ...args) => answers([{ frustum, volume }], ...args)[0];

/** Refused with a line that names file and line. */
function refused(text, what, line = 1, ...args) {
  refused_command(["cull", ...args], what instanceof RegExp ? what : `-:${line}: ${what}`, typeof text === "string" ? text : JSON.stringify(text));
}

const cube = { planes: [[-1, 0, 0, -1], [1, 0, 0, -1], [0, -1, 0, -1], [0, 1, 0, -1], [0, 0, -1, -1], [0, 0, 1, -1]] };
const square = { planes: [[-1, 0, -1], [1, 0, -1], [0, -1, -1], [0, 1, -1]] };
/** 90 degrees, near 1, far 3, from the origin along -z. */
const perspective = { view_projection: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2, -1, 0, 0, -3, 0] };
const sphere = { sphere: { center: [0, 0, 0], radius: 0.5 } };

/** A volume of each kind that reaches from x - 0.5 to x + 0.5, and no farther otherwise. */
const space = {
  sphere: (x) => ({ center: [x, 0, 0], radius: 0.5 }),
  aabb: (x) => ({ min: [x - 0.5, -0.5, -0.5], max: [x + 0.5, 0.5, 0.5] }),
  obb: (x) => ({ center: [x, 0, 0], axes: [[0, 1, 0], [0, 0, 1], [1, 0, 0]], half_extents: [0.25, 0.125, 0.5] }),
  capsule: (x) => ({ a: [x, -0.25, 0], b: [x, 0.25, 0], radius: 0.5 }),
  lozenge: (x) => ({ origin: [x, -0.25, -0.25], edges: [[0, 0.5, 0], [0, 0, 0.5]], radius: 0.5 }),
  kdop: (x) => ({ k: 14, min: [x - 0.5, -0.5, -0.5, x - 1, x - 1, x - 1, -x - 1], max: [x + 0.5, 0.5, 0.5, x + 1, x + 1, x + 1, -x + 1] }),
  hull: (x) => ({ points: [[x - 0.5, 0, 0], [x + 0.5, 0, 0], [x, 0.5, 0], [x, -0.5, 0], [x, 0, 0.5], [x, 0, -0.5]] }),
};
const plane = {
  sphere: (x) => ({ center: [x, 0], radius: 0.5 }),
  aabb: (x) => ({ min: [x - 0.5, -0.5], max: [x + 0.5, 0.5] }),
  obb: (x) => ({ center: [x, 0], axes: [[0, 1], [-1, 0]], half_extents: [0.25, 0.5] }),
  capsule: (x) => ({ a: [x, -0.25], b: [x, 0.25], radius: 0.5 }),
  lozenge: (x) => ({ origin: [x - 0.25, -0.25], edges: [[0.5, 0], [0, 0.5]], radius: 0.25 }),
  kdop: (x) => ({ k: 8, min: [x - 0.5, -0.5, x - 1, x - 1], max: [x + 0.5, 0.5, x + 1, x + 1] }),
  hull: (x) => ({ points: [[x - 0.5, 0], [x + 0.5, 0], [x, 0.5], [x, -0.5]] }),
};

for (const [dim, of, frustum] of [[3, space, cube], [2, plane, square]])
  for (const scalar of ["double", "float"])
    test(`every kind of volume inside, touching from in and out, and outside, ${dim}-D ${scalar}`, () => {
      const small = 2 ** (scalar === "float" ? -22 : -50);
      const classes = [[0, "inside"], [0.5, "inside"], [0.5 + small, "intersecting"], [1, "intersecting"], [1.5, "intersecting"], [1.5 + small, "outside"], [9, "outside"]];
      const cases = Object.keys(of).flatMap((kind) => classes.flatMap(([x, name]) => [1, -1].map((side) => ({ kind, x: side * x, side, name }))));
      const results = answers(cases.map(({ kind, x }) => ({ frustum, volume: { [kind]: of[kind](x) } })), "--scalar", scalar);
      assert.equal(results.length, cases.length);
      results.forEach((result, i) => {
        const { kind, x, side, name } = cases[i];
        const about = `${kind} ${x}: ${JSON.stringify(result)}`;
        assert.deepEqual(Object.keys(result), ["class", "planes", "exact"], about);
        assert.equal(result.class, name, about);
        const touches = Math.abs(x) === 1.5;  // of others than boxes and spheres only rounding would tell
        assert.equal(result.exact, touches && !["sphere", "aabb", "obb"].includes(kind) ? null : name, about);
        assert.deepEqual(result.planes.map((one) => one.plane), [...Array(2 * dim).keys()], about);
        const near = result.planes[side > 0 ? 1 : 0];
        assert.deepEqual(Object.keys(near), ["plane", "p_vertex", "n_vertex", "side", "p_distance", "n_distance"], about);
        assert.equal(near.side, name, about);
        assert.ok(Math.abs(near.p_vertex[0] - (x + side * 0.5)) < 1e-6, about);
        assert.ok(Math.abs(near.n_vertex[0] - (x - side * 0.5)) < 1e-6, about);
        assert.equal(near.p_vertex.length, dim, about);
        assert.ok(Math.abs(near.p_distance - (side * x - 0.5)) < 1e-6, about);
        assert.ok(Math.abs(near.n_distance - (side * x - 1.5)) < 1e-6, about);
        for (const other of result.planes.slice(2)) assert.equal(other.side, "inside", about);
      });
    });

test("p- and n-vertex are the corners that the normal's signs choose", () => {
  const slanted = structuredClone(cube);
  slanted.planes[1] = [3, -4, 12, -13];  // of length 13
  const { planes } = answer(slanted, { aabb: { min: [1, 2, 3], max: [4, 5, 6] } });
  assert.deepEqual(planes[1], { plane: 1, p_vertex: [4, 2, 6], n_vertex: [1, 5, 3], side: "outside", p_distance: 63 / 13, n_distance: 6 / 13 });
});

test("a view-projection matrix gives the six planes of its clip space", () => {
  const cases = [[[0, 0, -2], "inside"], [[0, 0, -0.25], "outside"], [[0, 0, -1], "intersecting"], [[0, 0, -3.4], "intersecting"], [[0, 0, -3.6], "outside"],
    [[2, 0, -2], "intersecting"], [[-2.8, 0, -2], "outside"], [[0, 2, -2], "intersecting"], [[0, -2.8, -2], "outside"]];
  for (const scalar of ["double", "float"])
    assert.deepEqual(answers(cases.map(([center]) => ({ frustum: perspective, volume: { sphere: { center, radius: 0.5 } } })), "--scalar", scalar)
      .map((result) => result.class), cases.map(([, name]) => name));
});

test("what the planes call intersecting near an edge, and is outside, is told by exact", () => {
  const box = { aabb: { min: [-6, -0.5, -4.5], max: [-3.25, 0.5, -2.5] } };  // beside the far left edge, at x = -3, z = -3
  const far = answer(perspective, box);
  assert.equal(far.class, "intersecting");
  assert.equal(far.exact, "outside");
  const touching = answer(perspective, { aabb: { ...box.aabb, max: [-3, 0.5, -2.5] } });
  assert.equal(touching.exact, "intersecting");
  // No frustum that bounds: nobody knows.
  const open = structuredClone(cube);
  open.planes[1] = [-1, 0, 0, -1];
  assert.equal(answer(open, { aabb: { min: [-2, 0, 0], max: [5, 0, 0] } }).exact, null);
});

test("every kind of volume beside an edge of the frustum is told to be outside it", () => {
  const beside = (x) => ({  // all nearest to the far left edge at x = -3, z = -3, a little inside both of its planes
    sphere: { center: [-3 - x, 0, -3 - x], radius: x * Math.SQRT2 - 1e-3 },
    capsule: { a: [-3 - x, -1, -3 - x], b: [-3 - x, 1, -3 - x], radius: x * Math.SQRT2 - 1e-3 },
    lozenge: { origin: [-3 - x, -1, -3 - x], edges: [[0, 2, 0], [-1, 0, -1]], radius: x * Math.SQRT2 - 1e-3 },
    kdop: { k: 14, min: [-6, -0.5, -4.5, -20, -20, -20, -20], max: [-3.25, 0.5, -2.5, 20, 20, 20, 20] },
    hull: { points: [[-6, 0, -2.5], [-3.25, 0, -2.5], [-3.25, 0.5, -4.5], [-6, 0.5, -4.5], [-4, -0.5, -3]] },
  });
  const lines = Object.entries(beside(1)).map(([kind, volume]) => ({ name: kind, frustum: perspective, volume: { [kind]: volume } }));
  assert.deepEqual(answers(lines).map((result) => [result.class, result.exact]), lines.map(() => ["intersecting", "outside"]));
  // The sphere that touches the edge is decided exactly: 3, 4 and 5.
  for (const [radius, exact] of [[5, "intersecting"], [5 - 2 ** -50, "outside"]])
    assert.equal(answer(cube, { sphere: { center: [4, 5, 0], radius } }).exact, exact);
});

test("clip spaces from 0, reversed depth and a far plane at infinity give the planes that they mean", () => {
  const near = 1, far = 3;  // 90 degrees, along -z
  const matrix = (z, w) => ({ view_projection: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, z, -1, 0, 0, w, 0] });
  const of_zero = { ...matrix(far / (near - far), near * far / (near - far)), clip: "0..1" };
  const reversed = { ...matrix(near / (far - near), near * far / (far - near)), clip: "0..1" };
  const spheres = [[0, 0, -2], [0, 0, -0.25], [0, 0, -1], [0, 0, -3.4], [0, 0, -3.6], [2, 0, -2], [0, -2.8, -2], [5, 0, -9]]
    .map((center) => ({ sphere: { center, radius: 0.5 } }));
  const classes = (frustum, ...args) => answers(spheres.map((volume) => ({ frustum, volume })), ...args);
  const told = (results) => results.map(({ class: name, planes, exact }) => [name, exact, planes.map((plane) => plane.side)]);
  for (const args of [[], ["--scalar", "float"]]) {
    const wanted = told(classes(perspective, ...args));
    assert.deepEqual(told(classes(of_zero, ...args)), wanted);
    assert.deepEqual(told(classes(reversed, ...args)), wanted);
    assert.deepEqual(told(classes({ ...matrix(-2, -3), clip: "-1..1" }, ...args)), wanted);
    // Without an end: OpenGL's, from 0, and reversed; as planes too.
    const endless = [matrix(-1, -2 * near), { ...matrix(-1, -near), clip: "0..1" }, { ...matrix(0, near), clip: "0..1" },
      { planes: [[-1, 0, 1, 0], [1, 0, 1, 0], [0, -1, 1, 0], [0, 1, 1, 0], [0, 0, 1, 1], null] }].map((frustum) => told(classes(frustum, ...args)));
    for (const one of endless) {
      assert.deepEqual(one.map(([name]) => name), ["inside", "outside", "intersecting", "inside", "inside", "intersecting", "outside", "inside"]);
      assert.deepEqual(one.map(([, exact]) => exact), one.map(([name]) => name));
      assert.ok(one.every(([, , sides]) => sides.length === 5));
    }
  }
  const corner = { aabb: { min: [-30, -1, -9], max: [-10, 1, -8] } };
  assert.equal(answer({ ...matrix(0, near), clip: "0..1" }, corner).exact, "outside");
  const tree = answers([[0, 0, -2], [0, 0, -500], [9, 0, -2]].map((center) => ({ frustum: { ...matrix(0, near), clip: "0..1" }, volume: { sphere: { center, radius: 0.5 } } })), "--tree", "median");
  assert.deepEqual(tree.slice(0, 3).map((result) => result.class), ["inside", "inside", "outside"]);
  const flat = { planes: [[-1, 1, 0], [1, 1, 0], [0, 1, 1], null] };
  assert.equal(answer(flat, { sphere: { center: [0, -1e6], radius: 1 } }).class, "inside");
  refused({ frustum: { ...perspective, clip: "0..2" }, volume: sphere }, 'frustum.clip is neither "-1..1" nor "0..1"');
  refused({ frustum: { ...cube, clip: "0..1" }, volume: sphere }, "frustum.clip goes with view_projection only");
  refused({ frustum: flat, volume: { sphere: { center: [0, 0], radius: 1 } } }, "frustum: its far plane lies at infinity, and --survey needs vertices", 1, "--survey", "9");
});

test("the corners' tests: one that is right, and the one that loses a box wider than the frustum", () => {
  const wide = { obb: { center: [0.5, 0, 0], axes: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], half_extents: [3, 0.5, 0.5] } };
  const beside = { aabb: { min: [2, -9, 0], max: [3, 9, 1] } };
  const inside = { aabb: { min: [-0.5, -0.5, -0.5], max: [0.5, 0.5, 0.5] } };
  const classes = (name) => answers([wide, beside, inside].map((volume) => ({ frustum: cube, volume })), "--test", name).map((result) => [result.class, result.exact]);
  const right = [["intersecting", "intersecting"], ["outside", "outside"], ["inside", "inside"]];
  assert.deepEqual(classes("planes"), right);
  assert.deepEqual(classes("corners"), right);
  assert.deepEqual(classes("corners_outside"), [["outside", "intersecting"], ...right.slice(1)]);
  refused({ frustum: cube, volume: sphere }, "volume is neither aabb nor obb, which --test corners needs", 1, "--test", "corners");
});

test("every kind of volume tells the steps of its test", () => {
  for (const [of, frustum, planes, corners] of [[space, cube, 6, 8], [plane, square, 4, 4]]) {
    const kinds = Object.keys(of);
    const run = (names, ...args) => {
      const lines = names.map((kind) => ({ frustum, volume: { [kind]: of[kind](1) } }));
      const results = answers(lines, "--steps", "cull.jsonl", ...args);
      const steps = json_lines(read("cull.jsonl"));
      return results.map((result, i) => ({ result, steps: steps.filter((step) => step.volume === i + 1) }));
    };
    for (const scalar of ["double", "float"])
      for (const { result, steps } of run(kinds, "--scalar", scalar)) {
        assert.deepEqual(steps.map((step) => step.step), [...Array(planes).fill("plane_tested"), "classified"]);
        steps.slice(0, -1).forEach((step, i) => assert.deepEqual([step.plane, step.p_point, step.n_point], [i, result.planes[i].p_vertex, result.planes[i].n_vertex]));
        assert.equal(["inside", "intersecting", "outside"][steps.at(-1).verdict], result.class);
      }
    for (const name of ["corners", "corners_outside"])
      for (const { steps } of run(["aabb", "obb"], "--test", name)) {
        assert.equal(steps.at(-1).step, "classified");
        assert.equal(steps.filter((step) => step.step === "corner_tested").length, name === "corners" ? planes * corners : corners);
        assert.ok(steps.every((step) => step.test === name));
      }
  }
});

/** Volumes of a kind on a lattice of n by n places, of which the frustum sees some. */
const lattice = (of, kind, frustum, n) => Array.from({ length: n * n }, (_, i) => {
  const volume = of[kind]((i % n) * 1.25 - 6);
  return { frustum, volume: { [kind]: volume } };
});

test("a tree of any kind, built by any rule, gives each volume its own class, and tests fewer", () => {
  for (const [of, frustum, most] of [[space, cube, 6], [plane, square, 4]])
    for (const kind of Object.keys(of))
      for (const scalar of ["double", "float"]) {
        const lines = lattice(of, kind, frustum, 11);
        const alone = answers(lines, "--scalar", scalar).map((result) => result.class);
        assert.ok(["inside", "intersecting", "outside"].every((name) => alone.includes(name)));
        for (const rule of ["median", "surface_area", "bottom_up", "insertion"]) {
          const results = answers(lines, "--scalar", scalar, "--tree", rule, "--steps", "tree.jsonl");
          const about = `${kind} ${scalar} ${rule}`;
          const { tree, nodes, nodes_visited, by_tree, without_masks, one_by_one } = results.pop();
          assert.deepEqual(results.map((result) => result.class), alone, about);
          assert.equal(tree, rule);
          assert.ok(nodes_visited < nodes && nodes < 2 * lines.length, about);
          assert.ok(by_tree.volume_tests < one_by_one.volume_tests, `${about} ${JSON.stringify([by_tree, one_by_one])}`);
          assert.equal(by_tree.volume_tests, without_masks.volume_tests, about);
          assert.ok(by_tree.planes_tested < without_masks.planes_tested && without_masks.planes_tested <= most * without_masks.volume_tests, about);
          const steps = json_lines(read("tree.jsonl"));
          assert.equal(steps.filter((step) => step.step === "volume_made").length, nodes, about);
          assert.equal(steps.filter((step) => step.step === "node_visited" || step.step === "body_tested").length, by_tree.volume_tests, about);
        }
      }
});

test("a tree of what does not belong together is refused", () => {
  const other = { frustum: cube, volume: { aabb: { min: [0, 0, 0], max: [1, 1, 1] } } };
  const line = { frustum: cube, volume: sphere };
  const two = (a, b) => `${JSON.stringify(a)}\n${JSON.stringify(b)}`;
  refused(two(line, other), "volume is of another kind than the first line's; a tree takes one kind", 2, "--tree", "median");
  refused(two(line, { ...line, frustum: perspective }), "frustum differs from the first line's; a tree is tested against one", 2, "--tree", "median");
  const tiny = { ...line, frustum: { planes: cube.planes.map((row) => row.map((x) => x * 1e-60)) } };
  assert.equal(answers([tiny, tiny], "--tree", "median").length, 3);
  refused(two(tiny, tiny), "frustum: plane 0 (left) has no normal: it is zero", 1, "--tree", "median", "--scalar", "float");
  refused_command(["cull", "--tree", "median", "--test", "corners"], "--tree goes with --test planes only", JSON.stringify(line));
  assert.equal(good(["cull", "--tree", "median"], ""), "");
});

test("lines come from a file or standard input, and empty ones are passed over", () => {
  const line = JSON.stringify({ frustum: cube, volume: sphere });
  write("volumes.jsonl", `${line}\r\n\n  \n${line}\n`);
  const { out, status } = snug(["cull", "volumes.jsonl"]);
  assert.equal(status, 0);
  assert.equal(out.split("\n").length, 3);
  assert.equal(snug(["cull", "-"], line).out.split("\n").length, 2);
  assert.deepEqual(snug(["cull"]), { out: "", err: "", status: 0 });
  assert.deepEqual(snug(["cull", "nowhere.jsonl"]), { out: "", err: "snug: nowhere.jsonl: cannot be opened: No such file or directory\n", status: 2 });
  write("bad.jsonl", `${line}\n${line}\n{}\n`);
  assert.deepEqual(snug(["cull", "bad.jsonl"]), { out: "", err: "snug: bad.jsonl:3: frustum is missing\n", status: 2 });
});

test("a 6-DOP is of the frustum's dimension", () => {
  const kdop = { kdop: { k: 6, min: [0, 0, 0], max: [0.5, 0.5, 0.5] } };
  assert.equal(answer(cube, kdop).planes[0].p_vertex.length, 3);
  assert.equal(answer(square, kdop).planes[0].p_vertex.length, 2);
});

test("a line that is wrong is refused by the name of its field", () => {
  const of = (frustum) => ({ frustum, volume: sphere });
  const planes = (change) => {
    const changed = structuredClone(cube);
    change(changed.planes);
    return of(changed);
  };
  for (const [line, what] of [
    [[1], "the line is not an object with frustum, volume"],
    [{ volume: sphere }, "frustum is missing"],
    [{ frustum: cube }, "volume is missing"],
    [of(3), "frustum is not an object with planes, view_projection, clip"],
    [of({}), "frustum must have exactly one of the fields planes, view_projection"],
    [of({ ...cube, ...perspective }), "frustum must have exactly one of the fields planes, view_projection"],
    [of({ matrix: [] }), 'frustum has an unknown field "matrix"; it takes planes, view_projection, clip'],
    [of({ planes: 3 }), "frustum.planes is not a list of planes"],
    [of({ planes: cube.planes.slice(1) }), "frustum.planes has 5 rows instead of 6 (in 2-D 4)"],
    [planes((all) => (all[2] = null)), "frustum.planes[2] is not a list of numbers"],
    [planes((all) => all[2].pop()), "frustum.planes[2] has 3 numbers instead of 4"],
    [planes((all) => (all[2] = "up")), "frustum.planes[2] is not a list of numbers"],
    [planes((all) => (all[2][3] = null)), "frustum.planes[2][3] is not a number"],
    [planes((all) => (all[3] = [0, 0, 0, 1])), "frustum: plane 3 (top) has no normal: it is zero"],
    [planes((all) => (all[3] = [0, 1e200, 0, 1])), "frustum: plane 3 (top) has a normal longer than this program can take"],
    [planes((all) => (all[3] = [0, 1e-200, 0, 0])), "frustum: plane 3 (top) has a normal shorter than this program can take"],
    [planes((all) => (all[3] = [0, 1, 0, 1e200])), "frustum: plane 3 (top) is farther away than this program can take"],
    [planes((all) => (all[3] = [0, 1, 0, 1e308])), "frustum.planes[3][3] is larger than this program can take"],
    [of({ view_projection: perspective.view_projection.slice(1) }), "frustum.view_projection has 15 numbers instead of 16"],
    [of({ view_projection: perspective.view_projection.map((x, i) => (i === 3 ? "0" : x)) }), "frustum.view_projection[3] is not a number"],
    [of({ view_projection: [1, 2, 0, 0, 2, 4, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] }), "frustum: the matrix is singular"],
    [{ frustum: square, volume: sphere }, "volume.sphere.center has 3 numbers instead of 2"],
    [{ frustum: cube, volume: { sphere: { center: [0, 0, 0], radius: -1 } } }, "volume.sphere.radius is negative"],
    [{ frustum: cube, volume: {} }, "volume is not an object with a field that names its kind: sphere, aabb, obb, capsule, lozenge, kdop, hull"],
  ])
    refused(line, what);
  const good = JSON.stringify(of(cube));
  refused(`${good}\n{"frustum":`, /^snug: -:2: not JSON: parse error/);
  refused(good.replace('"radius":0.5', '"radius":1,"radius":2'), 'the key "radius" appears twice');
});

test("what float cannot take, and bad usage, is refused", () => {
  refused({ frustum: cube, volume: { sphere: { center: [1e30, 0, 0], radius: 1 } } }, "volume.sphere.center[0] is larger than this program can take (1.1e18 in float)", 1, "--scalar", "float");
  const long = structuredClone(cube);
  long.planes[0][3] = 1e37;
  refused({ frustum: long, volume: sphere }, "frustum.planes[0][3] is larger than this program can take", 1, "--scalar", "float");
  long.planes[0][3] = 1e22;
  refused({ frustum: long, volume: sphere }, "frustum: plane 0 (left) is farther away than this program can take", 1, "--scalar", "float");
  refused({ frustum: cube, volume: sphere }, "frustum.planes has 6 rows instead of 4", 1, "--dim", "2");
  refused({ frustum: perspective, volume: sphere }, "frustum.view_projection is 3-D, and --dim is 2", 1, "--dim", "2");
  for (const args of [["--scalar", "half"], ["--dim", "4"], ["--test", "corner"], ["--tree", "best"], ["--steps", "no/where"], ["a", "b"], ["--jsonl"]]) {
    const { out, err, status } = snug(["cull", ...args]);
    assert.equal(out, "");
    assert.match(err, /^snug: [^\n]+\n$/);
    assert.equal(status, 2);
  }
});

test("help says what the contract says", () => {
  const { out } = snug(["cull", "--help"]);
  for (const word of ["--scalar", "--dim", "FILE", "frustum", "planes", "view_projection", "column-major", "normals point out", "sphere", "aabb", "widths",
    "obb", "capsule", "lozenge", "kdop", "hull", "class", "inside", "intersecting", "outside", "p_vertex", "n_vertex", "side", "exact", "Exit status"])
    assert.ok(out.includes(word), word);
  assert.ok(snug(["--help"]).out.includes("cull"));
});

test("no box or k-DOP loses a point on its way to float: what touches is not outside, what sticks out not inside", () => {
  const far = [[1, 0, 0, -1e9], [0, -1, 0, -1e9], [0, 1, 0, -1e9], [0, 0, -1, -1e9], [0, 0, 1, -1e9]];
  const forms = [{ center: [16777216, 0.5, 0], half_extents: [0.75, 0, 0] }, { min: [16777216, 0.5, 0], widths: [0.75, 0, 0] }];
  for (const form of forms)
    for (const planes of [[[-1, 1, 0, 16777216], ...far], [[1, -1, 0, -16777216], [-1, 0, 0, -1e9], ...far.slice(1)]])
      for (const scalar of ["double", "float"])
        assert.equal(answer({ planes }, { aabb: form }, "--scalar", scalar).class, "intersecting", JSON.stringify([form, planes[0], scalar]));
});

test("a point as a k-DOP, rounded, is on one side of a plane, and a tree says the same of it", () => {
  const kdop = (x, y) => ({ kdop: { k: 8, min: [x, y, x + y, x - y], max: [x, y, x + y, x - y] } });
  const normal = [-0.13446585834026337, 0.5245601534843445];
  for (const scalar of ["double", "float"]) {
    const points = Array.from({ length: 60 }, (_, i) => [Math.fround(Math.sin(7 * i)), Math.fround(Math.cos(11 * i))]);
    for (const [x, y] of points) {
      const frustum = { planes: [[...normal, -(normal[0] * x + normal[1] * y)], [1, 0, -10], [0, -1, -10], [0, 1, -10]] };
      const alone = answer(frustum, kdop(x, y), "--scalar", scalar);
      const [left] = alone.planes;
      assert.ok(left.n_distance <= left.p_distance, JSON.stringify([x, y, scalar, left]));
      assert.equal(answers([{ frustum, volume: kdop(x, y) }], "--scalar", scalar, "--tree", "median")[0].class, alone.class);
    }
  }
});

test("a survey counts the false positives among random spheres, by its seed", () => {
  const line = { frustum: cube, volume: { sphere: { center: [9, 9, 9], radius: 0.6 } } };
  const survey = (...args) => answers([line], "--survey", "20000", ...args)[0];
  const first = survey("--seed", "5");
  assert.deepEqual(Object.keys(first), ["spheres", "seed", "radius", "inside", "intersecting", "outside", "false_positives", "near_edges", "near_vertices"]);
  assert.equal(first.inside + first.intersecting + first.outside, 20000);
  assert.equal(first.false_positives, first.near_edges + first.near_vertices);
  assert.ok(first.near_edges > 50 && first.near_vertices > 50);
  assert.deepEqual(survey("--seed", "5"), first);
  assert.notDeepEqual(survey("--seed", "6"), first);
  const [flat] = answers([{ frustum: square, volume: { sphere: { center: [0, 0], radius: 0.6 } } }], "--survey", "20000");
  assert.equal(flat.false_positives, flat.near_vertices);
  assert.equal(flat.near_edges, undefined);
  // Around a square with spheres of radius r, the share is that of four corners without their quarter circles.
  const touching_square = (2 + 2 * 0.6) ** 2, corners = (4 - Math.PI) * 0.6 ** 2;
  assert.ok(Math.abs(flat.false_positives / 20000 - corners / touching_square) < 0.005);
  refused_command(["cull", "--survey", "10"], /volume is not a sphere/, JSON.stringify({ frustum: cube, volume: { aabb: space.aabb(0) } }));
  refused_command(["cull", "--survey", "10", "--tree", "median"], /--survey goes with/, "");
});
