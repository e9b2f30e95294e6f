// The scene from above: x upwards, y to the left, as the robot looks.
import { fit } from "./plots.js";

const TRAIL = 240;
const ROUND = 20;
const SIGHT = 3;
const MOST_TILES = 4000;

// Of a pose [x, y, z, w, i, j, k]: where a point of its frame is.
function apply([px, py, pz, w, i, j, k], [x, y, z]) {
  const tx = 2 * (j * z - k * y);
  const ty = 2 * (k * x - i * z);
  const tz = 2 * (i * y - j * x);
  return [
    px + x + w * tx + j * tz - k * ty,
    py + y + w * ty + k * tx - i * tz,
    pz + z + w * tz + i * ty - j * tx,
  ];
}

// Points whose hull, seen from above, is the outline of a part.
function corners({ shape, size }) {
  const [a, b, c] = size;
  const points = [];
  if (shape === "box") {
    for (const x of [-a, a]) for (const y of [-b, b]) for (const z of [-c, c]) points.push([x / 2, y / 2, z / 2]);
    return points;
  }
  for (let n = 0; n < ROUND; n++) {
    const angle = (2 * Math.PI * n) / ROUND;
    const [x, y] = [a * Math.cos(angle), a * Math.sin(angle)];
    if (shape === "sphere") points.push([x, y, 0], [x, 0, y], [0, x, y]);
    else if (shape === "cylinder") points.push([x, y, b / 2], [x, y, -b / 2]);
    else if (shape === "capsule")
      for (const end of [b / 2, -b / 2]) points.push([x, y, end], [x, 0, end + y], [0, x, end + y]);
  }
  return points;
}

// The convex hull of points in the plane (Andrew's monotone chain).
function hull(points) {
  points.sort((p, q) => p[0] - q[0] || p[1] - q[1]);
  const turn = (o, p, q) => (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
  const half = (sequence) => {
    const chain = [];
    for (const point of sequence) {
      while (chain.length > 1 && turn(chain.at(-2), chain.at(-1), point) <= 0) chain.pop();
      chain.push(point);
    }
    chain.pop();
    return chain;
  };
  return [...half(points), ...half(points.toReversed())];
}

const css = ([r, g, b], factor = 1) =>
  `rgb(${[r, g, b].map((level) => Math.round(255 * Math.min(1, Math.max(0, level * factor)))).join(" ")})`;

export class SceneView {
  #canvas;
  #setting = null;
  #moment = null;
  #trails = new Map();

  constructor(canvas) {
    this.#canvas = canvas;
  }

  begin(setting) {
    this.#setting = setting;
    this.#moment = null;
    this.#trails.clear();
    for (const body of setting.bodies)
      for (const part of body.parts) part.points = corners(part);
  }

  take(moment) {
    this.#moment = moment;
    this.#setting?.bodies.forEach((body, n) => {
      if (body.fixed || body.parts.length !== 1 || body.parts[0].shape !== "sphere") return;
      const trail = this.#trails.get(n) ?? [];
      this.#trails.set(n, trail);
      trail.push(moment.bodies[n]);
      if (trail.length > TRAIL) trail.shift();
    });
  }

  draw() {
    if (!this.#setting || !this.#moment || this.#canvas.hidden) return;
    const { pen, width, height } = fit(this.#canvas);
    const parts = this.#outlines();
    const view = this.#view(parts, width, height);
    pen.clearRect(0, 0, width, height);
    this.#drawFloor(pen, view);
    this.#drawSight(pen, view);
    this.#drawTrails(pen, view);
    for (const part of parts) this.#drawPart(pen, view, part);
  }

  #outlines() {
    const parts = [];
    this.#setting.bodies.forEach((body, n) => {
      const pose = this.#moment.bodies[n];
      for (const part of body.parts) {
        if (part.shape === "plane") continue;
        const points = part.points.map((point) => apply(pose, apply(part.at, point)));
        const top = Math.max(...points.map((point) => point[2]));
        parts.push({ body, part, top, outline: hull(points.map(([x, y]) => [x, y])) });
      }
    });
    return parts.sort((p, q) => p.top - q.top);
  }

  // From metres to the canvas: all that does not move is in view, or else everything.
  #view(parts, width, height) {
    const still = parts.filter(({ body }) => body.fixed);
    const points = (still.length ? still : parts).flatMap(({ outline }) => outline);
    const bounds = (axis) => {
      const all = points.map((point) => point[axis]);
      return all.length ? [Math.min(...all), Math.max(...all)] : [-1, 1];
    };
    const [[backX, frontX], [rightY, leftY]] = [bounds(0), bounds(1)];
    const scale = Math.min(width / (leftY - rightY + 0.2), height / (frontX - backX + 0.2));
    const [midX, midY] = [(backX + frontX) / 2, (rightY + leftY) / 2];
    const place = ([x, y]) => [width / 2 - (y - midY) * scale, height / 2 - (x - midX) * scale];
    return { place, scale, width, height, midX, midY };
  }

  #drawFloor(pen, view) {
    const floor = this.#setting.bodies.flatMap((body) => body.parts).find((part) => part.shape === "plane");
    if (!floor) return;
    pen.fillStyle = css(floor.colour);
    pen.fillRect(0, 0, view.width, view.height);
    if (!floor.second) return;
    const { tile } = floor;
    const [reachX, reachY] = [view.height / view.scale / 2, view.width / view.scale / 2];
    if ((4 * reachX * reachY) / (tile * tile) > MOST_TILES) return;
    pen.fillStyle = css(floor.second);
    const size = tile * view.scale;
    for (let i = Math.floor((view.midX - reachX) / tile); i * tile < view.midX + reachX; i++)
      for (let j = Math.floor((view.midY - reachY) / tile); j * tile < view.midY + reachY; j++)
        if ((i + j) & 1) {
          const [left, top] = view.place([(i + 1) * tile, (j + 1) * tile]);
          pen.fillRect(left, top, size, size);
        }
  }

  // What the camera may see: the angle that it looks into.
  #drawSight(pen, view) {
    const pose = this.#moment.sight?.camera;
    if (!pose || !this.#setting.camera) return;
    const ahead = apply(pose, [1, 0, 0]);
    const direction = Math.atan2(ahead[1] - pose[1], ahead[0] - pose[0]);
    const half = this.#setting.camera.xfov / 2;
    const [x, y] = view.place(pose);
    const radius = SIGHT * view.scale;
    const glow = pen.createRadialGradient(x, y, 0, x, y, radius);
    glow.addColorStop(0, "rgb(255 214 60 / .55)");
    glow.addColorStop(1, "rgb(255 214 60 / 0)");
    pen.fillStyle = glow;
    pen.beginPath();
    pen.moveTo(x, y);
    // On the canvas x is upwards: an angle to the left is one against the clock from there.
    pen.arc(x, y, radius, -Math.PI / 2 - direction - half, -Math.PI / 2 - direction + half);
    pen.fill();
  }

  #drawTrails(pen, view) {
    for (const [n, trail] of this.#trails) {
      pen.strokeStyle = css(this.#setting.bodies[n].parts[0].colour);
      pen.lineWidth = 2.5;
      pen.lineCap = "round";
      for (let i = 1; i < trail.length; i++) {
        pen.globalAlpha = (0.6 * i) / trail.length;
        pen.beginPath();
        pen.moveTo(...view.place(trail[i - 1]));
        pen.lineTo(...view.place(trail[i]));
        pen.stroke();
      }
      pen.globalAlpha = 1;
    }
  }

  #drawPart(pen, view, { part, outline }) {
    pen.beginPath();
    outline.forEach((point, n) => (n ? pen.lineTo(...view.place(point)) : pen.moveTo(...view.place(point))));
    pen.closePath();
    pen.fillStyle = css(part.colour);
    pen.fill();
    pen.strokeStyle = css(part.colour, 0.55);
    pen.lineWidth = 1;
    pen.stroke();
  }
}
