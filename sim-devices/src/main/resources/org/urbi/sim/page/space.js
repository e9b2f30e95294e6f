// The world in three dimensions: bodies, cameras and the rays of distance sensors; a body can be picked in it.
import * as THREE from "./libraries/three.module.js";
import { Orbit } from "./orbit.js";
import { Parts, place } from "./parts.js";

const FINEST = 2;
const PICKED = 0x2f8fff;
const STEEP = 0.2;

export class SpaceView {
  #canvas;
  #redraw;
  #onPick;
  #renderer;
  #scene = new THREE.Scene();
  #camera = new THREE.PerspectiveCamera(45, 1);
  #orbit;
  #parts = new Parts();
  #setting = null;
  #moment = null;
  #bodies = [];
  #eyes = [];
  #rays = [];
  #framed = false;
  #picked = null;
  #box = null;

  // Fails where the browser has no WebGL.
  constructor(canvas, redraw, onPick) {
    this.#canvas = canvas;
    this.#redraw = redraw;
    this.#onPick = onPick;
    // The drawing is kept: who saves the picture wants more than an empty one.
    this.#renderer = new THREE.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.#camera.up.set(0, 0, 1);
    this.#orbit = new Orbit(canvas, this.#camera, redraw);
    canvas.addEventListener("pointerup", (event) => event.button === 0 && this.#orbit.clicked && this.#pickAt(event));
    canvas.addEventListener("keydown", (event) => this.#key(event));
  }

  begin(setting) {
    this.#setting = setting;
    this.#moment = null;
    this.#framed = false;
    this.#unpick();
    this.#scene.clear();
    this.#parts.dispose();
    this.#scene.background = new THREE.Color().setRGB(...setting.background, THREE.SRGBColorSpace);
    const sky = new THREE.HemisphereLight(0xffffff, 0x8a8f98, 1.7);
    sky.position.set(0, 0, 1);
    const sun = new THREE.DirectionalLight(0xffffff, 1.8);
    sun.position.set(-0.5, -0.7, 1.4);
    this.#scene.add(sky, sun);
    this.#bodies = setting.bodies.map((body) => this.#parts.body(body));
    this.#eyes = setting.eyes.map((eye) => this.#parts.eye(eye));
    this.#rays = [];
    for (const object of [...this.#bodies, ...this.#eyes]) this.#scene.add(object);
  }

  take(moment) {
    this.#moment = moment;
  }

  draw() {
    if (!this.#setting || !this.#moment || this.#canvas.hidden) return;
    this.#moment.bodies.forEach((pose, n) => this.#bodies[n] && place(this.#bodies[n], pose));
    this.#moment.eyes.forEach((pose, n) => this.#eyes[n] && place(this.#eyes[n], pose));
    this.#moment.rays.forEach((pose, n) => this.#showRay(n, pose));
    if (!this.#framed) this.#frame();
    this.#fit();
    this.#box?.update();
    this.#renderer.render(this.#scene, this.#camera);
    this.#canvas.dataset.time = this.#moment.time;
  }

  #showRay(n, pose) {
    if (!this.#rays[n]) {
      this.#rays[n] = this.#parts.ray();
      this.#scene.add(this.#rays[n]);
    }
    place(this.#rays[n], pose);
    this.#rays[n].scale.setX(Math.max(1e-3, this.#moment.distances[n] ?? 0));
  }

  #fit() {
    const { clientWidth: width, clientHeight: height } = this.#canvas;
    const ratio = Math.min(FINEST, devicePixelRatio || 1);
    if (this.#canvas.width === Math.floor(width * ratio) && this.#canvas.height === Math.floor(height * ratio)) return;
    this.#renderer.setPixelRatio(ratio);
    this.#renderer.setSize(width, height, false);
    this.#camera.aspect = width / Math.max(1, height);
    this.#camera.updateProjectionMatrix();
  }

  // All that has an end is in view.
  #frame() {
    this.#framed = true;
    const all = new THREE.Box3();
    this.#scene.updateMatrixWorld();
    for (const body of this.#bodies)
      for (const mesh of body.children) if (body.visible && !mesh.userData.endless) all.expandByObject(mesh);
    if (all.isEmpty()) all.set(new THREE.Vector3(-1, -1, 0), new THREE.Vector3(1, 1, 1));
    this.#orbit.frame(all.getCenter(new THREE.Vector3()), Math.max(0.1, all.getSize(new THREE.Vector3()).length()));
  }

  #pickAt(event) {
    const { left, top, width, height } = this.#canvas.getBoundingClientRect();
    const pointer = new THREE.Vector2((2 * (event.clientX - left)) / width - 1, 1 - (2 * (event.clientY - top)) / height);
    const ray = new THREE.Raycaster();
    ray.setFromCamera(pointer, this.#camera);
    const hit = ray.intersectObjects(this.#bodies)[0];
    if (!hit || hit.object.userData.endless) this.#unpick();
    else this.#pick(this.#bodies.indexOf(hit.object.parent), hit.object.parent.worldToLocal(hit.point.clone()));
  }

  // The next one that can move, for who has no pointer.
  #pickNext() {
    const { bodies } = this.#setting;
    for (let i = 1; i <= bodies.length; i++) {
      const n = ((this.#picked?.index ?? -1) + i) % bodies.length;
      if (!bodies[n].fixed) return this.#pick(n, new THREE.Vector3());
    }
  }

  #pick(index, point) {
    this.#unpick();
    this.#picked = { index, point };
    this.#box = new THREE.BoxHelper(this.#bodies[index], PICKED);
    this.#scene.add(this.#box);
    this.#onPick(index);
    this.#redraw();
  }

  #unpick() {
    this.#picked = null;
    this.#box?.removeFromParent();
    this.#box?.dispose();
    this.#box = null;
    this.#onPick(null);
    this.#redraw();
  }

  // For a push of what is picked: which point of it, and the direction away from who looks, along the ground.
  get aim() {
    if (!this.#picked) return null;
    const point = this.#bodies[this.#picked.index].localToWorld(this.#picked.point.clone());
    const direction = this.#camera.getWorldDirection(new THREE.Vector3()).setZ(0);
    if (direction.length() < STEEP) direction.set(0, 1, 0).applyQuaternion(this.#camera.quaternion).setZ(0);
    direction.normalize();
    return { point: point.toArray(), direction: direction.toArray() };
  }

  #key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || !this.#setting) return;
    if (event.key === "Home") {
      this.#framed = false;
      this.#redraw();
    } else if (event.key === "n") this.#pickNext();
    else if (event.key === "Escape") this.#unpick();
    else if (!this.#orbit.key(event.key)) return;
    event.preventDefault();
  }
}
