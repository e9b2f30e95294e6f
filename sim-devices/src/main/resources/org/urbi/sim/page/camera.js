// What the camera sees, with what the detector has found in it.

export class CameraView {
  #canvas;
  #badge;
  #card;
  #bitmap = null;
  #sight = null;
  #shown = null;
  #trouble = null;
  #lens = null;

  constructor(canvas, badge, card) {
    this.#canvas = canvas;
    this.#badge = badge;
    this.#card = card;
  }

  begin(setting) {
    this.#lens = setting.camera ?? null;
    this.#card.hidden = !this.#lens;
    this.#bitmap?.close();
    this.#bitmap = null;
    this.#shown = this.#sight = this.#trouble = null;
    if (this.#lens) {
      this.#canvas.width = this.#lens.width;
      this.#canvas.height = this.#lens.height;
    }
  }

  take(moment) {
    // The image of a moment comes after it: until then, what was found belongs to the one before.
    this.#sight = moment.sight ?? null;
    this.#shown ??= this.#sight;
  }

  trouble(text) {
    this.#trouble = text;
  }

  async show(blob) {
    const sight = this.#sight;
    const bitmap = await createImageBitmap(blob);
    this.#bitmap?.close();
    this.#bitmap = bitmap;
    this.#shown = sight;
    this.#trouble = null;
  }

  draw() {
    const canvas = this.#canvas;
    const pen = canvas.getContext("2d");
    if (this.#bitmap) {
      if (canvas.width !== 2 * this.#bitmap.width || canvas.height !== 2 * this.#bitmap.height) {
        canvas.width = 2 * this.#bitmap.width;
        canvas.height = 2 * this.#bitmap.height;
      }
      pen.drawImage(this.#bitmap, 0, 0, canvas.width, canvas.height);
      canvas.dataset.image = this.#shown?.image ?? 0;
    }
    if (this.#shown?.detector) this.#drawDetection(pen, this.#shown.blob ?? null);
    else this.#badge.hidden = true;
    if (this.#trouble) {
      this.#badge.hidden = false;
      this.#badge.dataset.seen = "false";
      this.#badge.textContent = this.#trouble;
    }
  }

  #drawDetection(pen, blob) {
    this.#badge.hidden = false;
    this.#badge.dataset.seen = blob !== null;
    if (!blob) {
      this.#badge.textContent = "not in view";
      return;
    }
    const [x, y, ratio] = blob;
    const signed = (number) => (number < 0 ? "−" : "+") + Math.abs(number).toFixed(2);
    this.#badge.textContent = `x ${signed(x)}  y ${signed(y)}`;
    const { width, height } = this.#canvas;
    const left = (x + 0.5) * width;
    const top = (0.5 - y) * height;
    const radius = Math.max(8, Math.sqrt((ratio * width * height) / Math.PI) + 6);
    for (const [colour, thickness] of [["rgb(0 0 0 / .6)", 6], ["#ffe14d", 3]]) {
      pen.strokeStyle = colour;
      pen.lineWidth = thickness;
      pen.beginPath();
      pen.arc(left, top, radius, 0, 2 * Math.PI);
      for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
        pen.moveTo(left + dx * (radius + 4), top + dy * (radius + 4));
        pen.lineTo(left + dx * (radius + 16), top + dy * (radius + 16));
      }
      pen.stroke();
    }
    // The middle of the image, to which the head turns the ball.
    pen.strokeStyle = "rgb(255 255 255 / .7)";
    pen.lineWidth = 2;
    pen.beginPath();
    pen.moveTo(width / 2 - 9, height / 2);
    pen.lineTo(width / 2 + 9, height / 2);
    pen.moveTo(width / 2, height / 2 - 9);
    pen.lineTo(width / 2, height / 2 + 9);
    pen.stroke();
  }
}
