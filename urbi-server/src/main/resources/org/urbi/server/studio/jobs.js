// What is known of the jobs and tags, put together from what has changed.
import { Track } from "./track.js";

const KEPT = 60000;
// Turns may come before the job: of one that is never told of, because it has ended, they are kept so long.
const UNSEEN = 5000;
// Jobs that have ended are shown for a while, but of those of the same starter only so many, the latest ones, and so many in all.
const MOST_ENDED_OF_ONE = 8;
const MOST_ENDED = 1000;

const COLLATOR = new Intl.Collator("en", { numeric: true });
const NONE = [];

export class Jobs {
  constructor() {
    this.clear();
  }

  clear() {
    // Those that have ended are among them as long as they are shown; `count` is how many have not.
    this.rows = new Map();
    this.ended = [];
    // Those of before the connection was lost, until the server has told of them.
    this.untold = new Set();
    this.untoldTags = new Set();
    this.count = 0;
    this.tags = new Map();
    this.tracks = new Map();
    this.traced = new Set();
    // The time at which somebody holds the view: what was there then stays. Null if time goes on.
    this.held = null;
    this.load = 0;
    // Counts what changes the lines of the list, and all that comes.
    this.version = 0;
    this.views = 0;
    this.machine = 0;
    this.at = performance.now();
  }

  // The same server is there again, and tells all anew: what it does not tell of has ended meanwhile.
  again() {
    this.machine = this.now();
    this.at = performance.now();
    this.traced.clear();
    this.untoldTags = new Set(this.tags.keys());
    this.untold = new Set([...this.rows.values()].filter((job) => !job.ended).map((job) => job.number));
  }

  take(view) {
    this.machine = view.machine;
    this.at = performance.now();
    this.views++;
    for (const job of view.jobs) {
      const known = this.rows.get(job.number);
      if (!known || known.tags.join() !== job.tags.join()) this.version++;
      if (!known) this.count++;
      this.load += job.share - (known?.share ?? 0);
      job.since = known?.since ?? view.machine;
      this.rows.set(job.number, job);
      this.untold.delete(job.number);
    }
    this.follow(view);
    for (const number of view.gone) this.end(number);
    for (const tag of view.tags) {
      this.tags.set(tag.number, tag);
      this.untoldTags.delete(tag.number);
    }
    for (const number of view.tagsGone) this.tags.delete(number);
    if (view.complete) {
      for (const number of this.untold) this.end(number);
      for (const number of this.untoldTags) this.tags.delete(number);
      this.untold.clear();
      this.untoldTags.clear();
      this.forgetUnseen();
      this.forgetEnded();
    }
  }

  // A job has ended. What it was is still known for a while.
  end(number) {
    const job = this.rows.get(number);
    if (!job || job.ended) return;
    this.count--;
    this.load -= job.share;
    this.version++;
    // The tags under which it was may be gone as well.
    this.rows.set(number, { ...job, share: 0, ended: this.machine, tagNames: this.tagNames(job) });
    this.ended.push(number);
  }

  // What was there when somebody began to hold the view stays until he does not any more.
  forgetEnded() {
    const siblings = new Map();
    const kept = [];
    for (const number of this.ended.toReversed()) {
      const job = this.rows.get(number);
      const before = siblings.get(job.starter) ?? 0;
      siblings.set(job.starter, before + 1);
      const late = job.ended >= this.machine - KEPT && before < MOST_ENDED_OF_ONE && kept.length < MOST_ENDED;
      if (late || (this.held !== null && job.since <= this.held)) kept.push(number);
      else this.forget(number);
    }
    this.ended = kept.reverse();
  }

  forget(number) {
    this.rows.delete(number);
    this.tracks.delete(number);
    this.version++;
  }

  forgetUnseen() {
    for (const [number, track] of this.tracks) {
      if (!this.rows.has(number) && track.until < this.machine - UNSEEN) this.tracks.delete(number);
    }
  }

  // The turns of the jobs that are traced, and of which jobs and times they are: that none is told does not mean that there was none.
  follow({ machine, turns, lostUntil, traced }) {
    if (lostUntil) for (const number of this.traced) this.tracks.get(number)?.hole(lostUntil);
    for (const turn of turns) this.keep(turn, lostUntil);
    for (const number of this.traced) {
      const job = this.rows.get(number);
      if (job && !job.ended) this.tracks.get(number)?.cover(machine, Jobs.kind(job));
    }
    if (!traced) return;
    this.traced = new Set(traced.map(([number]) => number));
    for (const [number, since] of traced) {
      const track = this.tracks.get(number);
      if (track) track.hole(since);
      else this.tracks.set(number, new Track(since));
    }
  }

  keep([job, wakers, begin, end, before, ended], lostUntil = 0) {
    if (!this.tracks.has(job)) this.tracks.set(job, new Track(begin));
    const track = this.tracks.get(job);
    track.hole(Math.min(lostUntil, begin));
    track.turn({ wakers, begin, end, before, ended });
    track.forget((this.held ?? this.machine) - KEPT, this.held);
  }

  // Until when it is known what a job has done since its last turn, and what that is.
  tail(number) {
    const job = this.rows.get(number);
    const track = this.tracks.get(number);
    if (!track || track.last().ended) return { until: -Infinity, kind: "" };
    const goesOn = job && !job.ended && this.traced.has(number);
    return goesOn ? { until: this.now(), kind: Jobs.kind(job) } : track;
  }

  // When a job has ended, as far as that is known; never, if it goes on.
  endOf(number) {
    const last = this.tracks.get(number)?.last();
    return last?.ended ? last.end : (this.rows.get(number)?.ended ?? Infinity);
  }

  // The time of the machine by now, in milliseconds.
  now() {
    return this.machine + performance.now() - this.at;
  }

  // What a job is doing, in one word.
  static kind(job) {
    if (job.ended) return "ended";
    return job.frozen ? "frozen" : job.waits;
  }

  // How many have not ended.
  static alive(jobs) {
    return jobs.filter((job) => !job.ended).length;
  }

  // Its name and what it executes; a shell that waits for its next line executes nothing.
  static title({ name, code }) {
    return code ? `${name}: ${code}` : name;
  }

  tagNames(job) {
    return job.tagNames ?? job.tags.map((number) => this.tags.get(number)?.name).filter((name) => name);
  }

  matches(job, words) {
    if (!words.length) return true;
    const text = `${job.code} ${job.name} ${job.place} ${Jobs.kind(job)} ${this.tagNames(job).join(" ")}`.toLowerCase();
    return words.every((word) => text.includes(word));
  }

  // The lines of the list: lobbies with their jobs, each below the one that started it.
  tree(words, closed) {
    const below = new Map();
    const put = (key, job) => (below.has(key) ? below.get(key).push(job) : below.set(key, [job]));
    const shown = words.length ? this.withStarters(words) : this.rows;
    for (const job of shown.values()) {
      const starter = shown.get(job.starter);
      put(starter && starter.lobby === job.lobby ? job.starter : job.lobby, job);
    }
    const lines = [];
    const stack = [];
    const lobbies = [...below.keys()].filter((key) => typeof key === "string");
    // Where each is among those of the same starter, and of how many, is told to whoever does not see it.
    const later = (jobs, level) => {
      for (let i = jobs.length - 1; i >= 0; i--) stack.push({ job: jobs[i], level, place: i + 1, of: jobs.length });
    };
    for (const [i, lobby] of lobbies.sort(COLLATOR.compare).entries()) {
      const open = !closed.has(lobby);
      const jobs = below.get(lobby);
      lines.push({ key: lobby, lobby, level: 1, place: i + 1, of: lobbies.length, open, children: jobs.length, alive: Jobs.alive(jobs) });
      if (open) later(jobs, 2);
      while (stack.length) {
        const { job, level, place, of } = stack.pop();
        const { number } = job;
        const children = below.get(number) ?? NONE;
        const opened = !closed.has(number);
        lines.push({ key: number, job, level, place, of, open: opened, children: children.length });
        if (opened) later(children, level + 1);
      }
    }
    return lines;
  }

  withStarters(words) {
    const shown = new Map();
    for (let job of this.rows.values()) {
      if (!this.matches(job, words)) continue;
      for (; job && !shown.has(job.number); job = this.rows.get(job.starter)) shown.set(job.number, job);
    }
    return new Map([...shown].sort(([a], [b]) => a - b));
  }

  busiest(words) {
    return [...this.rows.values()]
      .filter((job) => this.matches(job, words))
      .sort((a, b) => b.share - a.share || a.number - b.number)
      .map((job, i, all) => ({ key: job.number, job, level: 1, place: i + 1, of: all.length, children: 0 }));
  }
}
