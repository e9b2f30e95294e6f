// The room of the reactions and events: what waits for what, how often it has happened, when last; events are emitted here.
import { Items, ago, make, set, withdraw } from "./elements.js";

const ASK_AFTER = 150;

const PAGE = `
  <section class="card" aria-labelledby="reactions-title">
    <div class="bar">
      <h2 id="reactions-title">Reactions</h2>
      <input id="reaction-filter" type="search" placeholder="filter: at, every, a name…" aria-label="Show only reactions and events with this text">
      <label><span>order</span>
        <select id="reaction-order"><option value="number">oldest first</option><option value="last">latest first</option><option value="times">most often first</option></select>
      </label>
      <span id="reaction-total" class="hint" role="status"></span>
    </div>
    <p id="reactions-found" class="spoken" role="status"></p>
    <div class="scroll" role="group" tabindex="0" aria-label="Reactions, as a table">
      <table id="reaction-table" aria-labelledby="reactions-title">
        <thead><tr><th scope="col">code</th><th scope="col">has read</th><th scope="col" class="number">times</th><th scope="col" class="number">last</th></tr></thead>
        <tbody></tbody>
      </table>
      <p id="no-reactions" class="hint" hidden>Nothing reacts to anything: there is no at, whenever, every or watch.</p>
    </div>
  </section>
  <aside>
    <section class="card" aria-labelledby="events-title">
      <h2 id="events-title">Events</h2>
      <p id="event-total" class="hint" role="status"></p>
      <ul id="event-list" aria-labelledby="events-title"></ul>
      <p id="no-events" class="hint" hidden>There is no event in a lobby, in Global, or in an object there, and none that is waited for.</p>
    </section>
    <form class="card" id="emission" aria-labelledby="emission-title">
      <h2 id="emission-title">Emit</h2>
      <p id="emission-event" class="hint">Choose an event.</p>
      <label for="payload">payload, in urbiscript</label>
      <input id="payload" autocomplete="off" autocapitalize="off" spellcheck="false" placeholder='1, "two", [3, 4]'>
      <div class="buttons"><button id="emit" type="submit">Emit</button></div>
      <p id="emission-result" class="hint" role="status"></p>
    </form>
  </aside>`;

const found = (count, what) => `${count.toLocaleString("en")} ${what}${count === 1 ? "" : "s"}`;
const cut = (shown, all) => (shown < all ? `${shown.toLocaleString("en")} of ${all.toLocaleString("en")}: the filter finds the others` : "");

export class Room {
  constructor(studio, host) {
    this.studio = studio;
    this.rows = new Map();
    this.events = new Map();
    this.total = { reactions: 0, events: 0 };
    this.text = "";
    this.order = "number";
    this.now = 0;
    host.classList.add("beside");
    host.innerHTML = PAGE;
    this.find = (name) => host.querySelector(`#${name}`);
    this.lines = new Items(host.querySelector("tbody"), (row) => row.number, () => this.newRow(), (line, row) => this.fillRow(line, row));
    this.eventItems = new Items(this.find("event-list"), (event) => event.number, () => this.newEvent(), (item, event) => this.fillEvent(item, event));
    this.find("reaction-filter").addEventListener("input", (event) => {
      this.text = event.target.value;
      clearTimeout(this.asking);
      this.asking = setTimeout(() => this.ask(), ASK_AFTER);
    });
    this.find("reaction-order").addEventListener("change", (event) => {
      this.order = event.target.value;
      this.draw();
    });
    this.find("emission").addEventListener("submit", (event) => {
      event.preventDefault();
      this.emit();
    });
    this.draw();
  }

  show() {
    this.shown = true;
    this.ask();
  }

  hide() {
    this.shown = false;
    this.studio.send({ type: "reactions" });
  }

  welcome(anew) {
    this.rows.clear();
    this.events.clear();
    if (anew) {
      this.chosen = null;
      this.find("emission-result").textContent = "";
    }
    if (this.shown) this.ask();
    this.draw();
  }

  ask() {
    this.studio.send({ type: "reactions", filter: this.text });
  }

  take(message) {
    if (message.type !== "view" || !message.reactions) return;
    const { anew, total, rows, gone, eventTotal, events, eventsGone } = message.reactions;
    // The server, and nobody else, knows whether it has noticed that nobody looked for a while: then it tells all again.
    if (anew) {
      this.rows.clear();
      this.events.clear();
    }
    this.now = message.time;
    this.total = { reactions: total, events: eventTotal };
    for (const number of gone) this.rows.delete(number);
    for (const row of rows) this.rows.set(row.number, row);
    for (const number of eventsGone) this.events.delete(number);
    for (const event of events) this.events.set(event.number, event);
    if (this.shown) this.draw();
  }

  async emit() {
    const event = this.events.get(this.chosen);
    if (!event) return;
    const result = this.find("emission-result");
    result.textContent = "…";
    const { error } = await this.studio.ask(
      { type: "emit", event: event.number, payload: this.find("payload").value },
      { quiet: true },
    );
    result.textContent = error || `${event.name} was emitted.`;
    result.classList.toggle("bad", Boolean(error));
  }

  draw() {
    const keys = { number: (row) => row.number, last: (row) => -row.last, times: (row) => -row.times };
    const key = keys[this.order];
    const rows = [...this.rows.values()].sort((a, b) => key(a) - key(b) || a.number - b.number);
    this.lines.show(rows);
    const events = [...this.events.values()].sort((a, b) => a.name.localeCompare(b.name) || a.number - b.number);
    this.eventItems.show(events);
    set(this.find("reaction-total"), cut(rows.length, this.total.reactions));
    set(this.find("event-total"), cut(events.length, this.total.events));
    this.find("no-reactions").hidden = rows.length > 0 || Boolean(this.text);
    this.find("no-events").hidden = events.length > 0 || Boolean(this.text);
    const chosen = this.events.get(this.chosen);
    this.find("emission-event").textContent = chosen ? chosen.name : "Choose an event.";
    for (const name of ["emit", "payload"]) withdraw(this.find(name), "disabled", !chosen || !this.studio.mayChange);
    set(this.find("reactions-found"), this.text && `${found(this.total.reactions, "reaction")}, ${found(this.total.events, "event")} found`);
  }

  newRow() {
    const line = make("tr");
    const what = make("th", "", { scope: "row" });
    what.append(make("span", "", { className: "code" }), make("span", "", { className: "place" }), make("span", "", { className: "reads" }));
    line.append(what, make("td"), make("td", "", { className: "number" }), make("td", "", { className: "number" }));
    return line;
  }

  fillRow(line, row) {
    const [what, read, times, last] = line.children;
    const tags = row.tags.map((number) => this.studio.jobs.tags.get(number)?.name).filter((name) => name && name !== row.lobby);
    const state = row.frozen ? " · frozen" : "";
    set(what.children[0], row.code || row.kind);
    set(what.children[1], [row.place, row.lobby, ...tags].filter((part) => part).join(" · ") + state);
    const names = row.read.join(", ");
    set(read, names);
    // Where there is no room for that column.
    set(what.children[2], names && `has read ${names}`);
    set(times, row.times.toLocaleString("en"));
    set(last, ago(row.last, this.now));
    line.classList.toggle("frozen", row.frozen);
    this.flash(line, row.times);
  }

  newEvent() {
    const item = make("li");
    const name = make("button", "", { type: "button", className: "eventname" });
    name.addEventListener("click", () => {
      this.chosen = Number(item.dataset.number);
      this.draw();
      if (this.studio.mayChange) this.find("payload").focus();
    });
    item.append(name, make("span", "", { className: "of" }));
    return item;
  }

  fillEvent(item, event) {
    const [name, facts] = item.children;
    item.dataset.number = event.number;
    item.dataset.event = event.name;
    set(name, event.name);
    name.setAttribute("aria-pressed", event.number === this.chosen);
    const listeners = `${event.listeners} ${event.listeners === 1 ? "listener" : "listeners"}`;
    set(facts, event.times ? `${listeners}, ${event.times.toLocaleString("en")} ×, ${ago(event.last, this.now)}` : `${listeners}, never emitted`);
    this.flash(item, event.times);
  }

  // What happens right now lights up.
  flash(element, times) {
    const before = element.dataset.times;
    element.dataset.times = times;
    if (before === undefined || Number(before) === times) return;
    element.classList.remove("flash");
    requestAnimationFrame(() => element.classList.add("flash"));
  }
}
