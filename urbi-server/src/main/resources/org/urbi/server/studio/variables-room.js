// The room of the variables: browsing lobbies, objects and prototypes, changing slots, plotting numbers.
import { Items, ago, make, set } from "./elements.js";
import { Objects, shownWay } from "./objects.js";
import { Plot } from "./plot.js";
import { Recording } from "./recording.js";
import { Slot } from "./slot.js";

const INDENT = 0.9;
const ASK_AFTER = 100;

const PAGE = `
  <div class="stack">
    <section class="card" aria-labelledby="variables-title">
      <div class="bar">
        <h2 id="variables-title">Variables</h2>
        <input id="variable-filter" type="search" placeholder="filter: a name…" aria-label="Show only slots whose name contains this text">
        <span id="record-state" class="hint" role="status"></span>
        <button id="record" type="button" aria-pressed="false" title="All UVars, the slots of --watch, and the log, to an MCAP file in the server's directory">Record</button>
      </div>
      <ul id="recordings" aria-label="Finished recordings" hidden></ul>
      <div class="columns" aria-hidden="true"><span>slot</span><span>value</span><span>per s</span><span>last written</span></div>
      <p id="variables-found" class="spoken" role="status"></p>
      <div id="variable-tree" role="tree" tabindex="0" aria-labelledby="variables-title"></div>
    </section>
    <section class="card" id="plot" aria-labelledby="plot-title">
      <div class="bar">
        <h2 id="plot-title">Plot</h2>
        <ul id="plotted" aria-label="What is plotted"></ul>
        <label><span>last</span>
          <select id="plot-span"><option value="10">10 s</option><option value="60" selected>1 min</option><option value="600">10 min</option></select>
        </label>
        <button id="plot-pause" type="button" aria-pressed="false">Pause</button>
        <button id="plot-csv" type="button">CSV</button>
      </div>
      <div id="plot-area" role="group" tabindex="0" aria-label="The plotted numbers over time; + and - zoom, the arrows go back and forth, Home shows all again"></div>
      <p id="plot-hint" class="hint">Choose a number and press Plot. Drag over the plot to zoom, double-click to see all again.</p>
    </section>
  </div>
  <aside>
    <section class="card" id="slot" aria-labelledby="slot-title"></section>
  </aside>`;

export class Room {
  constructor(studio, host) {
    this.studio = studio;
    this.objects = new Objects();
    this.text = "";
    this.lines = [];
    this.selected = null;
    host.classList.add("beside");
    host.innerHTML = PAGE;
    this.find = (name) => host.querySelector(`#${name}`);
    this.tree = this.find("variable-tree");
    this.items = new Items(this.tree, (line) => line.way, (line) => this.newLine(line), (row, line) => this.fillLine(row, line));
    this.plot = new Plot(this.find, studio);
    this.slot = new Slot(this.find("slot"), studio, this.plot);
    this.recording = new Recording(studio, this.find("record"), this.find("record-state"), this.find("recordings"));
    this.recording.take(studio.recording);
    this.find("variable-filter").addEventListener("input", (event) => {
      this.text = event.target.value;
      this.draw();
    });
    this.tree.addEventListener("click", (event) => this.click(event));
    this.tree.addEventListener("keydown", (event) => this.key(event));
    this.draw();
  }

  show() {
    this.shown = true;
    this.ask();
    this.plot.ask();
    this.plot.draw();
  }

  hide() {
    this.shown = false;
    clearTimeout(this.asking);
    this.studio.send({ type: "variables" });
    this.plot.rest();
  }

  welcome() {
    this.objects.clear();
    this.recording.draw();
    if (this.shown) this.show();
    this.draw();
  }

  wanted() {
    return JSON.stringify(this.objects.wanted(this.selected, this.text));
  }

  ask() {
    clearTimeout(this.asking);
    this.asked = this.wanted();
    this.studio.send({ type: "variables", objects: JSON.parse(this.asked) });
  }

  // Who holds an arrow key goes through more slots than a server should be asked about.
  soon() {
    clearTimeout(this.asking);
    this.asking = setTimeout(() => this.ask(), ASK_AFTER);
  }

  take(message) {
    this.recording.take(message);
    if (message.type === "sample" && this.shown) this.plot.take(message);
    if (message.type !== "view" || !message.variables) return;
    this.objects.take(message.variables, message.time);
    if (!this.shown) return;
    // Objects come and go by themselves.
    if (this.wanted() !== this.asked) this.soon();
    this.draw();
  }

  draw() {
    this.lines = this.objects.lines(this.text);
    this.items.show(this.lines);
    const slots = this.lines.filter((line) => line.slot).length;
    set(this.find("variables-found"), this.text && `${slots} ${slots === 1 ? "slot" : "slots"} shown`);
    const index = this.lines.findIndex((line) => line.way === this.selected);
    if (index < 0) this.tree.removeAttribute("aria-activedescendant");
    else this.tree.setAttribute("aria-activedescendant", this.tree.children[index].id);
    this.slot.show(this.selected, this.selected ? this.objects.slot(this.selected) : undefined, this.objects);
  }

  newLine(line) {
    const row = make("div", "", { className: line.slot || line.opens ? "line" : "line remark" });
    row.role = "treeitem";
    row.dataset.way = line.way;
    row.id = `variable-${encodeURIComponent(line.way)}`;
    row.setAttribute("aria-level", line.level);
    const what = make("div", "", { className: "what" });
    what.style.paddingLeft = `${(line.level - 1) * INDENT}rem`;
    what.append(make("span", "", { className: "twisty", ariaHidden: true }), make("span", line.name, { className: "name" }), make("span", "", { className: "type" }));
    row.append(what, make("div", "", { className: "value" }), make("div", "", { className: "number", ariaHidden: true }), make("div", "", { className: "number", ariaHidden: true }));
    return row;
  }

  fillLine(row, line) {
    const [what, value, rate, last] = row.children;
    const { slot } = line;
    const open = this.objects.open.has(line.way);
    set(what.children[0], line.opens ? (open ? "▾" : "▸") : "");
    set(what.children[1], line.name);
    set(what.children[2], slot ? slot.type : (line.type ?? ""));
    set(value, slot && !(slot.opens && slot.value === slot.type) ? slot.value : "");
    const perSecond = slot?.variable ? this.objects.perSecond(slot) : 0;
    set(rate, perSecond ? perSecond.toFixed(perSecond < 10 ? 1 : 0) : "");
    set(last, slot?.variable ? ago(slot.last, this.objects.now) : "");
    row.setAttribute("aria-selected", line.way === this.selected);
    if (line.opens) row.setAttribute("aria-expanded", open);
    else row.removeAttribute("aria-expanded");
  }

  click(event) {
    const row = event.target.closest(".line");
    const line = this.lines.find((each) => each.way === row?.dataset.way);
    if (!line) return;
    if (line.opens && (event.target.className === "twisty" || !line.slot)) this.toggle(line.way);
    this.select(line.way);
  }

  toggle(way) {
    if (!this.objects.open.delete(way)) this.objects.open.add(way);
    this.ask();
    this.draw();
  }

  select(way) {
    this.selected = way;
    this.soon();
    this.draw();
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const at = this.lines.findIndex((line) => line.way === this.selected);
    const line = this.lines[at];
    const steps = { ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10, Home: -1e9, End: 1e9 }[event.key];
    if (steps && this.lines.length) {
      const index = Math.min(this.lines.length - 1, Math.max(0, at + steps));
      this.select(this.lines[index].way);
      this.tree.children[index].scrollIntoView({ block: "nearest" });
    } else if (event.key === "ArrowRight" && line?.opens && !this.objects.open.has(line.way)) this.toggle(line.way);
    else if (event.key === "ArrowLeft" && line && this.objects.open.has(line.way)) this.toggle(line.way);
    else if (event.key === "Enter" && line?.slot) this.slot.edit();
    else if (event.key === "p" && line?.slot && !event.repeat) this.slot.togglePlot();
    else return;
    event.preventDefault();
  }
}
