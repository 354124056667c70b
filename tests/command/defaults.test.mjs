// A class's defaults: where snug.toml is looked for, what it sets for the command line, and what is refused in it.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { copyFileSync, mkdirSync, rmSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { folder, json_lines, program, root, write } from "./support.mjs";

const user = join(folder, "user"), system = join(folder, "system"), lessons = join(folder, "class");
for (const path of [join(user, "snug"), join(system, "snug"), lessons]) mkdirSync(path, { recursive: true });
copyFileSync(join(root, "lessons/sphere-ritter.toml"), join(lessons, "ours.toml"));

function snug(...args) {
  const env = { ...process.env, XDG_CONFIG_HOME: user, XDG_CONFIG_DIRS: `nowhere:${join(folder, "none")}:${system}` };
  const { stdout, stderr, status } = spawnSync(program, args, { cwd: folder, encoding: "utf8", env });
  return { out: stdout, err: stderr, status };
}
const ids = () => json_lines(snug("lesson", "list").out).map(({ lesson }) => lesson);

test("the class's lessons stand in place of the program's, and its exercises and cases stay", () => {
  write("system/snug/snug.toml", `lessons = "${lessons}"\nfirst_lesson = "ours"\ntheme = "projector"\nresults = "~/handed-in"\n`);
  assert.deepEqual(ids(), ["ours"]);
  assert.ok(json_lines(snug("exercise", "list").out).length > 10);
  assert.ok(json_lines(snug("cases").out).length > 10);
  assert.equal(snug("lesson", "play", "ours").status, 0);
  assert.equal(snug("lesson", "play", "sphere-ritter").status, 2);
});

test("the user's own file comes first, and a relative folder begins at the file's", () => {
  write("user/snug/snug.toml", "");
  assert.ok(ids().length > 40);
  write("user/snug/snug.toml", 'lessons = "../../class"\n');
  assert.deepEqual(ids(), ["ours"]);
  rmSync(join(user, "snug/snug.toml"));
});

test("what is wrong is told with its line, and nothing runs but help and version", () => {
  const file = join(system, "snug/snug.toml");
  for (const [text, line, says] of [
    ['theme = "pink"\n', 1, /light, dark, contrast or projector/],
    ['\nlessons = "/nowhere/at all"\n', 2, /is not a folder: \/nowhere\/at all/],
    ['first_lesson = "nothing"\n', 1, /is not a lesson: there is no .*nothing\.toml/],
    ['colour = "red"\n', 1, /colour/],
    ["theme = 1\n", 1, /theme/],
    ["theme\n", 1, /./],
  ]) {
    write("system/snug/snug.toml", text);
    const { out, err, status } = snug("algorithms");
    assert.equal(out, "");
    assert.ok(err.startsWith(`snug: ${file}:${line}:`), err);
    assert.match(err, says);
    assert.match(err, /^[^\n]*\n$/);
    assert.equal(status, 2);
    assert.equal(snug("--version").status, 0);
    assert.equal(snug("fit", "--help").status, 0);
  }
});
