// The files of the server: listed, opened into the editor, saved from it.
import { make } from "./elements.js";

const KEPT = "file";

export class Files {
  constructor(studio, { list, name, save, say }, editor) {
    Object.assign(this, { studio, list, name, save, say, editor });
    // The file in the editor: its name, its version when it was opened or saved, and its text then.
    this.file = kept();
    name.value = this.file.name;
    this.last = Promise.resolve();
    list.addEventListener("change", () => this.open(list.value));
    list.addEventListener("focus", () => this.renew());
    save.addEventListener("click", () => this.write());
  }

  welcome() {
    const none = !this.studio.mayChange;
    for (const each of [this.list, this.name, this.save]) each.disabled = none;
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
    const first = make("option", files.length ? "open a file…" : "no files", { value: "" });
    this.list.replaceChildren(first, ...files.map((each) => make("option", each, { value: each })));
  }

  async open(name) {
    this.list.value = "";
    if (!name) return;
    const text = this.editor.text();
    if (this.file.name && text !== this.file.text && this.losing !== name) {
      this.losing = name;
      this.say(`${this.file.name} is not saved: save it, or choose ${name} again to lose what was typed`);
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
function kept() {
  try {
    const { name, version, text } = JSON.parse(localStorage.getItem(KEPT) ?? "{}");
    return { name: name ?? "", version: version ?? "", text: text ?? "" };
  } catch {
    return { name: "", version: "", text: "" };
  }
}
