// formulas.mjs LESSON.toml... OUT.json: every formula of the lessons, typeset: {TeX: MathML}; those that stand on a line
// of their own, $$…$$, by their TeX with these signs.
import { readFileSync, writeFileSync } from "node:fs";
import temml from "temml";

const files = process.argv.slice(2, -1);
const formulas = {};
for (const file of files)
  for (const [, signs, tex] of readFileSync(file, "utf8").matchAll(/(\$\$?)([^$]+)\1/g)) {
    const line = tex.replace(/\s+/g, " ").trim();
    const displayMode = signs === "$$";
    // The page's policy lets no style stand in an element.
    const math = temml.renderToString(line, { throwOnError: true, displayMode }).replace(/ style="[^"]*"/g, "");
    formulas[displayMode ? `$$${line}$$` : line] = math;
  }
writeFileSync(process.argv.at(-1), JSON.stringify(formulas));
