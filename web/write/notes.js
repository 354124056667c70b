// Code that says what its variables are: after each declaration and assignment stands a note of the variable, on the
// same line, so that a mistake is still at its own. A statement that is the whole body of another gets braces.
import { javascriptLanguage } from "@codemirror/lang-javascript";
import { kNote } from "./note_name.js";

/** @param {string} code */
export function with_notes(code) {
  const inserts = /** @type {[number, string][]} */ ([]);
  javascriptLanguage.parser.parse(code).iterate({
    enter({ name, node, from, to }) {
      if (!/^(VariableDeclaration|ExpressionStatement)$/.test(name)) return;
      const within = node.parent?.name ?? "", in_block = /^(Block|Script)$/.test(within);
      if (!in_block && (name !== "ExpressionStatement" || !/Statement$/.test(within))) return;
      const names = name === "VariableDeclaration" ? declared_in(node, code) : assigned_in(node, code);
      if (names.length === 0) return;
      // A name may be one of a function inside, which is not known here.
      const notes = names.map((one) => `;try{${kNote}("${one}",${one})}catch{}`).join("") + ";";
      if (!in_block) inserts.push([from, "{"]);
      inserts.push([to, in_block ? notes : `${notes}}`]);
    },
  });
  inserts.sort(([a], [b]) => a - b);
  return inserts.reverse().reduce((text, [at, note]) => text.slice(0, at) + note + text.slice(at), code);
}

/** The names that a declaration gives, those in patterns too, but none of a function inside.
 *  @param {import("@lezer/common").SyntaxNode} node @param {string} code */
function declared_in(node, code) {
  const names = /** @type {string[]} */ ([]);
  const visit = (/** @type {import("@lezer/common").SyntaxNode} */ from) => {
    for (let child = from.firstChild; child; child = child.nextSibling) {
      if (child.name === "VariableDefinition") names.push(code.slice(child.from, child.to));
      else if (/Pattern/.test(child.name)) visit(child);
    }
  };
  visit(node);
  return names;
}

/** The variables that a statement changes, or an entry of; not those that blocks inside it change, which note them.
 *  @param {import("@lezer/common").SyntaxNode} node @param {string} code */
function assigned_in(node, code) {
  const names = /** @type {Set<string>} */ (new Set());
  const target = (/** @type {import("@lezer/common").SyntaxNode | null | undefined} */ of) => {
    while (of?.name === "MemberExpression") of = of.firstChild;
    if (of?.name === "VariableName" || of?.name === "VariableDefinition") names.add(code.slice(of.from, of.to));
    else if (/Pattern/.test(of?.name ?? "")) for (let child = of.firstChild; child; child = child.nextSibling) target(child);
  };
  const visit = (/** @type {import("@lezer/common").SyntaxNode} */ from) => {
    if (from.name === "AssignmentExpression" || from.name === "PostfixExpression") target(from.firstChild);
    if (from.name === "UnaryExpression" && /^(\+\+|--)/.test(code.slice(from.from, from.from + 2))) target(from.lastChild);
    for (let child = from.firstChild; child; child = child.nextSibling) if (child.name !== "Block") visit(child);
  };
  visit(node);
  return [...names];
}
