// The connection to the server: connects again when it is lost, and lets go while nobody looks.
import { forget, keep, kept } from "./storage.js";

const FIRST_WAIT = 300;
const LONGEST_WAIT = 5000;
const HIDDEN_SECONDS = 30;
// Who was refused for what he has sent may come again after that, in milliseconds.
const LONG_WAIT = 30000;

// The token of the address stays out of sight, and of the history.
function given() {
  const token = new URLSearchParams(location.search).get("token");
  if (token) history.replaceState(null, "", location.pathname + location.hash);
  return token;
}

export class Stream {
  // onMessage(message); onState(state, text, connections); onRefused(): it was not let in.
  constructor({ onMessage, onState, onRefused }) {
    Object.assign(this, { onMessage, onState, onRefused });
    this.wait = FIRST_WAIT;
    this.connections = 0;
    this.token = given() ?? kept("session", "token");
    this.connect();
    document.addEventListener("visibilitychange", () => this.look());
    // A page that was opened in the background has never been in sight.
    if (document.hidden) this.look();
    // A page that browsers keep, for the case that somebody comes back to it, must not keep its lobby.
    window.addEventListener("pagehide", () => this.rest());
    window.addEventListener("pageshow", () => this.resting && this.connect());
  }

  // Somebody looks at the page, or nobody does any more.
  look() {
    clearTimeout(this.hiding);
    if (document.hidden) this.hiding = setTimeout(() => this.rest(), HIDDEN_SECONDS * 1000);
    else if (this.resting) this.connect();
  }

  // Tries another token.
  enter(token) {
    this.token = token;
    this.connect();
  }

  connect() {
    clearTimeout(this.coming);
    this.resting = false;
    this.refused = false;
    this.welcomed = false;
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const query = this.token ? `?token=${encodeURIComponent(this.token)}` : "";
    this.socket?.close();
    const socket = new WebSocket(`${scheme}://${location.host}/stream${query}`);
    this.socket = socket;
    // What an earlier one still has to say is of no interest: not even its end, which may be told late.
    socket.onmessage = ({ data }) => socket === this.socket && this.take(JSON.parse(data));
    socket.onclose = () => socket === this.socket && this.lost();
  }

  take(message) {
    if (message.type === "hello") this.welcome();
    else if (message.type === "refused") this.refuse(message);
    this.onMessage(message);
  }

  welcome() {
    this.welcomed = true;
    this.wait = FIRST_WAIT;
    this.connections++;
    // Only one that has been accepted: the address without a token may be let in where a wrong one is not.
    if (this.token) keep("session", "token", this.token);
    this.onState("live", "live", this.connections);
  }

  // again: in how many seconds it may be let in, if it can be at all.
  refuse({ text, again }) {
    this.refused = true;
    this.onState("lost", text, this.connections);
    if (again) this.comeAgain(again * 1000);
    else if (this.welcomed) this.comeAgain(LONG_WAIT);
    else {
      forget("session", "token");
      this.onRefused();
    }
  }

  lost() {
    if (this.resting || this.refused) return;
    this.onState("lost", "connection lost, trying again…", this.connections);
    this.comeAgain(this.wait);
    this.wait = Math.min(2 * this.wait, LONGEST_WAIT);
  }

  // Connects again after some milliseconds, unless nobody looks by then.
  comeAgain(wait) {
    clearTimeout(this.coming);
    this.coming = setTimeout(() => {
      this.refused = false;
      if (document.hidden) this.rest();
      else this.connect();
    }, wait);
  }

  // A token that was refused is not tried again only because somebody has looked away.
  rest() {
    if (this.refused) return;
    clearTimeout(this.coming);
    this.resting = true;
    this.socket.close();
    this.onState("waiting", "resting", this.connections);
  }

  // Whether it could be sent.
  send(message) {
    const open = this.socket.readyState === WebSocket.OPEN;
    if (open) this.socket.send(JSON.stringify(message));
    return open;
  }
}
