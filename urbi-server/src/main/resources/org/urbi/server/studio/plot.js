// Plots numbers while they change.
import uPlot from "./libraries/uPlot.esm.js";
import { make, put, rem } from "./elements.js";
import { shownWay } from "./objects.js";
import { zoomByTouch } from "./plot-touch.js";

const MOST = 16;
const KEPT_SECONDS = 600;
const HEIGHT = 13.75;
const KEY_PART = 0.25;
const LEAST_SECONDS = 0.001;
const LONG = 1e7;
const COLOURS = ["jobs", "signal", "running", "event", "condition", "bad", "outside", "frozen"];

// A number at an axis: neighbours differ, however close they are.
export function shownMark(mark) {
  const number = Number(mark.toPrecision(12));
  return Math.abs(number) < LONG ? String(number) : number.toExponential();
}

// What is in sight. If that were next to nothing, uPlot would look for marks until the memory is full.
function sight({ min, max }) {
  const missing = Math.max(0, (LEAST_SECONDS - (max - min)) / 2);
  return { min: min - missing, max: max + missing };
}

export class Plot {
  constructor(find, studio) {
    this.find = find;
    this.studio = studio;
    this.ways = [];
    this.data = [[]];
    this.version = 0;
    this.zoomed = false;
    this.colours = new Map();
    this.pause(false);
    find("plot-span").addEventListener("change", () => this.showAll());
    find("plot-pause").addEventListener("click", () => {
      this.pause(!this.paused);
      this.draw();
    });
    find("plot-csv").addEventListener("click", () => this.save());
    find("plot-area").addEventListener("keydown", (event) => this.key(event));
    // In another room it has no size: it gets that when it is in sight again.
    new ResizeObserver(() => this.fit()).observe(find("plot-area"));
    window.addEventListener("resize", () => {
      this.colours.clear();
      this.fit();
      this.chart?.redraw(false, true);
    });
    this.rebuild();
  }

  pause(paused) {
    this.paused = paused;
    this.end = this.data[0].at(-1) ?? 0;
    this.find("plot-pause").setAttribute("aria-pressed", paused);
  }

  has(way) {
    return this.ways.includes(way);
  }

  toggle(way) {
    const at = this.ways.indexOf(way);
    if (at < 0 && this.ways.length === MOST) {
      this.studio.alert(`At most ${MOST} numbers are plotted at a time.`);
      return;
    }
    if (at < 0) {
      this.ways.push(way);
      this.data.push(this.data[0].map(() => null));
    } else {
      this.ways.splice(at, 1);
      this.data.splice(at + 1, 1);
      if (!this.ways.length) this.data = [[]];
    }
    this.ask();
    this.rebuild();
  }

  // Samples have the number of the question that they answer: earlier ones are about other slots.
  ask() {
    this.studio.send({ type: "plot", id: ++this.version, ways: this.ways });
  }

  rest() {
    this.studio.send({ type: "plot", id: ++this.version });
  }

  take({ id, time, values }) {
    if (id !== this.version) return;
    const [times] = this.data;
    const now = time / 1000;
    // A server that was started again begins at 0.
    if (times.length && now <= times.at(-1)) {
      if (now === times.at(-1)) return;
      this.data = this.data.map(() => []);
      this.zoomed = false;
      this.end = now;
    }
    this.data[0].push(now);
    values.forEach((value, i) => this.data[i + 1].push(value));
    const old = this.data[0].findIndex((each) => each >= now - KEPT_SECONDS);
    if (old > KEPT_SECONDS) for (const column of this.data) column.splice(0, old);
    if (!this.paused) this.soon();
  }

  soon() {
    if (this.drawing) return;
    this.drawing = requestAnimationFrame(() => {
      this.drawing = 0;
      this.draw();
    });
  }

  draw() {
    if (!this.chart) return;
    const span = Number(this.find("plot-span").value);
    const end = this.paused ? this.end : (this.data[0].at(-1) ?? 0);
    const first = this.data[0][0] ?? 0;
    this.chart.setData(this.data, false);
    this.chart.setScale("x", sight(this.zoomed ? this.seen : { min: Math.min(end, Math.max(end - span, first)), max: end }));
    this.find("plot-area").dataset.points = this.data[0].length;
    this.find("plot-area").dataset.zoomed = this.zoomed;
  }

  colour(name) {
    if (!this.colours.has(name)) {
      const probe = this.find("plot-area");
      probe.style.color = `var(--${name})`;
      this.colours.set(name, getComputedStyle(probe).color);
      probe.style.color = "";
    }
    return this.colours.get(name);
  }

  // Its place has another size, or the letters have.
  fit() {
    const width = this.find("plot-area").clientWidth;
    if (!this.chart || !width) return;
    if (this.letters !== rem(1)) this.rebuild();
    else if (this.chart.width !== width) this.chart.setSize({ width, height: this.chart.height });
  }

  // Other numbers are plotted, at the times that are in sight.
  rebuild() {
    const { seen } = this;
    this.chart?.destroy();
    this.chart = null;
    const area = this.find("plot-area");
    const used = this.ways.length > 0;
    if (!used) {
      this.zoomed = false;
      this.pause(false);
    }
    area.hidden = !used;
    this.find("plot-hint").hidden = used;
    this.find("plot-csv").disabled = this.find("plot-pause").disabled = !used;
    put(this.find("plotted"), this.ways, () => this.ways.map((way, i) => this.chip(way, i)));
    if (!used) return;
    this.letters = rem(1);
    this.colours.clear();
    const line = { stroke: () => this.colour("line"), width: 1 };
    const axis = { font: `${rem(0.75)}px system-ui, sans-serif`, stroke: () => this.colour("faint"), grid: line, ticks: line };
    const options = {
      width: area.clientWidth,
      height: rem(HEIGHT),
      legend: { show: false },
      scales: { x: { time: false } },
      axes: [
        { ...axis, size: rem(3), space: rem(4), values: (_, marks) => marks.map((mark) => `${shownMark(mark)} s`) },
        { ...axis, size: rem(3.75), values: (_, marks) => marks.map(shownMark) },
      ],
      series: [{}, ...this.ways.map((way, i) => ({ label: shownWay(way), stroke: () => this.colour(COLOURS[i % COLOURS.length]), width: 1.5, spanGaps: false }))],
      hooks: {
        setSelect: [(chart) => (this.zoomed = chart.select.width > 0 || this.zoomed)],
        setScale: [(chart, name) => name === "x" && chart === this.chart && this.see(chart.scales.x)],
      },
    };
    this.chart = new uPlot(options, this.data, area);
    this.seen = seen;
    zoomByTouch(this.chart, () => (this.zoomed = true));
    this.chart.over.addEventListener("dblclick", () => this.showAll());
    this.draw();
  }

  see({ min, max }) {
    this.seen = { min, max };
    Object.assign(this.find("plot-area").dataset, { from: min, to: max });
  }

  showAll() {
    this.zoomed = false;
    this.draw();
  }

  // What a mouse does by drawing, and by a double click.
  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || !this.chart) return;
    const { min, max } = this.seen;
    const part = (max - min) * KEY_PART;
    const moves = { "+": [part, -part], "-": [-part, part], ArrowLeft: [-part, -part], ArrowRight: [part, part] };
    const move = moves[event.key];
    if (event.key === "Home") this.showAll();
    else if (move) {
      this.zoomed = true;
      this.seen = { min: min + move[0], max: max + move[1] };
      this.draw();
    } else return;
    event.preventDefault();
  }

  chip(way, index) {
    const item = make("li");
    const button = make("button", `${shownWay(way)} ✕`, { type: "button", title: `No longer plot ${shownWay(way)}` });
    button.style.borderColor = `var(--${COLOURS[index % COLOURS.length]})`;
    button.addEventListener("click", () => this.toggle(way));
    item.append(button);
    return item;
  }

  csv() {
    const quote = (text) => `"${text.replaceAll('"', '""')}"`;
    const lines = [["time", ...this.ways.map((way) => quote(shownWay(way)))].join(",")];
    this.data[0].forEach((time, row) => {
      lines.push([time, ...this.data.slice(1).map((column) => column[row] ?? "")].join(","));
    });
    return `${lines.join("\n")}\n`;
  }

  save() {
    const link = make("a", "", { download: "plot.csv", href: URL.createObjectURL(new Blob([this.csv()], { type: "text/csv" })) });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }
}
