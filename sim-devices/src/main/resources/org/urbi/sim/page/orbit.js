// From where the world is seen: people turn, move and zoom the view of a point by pointer and keys.
import { Vector3 } from "./libraries/three.module.js";

const TURN = 0.006;
const KEY_TURN = 0.1;
const ZOOM = 0.0012;
const KEY_ZOOM = 0.85;
const STEEPEST = Math.PI / 2 - 0.01;
const CLICK_PIXELS = { mouse: 4, touch: 14 };

export class Orbit {
  #canvas;
  #camera;
  #changed;
  #target = new Vector3();
  #azimuth = -2.2;
  #elevation = 0.55;
  #distance = 4;
  #size = 2;
  #pointers = new Map();
  #travelled = 0;
  #unsteady = CLICK_PIXELS.mouse;

  constructor(canvas, camera, changed) {
    this.#canvas = canvas;
    this.#camera = camera;
    this.#changed = changed;
    canvas.addEventListener("pointerdown", (event) => this.#down(event));
    canvas.addEventListener("pointermove", (event) => this.#move(event));
    for (const end of ["pointerup", "pointercancel"])
      canvas.addEventListener(end, (event) => this.#pointers.delete(event.pointerId));
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
  }

  // Has something of that size in view.
  frame(centre, size) {
    this.#target.copy(centre);
    this.#size = size;
    this.#distance = 1.08 * size;
    this.#apply();
  }

  // Whether the pointer has hardly moved since it was pressed; a finger is less steady than a mouse.
  get clicked() {
    return this.#travelled < this.#unsteady;
  }

  #apply() {
    this.#elevation = Math.min(STEEPEST, Math.max(-STEEPEST, this.#elevation));
    this.#distance = Math.min(20 * this.#size, Math.max(0.02 * this.#size, this.#distance));
    const flat = Math.cos(this.#elevation);
    const offset = new Vector3(flat * Math.cos(this.#azimuth), flat * Math.sin(this.#azimuth), Math.sin(this.#elevation));
    this.#camera.position.copy(this.#target).addScaledVector(offset, this.#distance);
    this.#camera.lookAt(this.#target);
    this.#camera.near = this.#distance / 200;
    this.#camera.far = this.#distance * 4 + 20 * this.#size;
    this.#camera.updateProjectionMatrix();
    this.#canvas.dataset.distance = this.#distance;
    this.#changed();
  }

  #down(event) {
    this.#canvas.focus();
    this.#canvas.setPointerCapture(event.pointerId);
    this.#pointers.set(event.pointerId, [event.clientX, event.clientY]);
    this.#travelled = 0;
    this.#unsteady = CLICK_PIXELS[event.pointerType] ?? CLICK_PIXELS.mouse;
  }

  #move(event) {
    const last = this.#pointers.get(event.pointerId);
    if (!last) return;
    const [dx, dy] = [event.clientX - last[0], event.clientY - last[1]];
    this.#travelled += Math.hypot(dx, dy);
    if (this.#pointers.size > 1) this.#pinch(event);
    else if (event.buttons > 1 || event.shiftKey) this.#shift(dx, dy);
    else {
      this.#azimuth -= dx * TURN;
      this.#elevation += dy * TURN;
    }
    this.#pointers.set(event.pointerId, [event.clientX, event.clientY]);
    this.#apply();
  }

  // Two fingers: what is between them grows as they part.
  #pinch(event) {
    const span = () => {
      const [[ax, ay], [bx, by]] = [...this.#pointers.values()];
      return Math.hypot(ax - bx, ay - by);
    };
    const before = span();
    this.#pointers.set(event.pointerId, [event.clientX, event.clientY]);
    if (span() > 0) this.#distance *= before / span();
  }

  // What is below the pointer stays there.
  #shift(dx, dy) {
    const perPixel = (2 * this.#distance * Math.tan((this.#camera.fov * Math.PI) / 360)) / this.#canvas.clientHeight;
    const { elements } = this.#camera.matrixWorld;
    this.#target.addScaledVector(new Vector3(elements[0], elements[1], elements[2]), -dx * perPixel);
    this.#target.addScaledVector(new Vector3(elements[4], elements[5], elements[6]), dy * perPixel);
  }

  #wheel(event) {
    event.preventDefault();
    this.#distance *= Math.exp(event.deltaY * ZOOM);
    this.#apply();
  }

  // Whether it was a key for the view.
  key(key) {
    if (key === "ArrowLeft") this.#azimuth -= KEY_TURN;
    else if (key === "ArrowRight") this.#azimuth += KEY_TURN;
    else if (key === "ArrowUp") this.#elevation += KEY_TURN;
    else if (key === "ArrowDown") this.#elevation -= KEY_TURN;
    else if (key === "+") this.#distance *= KEY_ZOOM;
    else if (key === "-") this.#distance /= KEY_ZOOM;
    else return false;
    this.#apply();
    return true;
  }
}
