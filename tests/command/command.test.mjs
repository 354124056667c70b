// The `snug` command as scripts and graders use it: what it prints, where, and how it ends.
import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { once } from "node:events";
import { existsSync, mkdirSync, readFileSync, readdirSync, symlinkSync, truncateSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { folder, good, json_lines, program, read, refused, root, snug, write } from "./support.mjs";

const corpus = join(root, "tests/corpus/points");
const lessons = join(root, "lessons");

const fit_args = (algorithm, ...more) => ["fit", "--volume", "sphere", "--algorithm", algorithm, ...more];
const fit = (algorithm, ...more) => JSON.parse(good(fit_args(algorithm, ...more)));

const tetra = write("tetra.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
const algorithms = ["aabb_center", "ritter", "ritter_iterative", "pca", "welzl", "pivot", "brute_force", "welzl_recursive", "brute_force_slide"];
const naive = ["welzl_naive", "welzl_epsilon"]; // they promise nothing

test("fit prints one object with the contract's keys in their order", () => {
  for (const algorithm of algorithms) {
    const out = good(fit_args(algorithm, tetra));
    assert.equal(out.split("\n").length, 2);
    const result = JSON.parse(out);
    assert.deepEqual(Object.keys(result), ["sphere", "points", "support", "measure", "max_outside", "certificate",
      "steps", "operations", "time_ns"]);
    assert.deepEqual(Object.keys(result.certificate), ["contains", "on_boundary", "optimal"]);
    assert.deepEqual(Object.keys(result.time_ns), ["median", "min", "repeats"]);
    const { center, radius } = result.sphere;
    assert.equal(result.points, 4);
    assert.equal(result.max_outside, 0);
    assert.equal(result.certificate.contains, true);
    assert.ok(Math.abs(result.measure / (4 / 3 * Math.PI * radius ** 3) - 1) < 1e-14);
    assert.ok(radius >= Math.sqrt(2 / 3) && radius < 1);
    for (const p of [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
      assert.ok(Math.hypot(...p.map((x, i) => x - center[i])) <= radius * (1 + 1e-15));
    assert.ok(result.support.every((i) => i >= 0 && i < 4));
    assert.ok(result.steps > 0 && result.operations.points_touched > 0);
    assert.ok(result.time_ns.min > 0 && result.time_ns.min <= result.time_ns.median);
  }
});

test("only exact algorithms claim to be optimal, and are", () => {
  for (const algorithm of algorithms)
    assert.equal(fit(algorithm, tetra).certificate.optimal, ["welzl", "pivot", "brute_force", "welzl_recursive"].includes(algorithm) ? true : null);
  const { sphere, support } = fit("welzl", tetra);
  assert.deepEqual([...support].sort(), [1, 2, 3]);
  assert.ok(Math.abs(sphere.radius - Math.sqrt(2 / 3)) < 1e-15);
});

test("one point is a ball of radius zero", () => {
  for (const algorithm of algorithms) {
    const result = fit(algorithm, write("one.xyz", "1 -2 0.1\n"));
    assert.deepEqual(result.sphere, { center: [1, -2, 0.1], radius: 0 });
    assert.equal(result.measure, 0);
    assert.equal(result.certificate.contains, true);
  }
});

test("2-D points have two coordinates and an area", () => {
  const result = fit("welzl", write("flat.csv", "x,y\n-1,0\n1,0\n"));
  assert.deepEqual(result.sphere, { center: [0, 0], radius: 1 });
  assert.equal(result.measure, Math.PI);
  assert.deepEqual(fit("welzl", "--dim", "3", "flat.csv").sphere.center, [0, 0, 0]);
});

test("numbers read back to the same bits, and float results are floats", () => {
  const points = write("third.xyz", "0.1 0.2 0.3\n");
  assert.deepEqual(fit("ritter", points).sphere.center, [0.1, 0.2, 0.3]);
  assert.deepEqual(fit("ritter", "--scalar", "float", points).sphere.center, [0.1, 0.2, 0.3].map(Math.fround));
});

test("in float fit says how far rounding moved the points, and how far outside it leaves those of the file", () => {
  const far = write("far_off.xyz", "100000003 0 0\n100000003 0 1\n"); // floats there are 8 apart
  const volumes = { sphere: "welzl", aabb: "min_max", obb: "exact", capsule: "pca", lozenge: "pca", kdop: "k14", hull: "quickhull" };
  for (const [volume, algorithm] of Object.entries(volumes)) {
    const result = JSON.parse(good(["fit", "--volume", volume, "--algorithm", algorithm, "--scalar", "float", far]));
    assert.equal(result.max_outside, 0, volume);
    assert.equal(result.certificate.contains, true, volume);
    assert.equal(result.rounded_by, 3, volume);
    assert.equal(result.certificate_of, "points rounded to float", volume);
    const outside = volume === "sphere" ? Math.hypot(3, 0.5) - 0.5 : 3;
    assert.ok(Math.abs(result.max_outside_of_file - outside) < 1e-6, `${volume} ${result.max_outside_of_file}`);
  }
});

test("points that are floats already lose nothing, and in double there is nothing to say of rounding", () => {
  const same = fit("welzl", "--scalar", "float", tetra);
  assert.deepEqual([same.rounded_by, same.max_outside_of_file], [0, 0]);
  const third = fit("welzl", "--scalar", "float", "--dim", "3", write("thirds.csv", "0.1,0.2\n-0.1,0.7\n"));
  assert.ok(third.rounded_by > 1e-9 && third.rounded_by < 1e-7);
  assert.ok(third.max_outside_of_file <= third.rounded_by);
  assert.equal("rounded_by" in fit("welzl", tetra), false);
  const twins = JSON.parse(good(["fit", "--case", "far-sphere", "--volume", "sphere", "--algorithm", "welzl"]));
  assert.ok(twins.rounded_by >= 0 && twins.max_outside_of_file >= 0);
});

test("- is xyz on standard input", () => {
  const out = good(fit_args("welzl", "-"), "-3 0 0\n3 0 0\n");
  assert.equal(JSON.parse(out).sphere.radius, 3);
  refused(fit_args("welzl", "-"), '-:2: "a" is not a number', "1 2 3\na b c\n");
  refused(fit_args("welzl", "-"), "-: there are no points", "");
});

test("every format is fitted", () => {
  const files = readdirSync(corpus).filter((name) => name.startsWith("tetra_"));
  assert.ok(files.length >= 2);
  const radii = files.map((name) => fit("welzl", join(corpus, name)).sphere.radius);
  assert.deepEqual(new Set(radii).size, 1);
  assert.equal(fit("ritter", join(dirname(program), "assets/meshes/bunny.ply")).points, 1839);
});

test("--seed sets the random order, and --repeat how often the time is taken", () => {
  const cloud = write("cloud.xyz", Array.from({ length: 50 }, (_, i) => `${i * i % 37} ${i * 7 % 31} ${i % 11}`).join("\n"));
  const with_seed = (seed, ...more) => fit("ritter_iterative", "--seed", seed, ...more, cloud);
  const first = with_seed("1", "--repeat", "3");
  assert.equal(first.time_ns.repeats, 3);
  assert.deepEqual(with_seed("1").sphere, first.sphere);
  assert.deepEqual(fit("ritter_iterative", cloud).sphere, first.sphere);
  assert.notDeepEqual(with_seed("18446744073709551615").sphere, first.sphere);
  assert.notDeepEqual(with_seed("8").sphere, with_seed("10").sphere);
  assert.deepEqual(with_seed("010").sphere, with_seed("10").sphere);
  assert.deepEqual(with_seed("08").sphere, with_seed("8").sphere);
  assert.equal(with_seed("1", "--repeat", "010").time_ns.repeats, 10);
});

test("--steps writes the trace, one object a line, in place of what was there", () => {
  write("steps.jsonl", "old");
  symlinkSync("steps.jsonl", join(folder, "link.jsonl"));
  const { steps } = fit("welzl", "--steps", "link.jsonl", tetra);
  const lines = json_lines(readFileSync(join(folder, "steps.jsonl"), "utf8"));
  assert.equal(lines.length, steps);
  assert.ok(lines.every((line) => typeof line.step === "string" && Number.isInteger(line.line)));
  assert.equal(lines.at(-1).step, "finished");
});

test("a trace that cannot be written leaves nothing behind", () => {
  refused(fit_args("welzl", "--steps", "nowhere/steps.jsonl", tetra),
    "nowhere/steps.jsonl: cannot be written: No such file or directory");
  refused(fit_args("welzl", "--steps", ".", tetra), ".: is a directory");
  refused(fit_args("welzl", "--steps", "/dev/full", tetra), "/dev/full: cannot be written: No space left on device");
  write("kept.jsonl", "old");
  refused(fit_args("welzl", "--steps", "kept.jsonl", write("bad.xyz", "1 2\n1 2 3\n")), /^snug: bad\.xyz:2: /);
  assert.equal(readFileSync(join(folder, "kept.jsonl"), "utf8"), "old");
  assert.deepEqual(readdirSync(folder).filter((name) => name.includes(".part")), []);
});

test("a trace is not written over the result", () => {
  for (const name of ["/dev/stdout", "both.jsonl"]) {
    const command = `"$0" fit --volume sphere --algorithm welzl --steps ${name} tetra.xyz > both.jsonl`;
    const { stderr, status } = spawnSync("bash", ["-c", command, program], { encoding: "utf8", cwd: folder });
    assert.equal(stderr, `snug: ${name}: is where the result goes\n`);
    assert.equal(status, 2);
    assert.equal(readFileSync(join(folder, "both.jsonl"), "utf8"), "");
  }
});

test("a trace is not written over the points or lines that are read", () => {
  const ball = JSON.stringify({ sphere: { center: [0, 0, 0], radius: 1 } });
  const planes = "[[1,0,0,-1],[-1,0,0,-1],[0,1,0,-1],[0,-1,0,-1],[0,0,1,-1],[0,0,-1,-1]]";
  symlinkSync("read.txt", join(folder, "linked.txt"));
  for (const [text, ...args] of [
    ["0 0 0\n1 2 3\n", "fit", "--volume", "sphere", "--algorithm", "ritter"],
    ["0 0 0\n1 2 3\n", "update", "--volume", "sphere", "--strategy", "transform"],
    [`{"a":${ball},"b":${ball}}\n`, "overlap"],
    [`{"frustum":{"planes":${planes}},"volume":${ball}}\n`, "cull"],
  ])
    for (const name of ["read.txt", "./read.txt", "linked.txt"]) {
      write("read.txt", text);
      refused([...args, "--steps", name, "read.txt"], `${name}: is the file that is read`);
      assert.equal(read("read.txt"), text);
    }
});

test("a trace that is interrupted leaves nothing behind", async () => {
  write("long.xyz", Array.from({ length: 300000 }, (_, i) => `${i * i % 1009} ${i * 7 % 1013} ${i % 11}`).join("\n"));
  const parts = () => readdirSync(folder).filter((name) => name.startsWith("long.jsonl"));
  for (const signal of ["SIGINT", "SIGTERM"]) {
    const run = spawn(program, fit_args("ritter_iterative", "--steps", "long.jsonl", "long.xyz"), { cwd: folder });
    const ended = once(run, "exit");
    while (parts().length === 0 && run.exitCode === null) await new Promise((done) => setTimeout(done, 5));
    assert.match(parts()[0], /\.part$/);
    run.kill(signal);
    assert.deepEqual(await ended, [null, signal]);
    assert.deepEqual(parts(), []);
  }
});

test("bad points are refused in one line with file and line, or byte", () => {
  for (const [name, text, line] of [
    ["nan.xyz", "0 0 0\n0 nan 0\n", 'nan.xyz:2: "nan" is not a finite number'],
    ["inf.csv", "1,2\n3,inf\n", 'inf.csv:2: "inf" is not a finite number'],
    ["overflow.txt", "0 0 1e999\n", 'overflow.txt:1: "1e999" is too large: coordinates reach to 2^508, about 8.3e152'],
    ["empty.xyz", "", "empty.xyz: there are no points"],
    ["mixed.xyz", "1 2 3\n1 2\n", "mixed.xyz:2: there are 2 numbers on the line, and on line 1 there were 3"],
    ["open.stl", "solid a\nfacet normal 0 0 1\n", "open.stl:2: the file ends within a facet"],
    ["cut.ply", "ply\nformat ascii 1.0\n", "cut.ply:2: the file ends within its header"],
  ])
    refused(fit_args("welzl", write(name, text)), line);
  for (const [name, line] of [
    ["claims_too_much.stl", /:byte 80: the header claims 1000000000 triangles/],
    ["claims_too_little.stl", /:byte 80: the header claims 3 triangles/],
    ["claims_too_much.ply", /:3: the header claims 2000000000 of "vertex", and the file is too short/],
    ["cut_short.ply", /cut_short\.ply:7: the header claims 4 of "face"|cut_short\.ply:byte \d+: the file is cut short/],
    ["not_finite.ply", /:byte \d+: the coordinate is not a finite number/],
  ])
    refused(fit_args("welzl", join(corpus, name)), line);
});

test("what follows the data of a PLY is passed over, and counted", () => {
  const { err, status } = snug(fit_args("welzl", join(corpus, "claims_too_little.ply")));
  assert.match(err, /claims_too_little\.ply: warning: passed over: .*\d+ bytes after the data\n$/);
  assert.equal(status, 0);
});

test("a header that lies costs no memory", () => {
  for (const name of readdirSync(corpus).filter((file) => file.startsWith("claims_") && file !== "claims_too_little.ply")) {
    const command = `ulimit -v 100000 && exec "$0" fit --volume sphere --algorithm welzl "$1"`;
    const { stderr, status } = spawnSync("bash", ["-c", command, program, join(corpus, name)], { encoding: "utf8" });
    assert.match(stderr, /^snug: .*claims_/);
    assert.doesNotMatch(stderr, /memory/);
    assert.equal(status, 2);
  }
});

test("files that cannot be read are refused", () => {
  refused(fit_args("welzl", "nowhere.xyz"), "nowhere.xyz: cannot be opened: No such file or directory");
  refused(fit_args("welzl", "."), ".: is a directory");
  refused(fit_args("welzl", "/proc/self/mem"), "/proc/self/mem: cannot be read: Input/output error");
});

test("bad usage is refused in one line", () => {
  refused(["fti"], /"fti" is neither a command nor a lesson/);
  refused(["fit"], /--volume is required; known: sphere, aabb, obb, capsule, lozenge, kdop, hull$/m);
  refused(["fit", tetra], "--volume is required; known: sphere, aabb, obb, capsule, lozenge, kdop, hull");
  refused(["fit", "--volume", "capsule", tetra], "--algorithm is required; known: pca");
  refused(["fit", "--volume", "cube", "--algorithm", "welzl", tetra], 'there is no volume "cube"; known: sphere, aabb, obb, capsule, lozenge, kdop, hull');
  refused(fit_args("quick", tetra),
    `there is no algorithm "quick" for sphere; known: ${algorithms.slice(0, 1)}, ritter, ritter_iterative, pca, welzl, pivot, brute_force, welzl_recursive, brute_force_slide, ${naive.join(", ")}`);
  refused(fit_args("welzl"), /FILE is required/);
  refused(fit_args("welzl", tetra, tetra), /not expected/);
  refused(fit_args("welzl", "--repeat", "0", tetra), /--repeat/);
  refused(fit_args("welzl", "--repeat", "many", tetra), /--repeat/);
  refused(fit_args("welzl", "--seed", "-1", tetra), /--seed/);
  refused(fit_args("welzl", "--seed", "18446744073709551616", tetra), /--seed/);
  refused(fit_args("welzl", "--seed", "1.5", tetra), /--seed/);
  for (const seed of ["-1", "0x10", "1.5"]) {
    refused(["overlap", "--random", "10", "--seed", seed], /--seed/);
    refused(["cull", "--survey", "10", "--seed", seed], /--seed/);
  }
  assert.equal(json_lines(good(["overlap", "--random", "10", "--seed", "010"]))[0].seed, 10);
  for (const command of ["render", "lab check"])
    refused([...command.split(" "), "x", "--seed", "9007199254740993"], /--seed: .* from 0 to 9007199254740992/);
  refused(["which", tetra, "--hit-rate", "nan"], /--hit-rate: "nan" is not a number/);
  refused(["which", tetra, "--bodies=-NaN"], /--bodies: "-NaN" is not a number/);
  refused(["which", tetra, "--hit-rate", "101"], /--hit-rate: Value 101 not in range 0/);
  refused(["render", "sphere-ritter", "-o", "x.gif", "--pause", "nan"], /--pause: "nan" is not a number/);
  refused(fit_args("welzl", "--volume", "aabb", tetra), /^snug: --volume is given twice \(see/);
  refused(fit_args("welzl", "--seed", "1", "--seed", "1", "--seed", "1", tetra), /^snug: --seed is given 3 times \(see/);
  refused(fit_args("welzl", "--scalar", "half", tetra), /--scalar/);
  refused(fit_args("welzl", "--repeat", "1000001", tetra), /--repeat: "1000001" is not a whole number from 1 to 1000000/);
  refused(fit_args("welzl", "--dim", "4", tetra), /--dim: "4" is not a whole number from 2 to 3/);
  refused(fit_args("welzl", "--dim", "", tetra), /--dim/);
  refused(fit_args("welzl", "--dim", "2", tetra), "tetra.xyz: the points are 3-D, and 2-D was asked for");
  refused(fit_args("welzl", "--scalar", "float", write("far.xyz", "0 0 0\n1e30 0 0\n")),
    "far.xyz: point 1 is too far out for float: coordinates reach to 2^60, about 1.15e18");
  refused(["lesson"], /subcommand/);
  refused(["lesson", "check"], /FILE/);
  refused(["render", "sphere-ritter", "--size", "12", "-o", "x.png"], /--size: "12" is not a size/);
  refused(["render", "nowhere", "-o", "x.png"], /there is no lesson "nowhere"/);
  refused(["--step", "-1"], /--step: "-1" is not a whole number from 0 to 2147483647/);
  refused(["--lesson", "nowhere"], /there is no lesson "nowhere"/);
  refused(["--points", "nowhere.xyz"], /nowhere\.xyz: cannot be opened/);
  refused(["nowhere.ply"], /nowhere\.ply: cannot be opened/);
  assert.ok(!existsSync(join(folder, "x.png")));
});

test("usage errors name the help of the subcommand they are about", () => {
  refused(["fti"], /\(see `snug --help`\)\n$/);
  refused(["fit", "--volume"], /\(see `snug fit --help`\)\n$/);
  refused(["cost", "--scalar", "half", tetra], /\(see `snug cost --help`\)\n$/);
  refused(["lesson"], /\(see `snug lesson --help`\)\n$/);
  refused(["lesson", "check"], /\(see `snug lesson check --help`\)\n$/);
  refused(["render", "sphere-ritter"], /\(see `snug render --help`\)\n$/);
});

test("a mistyped command, option, algorithm or lesson is told what it may have been", () => {
  const meant = (args, word) => refused(args, new RegExp(`; did you mean "${word}"\\?`));
  meant(["fti"], "fit");
  meant(["fti", "--volume", "obb", tetra], "fit");
  meant(["overl", tetra], "overlap");
  meant(["sphere-riter"], "sphere-ritter");
  meant(["render", "sphere-riter", "-o", "x.png"], "sphere-ritter");
  meant(["lesson", "chek", "x.toml"], "check");
  meant(["fit", "--volum", "obb", tetra], "--volume");
  meant(["fit", "--scalr=float", tetra], "--scalar");
  meant(["fit", "--volume", "shpere", "--algorithm", "welzl", tetra], "sphere");
  meant(["fit", "--volume", "spher", tetra], "sphere");
  meant(fit_args("wezl", tetra), "welzl");
  meant(["-v"], "-V");
  meant(["knot.objj"], "\\.obj");
  refused(["knot.png"], /"knot\.png" is neither a command nor a lesson, and point files end in \.xyz, \.csv, \.txt, \.obj, \.ply, \.stl, \.off \(/);
  meant(["cost", "--algorithms", "ritter,pivto", tetra], "pivot");
  meant(["help", "lesson", "lst"], "list");
  meant(["exercise", "make", "be-rittr"], "be-ritter");
  meant(["fit", "--case", "nedle"], "needle");
  for (const far of [["cube"], ["fit", "--colour", tetra], ["sphere-"], ["help", "x"], ["-x"], ["knot.png"]])
    assert.doesNotMatch(snug(far).err, /did you mean/, far.join(" "));
});

test("snug help says what --help says", () => {
  for (const command of [[], ["fit"], ["lesson"], ["lesson", "check"], ["help"]])
    assert.equal(good(["help", ...command]), good([...command, "--help"]));
  refused(["help", "nothing"], '"nothing" is not a command of snug');
  assert.equal(good(["-V"]), good(["--version"]));
});

test("a picture is a PNG, and a chart may be SVG as well, whatever it is called", () => {
  for (const name of ["x.jpg", "x", "x.png.txt"]) {
    const line = `${name}: pictures are written as PNG, SVG or GIF: the name must end in .png, .svg or .gif, or be - for a PNG on standard output`;
    refused(["render", "sphere-ritter", "-o", name], line);
    const either = `${name}: charts are written as PNG or SVG: the name must end in .png or .svg, or be - for a PNG on standard output`;
    refused(["chart", write("some.csv", "# snug table: costs\n"), "-o", name], either);
    assert.ok(!existsSync(join(folder, name)));
  }
});

test("what has no end, or more than 512 MiB, is refused before it fills the memory", () => {
  write("sparse.xyz", "1 2 3\n");
  truncateSync(join(folder, "sparse.xyz"), 512 * 2 ** 20 + 1);
  const line = (name) => `${name}: has more than 512 MiB, the most that is read`;
  refused(fit_args("welzl", "sparse.xyz"), line("sparse.xyz"));
  refused(["cost", "sparse.xyz"], line("sparse.xyz"));
  refused(["overlap", "sparse.xyz"], line("sparse.xyz"));
  refused(["--points", "sparse.xyz"], line("sparse.xyz"));
  if (existsSync("/dev/zero")) refused(fit_args("welzl", "/dev/zero"), line("/dev/zero"));
  for (const command of [["fit"], ["cost"], []]) assert.match(good([...command, "--help"]), /512\s+MiB/);
});

test("a trace does not go to standard output", () => {
  refused(fit_args("welzl", "--steps", "-", tetra), "-: is where the result goes");
});

test("brute force says how many points it takes", () => {
  const many = write("many.xyz", Array.from({ length: 5000 }, (_, i) => `${i} ${i * i} 0`).join("\n"));
  refused(fit_args("brute_force", many), /^snug: many\.xyz: there are 5000 points, and brute_force takes at most \d+\n$/);
});

test("output that cannot be written is an error", () => {
  for (const command of ["algorithms", "--help", "--version"]) {
    const done = spawnSync("bash", ["-c", `"$0" ${command} > /dev/full`, program], { encoding: "utf8" });
    assert.equal(done.stderr, "snug: standard output: No space left on device\n");
    assert.equal(done.status, 2);
  }
});

test("algorithms lists what fit takes", () => {
  const rows = json_lines(good(["algorithms"]));
  const of = (volume) => rows.filter((row) => row.volume === volume).map((row) => row.algorithm);
  assert.deepEqual(of("sphere"), [...algorithms, ...naive]);
  assert.deepEqual(rows.filter((row) => row.naive).map((row) => row.algorithm), [...naive, "pca_one_pass", "quickhull_rounded", "quickhull_epsilon"]);
  assert.deepEqual(of("aabb"), ["min_max"]);
  assert.deepEqual(of("obb"), ["aabb", "sphere_axis", "pca", "pca_sums", "pca_one_pass", "pca_hull", "pca_hull_area", "pca_rectangle", "face_aligned", "rotations",
    "dito", "exact"]);
  assert.deepEqual([...of("capsule"), ...of("lozenge"), ...of("hull")], ["pca", "pca", "quickhull", "quickhull_rounded", "quickhull_epsilon"]);
  const dims = Object.fromEntries(rows.filter((row) => row.volume === "kdop").map((row) => [row.algorithm, row.dims]));
  assert.deepEqual(dims, { k4: [2], k6: [2, 3], k8: [2], k14: [3], k18: [3], k26: [3] });
  for (const row of rows) {
    assert.deepEqual(Object.keys(row).slice(0, 5), ["volume", "algorithm", "dims", "exact", "source"]);
    if (row.volume !== "kdop" && !row.algorithm.startsWith("quickhull_")) assert.deepEqual(row.dims, [2, 3]);
    assert.match(row.source, /\d{4}$/);
  }
});

test("lessons are listed in their order, and each is sound", () => {
  const files = readdirSync(lessons).filter((name) => name.endsWith(".toml") && name !== "course.toml");
  const list = json_lines(good(["lesson", "list", "--lessons", lessons]));
  assert.equal(list.length, files.length);
  assert.deepEqual(list, json_lines(good(["lesson", "list"])).map((row, i) => ({ ...row, file: list[i].file })));
  const checked = json_lines(good(["lesson", "check", ...files.map((name) => join(lessons, name))]));
  assert.deepEqual(checked.map((row) => `${row.lesson}.toml`), files);
  assert.deepEqual(checked.filter(({ warnings }) => warnings).map(({ lesson }) => lesson), []);
  for (const { lesson, questions, task } of list) {
    const lines = json_lines(good(["lesson", "play", lesson]));
    const end = lines.pop();
    assert.equal(lines.flatMap((line) => line.questions).length, questions);
    assert.ok(lines.every((line) => line.steps > 0 && line.questions.every((question) => question.right)));
    assert.equal(end.sound, true);
    assert.equal(end.task !== null && end.task.done, task);
  }
});

test("a course says which lessons come in which order, and is checked with them", () => {
  const course = readFileSync(join(lessons, "course.toml"), "utf8");
  const named = [...course.slice(course.indexOf("[[chapter]]")).matchAll(/"([a-z0-9-]+)"/g)].map(([, id]) => id);
  const list = json_lines(good(["lesson", "list"]));
  assert.deepEqual(list.map(({ lesson }) => lesson), named);
  assert.deepEqual([...new Set(list.map(({ group }) => group))], [...course.matchAll(/^title = "(.*)"$/gm)].map(([, title]) => title));
  assert.ok(list.every(({ minutes }) => minutes >= 5 && minutes <= 30));

  const text = readFileSync(join(lessons, "sphere-ritter.toml"), "utf8");
  const own = (lines) => `version = 1\n\n[[chapter]]\ntitle = "Own"\nlessons = [\n${lines}]\n`;
  mkdirSync(join(folder, "own"), { recursive: true });
  for (const id of ["one", "two"]) write(`own/${id}.toml`, text);
  assert.deepEqual(json_lines(good(["lesson", "list", "--lessons", "own"])).map(({ lesson, group }) => [lesson, group]), [["one", ""], ["two", ""]]);
  write("own/course.toml", own('  "two",\n  "one",\n'));
  assert.deepEqual(json_lines(good(["lesson", "list", "--lessons", "own"])).map(({ lesson, group }) => [lesson, group]), [["two", "Own"], ["one", "Own"]]);
  const checked = json_lines(good(["lesson", "check", "own"]));
  assert.deepEqual(checked.map(({ file }) => file), ["own/one.toml", "own/two.toml", "own/course.toml"]);
  assert.deepEqual(checked.at(-1), { chapters: 1, lessons: 2, file: "own/course.toml" });
  const wrong = [['  "two",\n  "three",\n', /^snug: own\/course\.toml:7: there is no lesson "three"/], ['  "two",\n  "one",\n  "two",\n', /^snug: own\/course\.toml:8: the lesson "two" is listed twice/],
    ['  "two",\n', /^snug: own\/course\.toml:3: the lesson "one" is in no chapter/]];
  for (const [lines, says] of wrong) {
    write("own/course.toml", own(lines));
    refused(["lesson", "check", "own/course.toml"], says);
    refused(["lesson", "list", "--lessons", "own"], says);
  }
});

test("a link to a lesson that is not in the lesson's folder is refused with its line", () => {
  const text = readFileSync(join(lessons, "sphere-ritter.toml"), "utf8").replace("Drag a point.", "Drag\na [point](lesson:beside-it).");
  const line = 1 + text.split("\n").findIndex((row) => row.includes("lesson:beside-it"));
  write("linked.toml", text);
  refused(["lesson", "check", "linked.toml"], new RegExp(`^snug: linked\\.toml:${line}:3: "text" links to a lesson that is not there: beside-it`));
  write("beside-it.toml", text.replace("lesson:beside-it", "lesson:linked"));
  good(["lesson", "check", "linked.toml"]);
});

test("a folder without a lesson is refused, and what is no file in one is passed by", () => {
  mkdirSync(join(folder, "none/dir.toml"), { recursive: true });
  refused(["lesson", "check", "none"], "none: there is no lesson: no file here ends in .toml");
  assert.equal(spawnSync("mkfifo", [join(folder, "none/pipe.toml")]).status, 0);
  refused(["lesson", "check", "none"], "none: there is no lesson: no file here ends in .toml");
  write("none/mine.toml", readFileSync(join(lessons, "examples/cloud.toml"), "utf8"));
  assert.equal(json_lines(good(["lesson", "check", "none"])).length, 1);
});

test("a mistake in the head or in a text hides none of the others, and each has its line", () => {
  write("many.toml", `version = 2
title = "Many mistakes"
summary = "Each in a line of its own."
minutes = 0 # wrong
algorithms = ["kdop/k8", "obb/exakt", "obb/exact"] # wrong
reference = "hull/quickhul" # wrong

[points]
list = [[0, 0], [1, 0], [0, 1], [2, 2]]

[view]
inset = { at = "P7", size = 0.2 } # wrong
names = ["A", "A"] # wrong

[[situation]]
name = "two"
title = "Three points"
[situation.points]
list = [[0, 0], [1, 1], [3, 1]]

[[slider]]
title = "Turn"
drives = "angel" # wrong
from = 0
to = 5

[[section]]
title = "One"
situation = "nowhere" # wrong
text = """
A **term without an end. # wrong

There is [it](situation:gone). # wrong

| a | b |
|---|
| 1 | 2 |

Its size: {excess kdop/k9} # wrong
"""

[[question]]
id = "number"
algorithm = "kdop/k8"
before = "slab_found"
asks = "number"
figure = "excess"
tolerance = -1 # wrong
prompt = "How many per cent?"
because = "It is so."

[[question]]
id = "twice"
algorithm = "kdop/k8"
before = "finished"
asks = "choice"
choices = ["yes", "yes"] # wrong
answer = "yes"
holds = "always"
prompt = "Twice?"
because = "It is so."
section = "Nine" # wrong

[[task]]
prompt = "Build it."
hint = "Try."
model = [[0, 0]]

[[task.require]]
figure = "excess"
over = "obb/exact"
at_least = 3
at_most = 2 # wrong
`);
  const { err, status } = snug(["lesson", "check", "many.toml"]);
  assert.equal(status, 2);
  const wrong = read("many.toml").split("\n").flatMap((line, i) => (/# wrong|^\|---\|$/.test(line) ? [i + 1] : []));
  assert.deepEqual(err.trimEnd().split("\n").map((line) => Number(line.match(/^snug: many\.toml:(\d+):\d+: /)?.[1])), wrong, err);
});

test("a lesson that is wrong is refused with its line, each in a line of its own", () => {
  const text = readFileSync(join(lessons, "sphere-ritter.toml"), "utf8");
  const line = text.split("\n").findIndex((row) => /^algorithms\b/.test(row));
  assert.ok(line >= 0);
  write("unknown.toml", text.replace(/^algorithms\b.*$/m, 'algorithms = ["quick"]'));
  write("syntax.toml", "title = \n");
  refused(["lesson", "check", "unknown.toml"], new RegExp(`^snug: unknown\\.toml:${line + 1}:\\d+: .*quick`));
  write("large.toml", `${"a.".repeat(1000000)}a = 1\n`);
  refused(["lesson", "check", "large.toml"], "large.toml:1:1: the file is too long: a lesson has at most 262144 bytes");
  const long = (name) => `${name}:1:1: the file is too long: a lesson has at most 262144 bytes`;
  write("sparse.toml", "version = 2\n");
  truncateSync(join(folder, "sparse.toml"), 3e9);
  refused(["lesson", "check", "sparse.toml"], long("sparse.toml"));
  if (existsSync("/dev/zero")) refused(["lesson", "check", "/dev/zero"], long("/dev/zero"));
  refused(["lesson", "check", "nowhere.toml"], /^snug: nowhere\.toml: cannot be opened/);
  const { out, err, status } = snug(["lesson", "check", "unknown.toml", join(lessons, "sphere-ritter.toml"), "syntax.toml"]);
  assert.equal(out, "");
  assert.match(err, /^snug: unknown\.toml:\d+:\d+: [^\n]+\nsnug: syntax\.toml:1:\d+: [^\n]+\n$/);
  assert.equal(status, 2);
});

test("every mistake of a lesson is told, in its order, and warnings beside them", () => {
  const text = readFileSync(join(lessons, "examples", "cloud.toml"), "utf8");
  const changed = text.replace("title =", "titel =").replace("minutes = 5", "minutes = 0").replace('asks = "point"', 'asks = "pont"').replace("Drag an outer point", "Drag P7");
  const { out, err, status } = snug(["lesson", "check", write("many.toml", changed)]);
  assert.deepEqual([out, status], ["", 2]);
  const line = (words) => 1 + changed.split("\n").findIndex((row) => row.includes(words));
  assert.deepEqual(err.trimEnd().split("\n"), [
    `snug: many.toml:${line("titel")}:1: the lesson has no key "titel": did you mean "title"?`,
    `snug: many.toml:${line("minutes")}:11: "minutes" must be from 1 to 240`,
    `snug: many.toml:${line("pont")}:8: "asks" is none of point, points, choice, sequence, figure, number, tightest, tightest_order, cheapest, cheapest_order, farthest or grows: pont; did you mean point?`,
    `snug: many.toml:${line("P7")}:41: warning: "text" speaks of P7, which is not there: the last one is P4`,
  ]);
  const warned = snug(["lesson", "check", write("warned.toml", text.replace("Drag an outer point", "Drag P7"))]);
  assert.match(warned.err, /^snug: warned\.toml:\d+:\d+: warning: [^\n]+\n$/);
  assert.deepEqual([warned.status, json_lines(warned.out)[0].warnings], [0, 1]);
});

test("a new lesson of each subject passes as it is written, and does not replace another", () => {
  const subjects = readdirSync(join(lessons, "examples")).map((file) => file.replace(/\.toml$/, ""));
  assert.ok(subjects.length >= 11);
  for (const subject of subjects) {
    assert.equal(good(["lesson", "new", `my-${subject}`, "--subject", subject]), `my-${subject}.toml\n`);
    const [row] = json_lines(good(["lesson", "check", `my-${subject}.toml`]));
    assert.deepEqual([row.lesson, row.warnings], [`my-${subject}`, undefined]);
    refused(["lesson", "new", `my-${subject}`], `my-${subject}.toml: is there already`);
  }
  refused(["lesson", "new", "other", "--subject", "frostum"], /did you mean frustum\?$/m);
  refused(["lesson", "new", "Not An Id"], /small letters, digits and hyphens/);
});

test("lessons/README.md lists what can be asked and required, as the program does", () => {
  const listed = readFileSync(join(lessons, "README.md"), "utf8").split("<!-- snug lesson table -->\n")[1].split("<!-- end -->")[0];
  assert.equal(listed, good(["lesson", "table"]));
});

test("the coverage lists every idea of the course in its order, and says no while one has no lesson", () => {
  const course = readFileSync(join(lessons, "course.toml"), "utf8");
  const ids = [...course.matchAll(/^id = "(.*)"$/gm)].map(([, id]) => id);
  const { status, out: stdout } = snug(["lesson", "coverage"]);
  const rows = json_lines(stdout);
  assert.deepEqual(rows.map(({ id }) => id), ids);
  assert.deepEqual(rows.filter(({ lessons: some }) => some.length === 0), []);
  assert.equal(status, 0);
  assert.deepEqual(rows.find(({ id }) => id === "L1.sphere.ritter"), { id: "L1.sphere.ritter", slide: "Computing a Bounding Sphere", lessons: ["sphere-ritter"] });
  const own = join(folder, "covered");
  mkdirSync(own);
  const text = readFileSync(join(lessons, "examples", "cloud.toml"), "utf8");
  const put = (covers) => write("covered/mine.toml", text.replace("minutes", `covers = [${covers}]\nminutes`));
  put('"a.tight"');
  write("covered/course.toml", 'version = 1\n\n[[chapter]]\ntitle = "Own"\nlessons = ["mine"]\n\n[[idea]]\nid = "a.tight"\nslide = "One"\n');
  assert.deepEqual(json_lines(good(["lesson", "coverage", "--lessons", own])), [{ id: "a.tight", slide: "One", lessons: ["mine"] }]);
  put('"a.tigth"');
  const unlisted = snug(["lesson", "coverage", "--lessons", own]);
  assert.equal(unlisted.status, 1);
  assert.match(unlisted.err, /^snug: .*mine\.toml: warning: "covers" names an idea that the course does not list: a\.tigth$/m);
  refused(["lesson", "check", own], /mine\.toml:\d+:\d+: "covers" names an idea that the course does not list: a\.tigth; did you mean a\.tight\?$/m);
});

test("lessons of lecturers' own, written by the guide, are sound and play to their end", () => {
  const own = join(root, "tests", "lessons");
  for (const file of readdirSync(own)) {
    good(["lesson", "check", join(own, file)]);
    const end = json_lines(good(["lesson", "play", "--lessons", own, file.replace(".toml", "")])).at(-1);
    assert.deepEqual([end.not_asked, end.sound], [[], true], file);
  }
});

test("facts are what the steps of a lesson are and come to", () => {
  const rows = json_lines(good(["lesson", "facts", join(lessons, "sphere-ritter.toml")]));
  const lengths = Object.fromEntries(json_lines(good(["lesson", "play", "sphere-ritter"])).slice(0, -1).map(({ algorithm, steps }) => [algorithm, steps]));
  for (const [algorithm, steps] of Object.entries(lengths)) {
    const own = rows.filter((row) => row.algorithm === algorithm);
    assert.deepEqual(own.map((row) => row.step), [...Array(steps).keys()].map((i) => i + 1).concat(undefined));
    assert.equal(own.at(-2).fact, "finished");
    assert.equal(own.at(-2).figures.radius, own.at(-1).size);
  }
  const pair = rows.find((row) => row.fact === "pair_chosen");
  assert.equal(pair.handles.length, 2);
  assert.ok(pair.asks.includes("axis") && pair.sentence.includes(pair.handles[0]));
  const one = json_lines(good(["lesson", "facts", "--algorithm", "welzl", join(lessons, "sphere-ritter.toml")]));
  assert.deepEqual(one, rows.filter((row) => row.algorithm === "welzl"));
  refused(["lesson", "facts", "--algorithm", "pca", join(lessons, "sphere-ritter.toml")], /does not offer the algorithm pca/);
});

test("a file stands wherever a lesson's id does, and --lessons says where the lessons are", () => {
  const text = readFileSync(join(lessons, "examples", "scene.toml"), "utf8");
  mkdirSync(join(folder, "mine"));
  write("mine/bodies.toml", text);
  write("mine/.#bodies.toml", "an editor's own");
  assert.equal(json_lines(good(["lesson", "list", "--lessons", "mine"])).map(({ lesson }) => lesson).join(), "bodies");
  for (const command of [["lesson", "play"], ["lesson", "facts"], ["scene", "--frames", "2"]]) {
    const last = (args) => json_lines(good([...command, ...args])).at(-1);
    const whole = last(["bodies", "--lessons", "mine"]);
    const timeless = ({ microseconds, ...rest }) => rest;
    assert.deepEqual(timeless(last(["mine/bodies.toml"])), timeless(whole), command.join(" "));
    refused([...command, "bodies"], 'there is no lesson "bodies"; `snug lesson list` lists them');
    refused([...command, "other", "--lessons", "mine"], 'there is no lesson "other"; `snug lesson list --lessons mine` lists them');
    refused([...command, "mine/other.toml"], /^snug: mine\/other\.toml: cannot be opened/);
    refused([...command, "bodies", "--lessons", "nowhere"], /^snug: nowhere: the lessons cannot be read/);
  }
  // The window says the same before there is one.
  refused(["--lessons", "mine", "other"], 'there is no lesson "other"; `snug lesson list --lessons mine` lists them');
  refused(["--lessons", "nowhere"], /^snug: nowhere: the lessons cannot be read/);
  mkdirSync(join(folder, "empty"));
  refused(["--lessons", "empty"], "empty: there is no lesson: no file here ends in .toml");
  refused(["other.toml"], /^snug: other\.toml: cannot be opened/);
});

test("a picture's algorithm, step and question are those of the lesson", () => {
  const render = (...args) => ["render", ...args, "-o", "x.png"];
  const file = write("asked.toml", readFileSync(join(lessons, "examples", "cloud.toml"), "utf8"));
  refused(render(file, "--algorithm", "wezl"), "asked.toml: the lesson's algorithm is none of aabb_center or welzl: wezl; did you mean welzl?");
  refused(render(file, "--step", "5"), "asked.toml: there is no step 5: aabb_center has 4");
  refused(render(file, "--step", "last"), /--step: "last" is not a whole number/);
  refused(render(file, "--question", "fathest"), "asked.toml: the question is none of farthest: fathest; did you mean farthest?");
  refused(render(file, "--question", "farthest", "--algorithm", "welzl"), "asked.toml: the question farthest is about aabb_center, not about welzl");
  refused(render(file, "--question", "farthest", "--step", "1"), /--step excludes --question/);
  refused(render(file, "--answered"), /--answered requires --question/);
  refused(render("cost-chart", "--question", "slowest", "--answered"), /the question slowest is decided by what is measured then/);
  write("unasked.toml", read(file).replace(/\[\[question\]\][^]*/, ""));
  refused(render("unasked.toml", "--question", "farthest"), "unasked.toml: the lesson has no questions");
  refused(render(write("wrong.toml", read(file).replace("minutes = 5", "minutes = 0"))), /^snug: wrong\.toml:5: "minutes" must be/);
  assert.ok(!existsSync(join(folder, "x.png")));
});

test("a lesson whose question is never asked is unsound", () => {
  // On a mesh's points, for on others reading finds it.
  const text = readFileSync(join(lessons, "sphere-ritter.toml"), "utf8");
  const changed = text.slice(0, text.indexOf("[[task]]")).replace(/^\[points\][^[]*/m, '[points]\nmesh = "bunny"\n\n').replace(/^nth = \d+$/m, "nth = 9999");
  const line = 1 + changed.split("\n").findIndex((row) => row === "nth = 9999");
  const asked = json_lines(good(["lesson", "list"])).find((row) => row.lesson === "sphere-ritter").questions;
  write("never.toml", changed);
  const { out, err, status } = snug(["lesson", "play", "never", "--lessons", "."]);
  assert.equal(err, "");
  assert.equal(status, 1);
  const lines = json_lines(out);
  const { sound, not_asked } = lines.pop();
  assert.equal(sound, false);
  assert.ok(not_asked.length > 0);
  assert.equal(lines.flatMap((row) => row.questions).length, asked - not_asked.length);
  const checked = snug(["lesson", "check", "never.toml"]);
  const at = Number(/^snug: never\.toml:(\d+):1: \w+ does not take step \w+ 9999 times on these points$/m.exec(checked.err)?.[1]);
  assert.ok(at > 0 && at < line && line - at < 10, checked.err);
  assert.equal(checked.status, 2);
  refused(["lesson", "play", "nowhere"], /there is no lesson "nowhere"/);
});

test("a test that does not suit the volumes is refused, and nothing is run with it", () => {
  const text = readFileSync(join(lessons, "examples", "volumes.toml"), "utf8").replaceAll('"gjk"', '"spheres"');
  write("unsuited.toml", text);
  refused(["lesson", "check", "unsuited.toml"], /the test of these two volumes is .*, not spheres$/m);
  refused(["lesson", "facts", "unsuited.toml"], /is not a test of these two volumes$/m);
});

test("a fixed answer that the run contradicts is warned of, and makes play say no", () => {
  const choice = ['id = "key"', 'algorithm = "welzl"', 'before = "finished"', 'asks = "choice"', 'prompt = "Which circle is smallest?"', 'choices = ["aabb_center", "welzl"]', 'answer = "aabb_center"', 'holds = "here"', 'wrong = { welzl = "No." }', 'because = "So."'];
  write("key.toml", readFileSync(join(lessons, "examples", "cloud.toml"), "utf8").replace("[[task]]", `[[question]]\n${choice.join("\n")}\n\n[[task]]`));
  const checked = snug(["lesson", "check", "key.toml"]);
  assert.equal(checked.status, 0);
  assert.match(checked.err, /^snug: key\.toml:\d+:1: warning: the run contradicts the answer "aabb_center": it is Welzl/);
  const played = snug(["lesson", "play", "key.toml"]);
  const end = json_lines(played.out).at(-1);
  assert.deepEqual([played.status, end.sound, end.false_keys.map(({ question, answer }) => [question, answer])], [1, false, [["key", "aabb_center"]]]);
});

test("a lesson on a mesh is checked on it as any other is on its points", () => {
  const text = readFileSync(join(lessons, "examples", "cloud.toml"), "utf8");
  const mesh = text.slice(0, text.indexOf("[[task]]")).replace(/^list = .*$/m, 'mesh = "bunny"').replace("mark:farthest_found", "mark:farthest_fund").replace("Drag an outer point", "Drag P999999");
  write("on-mesh.toml", mesh);
  const { err, status } = snug(["lesson", "check", "on-mesh.toml"]);
  assert.equal(status, 2);
  assert.match(err, /there is no mark farthest_fund: .* did you mean farthest_found\?$/m);
  assert.match(err, /warning: "text" speaks of P999999, which is not there: the last one is P\d+$/m);
});

test("a lesson with the chart of costs is played and checked by operations, and says so", () => {
  const lines = json_lines(good(["lesson", "play", "cost-chart"]));
  const { decided_by, task } = lines.at(-1);
  assert.equal(decided_by, "operations");
  assert.match(task.says, / times the operations\. Done\.$/);
  assert.equal(json_lines(good(["lesson", "play", "sphere-ritter"])).at(-1).decided_by, undefined);
  assert.equal(json_lines(good(["lesson", "check", join(lessons, "cost-chart.toml")]))[0].decided_by, "operations");
  for (const name of ["play", "check"]) assert.match(snug(["lesson", name, "--help"]).out, /counted operations/);
});

test("trace-hash is a line for each lesson, the same each time", () => {
  const out = good(["trace-hash"]);
  const ids = json_lines(good(["lesson", "list"])).map((row) => row.lesson);
  const lines = out.trimEnd().split("\n");
  assert.deepEqual(lines.map((line) => line.split(" ")[0]), ids);
  for (const line of lines) assert.match(line, /^[\w-]+ [1-9]\d* [0-9a-f]{16}$/);
  assert.equal(new Set(lines.map((line) => line.split(" ")[2])).size, lines.length);
  assert.equal(good(["trace-hash"]), out);
  refused(["trace-hash", "--lessons", "nowhere"], /^snug: nowhere: /);
});

test("help says what the contract says", () => {
  const all = good(["--help"]);
  for (const word of ["fit", "algorithms", "lesson", "trace-hash", "render", "Exit status"]) assert.ok(all.includes(word), word);
  const help = good(["fit", "--help"]);
  for (const word of ["--volume", "--algorithm", "--scalar", "--dim", "--seed", "--repeat", "--steps", "support", "measure",
    "max_outside", "certificate", "operations", "time_ns", ".xyz", ".csv", ".txt", ".obj", ".ply", ".stl"])
    assert.ok(help.includes(word), word);
  for (const command of [["algorithms"], ["lesson"], ["lesson", "list"], ["lesson", "check"], ["lesson", "play"], ["lesson", "new"], ["lesson", "facts"], ["lesson", "table"], ["lesson", "coverage"],
    ["trace-hash"], ["render"]])
    assert.match(good([...command, "--help"]), /Usage: snug/);
  assert.match(good(["--version"]), /^\d+\.\d+\.\d+\n$/);
});

test("a hull in space has its faces: closed, and counter-clockwise as seen from outside", () => {
  write("cube.xyz", [0, 1].flatMap((x) => [0, 1].flatMap((y) => [0, 1].map((z) => `${x} ${y} ${z}`))).join("\n"));
  const { hull, faces } = JSON.parse(good(["fit", "--volume", "hull", "--algorithm", "quickhull", "cube.xyz"]));
  assert.equal(faces.length, 12);
  const edges = new Set(faces.flatMap(([a, b, c]) => [`${a} ${b}`, `${b} ${c}`, `${c} ${a}`]));
  assert.equal(edges.size, 36); // each in each direction once
  for (const edge of edges) assert.ok(edges.has(edge.split(" ").reverse().join(" ")), edge);
  const minus = (p, q) => p.map((x, i) => x - q[i]);
  for (const [a, b, c] of faces.map((face) => face.map((i) => hull.points[i]))) {
    const [u, v] = [minus(b, a), minus(c, a)];
    const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    assert.ok(normal.reduce((sum, x, i) => sum + x * (a[i] - 0.5), 0) > 0);
  }
});

/** What a terminal shows, with so many columns. */
const shown = (call, { columns = 100, ...env } = {}) =>
  spawnSync("script", ["-qec", `stty cols ${columns}; '${program}' ${call}`, "/dev/null"], { encoding: "utf8", cwd: folder, env: { ...process.env, TERM: "xterm", ...env } })
    .stdout.replaceAll("\r", "");
const without_color = { NO_COLOR: "1" };

test("in a terminal lists are tables, in colour unless NO_COLOR is set, and --json keeps the lines", () => {
  const plain = shown("algorithms", without_color);
  assert.match(plain, /^volume +algorithm +dims +exact/);
  assert.match(plain, /\nsphere +welzl +2, 3 +yes/);
  assert.ok(!plain.includes("{") && !plain.includes("\x1b"));
  assert.match(shown("algorithms"), /^\x1b\[1mvolume/);
  assert.match(shown("algorithms --json"), /^\{"volume":"sphere"/);
});

test("a table is no wider than its terminal, and has its ids whole and its titles readable", () => {
  const ids = { "lesson list": "lesson", "exercise list": "exercise", algorithms: "algorithm", cases: "case", "demo list": "demo" };
  for (const [call, key] of Object.entries(ids)) {
    const all = json_lines(good(call.split(" ")));
    for (const columns of [80, 100, 400]) {
      const lines = shown(call, { ...without_color, columns }).trimEnd().split("\n");
      const words = new Set(lines.flatMap((line) => line.split(/ +/)));
      for (const row of all) assert.ok(words.has(row[key]), `${call}, ${columns}: ${row[key]} is not whole`);
      for (const line of lines) assert.ok([...line].length <= columns, `${call}, ${columns}: ${line}`);
      for (const [cut] of lines.join("\n").matchAll(/(\S+ )*\S*…/g)) assert.ok([...cut].length >= 30, `${call}, ${columns}: ${cut}`);
      assert.equal(/ file( |$)/m.test(lines[0]), columns === 400 && "file" in all[0], `${call}, ${columns}`);
    }
  }
});

test("wide tables of numbers have room for the figures that matter, and say what they leave out", () => {
  write("some.xyz", [...Array(60).keys()].map((i) => `${Math.cos(i)} ${Math.sin(2 * i)} ${Math.cos(3 * i)}`).join("\n"));
  const heads = {
    "update --volume obb --strategy transform --frames 3 some.xyz": "frame degrees measure slack over_hull contains steps dot_products",
    "update --volume kdop --strategy k14_loose --frames 3 some.xyz": "frame degrees measure slack over_hull contains steps points_touched",
    "overlap --costs": "a b test apart median time in a scene by GJK",
  };
  for (const [call, head] of Object.entries(heads)) {
    const lines = shown(call, { ...without_color, columns: 80 }).trimEnd().split("\n");
    assert.equal(lines[0].replace(/ +/g, " ").trim(), head, call);
    for (const line of lines) assert.ok([...line].length <= 80, `${call}: ${line}`);
    assert.match(lines.at(-1), /^\d+ columns have no room here; --json has all\.$/);
    assert.ok(!lines.join("\n").includes("…"), call);
  }
});

test("long work in a terminal says how far it is, at what rate, and how long it takes still", async () => {
  const call = `stty cols 100; '${program}' exercise check be-ritter --seeds 1000000`;
  const child = spawn("script", ["-qec", call, "/dev/null"], { cwd: folder, stdio: ["ignore", "pipe", "ignore"] });
  let said = "";
  for await (const chunk of child.stdout) if ((said += chunk).includes(" left")) break;
  child.kill("SIGKILL"); // which closes the terminal
  const line = /\rbe-ritter \[#*\.*\] (\d+) of 1000000, ([\d.e+]+) a second, (\d+) (s|min|h) left/.exec(said);
  assert.ok(line, said);
  const [done, rate, left] = [1, 2, 3].map((i) => Number(line[i])), unit = { s: 1, min: 60, h: 3600 }[line[4]];
  const seconds = (1e6 - done) / rate; // the rate has three digits, and what is left is rounded up
  assert.ok(left * unit > seconds * 0.98 && (left - 1) * unit < seconds * 1.02, line[0]);
});

test("in a terminal a fit has its numbers, as many as have room, a matrix in rows, and its time in words", () => {
  const text = shown(`fit --volume obb --algorithm pca ${tetra}`, { ...without_color, columns: 80 });
  assert.ok(!text.includes("…"), text);
  const number = "-?[\\d.e-]+", triple = `${number}, ${number}, ${number}`;
  assert.match(text, new RegExp(`^obb\\.center +${triple}\\nobb\\.axes +${triple}\\n +${triple}\\n +${triple}\\nobb\\.half_extents +${triple}\\n`));
  assert.match(text, /\nmedian time +[\d.]+ (ns|µs|ms)\nshortest time +[\d.]+ (ns|µs|ms)\nruns timed +5\n/);
  write("many.xyz", [...Array(60).keys()].map((i) => `${Math.cos(i)} ${Math.sin(i)}`).join("\n"));
  const hull = shown("fit --volume hull --algorithm quickhull many.xyz", { ...without_color, columns: 80 }).split("\n");
  assert.match(hull.find((line) => line.startsWith("support")), /^support +(\d+, ){10,}… \(60\)$/);
  assert.equal(hull[6].trim(), "… (60)");
  for (const line of hull) assert.ok([...line].length <= 80, line);
});
