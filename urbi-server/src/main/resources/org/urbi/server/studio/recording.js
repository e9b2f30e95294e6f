// Records all variables, the jobs and the log to an MCAP file beside the server, for Foxglove and its kind.
import { set } from "./elements.js";

// How errors of what is run here begin: with its name, and a place in it.
const FAILURE = /!!! record:\S+ (.*)/;

export class Recording {
  constructor(studio, button, state) {
    Object.assign(this, { studio, button, state });
    this.file = "";
    this.told = "";
    button.addEventListener("click", () => this.toggle());
  }

  take(message) {
    if (message.type === "output") this.failure = FAILURE.exec(message.text)?.[1] ?? this.failure;
    if (message.type !== "recording") return;
    this.told = message.file ? `records to ${message.file}` : this.file && `the recording to ${this.file} has ended`;
    this.file = message.file;
    this.draw();
  }

  draw() {
    const { role } = this.studio;
    this.button.disabled = role !== "owner";
    set(this.state, this.told || (!role || role === "owner" ? "" : "Only an owner may record."));
    this.button.setAttribute("aria-pressed", Boolean(this.file));
    set(this.button, this.file ? "Stop recording" : "Record");
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
