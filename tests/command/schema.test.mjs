// What the command prints as JSON is what desktop/schema.json says, field by field, for every command that has --json.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { folder, good, json_lines, root, snug, write } from "./support.mjs";

const schema = join(root, "desktop/schema.json");
const { $defs } = JSON.parse(readFileSync(schema, "utf8"));
// Users may meet fields that were added; here, one that the schema does not name is a fault.
const kCheck = `import json, jsonschema, sys
schema = json.load(open(sys.argv[1]))
def close(node):
    if isinstance(node, list): return [close(item) for item in node]
    if not isinstance(node, dict): return node
    closed = {key: close(item) for key, item in node.items()}
    if isinstance(node.get("properties"), dict) and node is not schema["$defs"]["step"]: closed.setdefault("additionalProperties", False)
    return closed
strict = close(schema)
checks = {}
for line in sys.stdin:
    kind, value = line.rstrip("\\n").split("\\t", 1)
    if kind not in checks: checks[kind] = jsonschema.Draft202012Validator({**strict, "$ref": "#/$defs/" + kind})
    for error in checks[kind].iter_errors(json.loads(value)):
        print(kind, error.json_path, error.validator, error.message[:300])`;

/** The faults that the schema finds in lines of JSON. kind: of each line's object. */
function faults(kind, lines) {
  const input = lines.trimEnd().split("\n").map((line) => `${kind(JSON.parse(line))}\t${line}\n`).join("");
  const { stdout, stderr } = spawnSync("/usr/bin/python3", ["-c", kCheck, schema], { input, encoding: "utf8" });
  assert.equal(stderr, "");
  return stdout;
}

const seen = new Set();
/** Each line is as the schema says. kind: the definition, or what tells it from the line's object. */
function conforms(kind, lines) {
  const kind_of = typeof kind === "string" ? () => kind : kind;
  for (const line of lines.trimEnd().split("\n")) seen.add(kind_of(JSON.parse(line)));
  assert.equal(faults(kind_of, lines), "");
}

const tetra = write("tetra.xyz", "0 0 0\n2 0 0\n0 2 0\n0 0 2\n");
const sphere = { sphere: { center: [0, 0, 0], radius: 1 } };
const planes = [[1, 0, 0, -1], [-1, 0, 0, -1], [0, 1, 0, -1], [0, -1, 0, -1], [0, 0, 1, -1], [0, 0, -1, -1]];
const lines = (...values) => values.map((value) => `${JSON.stringify(value)}\n`).join("");
const trace = (file) => conforms("step", readFileSync(join(folder, file), "utf8"));
const measured = (...args) => good([...args, "--json", "--repeat", "1"]);

/** By its call: runs each command that has --json in each of its forms. */
const runs = {
  fit() {
    for (const [volume, algorithm] of Object.entries({
      sphere: "welzl", aabb: "min_max", obb: "pca", capsule: "pca", lozenge: "pca", kdop: "k14", hull: "quickhull",
    }))
      for (const scalar of ["double", "float"])
        conforms("fit", good(["fit", "--volume", volume, "--algorithm", algorithm, "--scalar", scalar, "--repeat", "1", "--json", tetra]));
    good(["fit", "--volume", "sphere", "--algorithm", "ritter", "--steps", "steps.jsonl", tetra]);
    trace("steps.jsonl");
  },
  algorithms: () => conforms("algorithms", good(["algorithms", "--json"])),
  cases: () => conforms("case", good(["cases", "--json"])),
  overlap() {
    const b = { aabb: { min: [2, 0, 0], max: [3, 1, 1] } }, plane = { sphere: { center: [0, 0], radius: 1 } };
    conforms("overlap", good(["overlap", "--json", "--steps", "steps.jsonl"], lines({ a: sphere, b }, { a: sphere, b: sphere }, { a: plane, b: plane })));
    trace("steps.jsonl");
    for (const dim of ["2", "3"]) conforms("overlap_random", good(["overlap", "--json", "--random", "50", "--dim", dim]));
    conforms("overlap_costs", good(["overlap", "--json", "--costs", "--dim", "2"]));
  },
  update: () => {
    conforms("update", good(["update", "--volume", "obb", "--strategy", "transform", "--frames", "3", "--json", "--steps", "steps.jsonl", tetra]));
    trace("steps.jsonl");
  },
  cull() {
    const line = { frustum: { planes }, volume: sphere };
    conforms("cull", good(["cull", "--json", "--steps", "steps.jsonl"], lines(line)));
    trace("steps.jsonl");
    conforms((value) => ("tree" in value ? "cull_tree" : "cull_class"), good(["cull", "--json", "--tree", "median"], lines(line, line)));
    conforms("cull_survey", good(["cull", "--json", "--survey", "50"], lines(line)));
  },
  cost() {
    conforms("costs", measured("cost", "--generate", "ball:40", "--volume", "sphere"));
    write("then.json", measured("cost", tetra));
    conforms("costs", measured("cost", tetra, "--against", "then.json"));
    conforms("growth", measured("cost", "--growth", "--generate", "ball:40", "--algorithms", "ritter"));
    conforms("turn", measured("cost", "--turn", "--volume", "aabb", tetra));
    conforms("claims", measured("cost", "--claims", "--generate", "ball:40"));
    conforms("trials", measured("cost", "--trials", "ritter_ten_per_cent"));
  },
  which: () => conforms("which", measured("which", tetra)),
  scene() {
    const kind = (value) => ("effect" in value ? "scene_effect" : "lesson" in value ? "scene" : "scene_frame");
    for (const lesson of ["scene-broad", "scene-updates"]) conforms(kind, good(["scene", lesson, "--frames", "2", "--every", "--json"]));
  },
  "lesson list": () => conforms("lesson", good(["lesson", "list", "--json"])),
  "lesson check"() {
    const kind = (value) => ("chapters" in value ? "checked_course" : "sheet" in value ? "checked_sheet" : "checked_lesson");
    const files = ["sphere-ritter.toml", "cost-chart.toml", "course.toml", "labs/break-float.toml"];
    conforms(kind, good(["lesson", "check", "--json", ...files.map((file) => join(root, "lessons", file))]));
  },
  "lesson play": () => {
    for (const lesson of ["sphere-ritter", "obb-fitting"])
      conforms((value) => ("lesson" in value ? "played_lesson" : "played"), good(["lesson", "play", "--json", lesson]));
  },
  "lesson coverage": () => conforms("idea", good(["lesson", "coverage", "--json"])),
  "lesson facts": () => {
    for (const lesson of ["sphere-ritter", "obb-sat"])
      conforms((value) => ("fact" in value ? "fact" : "result"), good(["lesson", "facts", "--json", lesson]));
  },
  "exercise list": () => conforms("exercise", good(["exercise", "list", "--json"])),
  "exercise make": () => {
    for (const id of ["be-ritter", "sat-plane", "write:overlap-min-max"]) conforms("instance", good(["exercise", "make", id, "--seed", "3", "--json"]));
  },
  "exercise answer": () => {
    conforms("result_file", good(["exercise", "answer", "be-ritter", "--seed", "3", "--level", "1", "--json"]));
    conforms("result_file", good(["exercise", "answer", "write:overlap-min-max", "--seed", "3", "--json"]));
  },
  "exercise print": () => conforms("printed_sheet", good(["exercise", "print", "be-ritter", "-o", "paper", "--json"])),
  "exercise check": () => {
    conforms("checked_exercise", good(["exercise", "check", "be-ritter", "--seeds", "3", "--json"]));
    conforms("checked_function", good(["exercise", "check", "write:overlap-min-max", "--seeds", "3", "--json"]));
  },
  "demo list": () => conforms("demo", good(["demo", "list", "--json"])),
  "demo check"() {
    const file = write("own.toml", 'version = 1\ntitle = "One"\nlecture = "A"\n\n[[state]]\nslide = "One"\nlesson = "sphere-ritter"\nstep = 3\nnotes = "Say."\n');
    const { out, status } = snug(["demo", "check", "--json", file]);
    assert.equal(status, 1);
    conforms((value) => ("state" in value ? "demo_state" : "checked_demo"), out);
  },
  grade() {
    mkdirSync(join(folder, "class"));
    for (const [name, seed] of [["ada", "3"], ["bob", "3"]])
      good(["exercise", "answer", "be-ritter", "--seed", seed, "--level", "1", "--student", name, "-o", `class/${name}.json`]);
    conforms("attempt", good(["grade", "--json", "class"]));
    conforms("student", good(["grade", "--json", "--by-student", "class"]));
    conforms("alike", good(["grade", "--json", "--alike", "class"]));
    // A lab sheet, as it is handed in: its tables are those of snug cost and snug which.
    const tables = [measured("cost", tetra), measured("which", tetra)].map((text) => ({ date: "2026-11-28", table: JSON.parse(text) }));
    const sheet = { sheet: "own-mesh", hash: "0".repeat(16), written: { mesh: "Mine." }, measured: { teapot: tables[0], own: tables[1] }, built: { 1: "b0,0;1,1@0.0" } };
    const result = JSON.stringify({ snug_result: 1, version: "0.1.0", student: "Ada", attempts: [], sheets: [sheet] });
    conforms("result_file", result);
    write("sheet.json", result);
    conforms("sheet", snug(["grade", "--json", "sheet.json"]).out);
    conforms("machine", snug(["grade", "--json", "--tables", "sheet.json"]).out);
    writeFileSync(join(folder, "no.json"), "{}");
    conforms("attempt", snug(["grade", "--json", "no.json", "nowhere.json"]).out);
    conforms("student", snug(["grade", "--json", "--by-student", "nowhere.json"]).out);
  },
};
for (const [call, run] of Object.entries(runs)) test(`snug ${call} prints what the schema says`, run);

test("no command that can print JSON, and no definition, is left out", () => {
  const listed = (help, title) => help.split(`\n${title}:\n`)[1]?.split("\n\n")[0].split("\n") ?? [];
  const every = (call = []) => {
    const help = good([...call, "--help"]);
    const below = listed(help, "Subcommands").map((line) => /^ {2}(\S+)/.exec(line)?.[1]).filter(Boolean);
    const own = listed(help, "Options").some((line) => /^ {2}(-\S+,)*--json/.test(line));
    return [...(own ? [call.join(" ")] : []), ...below.flatMap((name) => every([...call, name]))];
  };
  assert.deepEqual(every().sort(), Object.keys(runs).sort());
  const printed = Object.entries($defs).filter(([, { description }]) => /^(snug|a line of a file) /.test(description));
  assert.deepEqual(printed.map(([kind]) => kind).filter((kind) => !seen.has(kind)), []);
});

test("the schema refuses what is not so, and says of every field what it is", () => {
  const [fit] = json_lines(good(["fit", "--volume", "sphere", "--algorithm", "welzl", "--repeat", "1", tetra]));
  const of_fit = (value) => faults(() => "fit", JSON.stringify(value));
  assert.match(of_fit({ ...fit, points: "four" }), /'four' is not of type 'integer'/);
  assert.match(of_fit({ ...fit, sphere: undefined }), / oneOf /);
  assert.match(of_fit({ ...fit, radius: 1 }), /'radius' was unexpected/);
  assert.match(of_fit({ ...fit, time_ns: { ...fit.time_ns, mean: 1 } }), /'mean' was unexpected/);
});
