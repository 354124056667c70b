// Brings the program and the fonts that it draws with.

const kFonts = {
  "Inter-Regular": "fonts/Inter-Regular.otf",
  "Inter-SemiBold": "fonts/Inter-SemiBold.otf",
  "JetBrainsMono-Regular": "fonts/JetBrainsMono-Regular.ttf",
  "JetBrainsMono-Bold": "fonts/JetBrainsMono-Bold.ttf",
};

/** The functions of web/main.cpp. attempt: counted up by each retry, for a browser remembers a module that failed. */
export async function open_door(downloads, attempt) {
  const fonts = Object.entries(kFonts).map(async ([font, path]) => [font, await downloads.bytes(path)]);
  const [program, glue, ...loaded] = await Promise.all([
    downloads.answer("snug.wasm", "application/wasm"),
    import(`./snug.mjs${attempt ? `?attempt=${attempt}` : ""}`),
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
