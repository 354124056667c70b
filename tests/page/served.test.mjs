// A script is served as it is written but for its comments (web/without_comments.py).
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const { Linter } = createRequire(new URL("../browser/package.json", import.meta.url))("eslint");
const web = fileURLToPath(new URL("../../web", import.meta.url));
const kServed = `import json, sys, without_comments
print(json.dumps([without_comments.served(text) for text in json.load(sys.stdin)]))`;

/** A script as ESLint reads it. */
function tokens_of(/** @type {string} */ text) {
  const linter = new Linter();
  assert.deepEqual(linter.verify(text, []), []);
  return linter.getSourceCode().ast.tokens.map(({ type, value }) => `${type} ${value}`);
}

test("every script is served with each of its tokens, and no word of types", () => {
  const names = readdirSync(`${web}/page`).filter((name) => name.endsWith(".js"));
  const written = names.map((name) => readFileSync(`${web}/page/${name}`, "utf8"));
  const input = JSON.stringify(written);
  /** @type {string[]} */
  const served = JSON.parse(execFileSync("python3", ["-B", "-c", kServed], { encoding: "utf8", input, cwd: web }));
  for (const [i, name] of names.entries()) {
    assert.deepEqual(tokens_of(served[i]), tokens_of(written[i]), name);
    assert.ok(!/@(type|param|import)/.test(served[i]), name);
  }
});
