// Code that says what its variables are: after each declaration and assignment of a block stands a note of the variable,
// on the same line, so that a mistake is still at its own.
import { javascriptLanguage } from "@codemirror/lang-javascript";
import { kNote } from "./note_name.js";

/** @param {string} code */
export function with_notes(code) {
  const inserts = /** @type {[number, string][]} */ ([]);
  javascriptLanguage.parser.parse(code).iterate({
    enter({ name, node, to }) {
      if (!/^(VariableDeclaration|ExpressionStatement)$/.test(name)) return;
      if (!/^(Block|Script)$/.test(node.parent?.name ?? "")) return;
      const names = name === "VariableDeclaration" ? declared_in(node, code) : assigned_in(node, code);
      if (names.length > 0) inserts.push([to, names.map((one) => `;${kNote}("${one}",${one})`).join("") + ";"]);
    },
  });
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

/** The variable that an assignment changes, or an entry of.
 *  @param {import("@lezer/common").SyntaxNode} node @param {string} code */
function assigned_in(node, code) {
  const changes = node.firstChild;
  if (!changes || !/^(AssignmentExpression|PostfixExpression|UnaryExpression)$/.test(changes.name)) return [];
  let target = changes.name === "UnaryExpression" ? changes.lastChild : changes.firstChild;
  while (target?.name === "MemberExpression") target = target.firstChild;
  return target?.name === "VariableName" ? [code.slice(target.from, target.to)] : [];
}
