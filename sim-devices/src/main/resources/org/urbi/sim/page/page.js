// Hands what the simulation sends to the views, and to the simulation what people want of it.
import { CameraView } from "./camera.js";
import { Controls } from "./controls.js";
import { SceneView } from "./scene.js";
import { PlotView } from "./plots.js";
import { WorldStream } from "./stream.js";

const SPEED_SECONDS = 2;
const REFUSAL_SECONDS = 8;

const byId = (id) => document.getElementById(id);
const views = [
  new CameraView(byId("camera"), byId("detection"), byId("sight")),
  new SceneView(byId("scene")),
  new PlotView(byId("plots")),
];
const camera = views[0];
const controls = new Controls(byId, send);
views.push(controls);

let clock = null;
let redrawing = false;
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

function say(state, text, connections) {
  byId("connection").dataset.state = state;
  byId("connection").dataset.connections = connections;
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
  if (!stream.send(order)) refuse("There is no connection to the simulation.");
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

// The colours that somebody has chosen in the studio; without a choice those of the system. A browser may keep nothing for pages.
function theme() {
  let chosen = null;
  try {
    chosen = localStorage.getItem("theme");
  } catch {
    // Then nothing is chosen.
  }
  if (chosen) document.documentElement.dataset.theme = chosen;
  else delete document.documentElement.dataset.theme;
  redraw();
}

const stream = new WorldStream({ onText: take, onImage: (image) => camera.show(image).then(redraw), onState: say });

addEventListener("storage", theme);
addEventListener("resize", redraw);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
theme();
addSpace().catch((error) => console.warn("There is no third dimension in this browser:", error.message));
