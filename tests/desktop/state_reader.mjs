// Reads a window's state file for the shell's tests (support.sh): one program for a whole test, because to start one takes
// longer than it takes to answer. A request is three texts that end with NUL: what is wanted, the state file, and an
// expression of the state s. So does the answer, which begins with + or, where there is none, with -.
import { readFileSync } from "node:fs";
import { format } from "node:util";

const kLook = 20; // milliseconds
const kFrame = 80; // what a key has just done is drawn and told by then
const pause = new Int32Array(new SharedArrayBuffer(4));
const wait = (milliseconds) => Atomics.wait(pause, 0, 0, milliseconds);

/** What is made of the state, once there is a whole one: the file may not be written yet, or half of it. */
function of_state(file, made_of, patience = 2000) {
  for (const end = Date.now() + patience; ; wait(kLook)) {
    let state;
    try {
      state = JSON.parse(readFileSync(file, "utf8"));
    } catch (error) {
      if (Date.now() > end) throw error;
      continue;
    }
    return made_of(state);
  }
}

/** Expressions are the tests' own, some of several statements. */
const evaluated = (expression) => (state) => ((globalThis.s = state), (0, eval)(expression));

const kAnswers = {
  state(file, expression) {
    wait(kFrame);
    return of_state(file, evaluated(expression));
  },

  /** Waits until the expression is true; machines that do other work as well may be very slow. */
  until(file, expression) {
    for (const end = Date.now() + 120_000; Date.now() < end; wait(kLook)) {
      try {
        if (of_state(file, evaluated(expression), 0) !== true) continue;
      } catch {
        continue; // of what it asks for there is nothing yet
      }
      wait(120); // what follows meets a window that has drawn it
      return "";
    }
    throw Error(`never came true: ${expression}`);
  },

  /** What the expression comes to, once that stays the same: a window that has opened, or has another size, is laid out
   *  anew for some frames. */
  settled(file, expression) {
    const now = () => format(of_state(file, evaluated(expression)));
    let before = now();
    for (let same = 0, looks = 0; same < 6 && looks < 100; ++looks) {
      wait(50);
      const after = now();
      same = after === before ? same + 1 : 0;
      before = after;
    }
    return before;
  },
};

function answer([wanted, file, given]) {
  try {
    return `+${format(kAnswers[wanted](file, given))}\0`;
  } catch (error) {
    return `-${error.message}\0`;
  }
}

let read = "";
process.stdin.setEncoding("utf8").on("data", (chunk) => {
  const texts = (read + chunk).split("\0");
  read = texts.pop();
  for (; texts.length >= 3; texts.splice(0, 3)) process.stdout.write(answer(texts));
  read = [...texts, read].join("\0");
});
