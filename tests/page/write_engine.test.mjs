// The engine that runs a student's code, as Node runs it for `snug grade`: what the code tries stays inside, and ends.
// It is the worker of the page, as it is built.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const assets = fileURLToPath(new URL("../../build/release/assets/write/", import.meta.url));

/** What becomes of code that is called with two cases. */
function run(code, gives = "b", lines = ['{"a":1}', '{"a":2}']) {
  const asked = { code, name: "f", gives, lines };
  const files = [`${assets}worker.js`, `${assets}quickjs.wasm`];
  const done = spawnSync("node", files, { input: JSON.stringify(asked), encoding: "utf8", timeout: 60_000 });
  assert.equal(done.status, 0, done.stderr);
  return JSON.parse(done.stdout);
}

test("a function is called with each case, and what it prints is kept", () => {
  const { answers, output, error } = run("function f(a) { console.log(a, { x: [a] }); return a < 2; }");
  assert.deepEqual(answers, ["1", "0"]);
  assert.equal(output, '1 {"x":[1]}\n2 {"x":[2]}\n');
  assert.equal(error, null);
});

test("numbers come back as they are, and what has another shape is said", () => {
  assert.deepEqual(run("const f = (a) => ({ x: [-0, 1 / 3, a / 0], y: NaN });", "{x:3n,y:n}").answers[0],
    "-0 0.3333333333333333 inf nan");
  assert.match(run("function f() { return [1, 2]; }", "3n").answers[0], /^!it is not a list of 3/);
  assert.match(run("function f() { return { x: 'no' }; }", "{x:n}").answers[0], /^!x is not a number/);
  assert.match(run("function f() { return null; }", "{x:n}").answers[0], /^!x is missing/);
  assert.equal(run("function f(a) { return 'two'; }", "one|two").answers[0], "1");
  assert.match(run("function f(a) { return 'three'; }", "one|two").answers[0], /^!it is none of/);
});

test("a mistake has its line", () => {
  assert.deepEqual(run("function f() {\n  retrn 1;\n}").error.line, 2);
  assert.deepEqual(run("function f(a) {\n\n  return a.b.c;\n}").error,
    { what: "TypeError: cannot read property 'c' of undefined", line: 3 });
  assert.deepEqual(run("function f() {\n  return 1;").error.line, 2); // not the line after it
  assert.deepEqual(run("function g() {\n}\n").error, { what: "There is no function f.", line: 0 });
  assert.deepEqual(run("const f = g;").error, { what: "ReferenceError: 'g' is not defined", line: 1 });
});

test("steps are counted to the last one: each call, each condition and each turn of a loop", () => {
  const lines = 2;
  /** @param {string} body @param {number} each */
  const takes = (body, each) => assert.equal(run(`function f(a) { ${body} }`).steps, lines * each, body);
  takes("return true;", 1);
  takes("return Math.abs(a) > 0;", 2);
  takes("return a > 1 ? true : false;", 2);
  takes("for (let i = 0; i < 7; ++i); return true;", 1 + 8 + 7);
  takes("for (let i = 0; i < 30000; ++i); return true;", 1 + 30001 + 30000);
  assert.equal(run("for (let i = 0; i < 25000; ++i); const f = () => true;").steps, lines); // of the cases alone
  assert.equal(run("function f() { for (;;); }").steps, null);
});

test("variables are noted, the last value of each, and no more than there is room for", () => {
  const { notes } = run("function f(a) { let x = a / 2; $note('x', x); $note('y', { a }); return true; }");
  assert.deepEqual(notes, { x: "1", y: '{"a":2}' });
  const many = run("function f() { for (let i = 0; i < 99; ++i) $note(`v${i}`, 'x'.repeat(999)); return true; }").notes;
  assert.equal(Object.keys(many).length, 40);
  assert.equal(many.v0.length, 200);
});

test("what does not end is ended, after as many steps each time", () => {
  const search = "function f() { return /^(a+)+$/.test('a'.repeat(40) + 'b'); }";
  for (const code of ["function f() { for (;;); }", "for (;;);", search]) {
    const { error, turns } = run(code);
    assert.equal(error.what, "it took too many steps", code);
    assert.equal(turns, 1001, code);
  }
  const getter = run("function f() { return { get x() { for (;;); } }; }", "{x:n}");
  assert.match(getter.answers[0], /^!x is not a number/);
  assert.equal(getter.answers.length, 1); // it is not asked for more
});

test("what runs long within the engine's own functions is ended as well, after the same work each time", () => {
  const lines = Array.from({ length: 400 }, (_, i) => `{"a":${i}}`);
  for (const work of ["'ab'.repeat(1e5).indexOf('bb')", "new Uint8Array(2e5).sort()", "'a'.repeat(4e6)"]) {
    const code = `function f() { for (let i = 0; i < 20; ++i) ${work}; return true; }`;
    const [first, second] = [run(code, "b", lines), run(code, "b", lines)];
    assert.equal(first.error.what, "it took too many steps", work);
    assert.equal(first.answers.at(-1), "!it took too many steps");
    assert.ok(first.answers.length > 2 && first.answers.length < lines.length, `${work}: ${first.answers.length}`);
    assert.deepEqual(second, first); // the answers before it are kept
  }
  const { answers, error } = run("for (;;) 'a'.repeat(4e6); function f() { return true; }");
  assert.deepEqual([answers, error.what], [[], "it took too many steps"]); // it could not be called
});

test("recursion and what is huge are refused", () => {
  assert.match(run("function f() { return f(); }").answers[0], /stack overflow/);
  assert.match(run("function f() { let s = 'x'; for (;;) s += s; }").answers[0], /string too long|out of memory/);
  assert.match(run("function f() { return new Array(2 ** 32 - 1).fill(0).length > 0; }").answers[0], /out of memory/);
  assert.match(run("function f() { return new Float64Array(2 ** 30).length > 0; }").answers[0], /invalid array buffer/);
  assert.match(run("function f() { return { length: 1e9 }; }", "*n").answers[0], /^!it is not a list/);
});

test("there is nothing outside to reach", () => {
  const names = ["fetch", "XMLHttpRequest", "WebSocket", "setTimeout", "process", "require", "document", "self",
    "postMessage", "Worker", "WebAssembly", "std", "os", "Date", "performance"];
  const code = `function f() { return ${JSON.stringify(names)}.every((name) => !(name in globalThis)); }`;
  assert.deepEqual(run(code).answers, ["1", "1"]);
  const within = "function f() { return Function('return this')() === globalThis && typeof process === 'undefined'; }";
  assert.deepEqual(run(within).answers, ["1", "1"]);
});

test("chance is the same each time, and what breaks the engine itself is an answer", () => {
  const chance = () => run("function f() { return Math.random(); }", "n").answers;
  assert.deepEqual(chance(), chance());
  const deep = run("function f() { let a = []; for (let i = 0; i < 2e4; ++i) a = [a]; console.log(a); return true; }");
  assert.equal(deep.error.what, "it nests too deeply");
});

test("what the code does to its own world does not change how it is called or read", () => {
  const code = `JSON.parse = () => 0; JSON.stringify = () => { throw 1; }; Array.prototype.push = () => { throw 1; };
    Object.prototype.toString = () => "no"; Object.defineProperty(Object.prototype, "x", { get: () => 7, set() {} });
    function f(a) { console.log({}); return a === 1; }`;
  assert.deepEqual(run(code).answers, ["1", "0"]);
  let reads = "let n = 0; function f() { return { get x() { return ++n; } }; }";
  assert.deepEqual(run(reads, "{x:n}").answers, ["1", "2"]); // a getter is asked once
  reads = "function f() { return { get x() { throw new Error('no'); } }; }";
  assert.match(run(reads, "{x:n}").answers[0], /^!x is not a number, but nothing that can be read/);
});

test("of what is printed the beginning is kept", () => {
  const { answers, output } = run(`function f() {
    for (let i = 0; i < 3000; ++i) console.log('x'.repeat(100));
    return true;
  }`);
  assert.deepEqual(answers, ["1", "1"]);
  assert.ok(output.length <= 4000);
});
