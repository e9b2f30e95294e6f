// The lanes: for each line in sight when the job ran, what it waited for, and who woke it.
import { rem } from "./elements.js";
import { Jobs } from "./jobs.js";

const LANE = 0.875;
const THIN = 0.1875;
// Lines that are higher have the lane below the code.
const HIGH = 3;

export class Lanes {
  constructor(canvas, list, jobs) {
    this.canvas = canvas;
    this.list = list;
    this.jobs = jobs;
    this.span = 60000;
    this.paused = null;
  }

  colours() {
    const style = getComputedStyle(document.documentElement);
    const of = (name) => style.getPropertyValue(`--${name}`).trim();
    const all = {};
    // The canvas knows nothing of light-dark(): a probe has the colour that is in force.
    const probe = this.canvas;
    for (const [kind, name] of Object.entries({
      running: "running", time: "time", waiting: "time", input: "time", event: "event", condition: "condition",
      jobs: "jobs", lock: "lock", signal: "signal", file: "outside", UObject: "outside", frozen: "frozen", line: "line", text: "text",
    })) {
      probe.style.color = of(name);
      all[kind] = getComputedStyle(probe).color;
    }
    return all;
  }

  pause(on) {
    this.paused = on ? this.jobs.now() : null;
  }

  draw() {
    const { list, canvas } = this;
    const width = canvas.clientWidth;
    const height = list.list.clientHeight;
    const ratio = window.devicePixelRatio || 1;
    canvas.style.height = `${height}px`;
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
    }
    const context = canvas.getContext("2d");
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    if (!width) return;
    const colours = this.colours();
    const now = this.paused ?? this.jobs.now();
    const x = (time) => width * (1 - (now - time) / this.span);
    const below = list.row > rem(HIGH);
    const sizes = { lane: rem(LANE), line: rem(THIN) };
    context.fillStyle = colours.line;
    for (let i = 0; i < 6; i++) context.fillRect((width * i) / 6, 0, 1, height);
    const { first, last } = list.visible();
    const middle = new Map();
    for (let i = first; i < last; i++) {
      const top = i * list.row - list.list.scrollTop;
      middle.set(list.lines[i].key, below ? top + list.row - sizes.lane / 2 - 5 : top + list.row / 2);
    }
    for (let i = first; i < last; i++) {
      const line = list.lines[i];
      if (line.job) this.lane(context, line.key, middle, x, width, colours, sizes);
    }
    canvas.dataset.drawn = Number(canvas.dataset.drawn ?? 0) + 1;
  }

  lane(context, number, middle, x, width, colours, sizes) {
    const job = this.jobs.rows.get(number);
    const turns = this.jobs.turns.get(number) ?? [];
    const y = middle.get(number);
    const thin = (kind, from, to) => {
      context.fillStyle = colours[kind] ?? colours.time;
      if (to > 0 && to > from) context.fillRect(Math.max(0, from), y - sizes.line / 2, to - Math.max(0, from), sizes.line);
    };
    let before = null;
    let drawn = -1;
    for (const turn of turns) {
      const from = x(turn.begin);
      const to = x(turn.end);
      if (to >= 0 && before !== null && from - before > 1) thin(turn.before, before, from);
      before = to;
      if (to < 0 || from > width || to < drawn) continue;
      const end = Math.max(to, from + 1.5);
      context.fillStyle = colours.running;
      context.fillRect(from, y - sizes.lane / 2, end - from, sizes.lane);
      drawn = Math.floor(end) + 0.5;
      const waker = turn.waker && turn.waker !== number ? middle.get(turn.waker) : undefined;
      if (waker !== undefined) {
        context.fillStyle = colours.event;
        context.fillRect(from - 0.5, Math.min(waker, y), 1, Math.abs(waker - y));
        context.fillRect(from - 2, y + (waker < y ? -sizes.lane / 2 - 3 : sizes.lane / 2), 4, 3);
      }
    }
    if (job && job.waits !== "running") thin(Jobs.kind(job), before ?? x(job.since), width);
  }
}
