// What the command prints as JSON is what desktop/schema.json says, field by field.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { good, root, write } from "./support.mjs";

const schema = join(root, "desktop/schema.json");
const { $defs } = JSON.parse(readFileSync(schema, "utf8"));
const kCheck = `import json, jsonschema, sys
schema = json.load(open(sys.argv[1]))
schema["$ref"] = "#/$defs/" + sys.argv[2]
check = jsonschema.Draft202012Validator(schema)
for line in sys.stdin:
    for error in check.iter_errors(json.loads(line)): print(error.validator, error.message[:300])`;

/** The faults that the schema finds in JSON Lines. */
function faults(kind, lines) {
  const { stdout, stderr } = spawnSync("/usr/bin/python3", ["-c", kCheck, schema, kind], { input: lines, encoding: "utf8" });
  assert.equal(stderr, "");
  return stdout;
}

/** Each line is as the schema says, and has no field that it does not name. */
function conforms(kind, lines) {
  assert.equal(faults(kind, lines), "", kind);
  for (const line of lines.trimEnd().split("\n"))
    for (const key of Object.keys(JSON.parse(line))) assert.ok(key in $defs[kind].properties, `${kind}: ${key} is not documented`);
}

const tetra = write("tetra.xyz", "0 0 0\n2 0 0\n0 2 0\n0 0 2\n");

test("fits of every volume, lists and tests are as the schema says", () => {
  for (const [volume, algorithm] of Object.entries({
    sphere: "welzl", aabb: "min_max", obb: "pca", capsule: "pca", lozenge: "pca", kdop: "k14", hull: "quickhull",
  }))
    for (const scalar of ["double", "float"])
      conforms("fit", good(["fit", "--volume", volume, "--algorithm", algorithm, "--scalar", scalar, "--repeat", "1", tetra]));
  conforms("algorithms", good(["algorithms"]));
  conforms("lesson", good(["lesson", "list"]));
  conforms("exercise", good(["exercise", "list"]));
  const [a, b] = [{ sphere: { center: [0, 0, 0], radius: 1 } }, { aabb: { min: [2, 0, 0], max: [3, 1, 1] } }];
  conforms("overlap", good(["overlap"], `${JSON.stringify({ a, b })}\n${JSON.stringify({ a, b: a })}\n`));
  const planes = [[1, 0, 0, -1], [-1, 0, 0, -1], [0, 1, 0, -1], [0, -1, 0, -1], [0, 0, 1, -1], [0, 0, -1, -1]];
  conforms("cull", good(["cull"], `${JSON.stringify({ frustum: { planes }, volume: a })}\n`));
  write("one.json", good(["exercise", "answer", "be-ritter", "--seed", "3"]));
  conforms("attempt", good(["grade", "--json", "one.json"]));
});

test("the schema refuses what is not so", () => {
  const fit = JSON.parse(good(["fit", "--volume", "sphere", "--algorithm", "welzl", "--repeat", "1", tetra]));
  assert.match(faults("fit", JSON.stringify({ ...fit, points: "four" })), /'four' is not of type 'integer'/);
  assert.match(faults("fit", JSON.stringify({ ...fit, sphere: undefined })), /^oneOf /);
});
