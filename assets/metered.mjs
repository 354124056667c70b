// Adds a meter to a WebAssembly program: each turn of a loop costs 1, as do 64 bytes that are copied or filled, and once
// so many are spent the program traps. So it ends after the same work on every machine, also within functions of its own
// that nothing else can interrupt.
// node metered.mjs IN.wasm OUT.wasm: as snug_asset calls it.
import { readFileSync, writeFileSync } from "node:fs";

const kMost = 200_000_000;
const kImports = 2, kGlobals = 6, kCode = 10; // sections
const kLoop = 0x03, kEnd = 0x0b, kGet = 0x23, kSet = 0x24, kConst = 0x41, kBulk = 0xfc, kCopy = 10, kFill = 11;
const kI32 = 0x7f, kVariable = 1, kSubtract = 0x6b, kBy64 = [kConst, 6, 0x76];
const kTrapIfNegative = [kConst, 0, 0x48, 0x04, 0x40, 0x00, kEnd];

/** A number as WebAssembly has it, without a sign and with one. */
function number(n) {
  const bytes = [];
  for (; n >= 0x80; n = Math.floor(n / 0x80)) bytes.push((n & 0x7f) | 0x80);
  return [...bytes, n];
}
function signed(n) {
  const bytes = [];
  for (; n < -0x40 || n >= 0x40; n >>= 7) bytes.push((n & 0x7f) | 0x80);
  return [...bytes, n & 0x7f];
}

/** Reads bytes from the first on. */
class Reader {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
  }
  get left() {
    return this.bytes.length - this.at;
  }
  byte() {
    return this.bytes[this.at++];
  }
  number() {
    let value = 0, factor = 1;
    for (;;) {
      const byte = this.byte();
      value += (byte & 0x7f) * factor;
      if (byte < 0x80) return value;
      factor *= 0x80;
    }
  }
  take(count) {
    return this.bytes.subarray(this.at, (this.at += count));
  }
  numbers(count) {
    for (; count > 0; --count) this.number();
  }

  /** Passes an instruction. Returns its code. */
  instruction() {
    const code = this.byte();
    if (code === 0x0e || code === 0x1c) this.numbers(this.number()); // br_table, select: a list
    if (code === kBulk) return this.#bulk();
    else if (code === 0x44) this.take(8);
    else if (code === 0x43) this.take(4);
    else if (code === 0x11 || (code >= 0x28 && code <= 0x3e)) this.numbers(2); // call_indirect, memory
    else if ([0x02, kLoop, 0x04, 0x0c, 0x0d, 0x0e, 0x10, 0x3f, 0x40, kConst, 0x42, 0xd0, 0xd2].includes(code) ||
      (code >= 0x20 && code <= 0x26)) this.number();
    else if (code > 0xd2) throw new Error(`there is no instruction ${code.toString(16)}`);
    return code;
  }
  #bulk() {
    const code = this.number();
    if (code > 17) throw new Error(`there is no instruction fc ${code}`);
    if (code >= 8) this.numbers(code <= 14 && code % 2 === 0 ? 2 : 1);
    return kBulk << 8 | code;
  }
}

/** What costs a turn, and what costs the bytes whose number is on the stack and stays there. left, size: globals. */
function meter_of(left, size) {
  const get = [kGet, ...number(left)], set = [kSet, ...number(left)];
  const get_size = [kGet, ...number(size)], set_size = [kSet, ...number(size)];
  return {
    turn: Buffer.from([...get, kConst, 1, kSubtract, ...set, ...get, ...kTrapIfNegative]),
    bytes: Buffer.from([...set_size, ...get, ...get_size, ...kBy64, kSubtract, ...set, ...get, ...kTrapIfNegative,
      ...get_size]),
  };
}

/** A function's body with its meter: after the beginning of each loop, and before what copies or fills. */
function with_meter(body, { turn, bytes }) {
  const reader = new Reader(body), parts = [];
  for (let groups = reader.number(); groups > 0; --groups) reader.number(), reader.byte(); // of locals
  let from = 0;
  while (reader.left > 0) {
    const begins = reader.at, code = reader.instruction();
    const is_loop = code === kLoop;
    if (!is_loop && code !== (kBulk << 8 | kCopy) && code !== (kBulk << 8 | kFill)) continue;
    const to = is_loop ? reader.at : begins;
    parts.push(body.subarray(from, to), is_loop ? turn : bytes);
    from = to;
  }
  return Buffer.concat([...parts, body.subarray(from)]);
}

/** How many globals a program imports. */
function imported(section) {
  const reader = new Reader(section);
  let count = 0;
  for (let left = reader.number(); left > 0; --left) {
    reader.take(reader.number()), reader.take(reader.number()); // its names
    const kind = reader.byte();
    if (kind === 0) reader.number();
    if (kind === 1) reader.byte();
    if (kind === 1 || kind === 2) reader.numbers(reader.byte() % 2 === 1 ? 2 : 1); // limits
    if (kind === 3) reader.take(2), ++count;
  }
  return count;
}

export function metered(program, most) {
  const reader = new Reader(program), out = [reader.take(8)];
  let globals = 0, meter = null;
  const add = (id, bytes) => out.push(Buffer.from([id, ...number(bytes.length)]), bytes);
  while (reader.left > 0) {
    const id = reader.byte(), section = reader.take(reader.number()), own = new Reader(section);
    if (id === kImports) globals += imported(section);
    if (id === kGlobals) {
      const count = own.number();
      meter = meter_of(globals + count, globals + count + 1);
      const made = [most, 0].flatMap((value) => [kI32, kVariable, kConst, ...signed(value), kEnd]);
      add(id, Buffer.concat([Buffer.from(number(count + 2)), own.take(own.left), Buffer.from(made)]));
    } else if (id === kCode) {
      const count = own.number(), bodies = [Buffer.from(number(count))];
      for (let i = 0; i < count; ++i) {
        const body = with_meter(own.take(own.number()), meter);
        bodies.push(Buffer.from(number(body.length)), body);
      }
      add(id, Buffer.concat(bodies));
    } else add(id, section);
  }
  return Buffer.concat(out);
}

const [, , from, to] = process.argv;
writeFileSync(to, metered(readFileSync(from), kMost));
