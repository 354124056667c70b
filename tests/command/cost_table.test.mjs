// `snug cost`: its tables in every form, an earlier result beside the present one, and every way to ask for it wrongly.
import assert from "node:assert/strict";
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { folder, good, json_lines, refused, snug, write } from "./support.mjs";

const quick = ["--repeat", "3"];
const costs = (...args) => JSON.parse(good(["cost", ...quick, "--json", ...args]));
const read = (name) => readFileSync(join(folder, name), "utf8");

// Squares in the sine: without them all points would lie in a plane.
const cloud = write("cloud.xyz", Array.from({ length: 300 }, (_, i) =>
  [0, 1, 2].map((axis) => Math.sin(12.9898 * (3 * i + axis) ** 2 + 4.1) * (3 - axis)).join(" ")).join("\n"));
const square = write("square.xyz", "-1 -1\n1 -1\n1 1\n-1 1\n0 0.5\n");

test("every algorithm has a row with the figures that snug fit gives", () => {
  const { table, provenance, rows } = costs(cloud);
  assert.equal(table, "costs");
  assert.equal(provenance.points, "cloud.xyz");
  assert.equal(provenance.platform, "native");
  assert.equal(provenance.dim, 3);
  assert.match(provenance.version, /^\d+\.\d+\.\d+$/);
  assert.ok(provenance.build.length > 5 && provenance.clock_resolution_ns > 0);
  const listed = json_lines(good(["algorithms"])).filter(({ dims, naive }) => dims.includes(3) && !naive);
  assert.deepEqual(rows.map(({ volume, algorithm }) => `${volume} ${algorithm}`), listed.map(({ volume, algorithm }) => `${volume} ${algorithm}`));
  for (const row of rows) {
    assert.ok(row.time_ns.min > 0 && row.time_ns.median >= row.time_ns.min && row.time_ns.repeats >= 3 && row.time_ns.repeats <= 9);
    assert.equal(typeof row.time_ns.trusted, "boolean");
    assert.equal(row.of, 300);
    assert.ok(row.bytes > 0 && row.overlap_ns.median > 0 && row.certificate.contains);
    if (row.algorithm.startsWith("brute_force")) {
      assert.equal(row.points, 40);
      assert.ok(row.whole_ns > row.time_ns.median);
      continue;
    }
    assert.equal(row.points, 300);
    assert.equal(row.whole_ns, null);
    const fitted = JSON.parse(good(["fit", "--volume", row.volume, "--algorithm", row.algorithm, "--repeat", "1", cloud]));
    assert.equal(row.measure, fitted.measure);
    assert.deepEqual(row.operations, fitted.operations);
    assert.equal(row.steps, fitted.steps);
    assert.deepEqual(row.certificate, fitted.certificate);
  }
});

test("tightness is against the smallest of the kind and against the hull", () => {
  const { rows } = costs("--algorithms", "ritter,welzl,obb:pca,exact,quickhull", cloud);
  const [ritter, welzl, pca, exact, hull] = rows;
  assert.ok(Math.abs(ritter.tightness - ritter.size / welzl.size) < 1e-12 && ritter.tightness >= 1);
  assert.ok(Math.abs(pca.tightness - pca.measure / exact.measure) < 1e-12 && pca.tightness >= 1);
  assert.ok(Math.abs(exact.over_hull - exact.measure / hull.measure) < 1e-12 && exact.over_hull > 1);
  assert.equal(hull.over_hull, 1);
  for (const row of rows)
    assert.equal(row.on_front, !rows.some((other) => other.time_ns.median <= row.time_ns.median && other.measure <= row.measure &&
      (other.time_ns.median < row.time_ns.median || other.measure < row.measure)));
});

test("updates and overlap tests have their times", () => {
  const { rows } = costs("--volume", "kdop", "--scalar", "float", cloud);
  assert.deepEqual(rows.map(({ update }) => update), ["k6_hill_climb", "k14_hill_climb", "k18_hill_climb", "k26_hill_climb"]);
  assert.deepEqual(rows.map(({ bytes }) => bytes), [24, 56, 72, 104]);
  for (const row of rows) assert.ok(row.update_ns.median > 0 && row.overlapping === row.overlap_pairs / 2);
});

test("what would take too long is measured on fewer points, and says so", () => {
  const { rows: [row] } = costs("--generate", "sphere:20000", "--algorithms", "face_aligned", "--longest", "20");
  assert.ok(row.points < 20000 && row.points >= 16 && row.of === 20000);
  assert.ok(row.whole_ns > 20e6);
  assert.ok(row.time_ns.median < 60e6);
  assert.equal(row.on_front, false);
  assert.match(good(["cost", ...quick, "--generate", "sphere:20000", "--algorithms", "face_aligned", "--longest", "20"]), /on \d+ of 20000 points: all would take about/);
});

test("one batch has no spread, and a volume without an update none", () => {
  const [{ time_ns, update, update_ns }, hull] = JSON.parse(good(["cost", "--repeat", "1", "--json", "--algorithms", "ritter,quickhull", cloud])).rows;
  assert.equal(time_ns.spread, null);
  assert.equal(time_ns.trusted, false);
  assert.equal(update_ns.spread, null);
  assert.equal(typeof update, "string");
  assert.equal(hull.update, null);
  assert.equal(hull.update_ns, null);
  const text = good(["cost", "--repeat", "1", "--algorithms", "ritter", cloud]);
  assert.match(text, /\nsphere +ritter +[\d.]+ \? +\d/);
});

test("a result in JSON is the page's CSV, with columns for times that nobody took", async () => {
  const { result_as_csv } = await import("../../web/page/result.js");
  for (const [name, args] of Object.entries({ hull: ["--volume", "hull"], all: ["--algorithms", "quickhull,ritter"], turn: ["--turn"] })) {
    good(["cost", "--repeat", "1", "--json", "-o", `${name}.json`, ...args, cloud]);
    write(`${name}.csv`, result_as_csv(new TextEncoder().encode(read(`${name}.json`))));
    const columns = read(`${name}.csv`).split("\n").find((line) => !line.startsWith("# ")).split(",");
    for (const part of ["median", "min", "spread", "repeats", "batch", "trusted"]) assert.ok(columns.includes(`update_ns.${part}`), part);
    if (name === "turn") continue;
    for (const file of [`${name}.json`, `${name}.csv`])
      assert.match(good(["cost", ...quick, ...args, "--against", file, cloud]), /now\/then\n|now\/then /);
  }
});

test("a chart reads its table once, so that it may come through a pipe", () => {
  good(["cost", "--repeat", "1", "--csv", "-o", "piped.csv", "--volume", "obb", cloud]);
  good(["chart", "piped.csv", "-o", "of_file.svg"]);
  good(["chart", "-", "-o", "of_pipe.svg"], read("piped.csv"));
  assert.equal(read("of_pipe.svg"), read("of_file.svg"));
});

test("of flat points ratios are not known, nor a box's slack", () => {
  const line = write("line.xyz", Array.from({ length: 50 }, (_, i) => [1, 2, 3].map((axis) => axis * i / 10).join(" ")).join("\n"));
  for (const row of costs("--volume", "obb", line).rows) {
    assert.equal(row.tightness, null);
    assert.equal(row.over_hull, null);
  }
  assert.ok(costs("--generate", "line:100", "--volume", "obb").rows.every(({ tightness, over_hull }) => tightness === null && over_hull === null));
  assert.match(good(["cost", ...quick, "--csv", "--algorithms", "obb:pca", line]), /\nobb,pca,50,50,,.*,,,120,/);
  assert.match(good(["cost", ...quick, "--algorithms", "obb:pca", line]), /\nobb +pca +.* +- +- +120 /);
  assert.ok(costs("--turn", "--volume", "obb", line).rows.every(({ slack }) => slack === null));
  assert.match(good(["cost", ...quick, "--turn", "--volume", "obb", line]), /\nobb +\S+ .* - +- +-\n/);
  assert.equal(json_lines(good(["update", "--volume", "obb", "--strategy", "transform", "--frames", "3", line]))[1].slack, null);
});

test("in the plane there are the plane's algorithms", () => {
  const { provenance, rows } = costs(square);
  assert.equal(provenance.dim, 2);
  assert.ok(rows.some(({ algorithm }) => algorithm === "k8") && !rows.some(({ algorithm }) => algorithm === "k14"));
  assert.equal(costs("--generate", "cube:50", "--dim", "2", "--volume", "aabb").rows.length, 1);
});

test("the same points and seed have the same figures but for times", () => {
  const untimed = ({ rows }) => rows.map(({ volume, algorithm, operations, size, tightness, bytes }) => ({ volume, algorithm, operations, size, tightness, bytes }));
  const args = ["--generate", "clusters:200", "--seed", "7"];
  assert.deepEqual(untimed(costs(...args)), untimed(costs(...args)));
  assert.notDeepEqual(untimed(costs(...args)), untimed(costs("--generate", "clusters:200", "--seed", "8")));
});

test("the table for people says volume, time and who is on the front", () => {
  const text = good(["cost", ...quick, "--volume", "sphere", cloud]);
  assert.match(text, /^cloud\.xyz, 3-D, double, seed 1; native, /);
  assert.match(text, /\nvolume +algorithm +time (ns|µs|ms) +ops +\/least +\/hull +bytes +near ns +scene ns +update (ns|µs)\n/);
  assert.match(text, /\nsphere +welzl +[\d.]+( \?)? +\d/);
  assert.match(text, /\n\* no other is both faster and tighter\n/);
});

test("no table for people is wider than 100 characters, and what a row has to say stands below", () => {
  const tables = [["--generate", "cube:2000"], ["--generate", "cube:2000", "--growth"], ["--turn", cloud]];
  good(["cost", ...quick, "--csv", "-o", "wide.csv", "--generate", "cube:2000"]);
  tables.push(["--generate", "cube:2000", "--against", "wide.csv"]);
  for (const args of tables) {
    const text = good(["cost", ...quick, ...args]);
    for (const line of text.split("\n")) assert.ok(line.length <= 100, line);
  }
  const text = good(["cost", ...quick, "--generate", "cube:2000", "--algorithms", "welzl_recursive"]);
  assert.match(text, /\nsphere +welzl_recursive .* a\n/);
  assert.match(text, /\na  on \d+ of 2000 points: on more, a limit of its own stops it\n/);
});

test("an earlier result lies beside the present one, from CSV and from JSON", () => {
  const args = [...quick, "--volume", "sphere", cloud];
  good(["cost", "--csv", "-o", "then.csv", ...args]);
  good(["cost", "--json", "-o", "then.json", ...args]);
  for (const file of ["then.csv", "then.json"]) {
    const text = good(["cost", ...args, "--against", file]);
    assert.match(text, /time (ns|µs|ms) +then +now\/then/);
    assert.match(text, /\nsphere +ritter +[\d.]+( \?)? +[\d.]+( \?)? +\d+\.\d\d (faster|slower|within noise) /);
    const { against, rows } = JSON.parse(good(["cost", ...args, "--json", "--against", file]));
    assert.equal(against.table, "costs");
    assert.deepEqual(against.rows.map(({ measure }) => measure), rows.map(({ measure }) => measure));
  }
});

test("CSV has a column for every figure", () => {
  const lines = good(["cost", ...quick, "--csv", "--volume", "obb", cloud]).trimEnd().split("\n");
  assert.equal(lines[0], "# snug table: costs");
  const columns = lines.find((line) => !line.startsWith("# ")).split(",");
  for (const name of ["time_ns.median", "time_ns.spread", "operations.dot_products", "operations.square_roots", "tightness", "bytes", "overlap_ns.median", "scene_overlap_ns.median", "update_ns.median"])
    assert.ok(columns.includes(name), name);
  for (const line of lines.slice(lines.indexOf(columns.join(",")) + 1)) assert.equal(line.split(",").length, columns.length);
});

test("growth has a power beside theory's", () => {
  const { table, rows } = costs("--growth", "--generate", "cube:3000", "--algorithms", "ritter,brute_force");
  assert.equal(table, "growth");
  const ritter = rows.filter(({ algorithm }) => algorithm === "ritter");
  assert.deepEqual(ritter.map(({ points }) => points), [10, 32, 100, 316, 1000, 3000]);
  assert.ok(ritter.every(({ theory, tight }) => theory === "O(n)" && tight));
  assert.ok(Math.abs(ritter[0].theory_exponent - 1) < 1e-9 && ritter[0].exponent > 0.5 && ritter[0].exponent < 1.5);
  const brute = rows.filter(({ algorithm }) => algorithm === "brute_force");
  assert.equal(brute.at(-1).points, 40);
  assert.ok(brute[0].exponent > 2 && brute[0].exponent < 5.2);
  assert.match(good(["cost", ...quick, "--growth", "--algorithms", "ritter", cloud]), /sphere +ritter +300 /);
});

test("of few points no power is told, and the table says so", () => {
  const few = ["--growth", "--generate", "cube:20", "--algorithms", "ritter"];
  assert.ok(costs(...few).rows.every(({ exponent, theory_exponent }) => exponent === null && theory_exponent === null));
  assert.match(good(["cost", ...quick, ...few]), /\nsphere +ritter +20 .* - +- +O\(n\) +a\n[^]*\na  too few points to tell\n/);
});

test("a turn has slack for each update", () => {
  const { table, rows } = costs("--turn", cloud);
  assert.equal(table, "turn");
  const of = (name) => rows.filter(({ strategy }) => strategy === name);
  assert.equal(of("loose").length, 72);
  assert.ok(of("rebuild").every(({ slack }) => slack === 0));
  assert.ok(of("loose").every(({ slack, contains }) => slack > 0 && contains));
  assert.ok(rows.every(({ update_ns }) => update_ns.median > 0));
  assert.equal(new Set(rows.map(({ volume, strategy }) => `${volume} ${strategy}`)).size, 13);
  assert.match(good(["cost", ...quick, "--turn", "--volume", "aabb", cloud]), /aabb +hill_climb +[\d.]+( \?)? +0\.0 % +0\.0 % +0\.0 %/);
});

test("the claims have verdicts and figures", () => {
  const { table, rows } = costs("--claims", cloud);
  assert.equal(table, "claims");
  assert.equal(rows.length, 9);
  for (const { claim, lecture, slide, measured, verdict } of rows) {
    assert.ok(claim && lecture && slide);
    assert.match(measured, /\d/);
    assert.match(verdict, /^(holds|typical|false|unknown)$/);
  }
  assert.equal(rows.find(({ claim }) => claim === "box_on_a_face").verdict, "false");
});

test("a claim is tried on the same 240 clouds everywhere, and a cloud's value is that of snug fit on it", () => {
  const { table, rows } = JSON.parse(good(["cost", "--trials", "ritter_ten_per_cent", "--json"]));
  assert.equal(table, "trials");
  assert.equal(rows.length, 240);
  assert.deepEqual([...new Set(rows.map(({ kind }) => kind))], ["cube", "ball", "sphere", "gaussian", "clusters", "stick"]);
  assert.ok(rows.every(({ value, holds }) => holds === value <= 1.1));
  const worst = rows.reduce((a, b) => (b.value > a.value ? b : a));
  assert.ok(worst.value > 1.1, "there is a counter-example");
  const text = good(["cost", "--trials", "ritter_ten_per_cent"]);
  assert.match(text, new RegExp(`typical: holds on ${rows.filter(({ holds }) => holds).length} of 240 clouds`));
  assert.match(text, new RegExp(`on ${worst.kind}:${worst.points} with seed ${worst.seed}`));
  assert.equal(good(["cost", "--trials", "ritter_ten_per_cent", "--csv"]).split("\n").filter((line) => line.startsWith("ritter_ten_per_cent,")).length, 240);
  refused(["cost", "--trials", "flat_earth"], /^snug: there is no claim "flat_earth" to try; known: four_points, /);
  refused(["cost", "--trials", "four_points", cloud], "--trials generates its own clouds: give no points");
  refused(["cost", "--trials", "four_points", "--claims"], "give only one of --growth, --turn, --claims and --trials");
});

test("what is asked for wrongly is said in one line, and nothing is written", () => {
  refused(["cost"], "give either --generate KIND:N or FILE");
  refused(["cost", "--generate", "cube:10", cloud], "give either --generate KIND:N or FILE");
  refused(["cost", "--generate", "donut:10"], /^snug: there is no kind of points "donut"; known: cube, ball/);
  for (const many of ["cube", "cube:", "cube:0", "cube:-1", "cube:2000001", "cube:1e3", "cube:10x"])
    refused(["cost", "--generate", many], "--generate takes KIND:N with a whole number N from 1 to 2000000");
  refused(["cost", "--volume", "cone", cloud], 'there is no volume "cone"');
  refused(["cost", "--algorithms", "ritter,guess", cloud], 'there is no algorithm "guess"; `snug algorithms` lists all');
  refused(["cost", "--algorithms", "k14", square], "none of these algorithms takes 2-D points");
  refused(["cost", "--growth", "--turn", cloud], "give only one of --growth, --turn, --claims and --trials");
  refused(["cost", "--json", "--csv", cloud], "give only one of --json and --csv");
  refused(["cost", "--claims", square], "the claims are about 3-D: give 3-D points");
  refused(["cost", "--turn", "--volume", "hull", cloud], 'there is no update of "hull"; known: sphere, aabb, obb, kdop');
  refused(["cost", "--repeat", "0", cloud], /--repeat/);
  refused(["cost", "nowhere.xyz"], /^snug: nowhere\.xyz: /);
  refused(["cost", "-o", "no/such/file.csv", cloud], /^snug: no\/such\/file\.csv: /);
  write("old.csv", "# snug table: growth\n");
  refused(["cost", "-o", "never.txt", "--against", "old.csv", cloud], 'old.csv:1: the first line of such a table is "# snug table: costs"');
  refused(["cost", "--against", write("old.json", '{"table":"costs","provenance":{},"rows":[]}'), cloud], "old.json: provenance.version is missing");
  refused(["cost", "--against", write("not.json", "{"), cloud], "not.json: is not JSON");
  refused(["cost", "--growth", "--against", "old.csv", cloud], "--against goes with the table of costs only");
  refused(["cost", "--csv", "--against", "old.csv", cloud], "--against cannot go into CSV, which has room for one table");
  assert.ok(!existsSync(join(folder, "never.txt")));
  assert.ok(readdirSync(folder).every((name) => !name.endsWith(".part")));
});

test("more than two million points are refused", () => {
  const many = Buffer.alloc(2_000_001 * 12);
  for (let i = 0; i < 2_000_001; ++i) many.writeFloatLE(i / 7, 12 * i), many.writeFloatLE(i % 11, 12 * i + 4), many.writeFloatLE(i % 13, 12 * i + 8);
  write("many.ply", Buffer.concat([Buffer.from("ply\nformat binary_little_endian 1.0\nelement vertex 2000001\nproperty float x\nproperty float y\nproperty float z\nend_header\n"), many]));
  refused(["cost", "many.ply"], "many.ply: there are 2000001 points, and costs are measured on at most 2000000");
});

test("help says what the fields are", () => {
  const { out, status } = snug(["cost", "--help"]);
  assert.equal(status, 0);
  for (const word of ["tightness", "over_hull", "--growth", "--against", "trusted"]) assert.ok(out.includes(word), word);
});

test("the box along the coordinates is as cheap as it looks, and what is decided exactly is counted", () => {
  // Many points on its faces: each was once decided exactly.
  const grid = write("grid.xyz", Array.from({ length: 1000 }, (_, i) => `${i % 10} ${Math.floor(i / 10) % 10} ${Math.floor(i / 100)}`).join("\n"));
  const [box, pca, aabb] = ["obb:aabb", "obb:pca", "aabb:min_max"].map((name) =>
    JSON.parse(good(["cost", "--repeat", "9", "--json", "--algorithms", name, grid])).rows[0]);
  assert.equal(box.operations.exact_decisions, 0);
  assert.equal(box.operations.dot_products, 0);
  assert.ok(Math.abs(box.measure - aabb.measure) < 1e-9 * aabb.measure);
  assert.ok(box.time_ns.min < pca.time_ns.min, `${box.time_ns.min} ns, and PCA ${pca.time_ns.min}`);
  const [hull] = costs("--algorithms", "quickhull", grid).rows; // four points in a plane, again and again
  assert.ok(hull.operations.exact_decisions > 0);
});

test("sizes that differ by rounding alone are equal: of such only what is surely slower is off the front", () => {
  const { rows } = costs("--generate", "gaussian:500", "--algorithms", "aabb:min_max,obb:aabb,k6");
  const times = rows.map(({ time_ns }) => time_ns);
  const doubt = ({ median, spread }) => median * Math.max(0.05, spread);
  for (const { algorithm, on_front, time_ns } of rows) {
    const slower = times.some((other) => time_ns.median - other.median > Math.max(doubt(time_ns), doubt(other)));
    assert.equal(on_front, !slower, algorithm);
  }
});

test("a result of earlier versions, without the count of exact decisions, can still be compared", () => {
  const args = [...quick, "--volume", "aabb", cloud];
  const old = JSON.parse(good(["cost", "--json", ...args]));
  for (const row of old.rows) delete row.operations.exact_decisions;
  assert.match(good(["cost", ...args, "--against", write("earlier.json", JSON.stringify(old))]), /now\/then/);
  const lines = good(["cost", "--csv", ...args]).trimEnd().split("\n");
  const at = lines.find((line) => line.startsWith("volume,")).split(",").indexOf("operations.exact_decisions");
  assert.ok(at > 0);
  const csv = lines.map((line) => (line.startsWith("#") ? line : line.split(",").filter((_, i) => i !== at).join(","))).join("\n");
  assert.match(good(["cost", ...args, "--against", write("earlier.csv", `${csv}\n`)]), /now\/then/);
});

test("an earlier result of other points is refused", () => {
  const of = (...args) => ["cost", "--repeat", "1", "--volume", "aabb", ...args];
  good(of("-o", "cube.json", "--generate", "cube:100"));
  refused(of("--generate", "cube:200", "--against", "cube.json"),
    "cube.json: was measured on cube:100 (3-D, seed 1), and this on cube:200 (3-D, seed 1): only results on the same points can be compared");
  refused(of("--generate", "ball:100", "--against", "cube.json"), /^snug: cube\.json: was measured on cube:100/);
  refused(of("--generate", "cube:100", "--seed", "2", "--against", "cube.json"), /^snug: cube\.json: was measured on cube:100 \(3-D, seed 1\)/);
  refused(of("--generate", "cube:100", "--dim", "2", "--against", "cube.json"), /^snug: cube\.json: was measured/);
  good(of("-o", "points.csv", write("points.xyz", "0 0 0\n1 2 3\n")));
  refused(of("--against", "points.csv", write("points.xyz", "0 0 0\n1 2 3\n4 5 6\n")), "points.csv: was measured on 2 points, and here there are 3");
});

test("the format of a result follows the ending of its file, and - is standard output", () => {
  const of = (...args) => ["cost", "--repeat", "1", "--volume", "aabb", ...args, cloud];
  for (const [name, start] of [["as.csv", "# snug table: costs\n"], ["as.JSON", '{"table":"costs"'], ["as.txt", "cloud.xyz, 3-D"], ["as", "cloud.xyz, 3-D"]]) {
    assert.equal(good(of("-o", name)), "");
    assert.ok(read(name).startsWith(start), name);
  }
  good(of("--json", "-o", "flag.txt"));
  assert.ok(read("flag.txt").startsWith('{"table"'));
  refused(of("--json", "-o", "no.csv"), "no.csv: ends in .csv, and another format was asked for");
  refused(of("-o", "no.xlsx"), "no.xlsx: has none of the endings .csv, .json and .txt, which say the format");
  assert.ok(good(of("--csv", "-o", "-")).startsWith("# snug table: costs\n"));
  assert.ok(!existsSync(join(folder, "-")) && !existsSync(join(folder, "no.csv")));
});

test("a result goes to a file whole", () => {
  assert.equal(good(["cost", ...quick, "--volume", "aabb", "--csv", "-o", "here.csv", cloud]), "");
  assert.match(read("here.csv"), /\naabb,min_max,/);
});

test("the table of snug which has one unit for T, and counts in good English", () => {
  const args = ["which", "--generate", "gaussian:3000", "--repeat", "2", "--bodies", "1"];
  const text = good([...args, "--frames", "1", "--pairs", "1", "--updates", "1"]);
  assert.match(text, /what 1 volume, and in each of 1 frame 1 update and 1 test,/);
  const [head, ...rows] = text.split("\n").slice(text.split("\n").findIndex((line) => line.startsWith("volume")));
  assert.match(head, / T (s|ms|µs|ns) /);
  assert.equal(rows.filter((row) => /^(sphere|hull) .* [\d.]+( \*| {2}) +\d+ %$/.test(row)).length, 2);
  assert.doesNotMatch(rows.slice(0, 7).join("\n"), /\d (s|ms|µs|ns)\b/);
});

test("snug which has the five criteria, T and where it goes, in every format", () => {
  const args = ["which", "--generate", "gaussian:60", "--repeat", "2", "--bodies", "3", "--frames", "10", "--updates", "4", "--pairs", "50", "--hit-rate", "20"];
  const { table, rows } = JSON.parse(good([...args, "--json"]));
  assert.equal(table, "which");
  assert.deepEqual(rows.map((row) => row.volume), ["sphere", "aabb", "obb", "kdop", "capsule", "lozenge", "hull"]);
  const hull = rows.at(-1);
  assert.equal(hull.false_positives, 0);
  for (const row of rows) {
    assert.deepEqual(row.load, { bodies: 3, frames: 10, updates: 4, pairs: 50, hit_rate: 0.2, deforms: false });
    const close = (a, b) => assert.ok(Math.abs(a - b) <= 1e-9 * Math.abs(b), `${row.volume}: ${a}, ${b}`);
    close(row.total_ns.build, 3 * row.build_ns.median);
    close(row.total_ns.updates, 40 * row.update_ns.median);
    close(row.total_ns.tests, 500 * row.test_ns.median);
    close(row.total_ns.false_positives, 500 * 0.8 * row.false_positives * hull.test_ns.median);
    close(row.total_ns.total, row.total_ns.build + row.total_ns.updates + row.total_ns.tests + row.total_ns.false_positives);
    assert.equal(row.passed, Math.round(row.false_positives * row.pairs_apart));
  }
  const text = good(args);
  assert.ok(text.split("\n").every((line) => line.length <= 100), text);
  assert.equal(text.match(/ \*/g).length, 2);  // the least, and what the star means
  assert.ok(good([...args, "--csv"]).includes("total_ns.total"));
  assert.equal(JSON.parse(good([...args, "--dim", "2", "--json"])).rows.length, 7);
});
