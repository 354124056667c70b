// The `snug` command, called as a script calls it. SNUG: the program; build/release/snug if not set.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { after } from "node:test";
import { fileURLToPath } from "node:url";

export const root = resolve(dirname(fileURLToPath(import.meta.url)), "../..");
export const program = resolve(process.env.SNUG ?? join(root, "build/release/snug"));
/** Where the command runs: a folder of each test file's own. */
export const folder = mkdtempSync(join(tmpdir(), "snug-"));
after(() => rmSync(folder, { recursive: true }));

export function snug(args, input = "") {
  const done = spawnSync(program, args, { input, encoding: "utf8", cwd: folder, maxBuffer: 2 ** 28 });
  if (done.error?.code !== "EPIPE") assert.equal(done.error, undefined); // it may refuse without having read what it is given
  return { out: done.stdout, err: done.stderr, status: done.status };
}

export function write(name, text) {
  writeFileSync(join(folder, name), text);
  return name;
}

export const read = (name) => readFileSync(join(folder, name), "utf8");

export const json_lines = (text) => text.trimEnd().split("\n").map((line) => JSON.parse(line));

export function good(args, input) {
  const { out, err, status } = snug(args, input);
  assert.equal(err, "");
  assert.equal(status, 0);
  return out;
}

/** A mistake in a lesson's file, at some column of that line. */
export const mistake = (file, line, says) => new RegExp(`^snug: ${escaped(file)}:${line}:\\d+: ${escaped(says)}`);
const escaped = (text) => text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");

/** Exit 2, nothing on stdout, and one line on stderr, or as many as there are mistakes. line: the first of them. */
export function refused(args, line, input, mistakes = 1) {
  const { out, err, status } = snug(args, input);
  assert.equal(out, "");
  if (line instanceof RegExp) assert.match(err, line);
  else assert.equal(err, `snug: ${line}\n`);
  assert.match(err, new RegExp(`^(snug: [^\\n]+\\n){${mistakes}}$`));
  assert.equal(status, 2);
}
