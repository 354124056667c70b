// formulas.mjs LESSON.toml... OUT.json: every $formula$ of the lessons, typeset: {TeX: MathML}.
import { readFileSync, writeFileSync } from "node:fs";
import temml from "temml";

const files = process.argv.slice(2, -1);
const formulas = {};
for (const file of files)
  for (const [, tex] of readFileSync(file, "utf8").matchAll(/\$([^$\n]+(?:\n[^$\n]+)*)\$/g)) {
    const line = tex.replace(/\s+/g, " ");
    // The page's policy lets no style stand in an element.
    formulas[line] = temml.renderToString(line, { throwOnError: true }).replace(/ style="[^"]*"/g, "");
  }
writeFileSync(process.argv.at(-1), JSON.stringify(formulas));
