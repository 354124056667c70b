// The program of what only a lecture needs (web/lecture): votes, and the codes of states.
/** @type {Promise<Lecture> | null} */
let brought = null;

/** @returns {Promise<Lecture>} */
export const lecture = () => (brought ??= bring().catch((error) => {
  brought = null; // it may be asked for again
  throw error;
}));

async function bring() {
  const [program, wasmBinary] = await Promise.all([
    // @ts-expect-error: it is made when the page is built
    import("./lecture_program.js"),
    fetch(window.snug.at("lecture_program.wasm")).then((answer) => answer.arrayBuffer()),
  ]);
  return program.default({ wasmBinary });
}
