// The lab sheets on the command line: checked, graded, and the tables of forty machines side by side.
import assert from "node:assert/strict";
import { existsSync, mkdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { folder, good, json_lines, read, refused, root, snug, write } from "./support.mjs";

const sheets = ["own-mesh", "break-even", "break-float"];
const file_of = (id) => join(root, "lessons/labs", `${id}.toml`);

test("each sheet is sound, model answers and models included", () => {
  for (const id of sheets) {
    const [line] = json_lines(good(["lesson", "check", file_of(id)]));
    assert.equal(line.sheet, id);
    assert.ok(line.written >= 3);
    assert.ok(line.measured + line.built >= 1);
    const by_id = good(["lesson", "facts", id]); // its file is taken wherever its id is
    assert.equal(good(["lesson", "facts", file_of(id)]), by_id);
  }
});

/** The hash of a sheet's text, as Snug says it: FNV-1a. */
async function hash_of(id) {
  const { readFileSync } = await import("node:fs");
  let hash = 0xcbf29ce484222325n;
  for (const byte of readFileSync(file_of(id))) for (let i = 0; i < 8; ++i)
    hash = ((hash ^ (i === 0 ? BigInt(byte) : 0n)) * 0x100000001b3n) & 0xffffffffffffffffn;
  return hash.toString(16).padStart(16, "0");
}

const row = (algorithm, median, trusted = true, of = undefined) => ({
  volume: "sphere", algorithm, of, over_hull: 2, bytes: 32, time_ns: { median, spread: 0.05, trusted },
});
const table = (processor, rows, points = "teapot") => ({
  table: "costs",
  provenance: { version: "0.1.0", build: "GNU 12, Release", platform: "native", processor, points },
  rows,
});
const dated = (table) => ({ date: "2026-11-28", table });
const result = (student, sheet) =>
  JSON.stringify({ snug_result: 1, version: "0.1.0", student, attempts: [], sheets: [sheet] });

test("what was built is judged anew, and what was written is printed", async () => {
  const hash = await hash_of("break-float");
  const sheet = { sheet: "break-float", hash, written: { where: "The root.\nRounded down." }, built: { 1: "b0,0;1,1@0.0" } };
  write("ada.json", result("Ada", sheet));
  const text = good(["grade", "ada.json"]);
  assert.match(text, /ada\.json +Ada +break-float +1 +1 +ok/);
  assert.match(text, /Example of 2 points: /);
  assert.match(text, / {6}The root\.\n {6}Rounded down\./);
  assert.match(text, /\(nothing written\)/);
  const [line] = json_lines(good(["grade", "--json", "ada.json"]));
  assert.deepEqual([line.sheet, line.mark, line.of, line.status], ["break-float", 1, 1, "ok"]);
  assert.equal(line.written.where, "The root.\nRounded down.");

  write("bob.json", result("Bob", { ...sheet, built: { 1: "b0,0;1,0@0.0" } }));
  const bob = snug(["grade", "--json", "bob.json"]);
  assert.equal(bob.status, 1);
  assert.equal(JSON.parse(bob.out).status, "differs");
  write("old.json", result("Old", { ...sheet, hash: "0".repeat(16) }));
  assert.equal(JSON.parse(snug(["grade", "--json", "old.json"]).out).status, "foreign");
  for (const [name, broken] of Object.entries({
    "no-table": { ...sheet, measured: { own: { date: "2026-11-28", table: { table: "costs" } } } },
    "no-text": { ...sheet, written: { where: 7 } },
    "no-rows": { ...sheet, built: { 1: "b" } },
  })) {
    write(`${name}.json`, result("X", broken));
    const graded = snug(["grade", "--json", `${name}.json`]);
    assert.deepEqual([graded.status, JSON.parse(graded.out).status], [1, "damaged"], name);
  }
});

test("the tables of forty machines are one chart, a table and a picture", async () => {
  mkdirSync(join(folder, "class"));
  const hash = await hash_of("own-mesh");
  for (let i = 0; i < 40; ++i) {
    const rows = [row("ritter", 1000 + 20 * i), row("welzl", 5000 + 100 * i, i !== 7)];
    write(`class/${i}.json`, result(`Student ${i}`, {
      sheet: "own-mesh", hash, measured: { teapot: { date: "2026-11-28", table: table(i < 30 ? "Xeon" : "<Ryzen & co>", rows) } },
    }));
  }
  const lines = json_lines(good(["grade", "--tables", "class"]));
  assert.equal(lines.length, 80);
  assert.deepEqual(Object.keys(lines[0]), ["file", "student", "processor", "platform", "build", "version", "date", "table",
    "points", "volume", "algorithm", "what", "median_ns", "spread", "trusted", "over_hull", "bytes", "of"]);
  assert.equal(lines[0].date, "2026-11-28");

  good(["grade", "--tables", "class", "-o", "all.txt"]);
  const text = read("all.txt");
  assert.match(text, /One fit, teapot \(2 machines, 40 files\)/);
  assert.match(text, /sphere\/ritter +1 µs +1\.4 µs +1\.78 µs {2}[.oO|]/);
  assert.ok(text.indexOf("sphere/ritter") < text.indexOf("sphere/welzl"));
  assert.match(text, /1 time was not measured well/);
  assert.match(text, /Xeon, native, GNU 12, Release: 30 files/);

  good(["grade", "--tables", "class", "-o", "all.svg"]);
  const svg = read("all.svg");
  assert.equal(svg.match(/<circle/g).length, 80);
  assert.match(svg, /&lt;Ryzen &amp; co&gt;/);
  for (const tick of ["2 µs", "4 µs", "8 µs"]) assert.ok(svg.includes(`>${tick}<`), `less than a decade, and no ${tick}`);
  assert.equal(good(["grade", "--tables", "--csv", "class"]).trimEnd().split("\n").length, 81);
  write("none.json", JSON.stringify({ snug_result: 1, version: "0.1.0", student: "", attempts: [] }));
  refused(["grade", "--tables", "none.json"], /^snug: none\.json: missing: it has no attempt$/m);
});

test("tables are of as many points of one name, and machines are counted, not files", async () => {
  mkdirSync(join(folder, "knots"));
  const hash = await hash_of("own-mesh");
  const hand_in = (name, processor, of) => write(`knots/${name}.json`, result(name, {
    sheet: "own-mesh", hash, measured: { own: dated(table(processor, [row("ritter", 20 * of, true, of)], "knot.obj")) },
  }));
  hand_in("a", "Xeon", 1920), hand_in("b", "Xeon", 1920), hand_in("c", "Ryzen", 1920), hand_in("d", "Xeon", 88);
  good(["grade", "--tables", "knots", "-o", "knots.txt"]);
  assert.match(read("knots.txt"), /One fit, knot\.obj, 1,920 points \(2 machines, 3 files\)\n/);
  assert.match(read("knots.txt"), /One fit, knot\.obj, 88 points \(1 machine, 1 file\)\n/);
  assert.deepEqual(json_lines(good(["grade", "--tables", "knots"])).map(({ of }) => of), [1920, 1920, 1920, 88]);
});

test("--tables names each file that it cannot take, and draws the rest", async () => {
  mkdirSync(join(folder, "mixed"));
  const hash = await hash_of("own-mesh");
  const sheet = (median) => ({ sheet: "own-mesh", hash, measured: { own: dated(table("Xeon", [row("ritter", median)])) } });
  write("mixed/cut.json", '{ "snug_result": 1,');
  write("mixed/empty.json", "");
  write("mixed/odd.json", "{}");
  write("mixed/untimed.json", result("Ada", sheet(-1)));
  const alone = (name, says) => refused(["grade", "--tables", `mixed/${name}.json`], `mixed/${name}.json: ${says}`);
  alone("cut", "damaged: is not JSON");
  alone("empty", "damaged: is empty");
  alone("odd", "foreign: is no result file");
  alone("untimed", 'damaged: the table "own" has no time above 0 (own-mesh)');
  write("mixed/whole.json", result("Bob", sheet(1000)));
  const { out, err, status } = snug(["grade", "--tables", "mixed"]);
  assert.deepEqual([status, json_lines(out).map(({ student }) => student)], [1, ["Bob"]]);
  assert.deepEqual(err.match(/(?<=^snug: mixed\/)\w+(?=\.json: warning: (damaged|foreign): )/gm), ["cut", "empty", "odd", "untimed"]);
});

test("--tables writes what the ending says, and no other", () => {
  const as = (...more) => ["grade", "--tables", "class", ...more];
  for (const name of ["x.png", "x.pdf", "x.SVGZ"])
    refused(as("-o", name), `${name}: has none of the endings .svg, .csv, .json and .txt, which say the format`);
  refused(as("--csv", "-o", "x.svg"), "x.svg: ends in .svg, and another format was asked for");
  assert.ok(!existsSync(join(folder, "x.png")) && !existsSync(join(folder, "x.svg")));
  good(as("-o", "x.csv")), good(as("-o", "x.json"));
  assert.match(read("x.csv"), /^file,student,/);
  assert.equal(json_lines(read("x.json")).length, 80);
});

test("grade says what a file lacks, in columns of letters, and no mark where none can be earned", async () => {
  mkdirSync(join(folder, "three"));
  for (const [i, id] of [...sheets].sort().entries())
    write(`three/${id}.json`, result(["Žofie Šťastná", "Bo", "Zoë"][i], { sheet: id, hash: await hash_of(id), written: { where: "The root." } }));
  write("three/cut.json", "{");
  const { out, err, status } = snug(["grade", "three", "three/nowhere.json"]);
  assert.equal(status, 1);
  assert.match(err, /three\/nowhere\.json: warning: missing: there is no such file\n/);
  const [head, ...rows] = out.split("\n\n")[0].split("\n");
  const at = (line, name) => [...line].slice([...head].join("").indexOf(name)).join("").split("  ")[0].trim();
  const shown = rows.map((line) => ["exercise", "mark", "of", "status"].map((name) => at(line, name)));
  assert.deepEqual(shown, [["", "", "", "damaged"], ["", "", "", "missing"], ["own-mesh", "", "", "ok"],
    ["break-even", "", "", "ok"], ["break-float", "0", "1", "ok"]]);
  assert.match(out, /break-float\.json: break-float\n {2}\d of \d parts are missing\.\n/);
  assert.match(out, /own-mesh\.json: own-mesh\n {2}(\d) of \1 parts are missing\.\n/);
  const ids = [...out.matchAll(/\.json: (\S+)\n/g)].map(([, id]) => id);
  assert.deepEqual(ids, sheets, "in the order of their course");
});
