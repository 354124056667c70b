// Where a student's code runs: in a worker of the page, which is ended if it takes too long, and as a program of Node,
// which `snug grade` gives its questions on standard input. What asks gets one answer and no more.
import { bring_engine, run } from "./engine.js";

/** @typedef {{ wasm: BufferSource | WebAssembly.Module, code: string, name: string, gives: string, lines: string[] }} Asked */

/** A failure of the engine itself, as when it overflows the stack that it runs on, is an answer too. */
const answer = (/** @type {Asked} */ asked) =>
  bring_engine(asked.wasm).then((engine) => run(engine, asked)).catch((/** @type {unknown} */ error) =>
    ({ answers: [], output: "", notes: {}, error: { what: `the engine gave up: ${error}`, line: 0 }, turns: 0, steps: null }));

/** node worker.js ENGINE.wasm: a line of standard input is {code, name, gives, lines}, a line of output what became of
 *  it. */
async function answer_lines() {
  const { readFileSync } = await import("node:fs");
  const wasm = await WebAssembly.compile(readFileSync(process.argv[2]));
  for (const line of readFileSync(0, "utf8").split("\n").filter(Boolean))
    process.stdout.write(`${JSON.stringify(await answer({ ...JSON.parse(line), wasm }))}\n`);
}

if (typeof process === "object" && process.versions?.node) void answer_lines();
else
  onmessage = async ({ data }) => postMessage(await answer(data));
