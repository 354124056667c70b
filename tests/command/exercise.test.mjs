// snug exercise and snug grade: instances, result files, and a folder of them, some damaged or edited.
import assert from "node:assert/strict";
import { chmodSync, mkdirSync, readFileSync, symlinkSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { folder, good, json_lines, read, refused, root, snug, write } from "./support.mjs";

const kKinds = Object.fromEntries(json_lines(good(["exercise", "list"])).map(({ exercise, kind }) => [exercise, kind]));
const kIds = Object.keys(kKinds).filter((id) => kKinds[id] !== "write");

test("the exercises are listed, with the sets that they belong to", () => {
  const all = json_lines(good(["exercise", "list"]));
  assert.ok(all.length >= 15);
  assert.deepEqual([...new Set(Object.values(kKinds))].sort(), ["break_it", "build", "carry_out", "number", "order", "write"]);
  for (const one of all) assert.deepEqual(Object.keys(one), ["exercise", "kind", "title", "minutes", "set", "sets", "lesson", "file", "levels"]);
});

test("an instance is the same bytes each time", () => {
  const text = good(["exercise", "make", "be-ritter", "--seed", "7"]);
  assert.equal(good(["exercise", "make", "be-ritter", "--seed", "7"]), text);
  const [made] = json_lines(text);
  assert.equal(made.seed, 7);
  assert.equal(made.of, made.decisions);
  assert.equal(made.instance.handles.length, 12);
  assert.notEqual(good(["exercise", "make", "be-ritter", "--seed", "8"]), text);
  refused(["exercise", "make", "be-riter"], /there is no exercise "be-riter"/);
});

test("a function that is written is listed, made, answered and graded", () => {
  const id = "write:overlap-min-max";
  const [made] = json_lines(good(["exercise", "make", id]));
  assert.deepEqual([made.of, made.instance.function, made.instance.cases], [7, "overlap", 640]);
  write("written.json", good(["exercise", "answer", id, "--wrong", "1"]));
  const { out, status } = snug(["grade", "--json", "written.json"]);
  assert.deepEqual([status, json_lines(out)[0].mark, json_lines(out)[0].status], [0, 5, "ok"]);
  refused(["exercise", "answer", id, "--wrong", "99"], /number of a usual mistake/);
  refused(["exercise", "play", id], /is written on the page alone/);
  const { sets } = json_lines(good(["exercise", "list"])).find(({ exercise }) => exercise === id);
  assert.deepEqual(sets, ["collision", "write"]);
  const { out: sheets, err } = snug(["exercise", "print", "collision", "--seeds", "1", "-o", "set"]);
  assert.match(err, /^snug: warning: write:overlap-min-max is left out/);
  assert.equal(json_lines(sheets).length, 18);
  refused(["exercise", "make", "write:overlap-minmax"], /there is no exercise .*write:overlap-min-max/);
});

test("each function that is written is solved, and each of its usual mistakes gets the case that shows it", () => {
  const ids = Object.keys(kKinds).filter((id) => kKinds[id] === "write");
  assert.ok(ids.length >= 17);
  const { out, err } = snug(["exercise", "check", ...ids, "--seeds", "1000"]);
  const told = json_lines(out);
  assert.equal(told.length, ids.length, err);
  for (const { exercise, faults, methods, mistakes } of told) {
    assert.deepEqual(faults, [], exercise);
    assert.ok(mistakes >= 5 && methods >= 2, exercise);
  }
});

test("a model attempt earns every mark, one wrong decision costs one", () => {
  for (const id of kIds) {
    const [right] = json_lines(good(["exercise", "answer", id, "--seed", "3"]));
    assert.equal(right.attempts[0].mark, right.attempts[0].of, id);
    const [wrong] = json_lines(good(["exercise", "answer", id, "--seed", "3", "--wrong", "1"]));
    const builds = /^(build|break_it)$/.test(kKinds[id]); // where the one decision is wrong, nothing was built
    assert.equal(wrong.attempts[0].mark, builds ? 0 : wrong.attempts[0].of - 1, id);
  }
  const [ruled] = json_lines(good(["exercise", "answer", "be-quickhull", "--wrong", "1=nearest"]));
  assert.equal(ruled.attempts[0].mark, ruled.attempts[0].of - 1);
  refused(["exercise", "answer", "be-quickhull", "--wrong", "1=farthest"], /no wrong rule farthest/);
  refused(["exercise", "answer", "be-quickhull", "--wrong", "99"], /there are only \d+ decisions/);
  refused(["exercise", "answer", "be-quickhull", "--wrong", "x"], /--wrong takes the number of a decision/);
});

test("the promise is checked on many seeds", () => {
  const checked = kIds.flatMap((id) => json_lines(good(["exercise", "check", id, "--seeds", "40"])));
  for (const { exercise, kept, seeds, nearest, promised, decisions, hard } of checked) {
    assert.deepEqual([kept, seeds], [true, 40], exercise);
    assert.ok(hard.least <= hard.median && hard.median <= hard.most && hard.most <= decisions.most, exercise);
    assert.equal(hard.most > 0, nearest !== null && nearest < 2 * promised, exercise);
    assert.ok(nearest === null || nearest >= promised, exercise); // null: nothing comes near a tie
  }
});

test("a promise that every seed breaks is told, beside those that are kept", () => {
  const text = readFileSync(join(root, "lessons/exercises/be-ritter.toml"), "utf8");
  write("broken.toml", text.replace(/^decisions = .*/m, "decisions = [50, 60]"));
  const { out, err, status } = snug(["exercise", "check", "--seeds", "1", "broken.toml", "be-quickhull"]);
  assert.deepEqual([err, status], ["", 1]);
  const [broken, kept] = json_lines(out);
  assert.deepEqual([broken.kept, broken.decisions, broken.hard, broken.nearest], [false, null, null, null]);
  assert.match(broken.faults[0], /^seed 1: /);
  assert.equal(kept.kept, true);
});

test("every exercise has a sheet, in space with coordinates, and what the run did before is printed", () => {
  for (const id of kIds) {
    const { out, err } = snug(["exercise", "print", id, "-o", "all"]);
    assert.equal(err, "", id);
    assert.equal(json_lines(out).length, 2, id);
    const [sheet, solution] = ["", "-solution"].map((part) => read(`all/${id}-1${part}.svg`));
    assert.ok(sheet.includes("Name: ___") && solution.includes(">Solution<"), id);
    for (const [, y] of sheet.matchAll(/<text x="[-\d.]+" y="([-\d.]+)"/g)) assert.ok(Number(y) < 297, `${id}: ${y}`);
  }
  assert.match(read("all/sat-space-1.svg"), />B7 \(−?\d\.\d{3}, −?\d\.\d{3}, −?\d\.\d{3}\)</);
  assert.match(read("all/be-welzl-1.svg"), />The circle now: centre \(−?\d\.\d{3}, −?\d\.\d{3}\),/);
  assert.doesNotMatch(read("all/be-welzl-1-solution.svg"), /The circle now/);
});

/** A result file of a folder of its own; change(result): edits it. */
function hand_in(name, id, seed, student, change = () => {}) {
  const [result] = json_lines(good(["exercise", "answer", id, "--seed", String(seed), "--student", student]));
  change(result);
  write(name, JSON.stringify(result));
}

test("a folder of 200 result files is graded, whatever is wrong with twenty of them", () => {
  mkdirSync(join(folder, "class"));
  const spoilt = { differs: 5, damaged: 8, foreign: 3, older: 2, newer: 2 };
  const edits = {
    differs: [(it) => (it.attempts[0].mark += 1), (it) => delete it.attempts[0].mark, (it) => (it.attempts[0].mark = 0),
      (it) => (it.attempts[0].decisions.pop()), (it) => (it.attempts[0].mark = "full")],
    damaged: [(it) => (it.attempts[0].decisions[0] = "zz"), (it) => (it.attempts[0].decisions = 7), (it) => (it.attempts[0].seed = -1),
      (it) => (it.attempts[0].hash = "12"), (it) => (it.attempts = {}), (it) => (it.attempts[0].decisions[0] = "p9999@1.0"),
      (it) => it.attempts[0].decisions.push(...it.attempts[0].decisions), null],
    foreign: [(it) => delete it.snug_result, (it) => (it.attempts[0].exercise = "be-nobody"), (it) => (it.attempts[0].hash = "0".repeat(16))],
    older: [(it) => (it.attempts[0].hash = "0".repeat(16), it.version = "0.0.1"), (it) => (it.snug_result = 0)],
    newer: [(it) => (it.attempts[0].hash = "0".repeat(16), it.version = "99.0"), (it) => (it.snug_result = 2)],
  };
  let n = 0;
  const add = (change) => {
    const name = `class/student-${String(n).padStart(3, "0")}.json`;
    if (change === null) write(name, "{ \"snug_result\": 1,");
    else hand_in(name, kIds[n % kIds.length], n, `Student ${n}`, change);
    n += 1;
  };
  for (const [status, count] of Object.entries(spoilt)) {
    assert.equal(edits[status].length, count);
    for (const change of edits[status]) add(change);
  }
  while (n < 200) add();
  const { out, err, status } = snug(["grade", "class", "--json"]);
  assert.equal(status, 1);
  const rows = json_lines(out);
  assert.equal(rows.length, 200);
  const counts = {};
  for (const row of rows) (counts[row.status] ??= []).push(row);
  for (const [kind, count] of Object.entries(spoilt)) assert.equal(counts[kind]?.length, count, `${kind}\n${err}`);
  assert.equal(counts.ok.length, 180);
  for (const row of counts.ok) assert.deepEqual([row.mark, row.claimed], [row.of, row.of]);
  assert.equal(err.trimEnd().split("\n").length, 20);
  const csv = snug(["grade", "class", "--csv"]).out.trimEnd().split("\n");
  assert.equal(csv[0], "file,student,exercise,seed,mark,of,claimed,status");
  assert.equal(csv.length, 201);
});

test("a file without an attempt is told, endings are of any case, and a folder without a result file is refused", () => {
  mkdirSync(join(folder, "few/below"), { recursive: true });
  hand_in("few/below/Ann.JSON", "be-ritter", 3, "Ann");
  hand_in("few/Bob.json", "be-ritter", 3, "Bob", (it) => (it.attempts = []));
  const { out, err, status } = snug(["grade", "--json", "few"]);
  assert.deepEqual(json_lines(out).map(({ student, status }) => [student, status]), [["Bob", "missing"], ["Ann", "ok"]]);
  assert.deepEqual([err, status], ["snug: few/Bob.json: warning: missing: it has no attempt\n", 1]);
  assert.match(snug(["grade", "--csv", "--by-student", "few"]).out, /^Bob,0,0,0,missing$/m);
  mkdirSync(join(folder, "empty"));
  refused(["grade", "empty"], "empty: missing: there is no result file (*.json) in it");
  const beside = snug(["grade", "--json", "empty", "few/below"]);
  assert.deepEqual([beside.status, json_lines(beside.out).map((row) => row.status)], [1, ["missing", "ok"]]);
});

test("what cannot be read does not end the grading of what can", (t) => {
  mkdirSync(join(folder, "odd/shut"), { recursive: true });
  hand_in("odd/z.json", "be-ritter", 3, "Zoe");
  symlinkSync("loop.json", join(folder, "odd/loop.json"));
  const grade = () => json_lines(snug(["grade", "--json", "odd"]).out).map(({ file, status }) => [file, status]);
  assert.deepEqual(grade(), [["odd/loop.json", "damaged"], ["odd/z.json", "ok"]]);
  chmodSync(join(folder, "odd/shut"), 0);
  t.after(() => chmodSync(join(folder, "odd/shut"), 0o700));
  if (process.getuid() !== 0) assert.deepEqual(grade()[0], ["odd/shut", "damaged"]); // root reads everything
});

test("a format beyond 32 bits is newer as well", () => {
  for (const format of ["4294967297", "9223372036854775809"]) {
    write("far.json", `{"snug_result":${format},"attempts":[]}`);
    assert.equal(json_lines(snug(["grade", "--json", "far.json"]).out)[0].status, "newer");
  }
});

test("a name with control characters stays in its row, and numbers and - are no formulas", () => {
  hand_in("name.json", "be-ritter", 3, "Eve\n\u001b[31m\u009b1mMallory", (it) => (it.attempts[0].mark = -1));
  const { out, err } = snug(["grade", "name.json"]);
  assert.match(out, /^.*\n.*Eve {2}\[31m 1mMallory.*\n$/);
  assert.doesNotMatch(out + err, /[^\n -\u007e]/);
  const csv = snug(["grade", "--csv", "-"], read("name.json").replace(/Eve.*Mallory/, "-1+2")).out.split("\n")[1];
  assert.match(csv, /^-,'-1\+2,be-ritter,3,\d+,\d+,-1,differs$/);
});

test("a stage that another could not have built earns nothing, and copies of one are alike", () => {
  const built = (rows) => (it) => (it.attempts[0].decisions = [`b${rows}@9`]);
  hand_in("flat.json", "break-pca-box", 3, "Ada", built("0,0;1,0.3"));
  hand_in("space.json", "break-pca-box", 3, "Ada", built("-1.06,-0.48,0;0.23,0.73,0;0.19,-0.52,0.01;-1.03,0.78,0"));
  for (const name of ["flat.json", "space.json"]) {
    const { out, status } = snug(["grade", name, "--json"]);
    assert.deepEqual([status, json_lines(out)[0].status], [1, "damaged"], name);
  }
  mkdirSync(join(folder, "copies"));
  for (const seed of [1, 2]) hand_in(`copies/${seed}.json`, "break-pca-box", seed, `Student ${seed}`);
  assert.match(snug(["grade", "copies", "--alike"]).out, /equal decisions on different instances/);
});

test("an attempt of a file is watched, and what is none is refused", () => {
  hand_in("watched.json", "be-ritter", 3, "Ada");
  refused(["grade", "--watch", "watched.json", "--attempt", "2"], /watched.json: has only one attempt$/m);
  write("odd.json", "{}");
  refused(["grade", "--watch", "odd.json"], /odd.json: is no result file/);
  refused(["grade", "watched.json", "--attempt", "1"], /--watch/);
});

test("a student's best attempts count, and a name is no formula", () => {
  hand_in("a.json", "be-quickhull", 4, "=1+1", (it) => {
    const [other] = json_lines(good(["exercise", "answer", "be-quickhull", "--seed", "5", "--wrong", "1"]));
    it.attempts.push(...other.attempts);
  });
  const [, row] = good(["grade", "a.json", "--by-student", "--csv"]).split("\n");
  const [{ attempts }] = [JSON.parse(read("a.json"))];
  assert.equal(row, `'=1+1,1,${attempts[0].of},${attempts[0].of},ok`);
});

test("what is alike is told, as a hint and no verdict", () => {
  hand_in("one.json", "covariance-signs", 4, "One");
  write("two.json", read("one.json").replace("One", "Two"));
  hand_in("three.json", "covariance-signs", 5, "Three", (it) => {
    it.attempts[0].decisions = JSON.parse(read("one.json")).attempts[0].decisions;
  });
  const text = good(["grade", "one.json", "two.json", "three.json", "--alike"]);
  assert.match(text, /one\.json +two\.json +covariance-signs +the same attempt, times included/);
  assert.match(text, /one\.json +three\.json +covariance-signs +equal decisions on different instances/);
  assert.match(text, /This is a hint for a teacher, and no verdict/);
  write("cut.json", read("one.json").slice(0, 100));
  const cut = snug(["grade", "one.json", "cut.json", "two.json", "--alike"]);
  assert.deepEqual([cut.status, cut.err.split("\n").length], [1, 2]);
  assert.match(cut.err, /^snug: cut\.json: warning: damaged: /);
  assert.match(cut.out, /one\.json +two\.json/);
});

test("a set is printed on paper, a sheet and a solution for each seed", () => {
  const { out, err, status } = snug(["exercise", "print", "geometry", "--seeds", "2", "-o", "sheets"]);
  assert.deepEqual([err, status], ["", 0]);
  assert.match(read("sheets/merge-bottom-up-1.svg"), />A<[^]*>B</, "a tree's boxes have their letters");
  const files = json_lines(out).map(({ file }) => file);
  assert.equal(files.length, 40, "ten exercises, two seeds, a sheet and a solution of each");
  good(["exercise", "print", "be-ritter", "--seeds", "2", "-o", "sheets"]);
  good(["exercise", "print", "kdop-overlap-test", "--seeds", "2", "-o", "sheets"]);
  const [sheet, solution] = ["", "-solution"].map((part) => read(`sheets/be-ritter-2${part}.svg`));
  assert.match(sheet, />Name: _+</);
  assert.doesNotMatch(sheet, /lies outside, by/);
  assert.match(solution, /P\d+\. P\d+ is the next in the list that lies outside, by/);
  const boxes = read("sheets/kdop-overlap-test-1.svg");
  assert.match(boxes, />yes<[^]*>no</, "choices are there to be marked");
  const frustum = read("sheets/p-and-n-vertex-1.svg");
  for (const plane of ["left", "right", "near", "far"]) assert.equal(frustum.match(`>${plane}<`)?.length, 1, plane);
  const build = read("sheets/break-pca-box-1.svg"), built = read("sheets/break-pca-box-1-solution.svg");
  assert.match(build, />P0 \( _+ , _+ \)</, "lines for coordinates");
  assert.match(built, /Excess over the optimum: [6-9]\d\.\d %\. Points: 4 points\. Done\./);
  assert.equal(built.match(/<circle/g).length, 4, "the example is drawn");
  refused(["exercise", "print", "nothing", "-o", "sheets"], /there is no exercise "nothing"/);
});
