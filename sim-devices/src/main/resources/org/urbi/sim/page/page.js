// Connects to the simulation, hands what it sends to the three views, and connects again when it
// has lost it.
import { CameraView } from "./camera.js";
import { SceneView } from "./scene.js";
import { PlotView } from "./plots.js";

const FIRST_WAIT = 500;
const LONGEST_WAIT = 5000;
const SPEED_SECONDS = 2;

const byId = (id) => document.getElementById(id);
const views = [
  new CameraView(byId("camera"), byId("detection"), byId("sight")),
  new SceneView(byId("scene")),
  new PlotView(byId("plots")),
];
const camera = views[0];

let wait = FIRST_WAIT;
let clock = null;
let redrawing = false;
let connections = 0;

function redraw() {
  if (redrawing) return;
  redrawing = true;
  requestAnimationFrame(() => {
    redrawing = false;
    for (const view of views) view.draw();
  });
}

function say(state, text) {
  byId("connection").dataset.state = state;
  byId("connection").textContent = text;
}

// How much faster than the clock on the wall the simulation goes, over the last seconds.
function showTime(time) {
  const now = performance.now() / 1000;
  if (!clock || time < clock.time) clock = { now, time };
  byId("time").textContent = `${time.toFixed(1)} s`;
  if (now - clock.now > SPEED_SECONDS) {
    byId("speed").textContent = `× ${((time - clock.time) / (now - clock.now)).toFixed(2)}`;
    clock = { now, time };
  }
}

function take(message) {
  switch (message.type) {
    case "setting":
      document.title = `${message.title} – simulation`;
      byId("title").textContent = message.title;
      byId("engine").textContent = message.engine;
      clock = null;
      for (const view of views) view.begin(message);
      break;
    case "moment":
      showTime(message.time);
      for (const view of views) view.take(message);
      break;
    case "trouble":
      camera.trouble(message.text);
      break;
  }
  redraw();
}

function connect() {
  const stream = new WebSocket(`ws://${location.host}/stream`);
  stream.binaryType = "blob";
  stream.onopen = () => {
    wait = FIRST_WAIT;
    byId("connection").dataset.connections = ++connections;
    say("live", "live");
  };
  stream.onmessage = ({ data }) => {
    if (typeof data === "string") take(JSON.parse(data));
    else camera.show(data).then(redraw);
  };
  stream.onclose = () => {
    say("lost", "connection lost, trying again…");
    setTimeout(connect, wait);
    wait = Math.min(2 * wait, LONGEST_WAIT);
  };
}

addEventListener("resize", redraw);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
connect();
