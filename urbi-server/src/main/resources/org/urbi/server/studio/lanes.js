// The lanes: for each line in sight when the job ran, what it waited for, and who woke it.
import { rem } from "./elements.js";
import { Jobs } from "./jobs.js";

const LANE = 0.875;
const THIN = 0.1875;
const LONGEST = 60000;
const SHORTEST = 10;
// How far from a turn somebody may point who means it.
const NEAR = 4;
// Lines that are higher have the lane below the code.
const HIGH = 3;

export class Lanes {
  constructor(canvas, list, jobs) {
    this.canvas = canvas;
    this.list = list;
    this.jobs = jobs;
    // How much time is in sight, in milliseconds.
    this.span = LONGEST;
    // The turn to which somebody has gone by keys.
    this.turn = null;
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

  // The time at the end of what is in sight; null for now.
  get paused() {
    return this.jobs.held;
  }

  set paused(time) {
    this.jobs.held = time;
  }

  pause(on) {
    this.paused = on ? this.jobs.now() : null;
  }

  end() {
    return this.paused ?? this.jobs.now();
  }

  // The time at a pixel.
  at(x) {
    return this.end() - this.span * (1 - x / this.canvas.clientWidth);
  }

  // Goes to earlier times, by pixels, within the last minute; who comes back to its end is there to stay.
  pan(pixels) {
    const now = this.jobs.now();
    const earliest = Math.min(now - LONGEST + this.span, this.end());
    const end = Math.max(this.end() - (pixels * this.span) / this.canvas.clientWidth, earliest);
    this.paused = end < now ? end : null;
  }

  // Shows more of the time, or less. What is at a pixel stays there, unless time goes on.
  zoom(factor, x) {
    const time = this.at(x);
    this.span = Math.min(LONGEST, Math.max(SHORTEST, this.span * factor));
    if (this.paused !== null) this.paused = Math.min(this.jobs.now(), time + this.span * (1 - x / this.canvas.clientWidth));
  }

  // What happened at a place, in words; nothing where there is no job.
  said(x, y) {
    const { list, jobs } = this;
    const line = list.lines[Math.floor((y + list.list.scrollTop) / list.row)];
    const job = line?.job && jobs.rows.get(line.key);
    if (!job) return "";
    const time = this.at(x);
    const track = jobs.tracks.get(line.key);
    const turn = track?.near(time);
    const name = `${job.name}: `;
    const away = turn ? Math.max(turn.begin - time, time - turn.end) : Infinity;
    if (away <= (NEAR * this.span) / this.canvas.clientWidth) return name + this.ran(turn, line.key);
    if (time >= jobs.endOf(line.key)) return `${name}has ended`;
    const tail = jobs.tail(line.key);
    const last = track?.last();
    const kind = last && time >= last.end && time <= tail.until ? tail.kind : track?.did(time);
    if (!kind) return `${name}was not in sight`;
    return name + (kind === "running" || kind === "frozen" ? kind : `waits for ${kind}`);
  }

  // Goes to an earlier or a later turn of a job than that of last time, to the latest one first; what it was, in words.
  step(number, steps) {
    const turns = this.jobs.tracks.get(number)?.turns() ?? [];
    if (!turns.length) return number ? "No turn of this job yet since it came in sight." : "Select a job first.";
    const known = turns.indexOf(this.turn);
    this.turn = turns[known < 0 ? turns.length - 1 : Math.min(turns.length - 1, Math.max(0, known + steps))];
    const { begin } = this.turn;
    if (begin < this.at(0) || begin > this.end()) this.paused = Math.min(this.jobs.now(), begin + this.span / 2);
    return `${this.jobs.rows.get(number)?.name}: ${this.ran(this.turn, number)}`;
  }

  ran(turn, number) {
    const long = `ran for ${(turn.end - turn.begin).toFixed(2)} ms, ${((this.jobs.now() - turn.begin) / 1000).toFixed(2)} s ago`;
    const [first] = turn.wakers;
    if (first === number) return `${long}, going on`;
    const waited = turn.before === "running" ? "" : `, after it had waited for ${turn.before}`;
    if (!first) return long + waited;
    const how = turn.before === "running" && first === this.jobs.rows.get(number)?.starter ? "started" : "woken";
    return `${long}${waited}, ${how} by ${this.whoWoke(turn)}`;
  }

  // The job that has woken another one, or the one that had started it: those of the turns of an `every` soon end.
  whoWoke({ wakers }) {
    const known = wakers.map((number) => this.jobs.rows.get(number)).find((job) => job);
    if (!known) return "a job that has ended";
    return `${known.number === wakers[0] ? "" : "a job that was started by "}${Jobs.title(known)}`;
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
    const now = this.end();
    const x = (time) => width * (1 - (now - time) / this.span);
    const below = list.row > rem(HIGH);
    const sizes = { lane: rem(LANE), line: rem(THIN) };
    const grid = (top, bottom) => {
      context.fillStyle = colours.line;
      for (let i = 0; i < 6; i++) context.fillRect((width * i) / 6, top, 1, bottom - top);
    };
    if (!below) grid(0, height);
    const { first, last } = list.visible();
    const middle = new Map();
    for (let i = first; i < last; i++) {
      const top = i * list.row - list.list.scrollTop;
      middle.set(list.lines[i].key, below ? top + list.row - sizes.lane / 2 - 5 : top + list.row / 2);
    }
    for (let i = first; i < last; i++) {
      const line = list.lines[i];
      const y = middle.get(line.key);
      // Lines through what is above a lane would make it hard to read.
      if (below && line.job) grid(y - sizes.lane / 2, y + sizes.lane / 2);
      if (line.job) this.lane(context, line.key, middle, x, width, colours, sizes);
    }
    canvas.dataset.drawn = Number(canvas.dataset.drawn ?? 0) + 1;
    canvas.dataset.span = this.span;
  }

  lane(context, number, middle, x, width, colours, sizes) {
    const track = this.jobs.tracks.get(number);
    if (!track) return;
    const y = middle.get(number);
    const thin = (kind, from, to) => {
      context.fillStyle = colours[kind] ?? colours.time;
      if (kind && to > 0 && to > from) context.fillRect(Math.max(0, from), y - sizes.line / 2, to - Math.max(0, from), sizes.line);
    };
    let before = null;
    let drawn = -1;
    for (const turn of track.all) {
      const from = x(turn.begin);
      const to = x(turn.end);
      if (to >= 0 && before !== null && from - before > 1) thin(turn.before, before, from);
      before = to;
      if (turn.hole || to < 0 || from > width || to < drawn) continue;
      const end = Math.max(to, from + 1.5);
      context.fillStyle = colours.running;
      context.fillRect(from, y - sizes.lane / 2, end - from, sizes.lane);
      drawn = Math.floor(end) + 0.5;
      if (turn === this.turn) {
        context.strokeStyle = colours.text;
        context.strokeRect(from - 2.5, y - sizes.lane / 2 - 1.5, end - from + 5, sizes.lane + 3);
      }
      const waker = turn.wakers[0] === number ? undefined : middle.get(turn.wakers.find((each) => middle.has(each)));
      if (waker !== undefined) {
        context.fillStyle = colours.event;
        context.fillRect(from - 0.5, Math.min(waker, y), 1, Math.abs(waker - y));
        context.fillRect(from - 2, y + (waker < y ? -sizes.lane / 2 - 3 : sizes.lane / 2), 4, 3);
      }
    }
    const { until, kind } = this.jobs.tail(number);
    if (kind !== "running") thin(kind, before, Math.min(x(until), width));
  }
}
