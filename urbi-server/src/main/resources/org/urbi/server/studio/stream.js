// The connection to the server: connects again when it is lost, and lets go while nobody looks.
const FIRST_WAIT = 300;
const LONGEST_WAIT = 5000;
const HIDDEN_SECONDS = 30;

// The token of the address stays out of sight, and of the history.
function token() {
  const given = new URLSearchParams(location.search).get("token");
  if (given) {
    sessionStorage.setItem("token", given);
    history.replaceState(null, "", location.pathname + location.hash);
  }
  return given ?? sessionStorage.getItem("token");
}

export class Stream {
  constructor({ onMessage, onState }) {
    this.onMessage = onMessage;
    this.onState = onState;
    this.wait = FIRST_WAIT;
    this.connections = 0;
    this.token = token();
    this.connect();
    document.addEventListener("visibilitychange", () => {
      clearTimeout(this.hiding);
      if (document.hidden) this.hiding = setTimeout(() => this.rest(), HIDDEN_SECONDS * 1000);
      else if (this.resting) this.connect();
    });
    // A page that browsers keep, for the case that somebody comes back to it, must not keep its lobby.
    window.addEventListener("pagehide", () => this.rest());
    window.addEventListener("pageshow", () => this.resting && this.connect());
  }

  connect() {
    this.resting = false;
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const query = this.token ? `?token=${encodeURIComponent(this.token)}` : "";
    const socket = new WebSocket(`${scheme}://${location.host}/stream${query}`);
    this.socket = socket;
    this.refused = false;
    socket.onmessage = ({ data }) => {
      const message = JSON.parse(data);
      if (message.type === "hello") {
        this.wait = FIRST_WAIT;
        this.connections++;
        this.onState("live", "live", this.connections);
      } else if (message.type === "refused") {
        this.refused = true;
        this.onState("lost", message.text, this.connections);
      }
      this.onMessage(message);
    };
    socket.onclose = () => {
      if (this.resting || this.refused) return;
      this.onState("lost", "connection lost, trying again…", this.connections);
      setTimeout(() => this.connect(), this.wait);
      this.wait = Math.min(2 * this.wait, LONGEST_WAIT);
    };
  }

  rest() {
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
