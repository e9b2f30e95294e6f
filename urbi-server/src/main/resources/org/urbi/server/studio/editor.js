// An editor of urbiscript, of many lines or of one: colours, errors under the words, completion.
import {
  Compartment,
  EditorState,
  EditorView,
  Prec,
  autocompletion,
  bracketMatching,
  closeBrackets,
  closeBracketsKeymap,
  defaultKeymap,
  history,
  historyKeymap,
  indentUnit,
  keymap,
  lineNumbers,
  lintKeymap,
  placeholder,
  setDiagnostics,
} from "./libraries/codemirror.js";
import { urbiscript } from "./urbiscript.js";

// How many characters the server takes at once.
export const LONGEST = 1 << 17;
const CHECK_AFTER = 300;
// How many characters before a name are told to complete it.
const MOST_BEFORE = 7000;
const MOST_FAILURES = 100;

const LOOKS = EditorView.theme({
  "&": { height: "100%", fontSize: ".875rem", color: "var(--text)", backgroundColor: "var(--card)", border: "1px solid var(--line)", borderRadius: "7px" },
  "&.cm-focused": { outline: "2px solid var(--accent)", outlineOffset: "-2px" },
  ".cm-scroller": { fontFamily: 'ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace', lineHeight: "1.45" },
  ".cm-content": { caretColor: "var(--text)" },
  ".cm-gutters": { backgroundColor: "var(--card)", color: "var(--faint)", borderRight: "1px solid var(--line)", borderRadius: "7px 0 0 7px" },
  ".cm-placeholder": { color: "var(--faint)" },
  "&.cm-focused .cm-matchingBracket": { backgroundColor: "var(--select)" },
  ".cm-tooltip": { backgroundColor: "var(--card)", color: "var(--text)", border: "1px solid var(--line)", borderRadius: "7px" },
  ".cm-tooltip.cm-tooltip-autocomplete > ul > li[aria-selected]": { backgroundColor: "var(--select)", color: "var(--text)" },
  ".cm-completionDetail": { color: "var(--faint)", fontStyle: "normal" },
  ".cm-completionInfo": { maxWidth: "24rem" },
  ".cm-diagnostic": { whiteSpace: "pre-wrap" },
});

export class Editor {
  // text: what it begins with; label: for screen readers; keys: [{ key, run }]; oneLine: whether Enter is not for new lines;
  // complete(text): the names that may follow; check(text): what is wrong; changed(text): somebody has typed
  // what is to be checked.
  constructor(host, { text = "", label, hint = "", keys, oneLine = false, complete, check, changed = () => {} }) {
    this.check = check;
    this.mistakes = [];
    this.failures = [];
    this.language = new Compartment();
    this.editable = new Compartment();
    // The styles of an editor in a shadow tree are not refused by the content security policy.
    const root = host.attachShadow({ mode: "open" });
    this.view = new EditorView({
      parent: root,
      root,
      state: EditorState.create({
        doc: text,
        extensions: [
          Prec.high(keymap.of(keys)),
          this.language.of([]),
          this.editable.of([]),
          LOOKS,
          history(),
          bracketMatching(),
          closeBrackets(),
          indentUnit.of("  "),
          placeholder(hint),
          autocompletion({ override: [(context) => completions(context, complete)] }),
          keymap.of([...closeBracketsKeymap, ...defaultKeymap, ...historyKeymap, ...lintKeymap]),
          oneLine ? [] : lineNumbers(),
          // Who may not type scrolls by keys all the same.
          EditorView.contentAttributes.of({ "aria-label": label, tabindex: "0" }),
          EditorView.updateListener.of((update) => {
            if (update.docChanged) this.typed(changed);
          }),
        ],
      }),
    });
    // What scrolls says nothing of itself, and needs no keys: those of the text within scroll it.
    this.view.scrollDOM.removeAttribute("tabindex");
  }

  typed(changed) {
    this.failures = [];
    if (!this.check) return;
    clearTimeout(this.waiting);
    this.waiting = setTimeout(() => {
      changed(this.text());
      this.examine();
    }, CHECK_AFTER);
  }

  // One text is looked at at a time.
  async examine() {
    this.again = true;
    if (this.examining) return;
    this.examining = true;
    while (this.again) {
      this.again = false;
      const { doc } = this.view.state;
      const found = await this.check(doc.toString());
      if (doc.eq(this.view.state.doc)) {
        this.mistakes = found.map(({ begin, end, text }) => ({ from: begin, to: end, message: text, severity: "error" }));
        this.underline();
      }
    }
    this.examining = false;
  }

  underline() {
    const { length } = this.view.state.doc;
    const inside = (place) => Math.max(0, Math.min(place, length));
    const all = [...this.mistakes, ...this.failures].map((each) => ({ ...each, from: inside(each.from), to: inside(each.to) }));
    this.view.dispatch(setDiagnostics(this.view.state, all));
  }

  // The text, or a part of it, is run: what goes wrong from now on belongs to it as long as it is not changed.
  begin() {
    this.ran = this.view.state.doc;
    this.failures = [];
    this.underline();
  }

  // Something went wrong in what was run: lines and columns begin with 1, the last column belongs to it.
  fail(line, column, lastLine, lastColumn, message) {
    const { doc } = this.view.state;
    if (doc !== this.ran || line > doc.lines || this.failures.length === MOST_FAILURES) return;
    const first = doc.line(line);
    const last = doc.line(Math.min(lastLine, doc.lines));
    const from = first.from + place(first.text, column - 1);
    const to = last.from + place(last.text, lastColumn);
    if (!this.failures.length) requestAnimationFrame(() => this.underline());
    this.failures.push({ from, to, message, severity: "error" });
  }

  // It has come in sight.
  show() {
    this.view.requestMeasure();
  }

  text() {
    return this.view.state.doc.toString();
  }

  put(text) {
    const { state } = this.view;
    this.view.dispatch({ changes: { from: 0, to: state.doc.length, insert: text }, selection: { anchor: text.length } });
  }

  // What is selected, or all. Blanks before it give it its place, which errors name.
  selected() {
    const { doc, selection } = this.view.state;
    const { from, to, empty } = selection.main;
    if (empty) return this.text();
    const line = doc.lineAt(from);
    return "\n".repeat(line.number - 1) + " ".repeat(bytes(line.text.slice(0, from - line.from))) + doc.sliceString(from, to);
  }

  // Whether the caret is in the first, or the last, line.
  atEdge(last) {
    const { doc, selection } = this.view.state;
    return doc.lineAt(selection.main.head).number === (last ? doc.lines : 1);
  }

  setKeywords(keywords) {
    this.view.dispatch({ effects: this.language.reconfigure(urbiscript(keywords)) });
  }

  setEditable(editable) {
    this.view.dispatch({ effects: this.editable.reconfigure(editable ? [] : EditorState.readOnly.of(true)) });
  }
}

const bytes = (text) => new TextEncoder().encode(text).length;

// Which character of a line is at that byte of it: the columns of errors count bytes.
function place(text, byte) {
  let at = 0;
  for (let passed = 0; passed < byte && at < text.length; ) {
    const character = String.fromCodePoint(text.codePointAt(at));
    passed += bytes(character);
    at += character.length;
  }
  return at;
}

// What precedes the name that is typed is understood by the server, which has the scanner of the language.
async function completions(context, complete) {
  const { from } = context.matchBefore(/\w*/);
  const before = context.state.sliceDoc(Math.max(0, from - MOST_BEFORE), from);
  const slot = before.endsWith(".");
  if (!context.explicit && !slot && context.pos - from < 2) return null;
  // A line that has been cut could begin within a string.
  const whole = from > MOST_BEFORE ? before.slice(before.indexOf("\n") + 1) : before;
  const options = await complete(whole + context.state.sliceDoc(from, context.pos));
  return options.length ? { from, options, validFor: /^\w*$/ } : null;
}
