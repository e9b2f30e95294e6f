// Records all variables, the jobs and the log to an MCAP file beside the server, for Foxglove and its kind.
import { make, put, set } from "./elements.js";

// How errors of what is run here begin: with its name, and a place in it.
const FAILURE = /!!! record:\S+ (.*)/;

export class Recording {
  constructor(studio, button, state, list) {
    Object.assign(this, { studio, button, state, list });
    this.finished = [];
    this.file = "";
    this.told = "";
    button.addEventListener("click", () => this.toggle());
  }

  take(message) {
    if (message.type === "output") this.failure = FAILURE.exec(message.text)?.[1] ?? this.failure;
    if (message.type !== "recording") return;
    this.told = message.file ? `records to ${message.file}` : this.file && `the recording to ${this.file} has ended`;
    this.file = message.file;
    this.finished = message.finished;
    this.draw();
  }

  draw() {
    const { role } = this.studio;
    this.button.disabled = role !== "owner";
    set(this.state, this.told || (!role || role === "owner" ? "" : "Only an owner may record."));
    this.button.setAttribute("aria-pressed", Boolean(this.file));
    set(this.button, this.file ? "Stop recording" : "Record");
    this.list.hidden = !this.finished.length;
    put(this.list, this.finished, () => this.finished.map((recording) => this.item(recording)));
  }

  item({ number, file }) {
    const item = make("li");
    const button = make("button", `Download ${file}`, { type: "button" });
    button.dataset.act = number;
    button.addEventListener("click", () => this.download(number));
    item.append(button);
    return item;
  }

  // The address is good for once: the browser itself keeps what comes from there.
  async download(recording) {
    const { error, address } = await this.studio.ask({ type: "download", recording });
    if (!error) make("a", "", { href: address, download: "" }).click();
  }

  // It is code as any other, which a recording of the run contains.
  async toggle() {
    const name = `values-${new Date().toISOString().slice(0, 19).replaceAll(":", "-")}.mcap`;
    const code = this.file ? "System.stopMcap;" : `System.startMcap("${name}");`;
    this.failure = "";
    const { error } = await this.studio.ask({ type: "run", file: "record", code }, { quiet: true });
    if (error) this.studio.alert(this.failure || error);
  }
}
