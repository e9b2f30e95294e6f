// Shows images and plays sounds that a Binary holds.
import { make } from "./elements.js";

const TYPES = { jpeg: "image/jpeg", jpg: "image/jpeg", png: "image/png", wav: "audio/wav", mp3: "audio/mpeg", ogg: "audio/ogg" };
const DEPTHS = { rgb: 3, grey8: 1 };

export function showMedia(box, kind, name, { error, keywords, bytes }) {
  if (error) {
    box.replaceChildren(make("p", error, { className: "hint" }));
    return;
  }
  const [format, width, height] = keywords.trim().split(/\s+/);
  const type = TYPES[format] ?? format;
  if (kind === "sound") {
    const player = make("audio", "", { controls: true, src: `data:${type};base64,${bytes}` });
    player.setAttribute("aria-label", name);
    box.replaceChildren(player);
  } else if (DEPTHS[format]) {
    box.replaceChildren(pixels(atob(bytes), Number(width), Number(height), DEPTHS[format], name));
  } else {
    const image = box.querySelector("img") ?? make("img");
    image.alt = `the image of ${name}`;
    image.src = `data:${type};base64,${bytes}`;
    if (image.parentNode !== box) box.replaceChildren(image);
  }
}

function pixels(bytes, width, height, depth, name) {
  if (!(width > 0 && height > 0 && width * height * depth <= bytes.length)) {
    return make("p", `The image has no size, or not all of its pixels: ${width} × ${height}, ${bytes.length} bytes`, { className: "hint" });
  }
  const canvas = make("canvas", "", { width, height });
  canvas.role = "img";
  canvas.setAttribute("aria-label", `the image of ${name}`);
  const image = new ImageData(width, height);
  for (let i = 0; i < width * height; i++) {
    for (let colour = 0; colour < 3; colour++) {
      image.data[4 * i + colour] = bytes.charCodeAt(depth * i + (depth === 3 ? colour : 0));
    }
    image.data[4 * i + 3] = 255;
  }
  canvas.getContext("2d").putImageData(image, 0, 0);
  return canvas;
}
