// Loads the program and its fonts.
/** @import { Downloads } from "./download.js" */

const kFonts = {
  "Inter-Regular": "fonts/Inter-Regular.otf",
  "Inter-SemiBold": "fonts/Inter-SemiBold.otf",
  "JetBrainsMono-Regular": "fonts/JetBrainsMono-Regular.ttf",
  "JetBrainsMono-Bold": "fonts/JetBrainsMono-Bold.ttf",
};

const kQuiet = 1000; // milliseconds that a page is left alone first

/** The functions of web/main.cpp. attempt: each retry increases it, for a browser remembers a module that failed.
 *  @param {Downloads} downloads @param {number} attempt @returns {Promise<Door>} */
export async function open_door(downloads, attempt) {
  const fonts = Object.entries(kFonts).map(async ([font, path]) => ({ font, bytes: await downloads.bytes(path) }));
  const [program, glue, ...loaded] = await Promise.all([
    downloads.answer("snug.wasm", "application/wasm"),
    // @ts-expect-error: it is made when the page is built
    attempt ? import(`./snug.js?attempt=${attempt}`) : import("./snug.js"),
    ...fonts,
  ]);
  /** @type {Door} */
  const door = await new Promise((resolve, reject) => {
    glue.default({
      // Compiles the program while it arrives, whichever type the host gives the file.
      instantiateWasm: (
        /** @type {WebAssembly.Imports} */ imports,
        /** @type {(made: WebAssembly.Instance) => void} */ done,
      ) => {
        WebAssembly.instantiateStreaming(program, imports).then((made) => done(made.instance), reject);
        return {};
      },
    }).then(resolve, reject);
  });
  for (const { font, bytes } of loaded) door.give_font(font, bytes);
  return door;
}

/** Fetches what the first lesson needs into the browser's cache, once the page has nothing else to do. What fails is
 *  fetched again when it is needed. */
export function warm_up() {
  if (navigator.connection?.saveData) return;
  const begin = () => {
    for (const path of ["snug.wasm", "snug.js", ...Object.values(kFonts)])
      fetch(window.snug.at(path), { priority: "low" }).then((answer) => answer.arrayBuffer()).catch(() => {});
  };
  setTimeout(() => (window.requestIdleCallback ?? setTimeout)(begin), kQuiet);
}
