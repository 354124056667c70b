// formulas.mjs LESSON.toml... OUT.json: every formula of the lessons, typeset: {TeX: MathML}; those that stand on a line
// of their own, $$…$$, by their TeX with these signs.
import { readFileSync, writeFileSync } from "node:fs";
import temml from "temml";

/** A prime stands as high as it is: Temml raises it once more, which only its own font makes up for. */
const lower_primes = (math) => math
  .replace(/<msup>(<mi>[^<]*<\/mi>)<mo[^>]*tml-prime[^>]*>(′+)<\/mo><\/msup>/g, '<mrow>$1<mo lspace="0em" rspace="0em">$2</mo></mrow>')
  .replace(/<msubsup>(<mi>[^<]*<\/mi>)(<m[in]>[^<]*<\/m[in]>)<mo[^>]*tml-prime[^>]*>(′+)<\/mo><\/msubsup>/g,
    '<msub><mrow>$1<mo lspace="0em" rspace="0em">$3</mo></mrow>$2</msub>');

/** A formula between its signs; or a sign after a backslash, or code, within which there is none. */
const kFormula = /\\+\$|`[^`\n]*`|(\$\$?)([^$]+)\1/g;

const files = process.argv.slice(2, -1);
const formulas = {};
for (const file of files)
  for (const [, signs, tex] of readFileSync(file, "utf8").matchAll(kFormula)) {
    if (!signs) continue;
    const line = tex.replace(/\s+/g, " ").trim();
    const displayMode = signs === "$$";
    // The page's policy lets no style stand in an element.
    const math = temml.renderToString(line, { throwOnError: true, displayMode }).replace(/ style="[^"]*"/g, "");
    formulas[displayMode ? `$$${line}$$` : line] = lower_primes(math);
  }
writeFileSync(process.argv.at(-1), JSON.stringify(formulas));
