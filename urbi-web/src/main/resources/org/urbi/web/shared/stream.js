// The connection of a page to its server: comes again when it is lost, and lets go while nobody looks. All pages have this one;
// how somebody is let in, and what is said, is their own.
const FIRST_WAIT = 300;
const LONGEST_WAIT = 5000;
const HIDDEN_SECONDS = 30;

export class Stream {
  #onState;
  #socket = null;
  #hiding = 0;
  #coming = 0;
  #wait = FIRST_WAIT;
  #resting = false;
  #refused = false;
  #connections = 0;

  // onState(state, text, connections): what becomes of it, the state being "live", "lost" or "waiting".
  constructor(onState) {
    this.#onState = onState;
  }

  // What a page has of its own: what stands behind the address, what it does with a message, and with the end of the
  // connection (whether that was all there is to do).
  query() {
    return "";
  }
  take() {}
  closed() {
    return false;
  }

  // Connects for the first time.
  begin() {
    this.connect();
    document.addEventListener("visibilitychange", () => this.#look());
    // A page that was opened in the background has never been in sight.
    if (document.hidden) this.#look();
    // A page that browsers keep, for the case that somebody comes back to it, looks no longer.
    window.addEventListener("pagehide", () => this.#rest());
    window.addEventListener("pageshow", () => this.#resting && this.connect());
  }

  connect() {
    clearTimeout(this.#coming);
    this.#resting = this.#refused = false;
    const address = new URL(`stream${this.query()}`, location.href);
    address.protocol = location.protocol.replace("http", "ws");
    this.#socket?.close();
    const socket = new WebSocket(address);
    this.#socket = socket;
    // What an earlier one still has to say is of no interest: not even its end, which may be told late.
    const ofThis = (act) => (event) => socket === this.#socket && act(event);
    socket.onmessage = ofThis(({ data }) => this.take(data));
    socket.onclose = ofThis((event) => this.#lost(event));
  }

  // It has been let in.
  welcome() {
    this.#wait = FIRST_WAIT;
    this.#onState("live", "live", ++this.#connections);
  }

  // It is not let in, or not any more; it comes again after some seconds, of itself only if there are any.
  refuse(text, seconds) {
    this.#refused = true;
    this.#onState("lost", text, this.#connections);
    if (seconds) this.#comeAgain(seconds * 1000);
  }

  // Whether it could be sent.
  send(text) {
    const open = this.#socket.readyState === WebSocket.OPEN;
    if (open) this.#socket.send(text);
    return open;
  }

  #lost(event) {
    if (this.#resting || this.#refused || this.closed(event)) return;
    this.#onState("lost", "connection lost, trying again…", this.#connections);
    this.#comeAgain(this.#wait);
    this.#wait = Math.min(2 * this.#wait, LONGEST_WAIT);
  }

  // Connects again after some milliseconds, unless nobody looks by then.
  #comeAgain(wait) {
    clearTimeout(this.#coming);
    this.#coming = setTimeout(() => {
      this.#refused = false;
      if (document.hidden) this.#rest();
      else this.connect();
    }, wait);
  }

  // Somebody looks at the page, or nobody does any more.
  #look() {
    clearTimeout(this.#hiding);
    if (document.hidden) this.#hiding = setTimeout(() => this.#rest(), HIDDEN_SECONDS * 1000);
    else if (this.#resting) this.connect();
  }

  // Who was refused does not come again only because somebody has looked away.
  #rest() {
    if (this.#refused) return;
    clearTimeout(this.#coming);
    this.#resting = true;
    this.#socket.close();
    this.#onState("waiting", "resting", this.#connections);
  }
}
