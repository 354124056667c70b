// snug lab: each lab solved, and with its usual mistakes, each of which gets the case that shows it; and code that does
// not behave. The core is installed into a folder of the test's own.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { before, test } from "node:test";
import { dirname, join } from "node:path";
import { folder, json_lines, program, refused, root, snug } from "./support.mjs";

const solved = (lab) => readFileSync(join(root, "tests/command/lab", `${lab}.cpp`), "utf8");

before(() => {
  const prefix = join(folder, "core");
  const install = ["--install", dirname(program), "--component", "development", "--prefix", prefix];
  execFileSync("cmake", install, { stdio: "ignore" });
  process.env.CMAKE_PREFIX_PATH = prefix;
});

/** The lab begun anew, with this code. */
function write(lab, code) {
  rmSync(join(folder, lab), { recursive: true, force: true });
  const { status, err } = snug(["lab", "new", lab, lab]);
  assert.equal(status, 0, err);
  writeFileSync(join(folder, lab, `${lab}.cpp`), code);
}
const check = (lab) => snug(["lab", "check", lab, "--student", "Ada"]);
const replaced = (code, from, to) => {
  assert.ok(code.includes(from), from);
  return code.replace(from, to);
};

test("what is begun has a stub, its header, three tests, a project and a page to read; nothing is overwritten", () => {
  write("overlap", "");
  for (const name of ["overlap.hpp", "tests.cpp", "CMakeLists.txt", "README.md"])
    assert.ok(existsSync(join(folder, "overlap", name)), name);
  assert.doesNotMatch(readFileSync(join(folder, "overlap", "README.md"), "utf8"), /@/);
  refused(["lab", "new", "overlap", "overlap"], "overlap: is there already, and not empty");
  refused(["lab", "new", "ovrlap", "x"], /^snug: the lab is none of overlap, .*: ovrlap; did you mean overlap\?$/m);
  refused(["lab", "check", "."], ".: is no folder that snug lab new has made");
});

// Each try compiles for seconds: SNUG_EVERY_MISTAKE=1 tries all labs, and all mistakes.
const kLabs = readdirSync(join(root, "desktop/lab"), { withFileTypes: true }).filter((one) => one.isDirectory())
  .map(({ name }) => name);
for (const lab of process.env.SNUG_EVERY_MISTAKE ? kLabs : kLabs.slice(0, 2))
  test(`${lab} is solved, and graded by what was handed in`, () => {
    write(lab, solved(lab));
    const { out, status, err } = check(lab);
    assert.equal(status, 0, out + err);
    const [, mark, of] = /Mark (\d+) of (\d+)[.]/.exec(out);
    assert.equal(mark, of);
    const graded = snug(["grade", "--json", join(lab, "result.json")]);
    const [row] = json_lines(graded.out);
    assert.deepEqual({ mark: row.mark, of: row.of, status: row.status, student: row.student },
      { mark: Number(mark), of: Number(of), status: "ok", student: "Ada" });
  });

/** The lab, what is replaced by what, and the kind of cases that shows it. */
const kMistakes = [
  ["overlap", "a.max[i] < b.min[i]", "a.max[i] <= b.min[i]", "touching"], // < for <=
  ["overlap", "return false;\n  return true;", "return false;\n    else return true;\n  return true;", "one axis"], // an early return
  ["overlap", "a.max[i] < b.min[i]", "a.max[i] < b.min[i] - 1e-9", "tiny"], // an epsilon at the wrong scale
  ["overlap", "a.max[i] < b.min[i]", "static_cast<float>(a.max[i]) < static_cast<float>(b.min[i])", "far"],
  ["ritter", "distance <= sphere.radius", "distance < sphere.radius", "zero"],
  ["ritter", "distance <= sphere.radius", "distance <= sphere.radius + 1e-9", "tiny"],
  ["ritter", "point - sphere.center", "(point.cast<float>() - sphere.center.cast<float>()).cast<double>()", "far"],
  ["sat", "std::abs(box.axes.col(i).dot(axis))", "box.axes.col(i).dot(axis)", "random"], // a forgotten absolute value
  ["sat", "axis.squaredNorm() > 1e-20 && separates", "!(axis.squaredNorm() > 1e-20) || separates", "parallel"],
  ["sat", "> radius(a", ">= radius(a", "touching"],
  ["sat", " || separates(a, b, b.axes.col(i))", "", "faces"],
  ["sat", "j < 3", "j < 0", "edges"],
  ["sat", "(b.center - a.center)", "(b.center.cast<float>() - a.center.cast<float>()).cast<double>()", "far"],
  ["pvertex", "normal[i] >= 0 ? box.max[i]", "normal[0] >= 0 ? box.max[i]", "random"],
  ["pvertex", "normal[i] >= 0 ? box.max[i]", "normal[i] > -1e-9 ? box.max[i]", "tiny"],
  ["pvertex", "? box.max[i]", "? static_cast<float>(box.max[i])", "far"],
  ["quickhull", "left > most", "left >= most", "none"],
  ["quickhull", "best = static_cast<int>(i), most = left", "return static_cast<int>(i)", "random"],
  ["quickhull", "double most = 0", "double most = 1e-9", "tiny"],
  ["quickhull", "points[i] - from", "(points[i].cast<float>() - from.cast<float>()).cast<double>()", "far"],
  ["welzl", "l < k", "l < 0", "random"], // four points are forgotten
  ["welzl", "if (!(extent > 0)) return {origin, 0};", "", "one"],
  ["welzl", "radius + 1e-10 * extent", "radius + 1e-10", "tiny"],
  ["welzl", "p -= origin,", "p = p.cast<float>().cast<double>(), p -= origin,", "far"],
];
for (const [lab, from, to, kind] of process.env.SNUG_EVERY_MISTAKE ? kMistakes : kMistakes.slice(0, 1))
  test(`${lab}: ${to} fails on ${kind}`, () => {
    write(lab, replaced(solved(lab), from, to));
    const { out, status } = check(lab);
    assert.equal(status, 1);
    assert.match(out, new RegExp(`FAILS ${kind}: `));
    assert.match(out, /The first that differs/);
  });

const body = (code) => `#include "overlap.hpp"
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>
#include <vector>
bool overlap(const snug::Aabb<double, 3>& a, const snug::Aabb<double, 3>& b) {
  ${code}
  return a.min[0] <= b.max[0];
}
`;
for (const [name, code, says] of [
  ["an endless loop", "for (volatile unsigned i = 0;; ++i) {}", /it took more than 10 seconds/],
  ["recursion", "return overlap(b, a);", /it crashed at overlap.cpp:\d+: stack-overflow/],
  ["huge memory", "for (;;) { auto* p = new std::vector<char>(1 << 24, 'x'); if (p->empty()) break; }",
    /it took more than 512 MiB of memory|it crashed/],
  ["an index out of range", "std::vector<int> v(3); return v.data()[a.min[0] > -1e300 ? 3 : 0] != 0;",
    /it crashed at overlap.cpp:9: heap-buffer-overflow/],
])
  test(`${name} is stopped, and said`, () => {
    write("overlap", body(code));
    const { out, status, err } = check("overlap");
    assert.equal(status, 1, err);
    assert.match(out, says);
  });

test("code reaches neither the network, nor another program, nor a file", () => {
  write("overlap", body(`static bool told = false;
  if (!told) {
    told = true;
    std::fprintf(stderr, "x");
    const bool net = socket(AF_INET, SOCK_STREAM, 0) >= 0, child = fork() >= 0;
    const bool file = open("/tmp/snug-was-here", O_CREAT | O_WRONLY, 0600) >= 0, gone = unlink("overlap.cpp") == 0;
    if (net || child || file || gone) std::abort();
  }`));
  const { out } = check("overlap");
  assert.doesNotMatch(out, /crashed/);
  assert.ok(!existsSync("/tmp/snug-was-here"));
});

test("what does not compile is said in the compiler's words", () => {
  write("overlap", "#include \"overlap.hpp\"\nbool overlap( {\n");
  refused(["lab", "check", "overlap"], /^snug: overlap\/overlap.cpp: it does not compile: .*overlap.cpp:2:/);
});

test("a file that claims more than its code earns differs", () => {
  write("overlap", replaced(solved("overlap"), "a.max[i] < b.min[i]", "a.max[i] <= b.min[i]"));
  check("overlap");
  const path = join(folder, "overlap", "result.json");
  writeFileSync(path, readFileSync(path, "utf8").replace(/"mark":\d/, '"mark":7'));
  const { out, status } = snug(["grade", "--json", path]);
  assert.equal(status, 1);
  assert.equal(json_lines(out)[0].status, "differs");
});
