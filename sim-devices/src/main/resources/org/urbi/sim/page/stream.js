// The connection to the simulation: comes again when it is lost, and lets go while nobody looks, so that no picture is made for that.
const FIRST_WAIT = 500;
const LONGEST_WAIT = 5000;
const HIDDEN_SECONDS = 30;
// The status of the close when nobody is let in, and when there is no place for another one now.
const REFUSED = 4003;
const LATER = 1013;
const LATER_SECONDS = 30;

export class Stream {
  #onText;
  #onImage;
  #onState;
  #socket = null;
  #again = 0;
  #hiding = 0;
  #wait = FIRST_WAIT;
  #resting = false;
  #connections = 0;

  constructor({ onText, onImage, onState }) {
    this.#onText = onText;
    this.#onImage = onImage;
    this.#onState = onState;
    document.addEventListener("visibilitychange", () => {
      clearTimeout(this.#hiding);
      if (document.hidden) this.#hideLater();
      else this.#wake();
    });
    // A page that browsers keep, for the case that somebody comes back to it, looks no longer.
    addEventListener("pagehide", () => this.#rest());
    addEventListener("pageshow", () => this.#wake());
    this.#connect();
    if (document.hidden) this.#hideLater();
  }

  // Whether it could be sent.
  send(order) {
    const open = this.#socket.readyState === WebSocket.OPEN;
    if (open) this.#socket.send(order);
    return open;
  }

  #connect() {
    clearTimeout(this.#again);
    const address = new URL(`stream${query()}`, location.href);
    address.protocol = location.protocol.replace("http", "ws");
    const socket = new WebSocket(address);
    socket.binaryType = "blob";
    // What one says that has been given up is of no interest.
    const ofThis = (act) => (event) => socket === this.#socket && act(event);
    let welcome = false;
    this.#socket = socket;
    socket.onmessage = ofThis(({ data }) => {
      if (!welcome) this.#onState("live", "live", ++this.#connections);
      welcome = true;
      this.#wait = FIRST_WAIT;
      if (typeof data === "string") this.#onText(JSON.parse(data));
      else this.#onImage(data);
    });
    socket.onclose = ofThis((event) => !this.#resting && this.#lost(event));
  }

  #lost({ code, reason }) {
    const told = code === REFUSED || code === LATER;
    this.#onState("lost", told ? reason : "connection lost, trying again…", this.#connections);
    if (code === REFUSED) return;
    this.#again = setTimeout(() => this.#connect(), code === LATER ? LATER_SECONDS * 1000 : this.#wait);
    this.#wait = Math.min(2 * this.#wait, LONGEST_WAIT);
  }

  #hideLater() {
    this.#hiding = setTimeout(() => this.#rest(), HIDDEN_SECONDS * 1000);
  }

  #rest() {
    this.#resting = true;
    clearTimeout(this.#hiding);
    clearTimeout(this.#again);
    this.#socket.close();
    this.#onState("waiting", "resting", this.#connections);
  }

  #wake() {
    if (!this.#resting) return;
    this.#resting = false;
    this.#connect();
  }
}

// As a part of the studio it has the token of the studio. A browser may keep nothing for pages.
function query() {
  try {
    const token = sessionStorage.getItem("token");
    return token ? `?token=${encodeURIComponent(token)}` : "";
  } catch {
    return "";
  }
}

