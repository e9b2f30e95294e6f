// The room of the code: an editor, what runs of it, and a console beside it.
import { Items, make, set, withdraw } from "./elements.js";
import { Editor, LONGEST } from "./editor.js";
import { Files } from "./files.js";
import { LineHistory } from "./line-history.js";
import { Log } from "./log.js";
import { kept } from "./storage.js";

const DRAFT = "code";
const MOST_RUNS = 50;
const LONGEST_TITLE = 200;
const FIRST_TEXT = `// Ctrl-Enter runs what is selected, or everything.
ticking: every (1s) echo("tick"),
`;

const PAGE = `
  <section class="card" aria-labelledby="code-title">
    <div class="bar">
      <h2 id="code-title">Code</h2>
      <button id="run-code" type="button" title="Ctrl-Enter: what is selected, or everything">Run</button>
      <select id="files" aria-label="Files of the server"></select>
      <button id="open-file" type="button">Open</button>
      <input id="file-name" autocomplete="off" autocapitalize="off" spellcheck="false" placeholder="name.u" aria-label="Name of the file">
      <button id="save-file" type="button" title="Ctrl-S">Save</button>
      <span id="file-state" class="hint" role="status"></span>
      <span id="code-state" class="hint" role="status"></span>
    </div>
    <div id="editor"></div>
  </section>
  <section class="card" aria-labelledby="console-title">
    <div class="bar">
      <h2 id="console-title">Console</h2>
      <button id="clear-log" type="button">Clear</button>
    </div>
    <ul id="runs" aria-label="What runs"></ul>
    <div id="log" role="log" aria-labelledby="console-title" tabindex="0"></div>
    <div id="console-line"></div>
  </section>`;

export class Room {
  constructor(studio, host) {
    this.studio = studio;
    this.runs = new Map();
    this.begun = 0;
    host.classList.add("beside");
    host.innerHTML = PAGE;
    this.find = (name) => host.querySelector(`#${name}`);
    this.log = new Log(this.find("log"));
    this.runItems = new Items(this.find("runs"), (run) => run.key, (run) => this.newRun(run), (item, run) => this.fillRun(item, run));
    this.editor = new Editor(this.find("editor"), {
      text: kept("local", DRAFT) ?? FIRST_TEXT,
      label: "urbiscript",
      keys: [
        { key: "Mod-Enter", run: () => this.runSelected() },
        { key: "Mod-s", run: () => this.save() },
      ],
      complete: (text) => this.complete(text),
      check: (text) => this.check(text),
      changed: (text) => keep(text),
    });
    const [list, open, name, save, state] = ["files", "open-file", "file-name", "save-file", "file-state"].map(this.find);
    this.files = new Files(studio, { list, open, name, save, say: (text) => set(state, text) }, this.editor, FIRST_TEXT);
    this.history = new LineHistory();
    this.line = new Editor(this.find("console-line"), {
      label: "console: a line of urbiscript",
      hint: "1 + 2;",
      oneLine: true,
      keys: [
        { key: "Enter", run: () => this.runLine() },
        { key: "ArrowUp", run: () => this.recall(-1) },
        { key: "ArrowDown", run: () => this.recall(1) },
      ],
      complete: (text) => this.complete(text),
    });
    this.find("run-code").addEventListener("click", () => this.runSelected());
    this.find("clear-log").addEventListener("click", () => this.clear());
  }

  show() {
    this.editor.show();
    this.line.show();
  }

  // What ran for the connection that was lost has been stopped by the server.
  welcome() {
    for (const run of this.runs.values()) if (run.state !== "ended") Object.assign(run, { state: "ended", error: "the connection was lost" });
    for (const editor of [this.editor, this.line]) {
      editor.setKeywords(this.studio.keywords);
    }
    this.line.setEditable(this.studio.mayChange);
    this.find("run-code").disabled = !this.studio.mayChange;
    this.editor.examine();
    this.files.welcome();
    this.draw();
  }

  take(message) {
    if (message.type === "output") this.output(message.text);
    else if (message.type === "begun") this.beginning(message);
  }

  output(text) {
    for (const line of this.log.add(text)) {
      const [, first, column, last, lastColumn, what] = /!!! code:(\d+)\.(\d+)(?:-(?:(\d+)\.)?(\d+))?: (.*)/.exec(line) ?? [];
      if (first) this.editor.fail(Number(first), Number(column), Number(last ?? first), Number(lastColumn ?? column), what);
    }
  }

  async complete(text) {
    const { proposals = [] } = await this.studio.ask({ type: "complete", text }, { quiet: true });
    return proposals.map(({ name, signature, doc }) => ({ label: name, detail: signature.slice(name.length), info: doc || undefined }));
  }

  async check(code) {
    const state = this.find("code-state");
    if (code.length > LONGEST) {
      set(state, `at most ${LONGEST.toLocaleString("en")} characters can be checked and run at once`);
      return [];
    }
    const { error, mistakes = [] } = await this.studio.ask({ type: "check", code }, { quiet: true });
    set(state, error || (mistakes.length ? mistakes[0].text : "no syntax error"));
    return mistakes;
  }

  runSelected() {
    this.editor.begin();
    this.run("code", this.editor.selected());
    return true;
  }

  save() {
    this.files.write();
    return true;
  }

  runLine() {
    const text = this.line.text();
    if (!this.studio.mayChange) this.studio.alert(this.studio.limit);
    else if (text.trim()) {
      this.history.add(text);
      this.line.put("");
      this.log.typed(text);
      this.run("console", text);
    }
    return true;
  }

  recall(step) {
    if (!this.line.atEdge(step > 0)) return false;
    this.line.put(this.history.step(step, this.line.text()));
    return true;
  }

  async run(file, code) {
    if (!this.studio.mayChange) {
      this.studio.alert(this.studio.limit);
      return;
    }
    if (code.length > LONGEST) {
      this.studio.alert(`At most ${LONGEST.toLocaleString("en")} characters can be run at once: select less.`);
      return;
    }
    const run = { key: ++this.begun, title: code.trim().split("\n")[0].slice(0, LONGEST_TITLE), state: "running", error: "" };
    this.runs.set(run.key, run);
    this.forgetEnded();
    const { error, goesOn } = await this.studio.ask({ type: "run", file, code }, { quiet: true, sent: (id) => (run.id = id) });
    Object.assign(run, { state: goesOn && !run.stopped ? "goes on" : "ended", error });
    this.draw();
  }

  beginning({ id, run, tag }) {
    const found = [...this.runs.values()].find((each) => each.id === id);
    if (found) Object.assign(found, { number: run, tag });
    this.draw();
  }

  async stop(run) {
    run.stopped = true;
    const { error } = await this.studio.ask({ type: "stop", run: run.number }, { quiet: true });
    if (run.state === "goes on" || error) run.state = "ended";
    this.draw();
  }

  clear() {
    this.log.clear();
    for (const run of [...this.runs.values()]) if (run.state === "ended") this.runs.delete(run.key);
    this.draw();
  }

  forgetEnded() {
    for (const run of [...this.runs.values()]) {
      if (this.runs.size <= MOST_RUNS) break;
      if (run.state === "ended") this.runs.delete(run.key);
    }
  }

  draw() {
    this.runItems.show([...this.runs.values()].filter((run) => run.state !== "ended" || run.error));
  }

  newRun(run) {
    const item = make("li");
    const stop = make("button", "Stop", { type: "button", className: "danger" });
    stop.addEventListener("click", () => this.stop(run));
    item.append(make("code", run.title), make("span", "", { className: "of" }), stop);
    return item;
  }

  fillRun(item, run) {
    const [, state, stop] = item.children;
    const ended = run.state === "ended";
    set(state, ended ? run.error : `${run.state}, under ${run.tag ?? "…"}`);
    withdraw(stop, "hidden", ended);
    stop.disabled = run.number === undefined;
    stop.setAttribute("aria-label", `Stop ${run.title}`);
  }
}

// What is typed survives that the page is left.
function keep(text) {
  try {
    localStorage.setItem(DRAFT, text);
  } catch {
    // It is too long for the browser; it stays on the page.
  }
}
