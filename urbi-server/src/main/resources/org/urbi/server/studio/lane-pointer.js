// Pointers, fingers and keys on the lanes. Drawn across, they go to earlier times; two fingers, and the wheel with Ctrl, show less or more of
// the time; who points at a lane, or goes from turn to turn of the selected job, is told what happened there.
const LEAST_PIXELS = 6;
const WHEEL = 1.003;
const KEY = 1.5;
const KEY_PART = 0.25;

// How far two places are from each other, in pixels; never nothing.
function distance(one, other) {
  return Math.max(1, Math.hypot(one.x - other.x, one.y - other.y));
}

export class LanePointer {
  // changed(): another part of the time is shown; told(text): what somebody points at; selected(): the number of the selected job.
  constructor(list, canvas, lanes, { changed, told, selected }) {
    Object.assign(this, { list, canvas, lanes, changed, told, selected });
    // Where the fingers, or the mouse, are that have come down.
    this.down = new Map();
    this.drawn = false;
    list.addEventListener("pointerdown", (event) => this.begin(event));
    list.addEventListener("pointermove", (event) => this.move(event));
    list.addEventListener("pointerup", (event) => this.end(event));
    list.addEventListener("pointercancel", (event) => this.end(event));
    list.addEventListener("pointerleave", () => this.down.size || told(""));
    list.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    list.addEventListener("dblclick", (event) => this.inside(event) && this.goOn());
    list.addEventListener("keydown", (event) => this.key(event));
  }

  // The place of an event in the lanes, in pixels.
  place({ clientX, clientY }) {
    const { left, top } = this.canvas.getBoundingClientRect();
    return { x: clientX - left, y: clientY - top };
  }

  inside(event) {
    return this.place(event).x >= 0;
  }

  begin(event) {
    if (event.button !== 0 || !this.inside(event)) return;
    if (!this.down.size) this.drawn = false;
    this.down.set(event.pointerId, this.place(event));
  }

  move(event) {
    // A mouse that was let go elsewhere is not told of here.
    if (!event.buttons) this.down.delete(event.pointerId);
    const from = this.down.get(event.pointerId);
    if (!from) {
      this.tell(event);
      return;
    }
    const to = this.place(event);
    const other = [...this.down.values()].find((each) => each !== from);
    if (!this.drawn && (other ? distance(from, to) : Math.abs(to.x - from.x)) < LEAST_PIXELS) return;
    if (!this.drawn) this.list.setPointerCapture(event.pointerId);
    this.drawn = true;
    this.down.set(event.pointerId, to);
    if (other) this.lanes.zoom(distance(from, other) / distance(to, other), (to.x + other.x) / 2);
    else this.lanes.pan(to.x - from.x);
    this.changed();
  }

  end(event) {
    if (this.down.delete(event.pointerId) && !this.drawn && event.type === "pointerup") this.tell(event);
  }

  wheel(event) {
    if (!this.inside(event)) return;
    if (event.ctrlKey) this.lanes.zoom(WHEEL ** event.deltaY, this.place(event).x);
    else if (Math.abs(event.deltaX) > Math.abs(event.deltaY)) this.lanes.pan(-event.deltaX);
    else return;
    event.preventDefault();
    this.changed();
  }

  goOn() {
    this.lanes.pause(false);
    this.changed();
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const width = this.canvas.clientWidth;
    if (event.key === "+" || event.key === "-") this.lanes.zoom(event.key === "+" ? 1 / KEY : KEY, width / 2);
    else if (event.shiftKey && event.key === "ArrowLeft") this.lanes.pan(KEY_PART * width);
    else if (event.shiftKey && event.key === "ArrowRight") this.lanes.pan(-KEY_PART * width);
    else if (event.key === "," || event.key === ".") this.told(this.lanes.step(this.selected(), event.key === "," ? -1 : 1));
    else return;
    event.preventDefault();
    this.changed();
  }

  tell(event) {
    const { x, y } = this.place(event);
    this.told(x >= 0 ? this.lanes.said(x, y) : "");
  }
}
