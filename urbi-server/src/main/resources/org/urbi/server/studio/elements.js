// Makes elements, and renews what they contain.

export const make = (tag, text = "", properties = {}) => {
  const made = document.createElement(tag);
  made.textContent = text;
  return Object.assign(made, properties);
};

// Pixels, of a size in the unit that grows with the screen.
export const rem = (size) => size * Number.parseFloat(getComputedStyle(document.documentElement).fontSize);

// Puts other content into an element, unless it is what is there: a click must not miss a button.
export function put(host, state, content) {
  const text = JSON.stringify(state);
  if (host.dataset.state === text) return;
  host.dataset.state = text;
  const focused = host.contains(document.activeElement) ? document.activeElement.dataset.act : null;
  host.replaceChildren(...content());
  if (focused) host.querySelector(`[data-act="${focused}"]`)?.focus();
}

export function set(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

// When something was last, in milliseconds of the kernel; negative for never.
export function ago(last, now) {
  if (last < 0) return "never";
  const seconds = (now - last) / 1000;
  if (seconds < 1) return "now";
  if (seconds < 60) return `${seconds.toFixed(0)} s ago`;
  return seconds < 3600 ? `${(seconds / 60).toFixed(0)} min ago` : `${(seconds / 3600).toFixed(1)} h ago`;
}

// The elements of a list stay those of what they show, in its order: a click must not miss one.
export class Items {
  constructor(host, key, create, write) {
    Object.assign(this, { host, key, create, write });
    this.known = new Map();
  }

  show(all) {
    const wanted = new Set();
    let at = this.host.firstElementChild;
    for (const each of all) {
      const key = this.key(each);
      wanted.add(key);
      if (!this.known.has(key)) this.known.set(key, this.create(each));
      const item = this.known.get(key);
      this.write(item, each);
      if (item === at) at = at.nextElementSibling;
      else this.host.insertBefore(item, at);
    }
    for (const [key, item] of this.known) {
      if (!wanted.has(key)) {
        item.remove();
        this.known.delete(key);
      }
    }
  }
}
