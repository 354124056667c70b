// Runs a student's function in QuickJS, which has no network, no page and no clock: in a worker of the page, and under
// Node for `snug grade`. Its limits are counted in the engine's own turns and bytes, the same on every machine. Within a
// function of its own, such as sort, it cannot be asked: there its program's meter ends it (assets/metered.mjs).
import variant from "@jitl/quickjs-wasmfile-release-sync";
import { newQuickJSWASMModuleFromVariant, newVariant } from "quickjs-emscripten-core";
import { kNote } from "./note_name.js";

const kMemory = 32 * 2 ** 20; // bytes
const kStack = 256 * 2 ** 10; // bytes, well below what the engine's own program has
const kTurns = 1000; // for all cases together
const kTurn = 10000; // steps: calls, conditions and turns of loops that go by before the engine asks
const kMostOutput = 4000; // characters of console.log
const kMostNotes = 40; // variables
const kMostNote = 200; // characters of a variable's value
const kMostWhat = 300; // characters of an error
const kMostList = 100000;
const kTooMany = "it took too many steps", kTooDeep = "it nests too deeply";

/** What would differ from run to run: the clock is taken away, and chance has a seed. */
const kSame = `(() => {
  delete globalThis.Date;
  let last = 1;
  Math.random = () => (last = last * 16807 % 2147483647) / 2147483647;
})()`;

/** The console, in the engine itself: so printing costs the code its own turns and bytes; and what notes the code's
 *  variables by their names. Gives what was printed, and the last value of each variable. A value is written as JSON has
 *  it. */
const kConsole = `(() => {
  const { stringify } = JSON, text_of = String, most = ${kMostOutput}, most_notes = ${kMostNotes};
  const notes = { __proto__: null };
  let output = "", count = 0;
  const word = (value) => {
    try {
      return typeof value === "object" ? stringify(value) : text_of(value);
    } catch {
      return "?";
    }
  };
  globalThis.console = {
    log(...values) {
      if (output.length >= most) return;
      let line = "";
      for (let i = 0; i < values.length && line.length < most; ++i) line += (i > 0 ? " " : "") + word(values[i]);
      output += line + "\\n";
      if (output.length >= most) output = output.substring(0, most - 1) + "…";
    },
  };
  globalThis.${kNote} = (name, value) => {
    if (typeof value === "function" || (notes[name] === undefined && ++count > most_notes)) return;
    const text = text_of(word(value));
    notes[name] = text.length > ${kMostNote} ? text.substring(0, ${kMostNote} - 1) + "…" : text;
  };
  return () => stringify({ output, notes });
})()`;

/** Takes turns of a loop until the engine asks, and says how many it took. Between two of these the code's own turns can
 *  be counted to the last one. */
const kSpin = `(() => {
  let count = 0;
  return { spin() { for (count = 0; ; ) ++count; }, count: () => count };
})()`;

/** @typedef {{ answers: string[], output: string, notes: Record<string, string>,
 *    error: { what: string, line: number } | null, turns: number, steps: number | null }} Ran
 *    answers: a line for each case, numbers or ! and why there are none; notes: the last value of each variable that is
 *    noted; turns: how often the engine asked; steps: the calls, conditions and turns of
 *    loops of all cases, null if it was ended */

/** The engine. wasm: its program.
 *  @param {BufferSource | WebAssembly.Module} wasm */
export async function bring_engine(wasm) {
  const wasmModule = wasm instanceof WebAssembly.Module ? wasm : await WebAssembly.compile(wasm);
  return newQuickJSWASMModuleFromVariant(newVariant(variant, { wasmModule }));
}

/** Runs `name` of the code once for each line of JSON arguments. gives: the shape of what it returns.
 *  @param {Awaited<ReturnType<typeof bring_engine>>} engine
 *  @param {{ code: string, name: string, gives: string, lines: string[] }} asked @returns {Ran} */
export function run(engine, { code, name, gives, lines }) {
  const runtime = engine.newRuntime();
  runtime.setMemoryLimit(kMemory);
  runtime.setMaxStackSize(kStack);
  const clock = { turns: 0, spins: false };
  runtime.setInterruptHandler(() => clock.spins || ++clock.turns > kTurns);
  const context = runtime.newContext();
  const sandbox = new Sandbox(context, { code, name, gives, clock });
  try {
    return sandbox.run(lines);
  } catch (error) {
    const what = what_ended(error), answers = sandbox.answers && [...sandbox.answers, `!${what}`];
    return { answers: answers ?? [], output: "", notes: {}, error: { what, line: 0 }, turns: clock.turns, steps: null };
  } finally {
    close(context, runtime);
  }
}

/** Why the engine stopped: its meter or the stack that it runs on, which browsers name in their own ways.
 *  @param {unknown} error */
function what_ended(error) {
  if (error instanceof WebAssembly.RuntimeError && /unreachable/i.test(error.message)) return kTooMany;
  if (error instanceof Error && /call stack|recursion/i.test(error.message)) return kTooDeep;
  throw error;
}

/** An engine that ran out of memory may fail to free all of it, and aborts. It is not used again. */
function close(/** @type {any} */ context, /** @type {any} */ runtime) {
  try {
    context.dispose();
    runtime.dispose();
  } catch {
    // the next one has an engine of its own
  }
}

class Sandbox {
  #context;
  #asked;
  #parse;
  #printed;
  #spin;
  #spun;
  answers = /** @type {string[] | null} */ (null); // null until it is called

  /** @param {import("quickjs-emscripten-core").QuickJSContext} context
   *  @param {{ code: string, name: string, gives: string, clock: { turns: number, spins: boolean } }} asked */
  constructor(context, asked) {
    this.#context = context;
    this.#asked = asked;
    const json = context.getProp(context.global, "JSON");
    this.#parse = context.getProp(json, "parse"); // before the code can change it
    json.dispose();
    context.unwrapResult(context.evalCode(kSame, "same.js")).dispose();
    this.#printed = context.unwrapResult(context.evalCode(kConsole, "console.js"));
    const spin = context.unwrapResult(context.evalCode(kSpin, "spin.js"));
    this.#spin = context.getProp(spin, "spin");
    this.#spun = context.getProp(spin, "count");
    spin.dispose();
  }

  /** Goes on to the moment at which the engine asks. Returns how many steps that took. */
  #to_turn() {
    const context = this.#context;
    this.#asked.clock.spins = true;
    const ended = context.callFunction(this.#spin, context.undefined);
    this.#asked.clock.spins = false;
    (ended.error ?? ended.value).dispose();
    const count = context.unwrapResult(context.callFunction(this.#spun, context.undefined));
    const spun = context.getNumber(count);
    count.dispose();
    return spun + 1; // with its own call
  }

  run(/** @type {string[]} */ lines) {
    const context = this.#context;
    const made = context.evalCode(`"use strict";${this.#asked.code}\n;${this.#asked.name}`, "code.js");
    if (made.error) return this.#ran([], this.#not_made(this.#error_of(made.error)));
    const own = made.value;
    if (context.typeof(own) !== "function") {
      own.dispose();
      return this.#ran([], { what: `${this.#asked.name} is not a function`, line: 0 });
    }
    const answers = (this.answers = /** @type {string[]} */ ([]));
    let error = null;
    this.#to_turn();
    const before = this.#asked.clock.turns + 1 / kTurn; // the count that #to_turn asked for is a call
    let ended = false;
    for (const line of lines) {
      const answer = this.#answer(own, line);
      answers.push(typeof answer === "string" ? answer : `!${answer.what}`);
      if (typeof answer !== "string") error ??= answer;
      ended = typeof answer !== "string" && answer.ends;
      if (ended) break;
    }
    own.dispose();
    if (ended) return this.#ran(answers, error);
    const turns = this.#asked.clock.turns + 1 - this.#to_turn() / kTurn - before;
    return this.#ran(answers, error, Math.round(turns * kTurn) - lines.length); // each line is read by a call
  }

  /** @param {string[]} answers @param {{ what: string, line: number } | null} error @param {number | null} steps
   *  @returns {Ran} */
  #ran(answers, error, steps = null) {
    const told = error && { what: error.what, line: error.line };
    const { turns } = this.#asked.clock; // what follows is not the code's
    const printed = this.#context.callFunction(this.#printed, this.#context.undefined);
    const { output, notes } =
      printed.error ? { output: "", notes: {} } : JSON.parse(this.#context.getString(printed.value));
    (printed.error ?? printed.value).dispose();
    for (const own of [this.#parse, this.#printed, this.#spin, this.#spun]) own.dispose();
    return { answers, output, notes, error: told, turns, steps };
  }

  /** The function's answer as a line of numbers, or what went wrong, and whether that ends the run.
   *  @param {any} own @param {string} line */
  #answer(own, line) {
    const context = this.#context;
    const text = context.newString(line);
    const parsed = context.callFunction(this.#parse, context.undefined, text);
    text.dispose();
    if (parsed.error) return this.#error_of(parsed.error);
    const names = Object.keys(JSON.parse(line));
    const given = names.map((name) => context.getProp(parsed.value, name));
    parsed.value.dispose();
    const result = context.callFunction(own, context.undefined, ...given);
    for (const one of given) one.dispose();
    if (result.error) return this.#error_of(result.error);
    try {
      const numbers = /** @type {number[]} */ ([]);
      const wrong = new Reader(context, this.#asked.gives, numbers).read(result.value);
      return wrong ? { what: wrong, line: 0, ends: this.#is_over() } : numbers.map(word_of).join(" ");
    } finally {
      result.value.dispose();
    }
  }

  /** Why the code gives no function. The line that asks for it, after the code's last, is not the student's.
   *  @param {{ what: string, line: number }} error */
  #not_made({ what, line }) {
    const { code, name } = this.#asked;
    const last = code.split("\n").length;
    if (line > last && what === `ReferenceError: '${name}' is not defined`)
      return { what: `There is no function ${name}.`, line: 0 };
    return { what, line: Math.min(line, last) };
  }

  #is_over() {
    return this.#asked.clock.turns > kTurns;
  }

  /** What was thrown, and at which line of the code.
   *  @param {any} thrown @returns {{ what: string, line: number, ends: boolean }} */
  #error_of(thrown) {
    const context = this.#context;
    const of = (/** @type {string} */ key) => {
      if (context.typeof(thrown) !== "object") return "";
      const found = context.getProp(thrown, key);
      const text = context.typeof(found) === "string" ? context.getString(found) : "";
      found.dispose();
      return text;
    };
    const over = this.#is_over();
    const plain = context.typeof(thrown) === "object" ? "" : String(context.dump(thrown));
    const what = over ? kTooMany : [of("name"), of("message") || plain].filter(Boolean).join(": ");
    const line = over ? 0 : Number(/code[.]js:(\d+)/.exec(of("stack"))?.[1] ?? 0); // it is not known where it was ended
    thrown.dispose();
    const ends = over || /out of memory/.test(what);
    return { what: one_line(what) || "it threw something without words", line, ends };
  }
}

const one_line = (/** @type {string} */ text) => text.replaceAll(/\s+/g, " ").trim().slice(0, kMostWhat);

/** A number as the judge reads it. */
const word_of = (/** @type {number} */ value) =>
  Number.isFinite(value) ? (Object.is(value, -0) ? "-0" : String(value)) : String(value).replace("Infinity", "inf").toLowerCase();

/** Reads a returned value as its shape says (write/shape.hpp), number by number. Each is looked at once: what a getter
 *  says the second time does not matter. */
class Reader {
  #context;
  #rest;
  #numbers;

  /** @param {import("quickjs-emscripten-core").QuickJSContext} context @param {string} shape @param {number[]} numbers */
  constructor(context, shape, numbers) {
    this.#context = context;
    this.#rest = shape;
    this.#numbers = numbers;
  }

  /** What is wrong with it; "" if nothing is. */
  read(/** @type {any} */ value) {
    try {
      this.#type(value, "it");
      return "";
    } catch (wrong) {
      if (wrong instanceof Wrong) return wrong.message;
      throw wrong;
    }
  }

  #take(/** @type {RegExp} */ pattern) {
    const found = /** @type {RegExpExecArray} */ (pattern.exec(this.#rest))[0];
    this.#rest = this.#rest.slice(found.length);
    return found;
  }

  /** @param {any} value @param {string} named */
  #type(value, named) {
    const first = this.#rest[0];
    if (first === "{") return this.#object(value, named);
    if (first === "*" || /\d/.test(first)) return this.#list(value, named);
    const words = this.#take(/^[a-z|]+/).split("|");
    const type = this.#context.typeof(value);
    if (words.length > 1) return this.#word(value, words, named);
    if (words[0] === "b" && type !== "boolean") throw new Wrong(`${named} is not true or false, but ${said(type)}`);
    if (words[0] !== "b" && type !== "number") throw new Wrong(`${named} is not a number, but ${said(type)}`);
    this.#numbers.push(type === "number" ? this.#context.getNumber(value) : this.#context.dump(value) ? 1 : 0);
  }

  /** @param {any} value @param {string[]} words @param {string} named */
  #word(value, words, named) {
    const place = this.#context.typeof(value) === "string" ? words.indexOf(this.#context.getString(value)) : -1;
    if (place < 0) throw new Wrong(`${named} is none of ${words.map((word) => `"${word}"`).join(", ")}`);
    this.#numbers.push(place);
  }

  #none_or(/** @type {any} */ value, /** @type {string} */ words) {
    const type = this.#context.typeof(value);
    return type === "undefined" || type === "object" ? "missing" : `${words}, but ${said(type)}`;
  }

  #is_object(/** @type {any} */ value) {
    return this.#context.typeof(value) === "object" && !this.#context.sameValue(value, this.#context.null);
  }

  /** @param {any} value @param {string} key @param {string} named */
  #within(value, key, named) {
    if (!this.#is_object(value)) throw new Wrong(`${named} is ${this.#none_or(value, "no object")}`);
    const own = this.#context.getProp(value, key);
    try {
      this.#type(own, named);
    } finally {
      own.dispose();
    }
  }

  /** @param {any} value @param {string} named */
  #object(value, named) {
    while (this.#rest[0] !== "}") {
      this.#rest = this.#rest.slice(1); // the brace or the comma
      const key = this.#take(/^[a-z_]+/);
      this.#rest = this.#rest.slice(1); // the colon
      this.#within(value, key, named === "it" ? key : `${named}.${key}`);
    }
    this.#rest = this.#rest.slice(1);
  }

  /** @param {any} value @param {string} named */
  #list(value, named) {
    const count = this.#take(/^(\*|\d)/);
    if (!this.#is_object(value)) throw new Wrong(`${named} is ${this.#none_or(value, "no list")}`);
    const length = this.#context.getProp(value, "length");
    const has = this.#context.typeof(length) === "number" ? this.#context.getNumber(length) : -1;
    length.dispose();
    const right = count === "*" ? has >= 0 && has <= kMostList : has === Number(count);
    if (!right) throw new Wrong(`${named} is not a list${count === "*" ? "" : ` of ${count}`}`);
    if (count === "*") this.#numbers.push(has);
    const element = this.#rest;
    for (let i = 0; i < has; ++i) {
      this.#rest = element;
      this.#within(value, String(i), `${named}[${i}]`);
    }
  }
}

class Wrong extends Error {}
/** Names the type of a wrong value. A getter that throws gives a value without a known type. */
const said = (/** @type {string} */ type) =>
  ({ undefined: "missing", unknown: "nothing that can be read", object: "an object" })[type] ?? `a ${type}`;
