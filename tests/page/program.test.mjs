// What tsc takes the program's functions to be (web/page/program.d.ts) is what web/main.cpp binds. The objects that
// they give are compared in tests/browser/state.test.mjs.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

const read = (/** @type {string} */ path) => readFileSync(new URL(`../../web/${path}`, import.meta.url), "utf8");

test("the interface Door has the functions that are bound, in their order, and no other", () => {
  const bound = [...read("main.cpp").matchAll(/^ {2}function\("(\w+)"/gm)].map(([, name]) => name);
  const [, body] = /^interface Door \{\n(.*?)^\}/ms.exec(read("page/program.d.ts")) ?? [];
  const declared = [...(body ?? "").matchAll(/^ {2}(\w+)\(/gm)].map(([, name]) => name);
  assert.ok(bound.length > 50);
  assert.deepEqual(declared, bound);
});
