// Puts the parts of the studio together.
import { Stream } from "./stream.js";
import { Jobs } from "./jobs.js";
import { JobList } from "./joblist.js";
import { Lanes } from "./lanes.js";
import { Side } from "./side.js";

const ALERT_SECONDS = 8;
const SILENT_SECONDS = 2;
const KINDS = ["running", "time", "event", "condition", "jobs", "lock", "signal", "file", "frozen"];

const byId = (id) => document.getElementById(id);
const jobs = new Jobs();
let selected = 0;
let detail = null;
let asked = 0;
let interest = "";
let redrawing = false;
let alerted;

function alert(text) {
  byId("alert").textContent = text;
  byId("alert").hidden = false;
  clearTimeout(alerted);
  alerted = setTimeout(() => (byId("alert").hidden = true), ALERT_SECONDS * 1000);
}

function steer(action, kind, target) {
  stream.send({ type: "steer", id: ++asked, action, kind, target });
}

function filter(text) {
  byId("filter").value = text;
  list.words = text.toLowerCase().split(/\s+/).filter((word) => word);
  list.state = "";
  byId("list").scrollTop = 0;
  redraw();
}

const list = new JobList(byId("list"), byId("rows"), jobs, {
  onSelect: (number) => {
    selected = number;
    redraw();
  },
  onStop: (number) => steer("stop", "job", number),
  onFreeze: (number) => steer(jobs.rows.get(number)?.frozen ? "unfreeze" : "freeze", "job", number),
});
const lanes = new Lanes(byId("lanes"), list, jobs);
const side = new Side(byId("job"), byId("taglist"), jobs, steer, filter);

// The server is told which job is selected, and which ones are in sight.
function tellInterest() {
  const { first, last } = list.visible();
  const traced = list.lines.slice(first, last).filter((line) => line.job).map((line) => line.key);
  const next = JSON.stringify({ type: "interest", selected, traced: traced.slice(0, 64) });
  if (next !== interest) {
    interest = next;
    stream.send(JSON.parse(next));
  }
}

function draw() {
  redrawing = false;
  list.draw();
  lanes.draw();
  side.showJob(selected, detail);
  side.showTags();
  byId("empty").hidden = list.lines.length > 0 || !jobs.machine;
  byId("count").textContent = jobs.rows.size.toLocaleString("en");
  byId("load").textContent = `${Math.min(100, jobs.load / 10).toFixed(1)} %`;
}

function redraw() {
  if (redrawing) return;
  redrawing = true;
  requestAnimationFrame(draw);
}

let telling;
function soon() {
  clearTimeout(telling);
  telling = setTimeout(tellInterest, 100);
}

function take(message) {
  switch (message.type) {
    case "hello":
      jobs.clear();
      list.state = "";
      interest = "";
      side.mayChange = message.role !== "observer";
      byId("role").hidden = false;
      byId("role").textContent = message.role;
      byId("role").title = side.mayChange ? "" : "An observer sees, and cannot change.";
      break;
    case "view":
      jobs.take(message);
      if (message.detail || message.complete) detail = message.detail ?? null;
      byId("time").textContent = `${(message.time / 1000).toFixed(1)} s`;
      if (byId("connection").dataset.state === "live") byId("connection").textContent = "live";
      soon();
      break;
    case "done":
      if (message.error) alert(message.error);
      break;
    case "error":
    case "refused":
      alert(message.text);
      break;
  }
  redraw();
}

const stream = new Stream({
  onMessage: take,
  onState: (state, text, connections) => {
    byId("connection").dataset.state = state;
    byId("connection").dataset.connections = connections;
    byId("connection").textContent = text;
  },
});

// A kernel that is held cannot answer, which is worth knowing.
setInterval(() => {
  const silent = (performance.now() - jobs.at) / 1000;
  if (byId("connection").dataset.state === "live" && silent > SILENT_SECONDS) {
    byId("connection").textContent = `the kernel has been busy for ${silent.toFixed(0)} s`;
  }
}, 1000);

byId("filter").addEventListener("input", (event) => filter(event.target.value));
byId("order").addEventListener("change", (event) => {
  list.order = event.target.value;
  list.state = "";
  redraw();
});
byId("span").addEventListener("change", (event) => {
  lanes.span = Number(event.target.value);
  byId("from").textContent = `${event.target.selectedOptions[0].textContent} ago`;
  redraw();
});
byId("pause").addEventListener("click", (event) => {
  const on = lanes.paused === null;
  lanes.pause(on);
  event.target.setAttribute("aria-pressed", on);
  redraw();
});
byId("list").addEventListener("scroll", () => {
  redraw();
  soon();
});
window.addEventListener("resize", () => {
  list.state = "";
  redraw();
});

function theme(name) {
  if (name) document.documentElement.dataset.theme = name;
}
theme(localStorage.getItem("theme"));
byId("theme").addEventListener("click", () => {
  const dark = matchMedia("(prefers-color-scheme: dark)").matches;
  const now = document.documentElement.dataset.theme ?? (dark ? "dark" : "light");
  const next = now === "dark" ? "light" : "dark";
  localStorage.setItem("theme", next);
  theme(next);
  redraw();
});

for (const kind of KINDS) {
  const entry = document.createElement("span");
  const mark = document.createElement("i");
  entry.dataset.kind = kind;
  entry.append(mark, kind);
  byId("legend").append(entry);
}
