// snug demo: the two that come with it are as they were recorded; what is wrong with a file is told with its place.
import assert from "node:assert/strict";
import { test } from "node:test";
import { good, json_lines, read, refused, snug, write } from "./support.mjs";

const kDemo = `version = 1
title = "Two states"
lecture = "A lecture"

[[state]]
slide = "One"
lesson = "sphere-ritter"
algorithm = "ritter"
step = 3
notes = "Say this."

[[state]]
slide = "Two"
lesson = "sphere-ritter"
seed = 7
step = "end"
reveal = ["numbers"]
notes = "Say that."
`;

test("the demos are listed, and every state's trace is what its file says", () => {
  const all = json_lines(good(["demo", "list"]));
  assert.deepEqual(all.map(({ demo, states }) => [demo, states]), [["collision", 20], ["geometry", 25]]);
  for (const checked of json_lines(good(["demo", "check", "collision", "geometry"])))
    assert.deepEqual([checked.differ, Object.keys(checked)], [0, ["demo", "states", "differ", "file"]]);
});

test("a state that is not as it was is told, and written on request; then nothing differs", () => {
  const file = write("two.toml", kDemo);
  const first = snug(["demo", "check", file]);
  assert.equal(first.status, 1);
  const [one, two, all] = json_lines(first.out);
  assert.deepEqual([one.state, one.line, one.was, two.state, two.line, all.differ], [1, 5, null, 2, 12, 2]);
  good(["demo", "check", "--write", file]);
  assert.ok(read("two.toml").includes(`[[state]]\nhash = "${one.is}"\nslide = "One"`));
  good(["demo", "check", file]);
  write("two.toml", read("two.toml").replace("seed = 7", "seed = 8"));
  const [differs] = json_lines(snug(["demo", "check", file]).out);
  assert.deepEqual([differs.state, differs.was, differs.is === two.is], [2, two.is, false]);
});

test("of a file's line only the hash is written, and the rest stays: remarks, quotes and line ends", () => {
  const old = "0".repeat(16), lines = `lesson = "sphere-ritter" # é\nhash   = '${old}'  # "as shown" = 1`;
  const file = write("remarks.toml", kDemo.replace('lesson = "sphere-ritter"', lines).replaceAll("\n", "\r\n"));
  const before = read(file);
  const [one, two] = json_lines(snug(["demo", "check", file]).out);
  good(["demo", "check", "--write", file]);
  const second = before.lastIndexOf("[[state]]\r\n") + "[[state]]\r\n".length;
  const with_second = `${before.slice(0, second)}hash = "${two.is}"\r\n${before.slice(second)}`;
  assert.equal(read(file), with_second.replace(old, one.is));
  good(["demo", "check", file]);
});

test("a state in braces has no line for its hash: it is told where, and no file is written", () => {
  const keys = kDemo.split("[[state]]\n").slice(1).map((keys) => `{ ${keys.trim().split("\n").join(", ")} }`);
  const braces = write("braces.toml", `${kDemo.split("[[state]]")[0]}state = [\n  ${keys.join(",\n  ")},\n]\n`);
  const before = read(braces), plain = write("plain.toml", kDemo);
  assert.equal(json_lines(snug(["demo", "check", braces]).out).at(-1).differ, 2);
  refused(["demo", "check", "--write", plain, braces], /^snug: braces\.toml:6:3: a state in braces has no line for its hash/);
  assert.deepEqual([read(braces), read(plain)], [before, kDemo]);
});

test("mistakes are told with file, line and column", () => {
  const wrong = (from, to, says) => refused(["demo", "check", write("wrong.toml", kDemo.replace(from, to))], says);
  wrong('slide = "One"', 'slid = "One"', /wrong\.toml:6:1: \[\[state\]\] has no key "slid": did you mean "slide"\?/);
  wrong('"sphere-ritter"', '"sphere-riter"', /wrong\.toml:7:10: "lesson": there is no lesson "sphere-riter"/);
  wrong('"ritter"', '"riter"', /wrong\.toml:8:13: "algorithm": .*did you mean ritter\?/);
  wrong("step = 3", "step = 3000", /wrong\.toml:9:8: "step": there is no step 3000/);
  wrong('["numbers"]', '["figures"]', /wrong\.toml:17:10: "reveal" is none of caption, prose, numbers/);
  wrong("seed = 7", 'rows = "1,x"', /wrong\.toml:15:8: "rows" must be rows of numbers/);
  wrong("seed = 7", 'hash = "12"', /wrong\.toml:15:8: "hash" must be 16 hexadecimal digits/);
  refused(["demo", "check", "nowhere"], /there is no demo "nowhere"/);
});

test("what many rows have packed is read from a demo's file, and what is damaged is told", () => {
  const wrong = write("packed.toml", kDemo.replace("step = 3", 'packed = "?"'));
  refused(["demo", "check", wrong], /packed\.toml:9:10: "packed" is not as an address has it/);
});
