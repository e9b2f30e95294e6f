// The selected slot: what it holds, who writes and reads it; it is changed, plotted, seen and heard here.
import { ago, make, set, withdraw } from "./elements.js";
import { shownWay } from "./objects.js";
import { showMedia } from "./media.js";

const SLIDE_MILLISECONDS = 100;
const STEPS = 200;
// What is shown as it is written in urbiscript, so that it can be changed. A camera is not replaced by a word.
const TYPED = ["Float", "String", "List", "Tuple", "Boolean", "nil", "void"];

const PAGE = `
  <h2 id="slot-title">Slot</h2>
  <p id="slot-hint" class="hint">Choose a slot: by a click, or with the arrow keys. ← and → close and open objects, Enter edits the value, p plots it.</p>
  <div id="slot-facts" hidden>
    <form id="assign">
      <label id="slot-label" for="slot-value">value, in urbiscript</label>
      <div class="buttons"><input id="slot-value" autocomplete="off" autocapitalize="off" spellcheck="false"><button id="slot-set" type="submit">Set</button></div>
      <div id="slot-range" hidden><span></span><input id="slot-slider" type="range" aria-label="The value, between its limits"><span></span></div>
      <p id="slot-result" class="hint" role="status"></p>
    </form>
    <div class="buttons"><button id="slot-plot" type="button" aria-pressed="false">Plot</button></div>
    <dl class="facts" id="slot-list"></dl>
    <div id="slot-media"></div>
  </div>`;

export class Slot {
  constructor(host, studio, plot) {
    this.studio = studio;
    this.plot = plot;
    host.innerHTML = PAGE;
    this.find = (name) => host.querySelector(`#${name}`);
    this.find("assign").addEventListener("submit", (event) => {
      event.preventDefault();
      this.dirty = false;
      this.assign(this.find("slot-value").value);
    });
    this.find("slot-value").addEventListener("input", () => (this.dirty = true));
    this.find("slot-slider").addEventListener("input", () => this.slide());
    this.find("slot-plot").addEventListener("click", () => this.togglePlot());
  }

  show(way, slot, objects) {
    const other = way !== this.way;
    if (other) this.settle();
    this.way = way;
    this.slot = slot;
    this.find("slot-hint").hidden = Boolean(slot);
    withdraw(this.find("slot-facts"), "hidden", !slot);
    set(this.find("slot-title"), way ? shownWay(way) : "Slot");
    if (other) {
      this.dirty = false;
      this.mediaKey = "";
      set(this.find("slot-result"), "");
      this.find("slot-media").replaceChildren();
    }
    if (!slot) return;
    this.showValue(slot, other);
    this.showFacts(slot, objects);
    this.showMedia(slot);
  }

  showValue(slot, other) {
    const typed = slot.number !== null || TYPED.includes(slot.type);
    const may = this.studio.mayChange && !slot.constant && typed;
    const field = this.find("slot-value");
    withdraw(field, "disabled", !may);
    withdraw(this.find("slot-set"), "disabled", !may);
    set(this.find("slot-label"), typed ? "value, in urbiscript" : `${slot.type}: cannot be typed here, code can change it`);
    // What is only a part of the value would be all of it if it were set.
    const whole = typed && !slot.value.includes("…");
    const exact = slot.number === null ? slot.value : String(slot.number);
    field.placeholder = whole ? "" : slot.value || slot.type;
    const typing = this.dirty || document.activeElement === field;
    if (other || !typing) field.value = whole ? exact : "";
    const range = this.find("slot-range");
    withdraw(range, "hidden", slot.number === null || slot.least === null || slot.most === null);
    if (!range.hidden) {
      const slider = this.find("slot-slider");
      slider.disabled = !may;
      slider.min = slot.least;
      slider.max = slot.most;
      slider.step = (slot.most - slot.least) / STEPS || 1;
      // Whoever has a hand on it is not to be hindered by a motor that lags behind.
      const held = this.position || slider.matches(":active, :focus");
      if (other || !held) slider.value = slot.number;
      set(range.firstElementChild, String(slot.least));
      set(range.lastElementChild, String(slot.most));
    }
    const plotted = this.plot.has(this.way);
    this.find("slot-plot").disabled = slot.number === null && !plotted;
    this.find("slot-plot").setAttribute("aria-pressed", plotted);
  }

  showFacts(slot, objects) {
    const facts = [["value", slot.value], ["type", slot.type]];
    if (slot.constant) facts.push(["constant", "cannot be assigned"]);
    if (slot.least !== null || slot.most !== null) facts.push(["range", `${slot.least ?? "…"} to ${slot.most ?? "…"}`]);
    if (slot.variable) {
      facts.push(["written", `${slot.times.toLocaleString("en")} ×, ${objects.perSecond(slot).toFixed(1)} per s`]);
      facts.push(["last", ago(slot.last, objects.now)], ["owner", slot.owner || "none"]);
    }
    facts.push(["read by", slot.readers.join("; ") || "no condition"]);
    const list = this.find("slot-list");
    while (list.children.length > 2 * facts.length) list.lastElementChild.remove();
    facts.forEach(([name, value], i) => {
      if (!list.children[2 * i]) list.append(make("dt"), make("dd"));
      set(list.children[2 * i], name);
      set(list.children[2 * i + 1], value);
    });
  }

  async showMedia(slot) {
    const key = slot.media ? `${this.way} ${slot.value} ${slot.times}` : "";
    if (key === this.mediaKey || this.asking) return;
    this.mediaKey = key;
    const box = this.find("slot-media");
    if (!key) return box.replaceChildren();
    const { way } = this;
    this.asking = true;
    const answer = await this.studio.ask({ type: "show", way });
    this.asking = false;
    if (way === this.way) showMedia(box, slot.media, shownWay(way), answer);
  }

  edit() {
    if (!this.studio.mayChange) this.studio.alert(this.studio.limit);
    this.find("slot-value").focus();
    this.find("slot-value").select();
  }

  togglePlot() {
    if (!this.slot || this.find("slot-plot").disabled) return;
    this.plot.toggle(this.way);
    this.find("slot-plot").setAttribute("aria-pressed", this.plot.has(this.way));
  }

  // Not more often than a server should be asked; the last position counts, and is for the slot that was selected then.
  slide() {
    this.position = { way: this.way, value: this.find("slot-slider").value };
    this.sliding ??= setTimeout(() => this.settle(), SLIDE_MILLISECONDS);
  }

  settle() {
    const { position } = this;
    clearTimeout(this.sliding);
    this.sliding = this.position = null;
    if (position) this.assign(position.value, position.way);
  }

  async assign(value, way = this.way) {
    const { error } = await this.studio.ask({ type: "assign", way, value }, { quiet: true });
    if (way !== this.way) {
      if (error) this.studio.alert(error);
      return;
    }
    // The slider is where somebody has left it: what was refused must not seem to be there.
    if (error && this.slot && this.slot.number !== null) this.find("slot-slider").value = this.slot.number;
    set(this.find("slot-result"), error || "It was assigned.");
    this.find("slot-result").classList.toggle("bad", Boolean(error));
  }
}
