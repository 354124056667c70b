// The editor of code that a student writes: CodeMirror in a shadow root, where its styles are adopted style sheets, which
// the page's policy allows.
import { closeBrackets, closeBracketsKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { javascript } from "@codemirror/lang-javascript";
import { HighlightStyle, bracketMatching, indentOnInput, indentUnit, syntaxHighlighting } from "@codemirror/language";
import { lintGutter, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
import { EditorState, Prec } from "@codemirror/state";
import {
  EditorView, drawSelection, highlightActiveLine, highlightActiveLineGutter, highlightSpecialChars, keymap, lineNumbers,
} from "@codemirror/view";
import { tags } from "@lezer/highlight";
import { with_notes } from "./notes.js";

/** The page's colours, whichever its theme is: custom properties reach into a shadow root. */
const colours = HighlightStyle.define([
  { tag: [tags.keyword, tags.operatorKeyword, tags.definitionKeyword, tags.controlKeyword], color: "var(--code-keyword)" },
  { tag: [tags.number, tags.bool, tags.null], color: "var(--code-number)" },
  { tag: [tags.string, tags.regexp], color: "var(--code-string)" },
  { tag: [tags.comment, tags.lineComment, tags.blockComment], color: "var(--code-comment)" },
  { tag: tags.function(tags.definition(tags.variableName)), fontWeight: "bold" },
]);
const look = EditorView.theme({
  "&": { color: "var(--code-ink)", backgroundColor: "var(--code-ground)", fontSize: "inherit", height: "100%" },
  "&.cm-focused": { outline: "none" }, // its frame has one
  ".cm-scroller": { fontFamily: "var(--code-font)", lineHeight: "1.5" },
  ".cm-gutters": { color: "var(--code-comment)", backgroundColor: "transparent", border: "none" },
  ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "var(--code-line)" },
  ".cm-content": { caretColor: "var(--code-ink)" },
  ".cm-cursor": { borderLeftColor: "var(--code-ink)" },
  "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground":
    { backgroundColor: "var(--code-selection)" },
  "&.cm-focused .cm-matchingBracket": { backgroundColor: "var(--code-selection)", outline: "1px solid var(--code-focus)" },
  ".cm-panels": { color: "var(--code-ink)", backgroundColor: "var(--code-line)" },
  // These replace CodeMirror's pictures, which the page's policy forbids in a style.
  ".cm-lintRange-error": { backgroundImage: "none", textDecoration: "underline wavy var(--code-wrong)" },
  ".cm-lintRange-active": { backgroundColor: "transparent" },
  ".cm-lint-marker-error": { content: "normal" },
  ".cm-lint-marker-error::before": { content: '"●"', color: "var(--code-wrong)", fontSize: ".75em" },
  ".cm-diagnostic-error": { borderLeftColor: "var(--code-wrong)" },
  ".cm-textfield, .cm-button": { color: "inherit", background: "var(--code-ground)", backgroundImage: "none" },
  ".cm-tooltip": { color: "var(--code-ink)", backgroundColor: "var(--code-ground)", border: "1px solid var(--code-focus)" },
});

/** An editor in `host`. changed: what is called with each change; run: by Ctrl+Enter; left: by Escape, after which Tab
 *  leaves the editor until it is entered again.
 *  @param {HTMLElement} host @param {string} code
 *  @param {{ label: string, described: string, changed: (code: string) => void, run: () => void,
 *    left: (is_left: boolean) => void }} of */
export function create_editor(host, code, { label, described, changed, run, left }) {
  const root = host.attachShadow({ mode: "open" });
  const about = document.createElement("p");
  about.id = "about";
  about.textContent = described;
  about.hidden = true; // what it is described by is read all the same
  const into = document.createElement("div");
  into.style.height = "100%";
  root.append(into, about);
  let tab_leaves = false;
  const leave = (/** @type {boolean} */ is_left) => {
    if (tab_leaves !== is_left) left(is_left);
    tab_leaves = is_left;
  };
  const indent = { .../** @type {import("@codemirror/view").KeyBinding} */ (indentWithTab) };
  const own_keys = Prec.highest(keymap.of([
    { key: "Mod-Enter", run: () => (run(), true) },
    { key: "Escape", run: (view) => (leave(true), Boolean(view.state.selection.ranges.length > 1)) },
    { key: "Tab", run: (view) => !tab_leaves && Boolean(indent.run?.(view)),
      shift: (view) => !tab_leaves && Boolean(indent.shift?.(view)) },
  ]));
  const view = new EditorView({
    root,
    parent: into,
    state: EditorState.create({
      doc: code,
      extensions: [
        own_keys, lineNumbers(), highlightActiveLineGutter(), highlightSpecialChars(), history(), drawSelection(),
        indentOnInput(), indentUnit.of("  "), bracketMatching(), closeBrackets(), highlightActiveLine(),
        highlightSelectionMatches(), search({ top: true }), lintGutter(), javascript(), syntaxHighlighting(colours),
        look, EditorView.lineWrapping,
        keymap.of([...closeBracketsKeymap, ...defaultKeymap, ...searchKeymap, ...historyKeymap]),
        EditorView.contentAttributes.of({
          "aria-label": label, "aria-describedby": "about", spellcheck: "false", autocapitalize: "off",
          autocorrect: "off",
        }),
        EditorView.updateListener.of((update) => update.docChanged && changed(update.state.doc.toString())),
        EditorView.domEventHandlers({
          // Chromium would keep the style of what is replaced in an attribute, which the policy forbids.
          beforeinput(event, own) {
            const { main } = own.state.selection;
            const one_line = own.state.doc.lineAt(main.from).to >= main.to;
            if (event.inputType !== "insertText" || !event.data || one_line) return false;
            event.preventDefault();
            own.dispatch(own.state.replaceSelection(event.data), { scrollIntoView: true, userEvent: "input.type" });
            return true;
          },
          focus: () => leave(false),
          keydown: (event) => void (/^(Escape|Tab|Shift)$/.test(event.key) || leave(false)),
        }),
      ],
    }),
  });
  return {
    code: () => view.state.doc.toString(),
    /** The code, so that it notes its variables. */
    noted: () => with_notes(view.state.doc.toString()),
    set(/** @type {string} */ text) {
      view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: text } });
    },
    /** Marks a line as the one where something went wrong; 0 for none. */
    mark(/** @type {number} */ line, /** @type {string} */ message) {
      const at = line >= 1 && line <= view.state.doc.lines ? view.state.doc.line(line) : null;
      const found = /** @type {import("@codemirror/lint").Diagnostic[]} */ (
        at ? [{ from: at.from, to: at.to, severity: "error", message }] : []);
      view.dispatch(setDiagnostics(view.state, found));
    },
    focus: () => view.focus(),
  };
}
