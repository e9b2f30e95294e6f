// The lines that were typed before, also on earlier days.
const KEY = "console";
const MOST = 200;

export class LineHistory {
  constructor() {
    this.lines = known();
    this.at = this.lines.length;
    this.typed = "";
  }

  add(line) {
    this.lines = [...this.lines.filter((each) => each !== line), line].slice(-MOST);
    this.at = this.lines.length;
    try {
      localStorage.setItem(KEY, JSON.stringify(this.lines));
    } catch {
      // The browser keeps no more; the page still knows them.
    }
  }

  // The line before or behind; behind the last one is what was being typed.
  step(by, present) {
    if (this.at === this.lines.length) this.typed = present;
    this.at = Math.max(0, Math.min(this.at + by, this.lines.length));
    return this.lines[this.at] ?? this.typed;
  }
}

// What the browser has kept may be anything.
function known() {
  try {
    return [JSON.parse(localStorage.getItem(KEY) ?? "[]")].flat().filter((line) => typeof line === "string");
  } catch {
    return [];
  }
}
