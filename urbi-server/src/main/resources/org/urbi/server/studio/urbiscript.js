// How urbiscript is coloured: by its words, which the server tells, and what they are made of.
import { HighlightStyle, StreamLanguage, syntaxHighlighting, tags } from "./libraries/codemirror.js";

const VALUES = new Set(["true", "false", "nil", "void", "acceptVoid", "inf", "nan"]);
const NUMBER = /^\d[\d_]*(?:\.\d[\d_]*)?(?:[eE][+-]?\d[\d_]*)?\w*/;

// Comments can be nested, and go on in the next line, as strings do.
function comment(stream, state) {
  while (!stream.eol()) {
    if (stream.match("/*")) state.comments++;
    else if (!stream.match("*/")) stream.next();
    else if (--state.comments === 0) break;
  }
  return "comment";
}

function string(stream, state) {
  state.inString = true;
  while (state.inString && !stream.eol()) {
    const next = stream.next();
    if (next === "\\") stream.next();
    else if (next === '"') state.inString = false;
  }
  return "string";
}

function token(words, stream, state) {
  if (state.comments) return comment(stream, state);
  if (state.inString) return string(stream, state);
  const slot = state.afterDot;
  if (stream.eatSpace()) return null;
  state.afterDot = false;
  if (stream.match("//")) {
    stream.skipToEnd();
    return "comment";
  }
  if (stream.match("/*")) {
    state.comments = 1;
    return comment(stream, state);
  }
  if (stream.eat('"')) return string(stream, state);
  if (stream.match(/^'(?:[^'\\]|\\.)*'?/)) return "variableName";
  if (stream.match(NUMBER)) return "number";
  const word = stream.match(/^[A-Za-z_]\w*/)?.[0];
  if (word) {
    if (slot) return "propertyName";
    if (words.has(word)) return "keyword";
    if (VALUES.has(word)) return "atom";
    return /^[A-Z]/.test(word) ? "typeName" : "variableName";
  }
  state.afterDot = stream.next() === ".";
  return "operator";
}

const COLOURS = HighlightStyle.define([
  { tag: tags.keyword, color: "var(--event)" },
  { tag: tags.comment, color: "var(--faint)", fontStyle: "italic" },
  { tag: tags.string, color: "var(--good)" },
  { tag: [tags.number, tags.atom], color: "var(--signal)" },
  { tag: tags.typeName, color: "var(--condition)" },
  { tag: tags.propertyName, color: "var(--accent)" },
]);

export function urbiscript(keywords) {
  const words = new Set(keywords);
  const language = StreamLanguage.define({
    name: "urbiscript",
    startState: () => ({ comments: 0, inString: false, afterDot: false }),
    token: (stream, state) => token(words, stream, state),
    languageData: {
      commentTokens: { line: "//", block: { open: "/*", close: "*/" } },
      closeBrackets: { brackets: ["(", "[", "{", '"'] },
    },
  });
  return [language, syntaxHighlighting(COLOURS)];
}
