// The room of the jobs: the list with its lanes, the selected job, the tags.
import { set } from "./elements.js";
import { JobList } from "./joblist.js";
import { LanePointer } from "./lane-pointer.js";
import { Lanes } from "./lanes.js";
import { Side } from "./side.js";

const MOST_TRACED = 64;
const TELL_AFTER = 100;
const POINT = "Draw across the lanes to go back, two fingers or Ctrl and the wheel show less or more; a turn tells of itself.";
const KINDS = ["running", "time", "event", "condition", "jobs", "lock", "signal", "file", "frozen", "ended"];

const PAGE = `
  <section class="card" aria-labelledby="jobs-title">
    <div class="bar">
      <h2 id="jobs-title">Jobs</h2>
      <input id="filter" type="search" placeholder="filter: code, tag, event, frozen…" aria-label="Show only jobs with this text">
      <label><span>order</span>
        <select id="order"><option value="tree">who started whom</option><option value="share">busiest first</option></select>
      </label>
      <label><span>lanes</span>
        <select id="span" aria-label="How much time the lanes show">
          <option value="60000">1 min</option><option value="10000">10 s</option>
          <option value="1000">1 s</option><option value="100">0.1 s</option><option id="span-other" hidden>other</option>
        </select>
      </label>
      <button id="pause" type="button" aria-pressed="false">Pause</button>
    </div>
    <div class="columns" aria-hidden="true"><span>code</span><span>waits for</span><span>share</span><span class="axis"><i id="from">1 min ago</i><i id="to">now</i></span></div>
    <div id="list" role="tree" tabindex="0" aria-labelledby="jobs-title">
      <div id="rows"><canvas id="lanes" aria-hidden="true"></canvas></div>
      <p id="empty" hidden>No such job.</p>
    </div>
    <p id="jobs-found" class="spoken" role="status"></p>
    <p class="legend" id="legend"></p>
    <p id="turn" class="hint" role="status"></p>
  </section>
  <aside>
    <section class="card" id="detail" tabindex="-1" aria-labelledby="detail-title">
      <h2 id="detail-title">Job</h2>
      <p id="job-state" class="spoken" role="status"></p>
      <div id="job"></div>
    </section>
    <section class="card" id="tags" tabindex="-1" aria-labelledby="tags-title">
      <h2 id="tags-title">Tags</h2>
      <ul id="taglist" aria-labelledby="tags-title"></ul>
    </section>
  </aside>`;

function seconds(milliseconds) {
  if (milliseconds === 60000) return "1 min";
  return `${Number((milliseconds / 1000).toPrecision(3))} s`;
}

export class Room {
  constructor(studio, host) {
    this.studio = studio;
    this.jobs = studio.jobs;
    this.selected = 0;
    this.detail = null;
    this.interest = "";
    host.classList.add("beside");
    host.innerHTML = PAGE;
    this.find = (name) => host.querySelector(`#${name}`);
    this.list = new JobList(this.find("list"), this.find("rows"), this.jobs, {
      onSelect: (number) => {
        this.selected = number;
        this.redraw();
      },
      onStop: (number) => this.steer("stop", "job", number),
      onFreeze: (number) => this.steer(this.jobs.rows.get(number)?.frozen ? "unfreeze" : "freeze", "job", number),
    });
    this.lanes = new Lanes(this.find("lanes"), this.list, this.jobs);
    this.side = new Side(this.find("job"), this.find("taglist"), this.jobs, {
      steer: (...what) => this.steer(...what),
      filter: (text) => this.filter(text),
      mayChange: () => studio.mayChange,
    });
    this.legend();
    this.listen();
    this.find("turn").textContent = POINT;
  }

  legend() {
    for (const kind of KINDS) {
      const entry = document.createElement("span");
      const mark = document.createElement("i");
      entry.dataset.kind = kind;
      entry.append(mark, kind);
      this.find("legend").append(entry);
    }
  }

  listen() {
    this.find("filter").addEventListener("input", (event) => this.filter(event.target.value));
    this.find("order").addEventListener("change", (event) => {
      this.list.order = event.target.value;
      this.rearrange();
    });
    this.find("span").addEventListener("change", (event) => {
      this.lanes.span = Number(event.target.value);
      this.redraw();
    });
    this.find("pause").addEventListener("click", () => {
      this.lanes.pause(this.lanes.paused === null);
      this.redraw();
    });
    new LanePointer(this.find("list"), this.find("lanes"), this.lanes, {
      changed: () => this.redraw(),
      told: (text) => set(this.find("turn"), text || POINT),
      selected: () => this.selected,
    });
    this.find("list").addEventListener("scroll", () => {
      this.redraw();
      this.soon();
    });
    window.addEventListener("resize", () => this.rearrange());
  }

  // Which part of the time the lanes show: any that somebody has drawn there.
  tellTime() {
    const { span, paused } = this.lanes;
    const other = this.find("span-other");
    const offered = [...this.find("span").options].find((option) => option !== other && Number(option.value) === span);
    if (!offered) {
      other.value = span;
      set(other, seconds(span));
    }
    other.hidden = Boolean(offered);
    const shown = offered ?? other;
    if (!shown.selected) shown.selected = true;
    const left = paused === null ? 0 : this.jobs.now() - paused;
    set(this.find("from"), `${seconds(span + left)} ago`);
    set(this.find("to"), left ? `${seconds(left)} ago` : "now");
    this.find("pause").setAttribute("aria-pressed", paused !== null);
  }

  show() {
    this.shown = true;
    this.rearrange();
    this.soon();
  }

  hide() {
    this.shown = false;
    this.tellInterest();
  }

  welcome(anew) {
    this.interest = "";
    if (anew) {
      this.selected = 0;
      this.detail = null;
      this.lanes.turn = null;
      this.list.forget();
      set(this.find("turn"), POINT);
    }
    this.rearrange();
  }

  take(message) {
    if (message.type !== "view") return;
    if (message.detail || message.complete) this.detail = message.detail ?? null;
    this.redraw();
    this.soon();
  }

  steer(action, kind, target) {
    this.studio.ask({ type: "steer", action, kind, target });
  }

  filter(text) {
    this.find("filter").value = text;
    this.list.words = text.toLowerCase().split(/\s+/).filter((word) => word);
    this.find("list").scrollTop = 0;
    this.counting = true;
    this.rearrange();
  }

  // The server is told which job is selected, and which ones are in sight.
  tellInterest() {
    const { first, last } = this.list.visible();
    const lines = this.shown ? this.list.lines.slice(first, last) : [];
    const traced = lines.filter((line) => line.job && !line.job.ended).map((line) => line.key);
    const selected = this.shown ? this.selected : 0;
    const next = JSON.stringify({ type: "interest", selected, traced: traced.slice(0, MOST_TRACED) });
    if (next !== this.interest) {
      this.interest = next;
      this.studio.send(JSON.parse(next));
    }
  }

  soon() {
    clearTimeout(this.telling);
    this.telling = setTimeout(() => this.tellInterest(), TELL_AFTER);
  }

  rearrange() {
    this.list.state = "";
    this.redraw();
  }

  redraw() {
    if (this.redrawing || !this.shown) return;
    this.redrawing = true;
    requestAnimationFrame(() => this.draw());
  }

  draw() {
    this.redrawing = false;
    if (!this.shown) return;
    this.list.draw();
    this.lanes.draw();
    this.tellTime();
    this.side.showJob(this.selected, this.detail);
    this.side.showTags(this.list.words);
    this.tellChanges();
    this.find("empty").hidden = this.list.lines.length > 0 || !this.jobs.machine;
    // bench/studio asks when there was something to see, in milliseconds after somebody has gone to the page.
    if (this.list.lines.length) this.find("list").dataset.since ??= Math.round(performance.now());
  }

  // For those who do not see it. How many jobs the filter shows is told once: they come and go.
  tellChanges() {
    const job = this.jobs.rows.get(this.selected);
    set(this.find("job-state"), this.selected && (!job || job.ended) ? "The selected job has ended." : "");
    if (!this.counting) return;
    this.counting = false;
    const count = this.list.lines.filter((line) => line.job).length;
    set(this.find("jobs-found"), this.list.words.length ? `${count.toLocaleString("en")} ${count === 1 ? "job" : "jobs"} shown` : "");
  }
}
