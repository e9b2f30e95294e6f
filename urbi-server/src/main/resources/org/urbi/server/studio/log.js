// What code says, the last lines of it. A flood is shown a picture at a time.
import { make, set } from "./elements.js";

const MOST_LINES = 2000;
const LONGEST_LINE = 10000;

export class Log {
  constructor(host) {
    this.host = host;
    this.part = "";
    this.waiting = [];
    // The element of the line that is not complete yet.
    this.last = null;
  }

  // Returns the lines that are complete now.
  add(text) {
    const lines = (this.part + text).split("\n");
    this.part = lines.pop().slice(-LONGEST_LINE);
    this.waiting.push(...lines);
    if (this.waiting.length > MOST_LINES) this.waiting = this.waiting.slice(-MOST_LINES);
    this.drawing ||= requestAnimationFrame(() => this.draw());
    return lines;
  }

  // What somebody has typed has a line of its own, also behind output that has not ended its line.
  typed(text) {
    this.add(`${this.part && "\n"}> ${text}\n`);
  }

  draw() {
    this.drawing = 0;
    const { host } = this;
    const atEnd = host.scrollHeight - host.scrollTop - host.clientHeight < 40;
    const lines = this.part ? [...this.waiting, this.part] : this.waiting;
    if (this.last && lines.length) show(this.last, lines.shift());
    const added = lines.map((line) => show(make("div"), line));
    host.append(...added);
    this.last = this.part ? (added.at(-1) ?? this.last) : null;
    this.waiting = [];
    while (host.childElementCount > MOST_LINES) host.firstElementChild.remove();
    if (atEnd) host.scrollTop = host.scrollHeight;
  }

  clear() {
    this.waiting = [];
    this.part = "";
    this.last = null;
    this.host.replaceChildren();
  }
}

function show(element, line) {
  set(element, line.slice(0, LONGEST_LINE));
  element.className = kind(line);
  return element;
}

function kind(line) {
  if (line.startsWith("> ")) return "typed";
  if (/^(\[\d+(:error)?\] )?!!!/.test(line)) return "wrong";
  return line.startsWith("***") ? "note" : "";
}
