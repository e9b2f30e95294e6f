// The connection to the simulation, which makes no pictures for who does not look.
import { Stream } from "./shared/stream.js";

// The status of the close when nobody is let in, and when there is no place for another one now.
const REFUSED = 4003;
const LATER = 1013;
const LATER_SECONDS = 30;

export class WorldStream extends Stream {
  #onText;
  #onImage;
  #welcomed;

  constructor({ onText, onImage, onState }) {
    super(onState);
    this.#onText = onText;
    this.#onImage = onImage;
    this.begin();
  }

  // As a part of the studio it has the token of the studio. A browser may keep nothing for pages.
  query() {
    this.#welcomed = false;
    try {
      const token = sessionStorage.getItem("token");
      return token ? `?token=${encodeURIComponent(token)}` : "";
    } catch {
      return "";
    }
  }

  take(data) {
    if (!this.#welcomed) this.welcome();
    this.#welcomed = true;
    if (typeof data === "string") this.#onText(JSON.parse(data));
    else this.#onImage(data);
  }

  closed({ code, reason }) {
    const told = code === REFUSED || code === LATER;
    if (told) this.refuse(reason, code === LATER ? LATER_SECONDS : 0);
    return told;
  }
}
