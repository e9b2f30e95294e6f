// The connection of the studio: it is let in by a token, and told so by its first message.
import { Stream } from "./shared/stream.js";
import { forget, keep, kept } from "./storage.js";

// Who was refused for what he has sent may come again after that.
const LONG_SECONDS = 30;

// The token of the address stays out of sight, and of the history.
function given() {
  const token = new URLSearchParams(location.search).get("token");
  if (token) history.replaceState(null, "", location.pathname + location.hash);
  return token;
}

export class StudioStream extends Stream {
  // onMessage(message); onState(state, text, connections); onRefused(): it was not let in.
  constructor({ onMessage, onState, onRefused }) {
    super(onState);
    Object.assign(this, { onMessage, onRefused });
    this.token = given() ?? kept("session", "token");
    this.begin();
  }

  // Tries another token.
  enter(token) {
    this.token = token;
    this.connect();
  }

  query() {
    this.welcomed = false;
    return this.token ? `?token=${encodeURIComponent(this.token)}` : "";
  }

  take(data) {
    const message = JSON.parse(data);
    if (message.type === "hello") this.welcome();
    else if (message.type === "refused") this.refused(message);
    this.onMessage(message);
  }

  welcome() {
    this.welcomed = true;
    // Only one that has been accepted: the address without a token may be let in where a wrong one is not.
    if (this.token) keep("session", "token", this.token);
    super.welcome();
  }

  // again: in how many seconds it may be let in, if it can be at all.
  refused({ text, again }) {
    this.refuse(text, again || (this.welcomed ? LONG_SECONDS : 0));
    if (again || this.welcomed) return;
    forget("session", "token");
    this.onRefused();
  }
}
