// The lab sheets on the command line: checked, graded, and the tables of forty machines side by side.
import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
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

const row = (algorithm, median, trusted = true) => ({
  volume: "sphere", algorithm, over_hull: 2, bytes: 32, time_ns: { median, spread: 0.05, trusted },
});
const table = (processor, rows) => ({
  table: "costs",
  provenance: { version: "0.1.0", build: "GNU 12, Release", platform: "native", processor, points: "teapot" },
  rows,
});
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
    "points", "volume", "algorithm", "what", "median_ns", "spread", "trusted", "over_hull", "bytes"]);
  assert.equal(lines[0].date, "2026-11-28");

  good(["grade", "--tables", "class", "-o", "all.txt"]);
  const text = read("all.txt");
  assert.match(text, /One fit, teapot \(40 machines\)/);
  assert.match(text, /sphere\/ritter +1 us +1\.4 us +1\.78 us +[.oO|]/);
  assert.ok(text.indexOf("sphere/ritter") < text.indexOf("sphere/welzl"));
  assert.match(text, /1 time was not measured well/);
  assert.match(text, /Xeon, native, GNU 12, Release: 30 files/);

  good(["grade", "--tables", "class", "-o", "all.svg"]);
  const svg = read("all.svg");
  assert.equal(svg.match(/<circle/g).length, 80);
  assert.match(svg, /&lt;Ryzen &amp; co&gt;/);
  assert.equal(good(["grade", "--tables", "--csv", "class"]).trimEnd().split("\n").length, 81);
  write("none.json", JSON.stringify({ snug_result: 1, version: "0.1.0", student: "", attempts: [] }));
  refused(["grade", "--tables", "none.json"], /no file has a measured table/);
});
