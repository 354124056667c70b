// Brings a program (programs/points.wasm …) and the fonts that it draws with.

const kFonts = {
  "Inter-Regular": "fonts/Inter-Regular.otf",
  "Inter-SemiBold": "fonts/Inter-SemiBold.otf",
  "JetBrainsMono-Regular": "fonts/JetBrainsMono-Regular.ttf",
  "JetBrainsMono-Bold": "fonts/JetBrainsMono-Bold.ttf",
};

/** The functions of web/main.cpp. name: the program's. attempt: counted up by each retry, for a browser remembers a module that failed. */
export async function open_door(downloads, name, attempt) {
  const fonts = Object.entries(kFonts).map(async ([font, path]) => [font, await downloads.bytes(path)]);
  const [program, glue, ...loaded] = await Promise.all([
    downloads.answer(`programs/${name}.wasm`, "application/wasm"),
    import(`./programs/${name}.mjs${attempt ? `?attempt=${attempt}` : ""}`),
    ...fonts,
  ]);
  const door = await new Promise((resolve, reject) => {
    glue.default({
      // The program compiles while it arrives, whatever type the host gives the file.
      instantiateWasm: (imports, done) => {
        WebAssembly.instantiateStreaming(program, imports).then((made) => done(made.instance), reject);
        return {};
      },
    }).then(resolve, reject);
  });
  for (const [font, bytes] of loaded) door.give_font(font, bytes);
  return door;
}
