// tests/suite.sh: a suite that passed is run again only where something has changed.
import { test } from "node:test";
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, existsSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { tmpdir } from "node:os";
import { root } from "./support.mjs";

const name = `suite-test-${process.pid}`;

/** Runs a suite that writes a line a time and ends with what the file `status` says. */
function run(folder, digest) {
  const command = `echo ran >>"${folder}/runs"; exit "$(cat "${folder}/status")"`;
  const env = { ...process.env, SNUG_DIGEST: digest };
  const { status } = spawnSync(join(root, "tests/suite.sh"), [name, "bash", "-c", command], { env });
  const runs = existsSync(join(folder, "runs")) ? readFileSync(join(folder, "runs"), "utf8").split("\n").length - 1 : 0;
  return { status, runs };
}

test("a suite that passed is run again once its digest is another, and one that failed always", (t) => {
  const folder = mkdtempSync(join(tmpdir(), "suite-"));
  t.after(() => {
    rmSync(folder, { recursive: true });
    execFileSync("bash", ["-c", `rm -f ${root}/build/logs/${name}.*`]);
  });
  writeFileSync(join(folder, "status"), "1");
  assert.deepEqual(run(folder, "a"), { status: 1, runs: 1 });
  assert.deepEqual(run(folder, "a"), { status: 1, runs: 2 });
  writeFileSync(join(folder, "status"), "0");
  assert.deepEqual(run(folder, "a"), { status: 0, runs: 3 });
  assert.deepEqual(run(folder, "a"), { status: 0, runs: 3 }, "nothing has changed");
  assert.deepEqual(run(folder, "b"), { status: 0, runs: 4 });
  assert.deepEqual(run(folder, ""), { status: 0, runs: 5 }, "without a digest it is always run");
  writeFileSync(join(folder, "status"), "1");
  assert.deepEqual(run(folder, "c"), { status: 1, runs: 6 });
  assert.deepEqual(run(folder, "b"), { status: 1, runs: 7 }, "what failed since is run, whatever passed before");
});
