// Connects to the simulation, hands what it sends to the views, and connects again when it has lost it.
import { CameraView } from "./camera.js";
import { Controls } from "./controls.js";
import { SceneView } from "./scene.js";
import { PlotView } from "./plots.js";

const FIRST_WAIT = 500;
const LONGEST_WAIT = 5000;
const SPEED_SECONDS = 2;
const REFUSAL_SECONDS = 8;
// The status of the close when the studio lets nobody in.
const REFUSED = 4003;

const byId = (id) => document.getElementById(id);
const views = [
  new CameraView(byId("camera"), byId("detection"), byId("sight")),
  new SceneView(byId("scene")),
  new PlotView(byId("plots")),
];
const camera = views[0];
const controls = new Controls(byId, send);
views.push(controls);

let wait = FIRST_WAIT;
let clock = null;
let redrawing = false;
let connections = 0;
let stream = null;
let setting = null;
let moment = null;
let refused;

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

// How much faster than the clock on the wall the simulation goes, over the last seconds in which nobody halted it or gave it another
// speed. The first moment of which a page is told may be the last one that somebody else has seen, long ago.
function showTime({ time, paused, speed }) {
  const now = performance.now() / 1000;
  // Who halts a world goes on in steps of milliseconds.
  byId("time").textContent = `${time.toFixed(paused ? 3 : 1)} s`;
  if (!moment) return;
  if (paused || time < clock?.time || speed !== clock?.speed) {
    clock = paused ? null : { now, time, speed };
    byId("speed").textContent = "–";
  } else if (now - clock.now > SPEED_SECONDS) {
    byId("speed").textContent = `× ${((time - clock.time) / (now - clock.now)).toFixed(2)}`;
    clock = { now, time, speed };
  }
}

function take(message) {
  switch (message.type) {
    case "may":
      controls.may(message.text);
      break;
    case "setting":
      setting = message;
      moment = null;
      document.title = `${message.title} – simulation`;
      byId("title").textContent = message.title;
      byId("engine").textContent = message.engine;
      clock = null;
      for (const view of views) view.begin(message);
      break;
    case "moment":
      showTime(message);
      moment = message;
      for (const view of views) view.take(message);
      break;
    case "refusal":
      refuse(message.text);
      break;
    case "trouble":
      camera.trouble(message.text);
      break;
  }
  redraw();
}

// Tells the simulation what somebody wants of it.
function send(order) {
  if (stream?.readyState === WebSocket.OPEN) stream.send(order);
  else refuse("There is no connection to the simulation.");
}

function refuse(text) {
  byId("refusal").textContent = text;
  byId("refusal").hidden = false;
  clearTimeout(refused);
  refused = setTimeout(() => (byId("refusal").hidden = true), REFUSAL_SECONDS * 1000);
}

// The third dimension is large, and not everywhere to be had: everything else is there before it, and without it.
async function addSpace() {
  const { SpaceView } = await import("./space.js");
  const space = new SpaceView(byId("space"), redraw, (picked) => controls.pick(picked));
  if (setting) space.begin(setting);
  if (moment) space.take(moment);
  views.push(space);
  controls.use(space);
  const flat = (wanted) => {
    byId("scene").hidden = !wanted;
    byId("space").hidden = byId("hint").hidden = wanted;
    byId("flat").setAttribute("aria-pressed", wanted);
    redraw();
  };
  byId("flat").disabled = false;
  byId("flat").addEventListener("click", () => flat(byId("scene").hidden));
  byId("space").addEventListener("webglcontextlost", () => flat(true));
  flat(false);
}

function connect() {
  // As a part of the studio it has the token of the studio, and its colours.
  const token = sessionStorage.getItem("token");
  const address = new URL(token ? `stream?token=${encodeURIComponent(token)}` : "stream", location.href);
  address.protocol = location.protocol.replace("http", "ws");
  stream = new WebSocket(address);
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
  stream.onclose = ({ code, reason }) => {
    if (code === REFUSED) {
      say("lost", reason);
      return;
    }
    say("lost", "connection lost, trying again…");
    setTimeout(connect, wait);
    wait = Math.min(2 * wait, LONGEST_WAIT);
  };
}

function theme() {
  const chosen = localStorage.getItem("theme");
  if (chosen) document.documentElement.dataset.theme = chosen;
  redraw();
}

// A page that browsers keep, for the case that somebody comes back to it, looks no longer.
addEventListener("pagehide", () => stream.close());

addEventListener("storage", theme);
addEventListener("resize", redraw);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
theme();
connect();
addSpace().catch((error) => console.warn("There is no third dimension in this browser:", error.message));
