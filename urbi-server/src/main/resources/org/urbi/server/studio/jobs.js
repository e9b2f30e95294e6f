// What is known of the jobs and tags, put together from what has changed.
const KEPT = 60000;
const MOST_TURNS = 20000;
// Turns may come before the job: of one that is never told of, because it has ended, they are kept so long.
const UNSEEN = 5000;

export class Jobs {
  constructor() {
    this.clear();
  }

  clear() {
    this.rows = new Map();
    this.tags = new Map();
    this.turns = new Map();
    this.load = 0;
    this.version = 0;
    this.machine = 0;
    this.at = performance.now();
  }

  take(view) {
    this.machine = view.machine;
    this.at = performance.now();
    for (const job of view.jobs) {
      const known = this.rows.get(job.number);
      if (!known || known.tags.join() !== job.tags.join()) this.version++;
      this.load += job.share - (known?.share ?? 0);
      // From when on it is known what it does: the lane begins there.
      job.since = known?.since ?? view.machine;
      this.rows.set(job.number, job);
    }
    for (const number of view.gone) {
      this.load -= this.rows.get(number)?.share ?? 0;
      this.rows.delete(number);
      this.turns.delete(number);
      this.version++;
    }
    for (const tag of view.tags) this.tags.set(tag.number, tag);
    for (const number of view.tagsGone) this.tags.delete(number);
    for (const turn of view.turns) this.keep(turn);
    if (view.complete) this.forgetUnseen();
  }

  forgetUnseen() {
    for (const [job, turns] of this.turns) {
      if (!this.rows.has(job) && turns.at(-1).end < this.machine - UNSEEN) this.turns.delete(job);
    }
  }

  keep([job, wakers, begin, end, before, ended]) {
    if (!this.turns.has(job)) this.turns.set(job, []);
    const turns = this.turns.get(job);
    turns.push({ wakers, begin, end, before, ended });
    if (turns.length > MOST_TURNS || turns[0].end < this.machine - 1.2 * KEPT) {
      const first = turns.findIndex((turn) => turn.end >= this.machine - KEPT);
      turns.splice(0, Math.max(first, turns.length - MOST_TURNS, 0));
    }
  }

  // The time of the machine by now, in milliseconds.
  now() {
    return this.machine + performance.now() - this.at;
  }

  // What a job is doing, in one word.
  static kind(job) {
    return job.frozen ? "frozen" : job.waits;
  }

  // Its name and what it executes; a shell that waits for its next line executes nothing.
  static title({ name, code }) {
    return code ? `${name}: ${code}` : name;
  }

  tagNames(job) {
    return job.tags.map((number) => this.tags.get(number)?.name).filter((name) => name);
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
    const collator = new Intl.Collator("en", { numeric: true });
    for (const lobby of lobbies.sort(collator.compare)) {
      const open = !closed.has(lobby);
      lines.push({ key: lobby, lobby, level: 1, open, children: below.get(lobby).length });
      if (open) stack.push(...below.get(lobby).map((job) => ({ job, level: 2 })).reverse());
      while (stack.length) {
        const { job, level } = stack.pop();
        const children = below.get(job.number) ?? [];
        const opened = !closed.has(job.number);
        lines.push({ key: job.number, job, level, open: opened, children: children.length });
        if (opened) for (let i = children.length - 1; i >= 0; i--) stack.push({ job: children[i], level: level + 1 });
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
      .map((job) => ({ key: job.number, job, level: 1, children: 0 }));
  }
}
