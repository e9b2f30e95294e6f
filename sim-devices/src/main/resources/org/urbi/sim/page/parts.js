// What bodies, cameras and rays look like in three dimensions: x to the front, y to the left, z upwards.
import * as THREE from "./libraries/three.module.js";

const FLOOR = 200;
const EYE_DEPTH = 0.25;
const EYE = 0xffb300;
const RAY = 0xe5392f;

const colour = ([r, g, b]) => new THREE.Color().setRGB(r, g, b, THREE.SRGBColorSpace);

// Of a pose [x, y, z, w, i, j, k]. What is nowhere is not shown.
export function place(object, pose) {
  object.visible = pose.every(Number.isFinite);
  if (!object.visible) return;
  const [x, y, z, w, i, j, k] = pose;
  object.position.set(x, y, z);
  object.quaternion.set(i, j, k, w);
}

// Makes the objects of a world. Those that look the same share what they are made of, since there may be very many.
export class Parts {
  #made = new Map();

  dispose() {
    for (const made of this.#made.values()) made.dispose();
    this.#made.clear();
  }

  #shared(key, create) {
    if (!this.#made.has(key)) this.#made.set(key, create());
    return this.#made.get(key);
  }

  body({ parts }) {
    const group = new THREE.Group();
    for (const part of parts) {
      const mesh = new THREE.Mesh(this.#geometry(part), this.#material(part));
      place(mesh, part.at);
      mesh.userData.endless = part.shape === "plane";
      group.add(mesh);
    }
    return group;
  }

  #geometry({ shape, size }) {
    const [a, b, c] = size;
    return this.#shared(`${shape} ${size}`, () => {
      switch (shape) {
        case "box":
          return new THREE.BoxGeometry(a, b, c);
        case "sphere":
          return new THREE.SphereGeometry(a, 32, 16);
        case "cylinder":
          return new THREE.CylinderGeometry(a, a, b, 32).rotateX(Math.PI / 2);
        case "capsule":
          return new THREE.CapsuleGeometry(a, b, 8, 24).rotateX(Math.PI / 2);
        default:
          return new THREE.PlaneGeometry(FLOOR, FLOOR);
      }
    });
  }

  #material({ shape, colour: first, second, tile }) {
    const floor = shape === "plane" && second;
    return this.#shared(floor ? `${first} ${second} ${tile}` : `${first}`, () =>
      floor
        ? new THREE.MeshLambertMaterial({ map: this.#checker(first, second, tile) })
        : new THREE.MeshStandardMaterial({ color: colour(first), roughness: 0.6 }),
    );
  }

  #checker(first, second, tile) {
    return this.#shared(`checker ${first} ${second} ${tile}`, () => {
      const bytes = [first, second, second, first].flatMap((each) => [...each.map((level) => 255 * level), 255]);
      const texture = new THREE.DataTexture(new Uint8Array(bytes), 2, 2);
      texture.colorSpace = THREE.SRGBColorSpace;
      texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
      texture.repeat.setScalar(FLOOR / tile / 2);
      texture.magFilter = THREE.NearestFilter;
      // From far away one sees neither colour, but what is between them.
      texture.minFilter = THREE.LinearMipmapLinearFilter;
      texture.generateMipmaps = true;
      texture.needsUpdate = true;
      return texture;
    });
  }

  // What a camera may see: it looks along x.
  eye({ xfov, aspect }) {
    const y = EYE_DEPTH * Math.tan(Math.min(xfov, 2.5) / 2);
    const z = y / aspect;
    const corners = [[y, z], [y, -z], [-y, -z], [-y, z]].map(([left, up]) => [EYE_DEPTH, left, up]);
    const ends = corners.flatMap((corner, n) => [[0, 0, 0], corner, corner, corners[(n + 1) % 4]]);
    return this.#lines(`eye ${xfov} ${aspect}`, ends, EYE);
  }

  // What a distance sensor measures: a line that is as long, with a dot at its end.
  ray() {
    const ray = this.#lines("ray", [[0, 0, 0], [1, 0, 0]], RAY);
    const geometry = this.#shared("dot", () => new THREE.BufferGeometry().setFromPoints([new THREE.Vector3(1, 0, 0)]));
    const material = this.#shared("dots", () => new THREE.PointsMaterial({ color: RAY, size: 7, sizeAttenuation: false }));
    ray.add(new THREE.Points(geometry, material));
    return ray;
  }

  #lines(key, ends, color) {
    const points = () => ends.map((end) => new THREE.Vector3(...end));
    const geometry = this.#shared(key, () => new THREE.BufferGeometry().setFromPoints(points()));
    return new THREE.LineSegments(geometry, this.#shared(`line ${color}`, () => new THREE.LineBasicMaterial({ color })));
  }
}
