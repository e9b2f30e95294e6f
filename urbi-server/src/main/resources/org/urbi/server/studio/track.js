// What is known of the turns of one job: what it did from when on, and in which times nobody looked.
const MOST = 20000;
// So many are forgotten at a time, if there are more.
const PART = 1000;
// What is too old is forgotten when there is more of it than these milliseconds.
const SLACK = 12000;

export class Track {
  constructor(from) {
    // In the order of time: turns, and holes of which it is not known what the job did. Up to the begin of each it did what `before`
    // says. The first one is a hole, in which the job perhaps was not there yet.
    this.all = [{ hole: true, begin: -Infinity, end: from, before: "" }];
    // Until when it is known what the job did, and what that was since its last turn.
    this.until = from;
    this.kind = "";
  }

  turns() {
    return this.all.filter((each) => !each.hole);
  }

  // The last thing that is known, a turn or a hole.
  last() {
    return this.all.at(-1);
  }

  // The turn that is the nearest to a time.
  near(time) {
    const away = (turn) => Math.max(turn.begin - time, time - turn.end, 0);
    const at = this.all.findLastIndex((each) => each.begin <= time);
    const around = this.all.slice(Math.max(0, at - 1), at + 3).filter((each) => !each.hole);
    return around.sort((a, b) => away(a) - away(b))[0];
  }

  turn(turn) {
    this.all.push(turn);
    this.until = Math.max(this.until, turn.end);
  }

  // Nobody has looked until then.
  hole(end) {
    if (end <= this.until) return;
    this.all.push({ hole: true, begin: this.until, end, before: this.kind });
    this.until = end;
  }

  // Somebody has looked until then, and the job does this.
  cover(until, kind) {
    this.until = Math.max(this.until, until);
    this.kind = kind;
  }

  // What the job did at a time between its turns; nothing if nobody knows.
  did(time) {
    const next = this.all.find((each) => each.end > time);
    if (!next) return time <= this.until ? this.kind : "";
    return next.hole && next.begin <= time ? "" : next.before;
  }

  // Forgets what was before a time, and, if there is too much, of what was after another time, which somebody looks at, the oldest part.
  forget(before, seen) {
    if (this.all[1]?.end < before - SLACK) this.cut(0, this.all.findLastIndex((each) => each.end < before));
    if (this.all.length <= MOST) return;
    const last = this.all.length - 1;
    const from = seen === null ? 0 : Math.min(this.all.findLastIndex((each) => each.begin <= seen) + 1, last);
    this.cut(from, Math.min(from + PART, last));
  }

  // In the place of some there is a hole.
  cut(from, to) {
    const { begin, before } = this.all[from];
    this.all.splice(from, to - from + 1, { hole: true, begin, end: this.all[to].end, before });
  }
}
