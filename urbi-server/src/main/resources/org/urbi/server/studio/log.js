// What code says, the last lines of it. A flood is shown a picture at a time.
import { make } from "./elements.js";

const MOST_LINES = 2000;
const LONGEST_LINE = 10000;

export class Log {
  constructor(host) {
    this.host = host;
    this.part = "";
    this.waiting = [];
  }

  // Returns the lines that are complete now.
  add(text) {
    const lines = (this.part + text).split("\n");
    this.part = lines.pop().slice(-LONGEST_LINE);
    if (!this.waiting.length && lines.length) requestAnimationFrame(() => this.draw());
    this.waiting.push(...lines);
    if (this.waiting.length > MOST_LINES) this.waiting = this.waiting.slice(-MOST_LINES);
    return lines;
  }

  draw() {
    const { host } = this;
    const atEnd = host.scrollHeight - host.scrollTop - host.clientHeight < 40;
    host.append(...this.waiting.map((line) => make("div", line.slice(0, LONGEST_LINE), { className: kind(line) })));
    this.waiting = [];
    while (host.childElementCount > MOST_LINES) host.firstElementChild.remove();
    if (atEnd) host.scrollTop = host.scrollHeight;
  }

  clear() {
    this.waiting = [];
    this.host.replaceChildren();
  }
}

function kind(line) {
  if (line.startsWith("> ")) return "typed";
  if (/^(\[\d+(:error)?\] )?!!!/.test(line)) return "wrong";
  return line.startsWith("***") ? "note" : "";
}
