// What is known of the objects that are open, put together from what has changed. A way leads to an object or a slot: the name
// of a lobby, or Global, then a line for each step: ".x" for the slot x, ":0" for the first prototype.
const MOST_LINES = 3000;
// How many objects the server tells of at a time.
const MOST_OBJECTS = 32;
const FORGET_RATE = 3000;

export const shownWay = (way) =>
  way.split("\n").map((step) => (step.startsWith(":") ? `.protos[${step.slice(1)}]` : step)).join("");

export class Objects {
  constructor() {
    this.open = new Set(["Global"]);
    // Those that are open, and of which the server does not tell.
    this.left = new Set();
    this.clear();
  }

  clear() {
    this.roots = ["Global"];
    this.objects = new Map();
    this.now = 0;
  }

  take({ roots, objects }, now) {
    this.now = now;
    this.roots = roots;
    for (const { way, anew, slots, gone, ...facts } of objects) {
      // The server, and nobody else, knows whether it has noticed that the object was closed for a while: then it tells all again.
      const known = anew ? new Map() : this.objects.get(way).slots;
      for (const name of gone) known.delete(name);
      for (const slot of slots) known.set(slot.name, { ...slot, ...this.rate(known.get(slot.name), slot) });
      this.objects.set(way, { ...facts, slots: known });
    }
  }

  // How often a second it is written, as far as this page has seen it.
  rate(before, slot) {
    const seen = this.now;
    const passed = seen - (before?.seen ?? seen);
    return { seen, perSecond: passed > 0 ? (1000 * (slot.times - before.times)) / passed : 0 };
  }

  perSecond(slot) {
    return this.now - slot.seen < FORGET_RATE ? slot.perSecond : 0;
  }

  // The slot at the end of a way; undefined for an object that is none.
  slot(way) {
    const last = way.lastIndexOf("\n.");
    return last < 0 ? undefined : this.objects.get(way.slice(0, last))?.slots.get(way.slice(last + 2));
  }

  // What the server is asked for: the object around the selected slot, which is told of also when that object has been
  // closed, and those that are open and in sight, as many as there is room for.
  wanted(selected, text) {
    const end = selected?.lastIndexOf("\n") ?? -1;
    const around = end > 0 && selected[end + 1] !== "?" ? [selected.slice(0, end)] : [];
    const open = this.lines(text, new Set()).filter((line) => line.opens && this.open.has(line.way));
    const ways = [...new Set([...around, ...open.map((line) => line.way)])];
    this.left = new Set(ways.splice(MOST_OBJECTS));
    return ways;
  }

  // The lines of the tree, with those slots that contain a text, and all objects that are open.
  lines(text, left = this.left) {
    const lines = [];
    const wanted = text.toLowerCase();
    const add = (line) => {
      lines.push(line);
      if (this.open.has(line.way) && line.opens && lines.length < MOST_LINES) below(line.way, line.level + 1);
    };
    const below = (way, level) => {
      const object = this.objects.get(way);
      if (left.has(way)) {
        return void lines.push({ way: `${way}\n?`, name: `not shown: close others, at most ${MOST_OBJECTS} are open at a time`, level });
      }
      if (!object) return;
      if (!object.found) return void lines.push({ way: `${way}\n?`, name: "no longer there", level });
      const slots = [...object.slots.values()].sort((a, b) => a.name.localeCompare(b.name, "en", { numeric: true }));
      for (const slot of slots) {
        const at = `${way}\n.${slot.name}`;
        if (slot.name.toLowerCase().includes(wanted) || this.open.has(at)) {
          add({ way: at, name: slot.name, level, opens: slot.opens, slot });
        }
      }
      if (object.total > slots.length) {
        lines.push({ way: `${way}\n?`, name: `and ${object.total - slots.length} more slots`, level });
      }
      object.protos.forEach((type, i) => add({ way: `${way}\n:${i}`, name: `protos[${i}]`, type, level, opens: true }));
    };
    for (const root of this.roots) add({ way: root, name: root, level: 1, opens: true });
    return lines.slice(0, MOST_LINES);
  }
}
