// Puts the parts of the studio together: the connection, what is known of the jobs, the rooms.
import { set, withdraw } from "./elements.js";
import { StudioStream } from "./stream.js";
import { Jobs } from "./jobs.js";
import { Navigation } from "./navigation.js";
import { chooseTheme } from "./theme.js";

const ALERT_SECONDS = 8;
const SILENT_SECONDS = 2;
// What whoever may not do everything is told.
const LIMITED = {
  observer: "You are an observer, who sees and cannot change.",
  user: "You are a user, who cannot change what belongs to the system or to others.",
};

const byId = (id) => document.getElementById(id);
const questions = new Map();
let asked = 0;
let alerted;
// Which server it was last.
let known;
// How many bytes the server takes at once.
let longest = Infinity;

// What rooms have of the studio.
const studio = {
  jobs: new Jobs(),
  // The role that the server has given to this page, whether it may change anything, and what it is told of that.
  role: "",
  mayChange: false,
  limit: "",
  // The keywords of urbiscript.
  keywords: [],
  // The simulated worlds whose pages can be shown: name and title.
  worlds: [],
  // The file to which variables are recorded, and those that can be downloaded, as the server has told last.
  recording: { type: "recording", file: "", finished: [] },

  // Tells the server something that it does not answer; while there is no connection that is of no use.
  send(message) {
    const text = JSON.stringify(message);
    const reason = tooLong(text);
    if (reason) studio.alert(reason);
    else stream.send(text);
  },

  // Asks the server: a promise of its answer, the message "done" of that number. People are told when the answer is an error,
  // unless who asks does that (quiet). The number is told when it is sent.
  ask(message, { quiet = false, sent = () => {} } = {}) {
    const id = ++asked;
    sent(id);
    const answer = new Promise((tell) => questions.set(id, { tell, quiet }));
    const text = JSON.stringify({ ...message, id });
    const reason = tooLong(text);
    if (reason) resolve(id, reason);
    else if (!stream.send(text)) resolve(id, "There is no connection to the server.");
    return answer;
  },

  alert(text) {
    byId("alert").textContent = text;
    byId("alert").hidden = false;
    clearTimeout(alerted);
    alerted = setTimeout(() => (byId("alert").hidden = true), ALERT_SECONDS * 1000);
  },

  go: (name, path = "") => (location.hash = path ? `${name}/${encodeURIComponent(path)}` : name),
};

// Why a text cannot be sent: the server would end the connection.
function tooLong(text) {
  const size = new TextEncoder().encode(text).length;
  return size <= longest ? "" : `This is too long: ${size.toLocaleString("en")} bytes, at most ${longest.toLocaleString("en")} can be sent at once.`;
}

function resolve(id, error, message = { error }) {
  const question = questions.get(id);
  questions.delete(id);
  question?.tell(message);
  if (error && !question?.quiet) studio.alert(error);
}

const navigation = new Navigation(byId("nav"), byId("rooms"), studio);

function welcome({ role, keywords, instance, longest: most }) {
  longest = most;
  const anew = instance !== known;
  known = instance;
  studio.role = role;
  studio.keywords = keywords;
  studio.mayChange = role !== "observer";
  studio.limit = LIMITED[role] ?? "";
  if (anew) studio.jobs.clear();
  else studio.jobs.again();
  for (const id of [...questions.keys()]) resolve(id, "The connection was lost before the answer came.");
  byId("role").hidden = false;
  byId("role").textContent = role;
  byId("limit").hidden = !studio.limit;
  byId("limit").textContent = studio.limit;
  withdraw(byId("entry"), "hidden", true);
  navigation.welcome(anew);
}

function take(message) {
  switch (message.type) {
    case "hello":
      welcome(message);
      break;
    case "view":
      studio.jobs.take(message);
      byId("time").textContent = `${(message.time / 1000).toFixed(1)} s`;
      byId("count").textContent = studio.jobs.count.toLocaleString("en");
      byId("load").textContent = `${Math.min(100, studio.jobs.load / 10).toFixed(1)} %`;
      if (byId("connection").dataset.state === "live") tellBusy(0);
      break;
    case "worlds":
      studio.worlds = message.worlds;
      break;
    case "recording":
      studio.recording = message;
      break;
    case "done":
      resolve(message.id, message.error, message);
      break;
    case "error":
    case "refused":
      studio.alert(message.text);
      break;
  }
  navigation.take(message);
}

const stream = new StudioStream({
  onMessage: take,
  onState: (state, text, connections) => {
    byId("connection").dataset.state = state;
    byId("connection").dataset.connections = connections;
    set(byId("connection-text"), text);
    set(byId("busy"), "");
  },
  // Another token may be let in.
  onRefused: () => {
    byId("entry").hidden = false;
  },
});

byId("entry").addEventListener("submit", (event) => {
  event.preventDefault();
  const token = byId("token").value.trim();
  byId("token").value = "";
  if (token) stream.enter(token);
});

// A kernel that is held cannot answer, which is worth knowing. That is read aloud once, and not each second.
function tellBusy(silent) {
  const busy = silent > SILENT_SECONDS;
  set(byId("connection-text"), busy ? "the kernel is busy" : "live");
  set(byId("busy"), busy ? ` for ${silent.toFixed(0)} s` : "");
}

setInterval(() => {
  const silent = (performance.now() - studio.jobs.at) / 1000;
  if (byId("connection").dataset.state === "live" && silent > SILENT_SECONDS) tellBusy(silent);
}, 1000);

chooseTheme(byId("theme"));

navigation.follow();
