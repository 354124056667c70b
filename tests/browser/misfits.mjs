// What the program gives, against the types that tsc takes it to be of (told.d.ts, program.d.ts and page.d.ts there).
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const path_of = (/** @type {string} */ path) => fileURLToPath(new URL(path, import.meta.url));
const kOptions = { noEmit: true, strict: true, target: "esnext", module: "esnext", types: [], pretty: false };
const kTypes = ["told", "program", "page"].map((name) => path_of(`../../web/page/${name}.d.ts`));

/** What tsc says of values that are written as they are where their type is wanted: then a key too many is a fault as
 *  well. Empty if all fit.
 *  @param {{ type: string, value: unknown }[]} values */
export function misfits(values) {
  const folder = mkdtempSync(join(tmpdir(), "snug-misfits-"));
  const lines = values.map(({ type, value }, i) => `export const value_${i}: ${type} = ${JSON.stringify(value)};`);
  writeFileSync(join(folder, "values.ts"), lines.join("\n"));
  const config = { compilerOptions: kOptions, files: ["values.ts", ...kTypes] };
  writeFileSync(join(folder, "tsconfig.json"), JSON.stringify(config));
  const { stdout, stderr } = spawnSync(path_of("node_modules/.bin/tsc"), ["-p", folder], { encoding: "utf8" });
  rmSync(folder, { recursive: true });
  return stdout + stderr;
}
