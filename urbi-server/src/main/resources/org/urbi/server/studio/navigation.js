// Goes from room to room. The address names the one in sight: #name, or #name/path.
import { ROOMS } from "./rooms.js";

function addStyle(file) {
  return new Promise((done) => {
    const link = document.createElement("link");
    link.rel = "stylesheet";
    link.onload = link.onerror = done;
    link.href = file;
    document.head.append(link);
  });
}

export class Navigation {
  constructor(nav, main, studio) {
    this.nav = nav;
    this.main = main;
    this.studio = studio;
    this.open = new Map();
    this.current = null;
    for (const { name, title } of ROOMS) {
      const link = document.createElement("a");
      link.href = `#${name}`;
      link.textContent = title;
      nav.append(link);
    }
    window.addEventListener("hashchange", () => this.follow());
  }

  // Shows the room that the address names, the first one if there is no such room.
  async follow() {
    const [, name, path] = /^#?([^/]*)\/?(.*)$/s.exec(location.hash);
    const entry = ROOMS.find((room) => room.name === name) ?? ROOMS[0];
    this.wanted = entry.name;
    for (const link of this.nav.children) {
      if (link.hash === `#${entry.name}`) link.setAttribute("aria-current", "page");
      else link.removeAttribute("aria-current");
    }
    if (!this.open.has(entry.name)) this.open.set(entry.name, this.make(entry));
    const opened = await this.open.get(entry.name);
    if (this.wanted !== entry.name) return;
    if (!opened) {
      this.open.delete(entry.name);
      this.studio.alert(`The server does not send the room ${entry.title}; try again when it is back.`);
      return;
    }
    if (this.current !== opened) {
      this.current?.host.setAttribute("hidden", "");
      this.current?.room.hide?.();
      this.current = opened;
      opened.host.hidden = false;
      document.title = `${entry.title} – Urbi studio`;
    }
    let plain = path;
    try {
      plain = decodeURIComponent(path);
    } catch {
      // Somebody has typed a lonely per cent sign.
    }
    opened.room.show?.(plain);
  }

  async make({ name, styles = [], load }) {
    try {
      const [{ Room }] = await Promise.all([load(), ...styles.map(addStyle)]);
      const host = document.createElement("div");
      host.className = "room";
      host.dataset.room = name;
      host.hidden = true;
      this.main.append(host);
      const room = new Room(this.studio, host);
      if (this.welcomed) room.welcome?.(true);
      return { host, room };
    } catch (error) {
      console.error(error);
      return null;
    }
  }

  async tell(method, ...what) {
    for (const opened of this.open.values()) (await opened)?.room[method]?.(...what);
  }

  welcome(anew) {
    this.welcomed = true;
    this.tell("welcome", anew);
  }

  take(message) {
    this.tell("take", message);
  }
}
