// Compares what the grammar says of each piece of the texts in a folder with what the scanner of the language says.
//   node agreement.mjs FOLDER
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const require = createRequire(import.meta.url);
const textmate = require("vscode-textmate");
const oniguruma = require("vscode-oniguruma");
const here = dirname(fileURLToPath(import.meta.url));
const folder = process.argv[2];

// What a piece is within, wherever in it: of a string even its escapes.
const WHOLE = [["comment", "comment"], ["string", "string"], ["variable.other.quoted", "name"]];
// The first that fits.
const KINDS = [
  ["constant.numeric.duration", "duration"],
  ["constant.numeric.angle", "angle"],
  ["constant.numeric", "number"],
  ["invalid.illegal.number", "number"],
  ["invalid", "refused"],
  ["constant.language", "name"],
  ["keyword.other.contextual", "contextual"],
  ["keyword.operator.word", "keyword"],
  ["keyword.operator", "symbol"],
  ["keyword", "keyword"],
  ["storage", "keyword"],
  ["variable.language", "keyword"],
  ["entity", "name"],
  ["variable", "name"],
];

function kind(scopes) {
  for (const [scope, whole] of WHOLE) if (scopes.some((each) => each.startsWith(scope))) return whole;
  const innermost = scopes.at(-1);
  return KINDS.find(([scope]) => innermost.startsWith(scope))?.[1] ?? "symbol";
}

const agree = (wanted, got) =>
  wanted === got || wanted === "invalid" || (wanted === "contextual" && (got === "name" || got === "keyword"));

async function load() {
  await oniguruma.loadWASM(readFileSync(require.resolve("vscode-oniguruma/release/onig.wasm")));
  const registry = new textmate.Registry({
    onigLib: Promise.resolve({
      createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
      createOnigString: (text) => new oniguruma.OnigString(text),
    }),
    loadGrammar: async (scope) => {
      const file = { "source.urbiscript": "urbiscript", "source.urbiscript.session": "session" }[scope];
      const path = join(here, "../syntaxes", `${file}.tmLanguage.json`);
      return textmate.parseRawGrammar(readFileSync(path, "utf8"), path);
    },
  });
  return registry.loadGrammar("source.urbiscript");
}

function kinds(grammar, text) {
  const all = [];
  let state = textmate.INITIAL;
  for (const line of text.split("\n")) {
    const result = grammar.tokenizeLine(line, state);
    state = result.ruleStack;
    let at = 0;
    for (const token of result.tokens) for (const of = kind(token.scopes); at < token.endIndex && at < line.length; at++) all.push(of);
    all.push("blank");
  }
  return all;
}

const grammar = await load();
let pieces = 0;
let wrong = 0;
readFileSync(join(folder, "names"), "utf8").trim().split("\n").forEach((name, number) => {
  const text = readFileSync(join(folder, `${number}.u`), "utf8");
  const found = kinds(grammar, text);
  for (const line of readFileSync(join(folder, `${number}.kinds`), "utf8").split("\n").filter(Boolean)) {
    const [begin, end, wanted] = line.split(" ");
    pieces++;
    for (let at = +begin; at < +end; at++) {
      if (/\s/.test(text[at]) || agree(wanted, found[at])) continue;
      if (wrong++ < 20) console.error(`${name}: ${JSON.stringify(text.slice(+begin, +end))} is ${wanted}, here ${found[at]}`);
      break;
    }
  }
});
console.log(`TextMate grammar: ${pieces} pieces, ${wrong} told otherwise`);
process.exit(pieces > 1000 && wrong === 0 ? 0 : 1);
