// The files of the server: listed, opened into the editor, saved from it.
import { LONGEST } from "./editor.js";
import { make } from "./elements.js";

const KEPT = "file";

export class Files {
  // first: the text that the editor has for who has typed nothing yet.
  constructor(studio, { list, open, name, save, say }, editor, first) {
    Object.assign(this, { studio, list, opening: open, name, save, say, editor });
    // The file in the editor: its name, its version when it was opened or saved, and its text then.
    this.file = kept(first);
    name.value = this.file.name;
    this.last = Promise.resolve();
    // Not when the list changes: an arrow key goes through it.
    open.addEventListener("click", () => this.open(list.value));
    list.addEventListener("focus", () => this.renew());
    save.addEventListener("click", () => this.write());
  }

  welcome() {
    const none = !this.studio.mayChange;
    for (const each of [this.list, this.opening, this.name, this.save]) each.disabled = none;
    if (!none) this.renew();
  }

  // The server does one thing after the other.
  ask(message) {
    this.last = this.last.then(() => this.studio.ask(message, { quiet: true }));
    return this.last;
  }

  async renew() {
    const { files = [], error } = await this.ask({ type: "files" });
    if (error) this.say(error);
    const names = files.join("\n");
    if (names === this.shown) return;
    this.shown = names;
    const chosen = this.list.value;
    const first = make("option", files.length ? "a file…" : "no files", { value: "" });
    this.list.replaceChildren(first, ...files.map((each) => make("option", each, { value: each })));
    this.list.value = files.includes(chosen) ? chosen : "";
  }

  async open(name) {
    if (!name) {
      this.say("choose a file first");
      this.list.focus();
      return;
    }
    const text = this.editor.text();
    const lost = `${name}\n${text}`;
    if (text.trim() && text !== this.file.text && this.losing !== lost) {
      this.losing = lost;
      this.say(`${this.file.name || "what was typed"} is not saved: save it, or open ${name} again to lose it`);
      return;
    }
    this.losing = "";
    const answer = await this.ask({ type: "open", name });
    if (answer.error) {
      this.say(answer.error);
      return;
    }
    this.editor.put(answer.text);
    this.name.value = name;
    this.know(name, answer.version);
    this.say(`${name} is opened`);
  }

  async write() {
    const name = this.name.value.trim();
    const text = this.editor.text();
    if (!name) this.name.focus();
    if (text.length > LONGEST) {
      const [most, now] = [LONGEST, text.length].map((count) => count.toLocaleString("en"));
      this.say(`at most ${most} characters can be saved, not ${now}`);
      return;
    }
    const version = name === this.file.name ? this.file.version : "";
    const answer = await this.ask({ type: "save", name, text, version });
    if (answer.error) {
      // Who saves again what was deleted has been told so.
      if (answer.error.includes("has been deleted")) this.know(name, "");
      this.say(answer.error);
      return;
    }
    this.know(name, answer.version, text);
    this.say(`${name} is saved`);
    this.renew();
  }

  know(name, version, text = this.editor.text()) {
    this.file = { name, version, text };
    try {
      localStorage.setItem(KEPT, JSON.stringify(this.file));
    } catch {
      // It is too long for the browser; the page still knows it.
    }
  }
}

// What the browser has kept may be anything.
function kept(first) {
  try {
    const { name, version, text } = JSON.parse(localStorage.getItem(KEPT) ?? "{}");
    return { name: name ?? "", version: version ?? "", text: text ?? first };
  } catch {
    return { name: "", version: "", text: first };
  }
}
