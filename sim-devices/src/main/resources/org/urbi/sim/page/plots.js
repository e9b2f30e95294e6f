// How the motors follow their targets: a plot for each, over the last seconds of simulated time.

const SECONDS = 12;
// In the unit that grows with the screen, as all sizes here.
const MARGIN = { left: 2.5, right: 0.4, top: 0.4, bottom: 1.1 };

// Gives a canvas as many pixels as the screen has for it.
export function fit(canvas) {
  const ratio = devicePixelRatio || 1;
  const { clientWidth: width, clientHeight: height } = canvas;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const pen = canvas.getContext("2d");
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  return { pen, width, height };
}

// A colour of the style sheet, as it is for who prefers light or dark.
export function style(element, name) {
  element.style.color = `var(--${name})`;
  return getComputedStyle(element).color;
}

const unit = () => parseFloat(getComputedStyle(document.documentElement).fontSize);

// Round numbers between two others, so many of them or fewer.
function ticks(low, high, most) {
  const raw = (high - low) / most;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((size) => size >= raw);
  const all = [];
  for (let n = Math.ceil(low / step); n * step <= high; n++) all.push(n * step);
  return { all, digits: Math.max(0, -Math.floor(Math.log10(step))) };
}

class Plot {
  #drive;
  #canvas = document.createElement("canvas");
  #reading = document.createElement("span");
  #samples = [];
  figure = document.createElement("figure");

  constructor(drive) {
    this.#drive = drive;
    const caption = document.createElement("figcaption");
    const name = document.createElement("b");
    name.textContent = drive.name;
    caption.append(name, this.#reading);
    this.#canvas.setAttribute("role", "img");
    this.#canvas.setAttribute("aria-label", `${drive.name}: sensed ${drive.control} and target`);
    this.figure.append(caption, this.#canvas);
  }

  take(time, [value, target]) {
    const samples = this.#samples;
    if (samples.length && time < samples.at(-1).time) samples.length = 0;
    samples.push({ time, value, target });
    while (samples[0].time < time - SECONDS - 1) samples.shift();
    this.#reading.textContent = `${value.toFixed(2)} → ${target.toFixed(2)} ${this.#drive.unit}`;
    this.#canvas.dataset.samples = samples.length;
    this.#canvas.dataset.value = value;
    this.#canvas.dataset.target = target;
  }

  // What of the range has been used, with some room.
  #range() {
    let low = Infinity;
    let high = -Infinity;
    for (const { value, target } of this.#samples) {
      low = Math.min(low, value, target);
      high = Math.max(high, value, target);
    }
    const room = Math.max(0.15 * (high - low), 0.1);
    return [low - room, high + room];
  }

  draw() {
    if (!this.#samples.length) return;
    const { pen, width, height } = fit(this.#canvas);
    const end = this.#samples.at(-1).time;
    const [low, high] = this.#range();
    const margin = Object.fromEntries(Object.entries(MARGIN).map(([side, size]) => [side, size * unit()]));
    const inner = { width: width - margin.left - margin.right, height: height - margin.top - margin.bottom };
    const x = (time) => margin.left + (1 - (end - time) / SECONDS) * inner.width;
    const y = (number) => margin.top + (1 - (number - low) / (high - low)) * inner.height;
    pen.clearRect(0, 0, width, height);
    this.#drawGrid(pen, x, y, [low, high], end, { width, margin });
    pen.save();
    pen.beginPath();
    pen.rect(margin.left, 0, inner.width, height);
    pen.clip();
    this.#drawLine(pen, x, y, "value", [], 2.5);
    this.#drawLine(pen, x, y, "target", [5, 4], 1.5);
    pen.restore();
  }

  #drawGrid(pen, x, y, [low, high], end, { width, margin }) {
    const line = style(this.#canvas, "line");
    const faint = style(this.#canvas, "faint");
    pen.lineWidth = 1;
    pen.font = `${0.7 * unit()}px system-ui, sans-serif`;
    pen.textAlign = "right";
    pen.textBaseline = "middle";
    const levels = ticks(low, high, 4);
    for (const level of levels.all) {
      pen.strokeStyle = line;
      pen.beginPath();
      pen.moveTo(margin.left, y(level));
      pen.lineTo(width - margin.right, y(level));
      pen.stroke();
      pen.fillStyle = faint;
      pen.fillText(level.toFixed(levels.digits).replace("-", "−"), margin.left - 6, y(level));
    }
    pen.textAlign = "center";
    pen.textBaseline = "alphabetic";
    for (let time = Math.ceil((end - SECONDS) / 4) * 4; time <= end; time += 4)
      if (time >= 0 && x(time) > margin.left + 8 && x(time) < width - unit())
        pen.fillText(`${time} s`, x(time), y(low) + 0.9 * unit());
  }

  #drawLine(pen, x, y, what, dashes, thickness) {
    pen.strokeStyle = style(this.#canvas, what);
    pen.lineWidth = thickness;
    pen.lineJoin = "round";
    pen.setLineDash(dashes);
    pen.beginPath();
    this.#samples.forEach((sample, n) => {
      if (n) pen.lineTo(x(sample.time), y(sample[what]));
      else pen.moveTo(x(sample.time), y(sample[what]));
    });
    pen.stroke();
    pen.setLineDash([]);
  }
}

export class PlotView {
  #place;
  #plots = [];

  constructor(place) {
    this.#place = place;
  }

  begin(setting) {
    // Those that go to positions are what there is to be looked at: they come first.
    const order = (drive) => (drive.control === "position" ? 0 : 1);
    this.#plots = setting.drives.map((drive) => new Plot(drive));
    const shown = this.#plots
      .map((plot, n) => ({ plot, rank: order(setting.drives[n]) }))
      .sort((p, q) => p.rank - q.rank);
    this.#place.replaceChildren(...shown.map(({ plot }) => plot.figure));
    this.#place.parentElement.hidden = this.#plots.length === 0;
  }

  take(moment) {
    this.#plots.forEach((plot, n) => plot.take(moment.time, moment.drives[n]));
  }

  draw() {
    for (const plot of this.#plots) plot.draw();
  }
}
