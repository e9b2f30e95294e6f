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
  const focused = focusIn(host);
  host.replaceChildren(...content());
  if (focused) returnFocus(host, focused.dataset.act);
}

function focusIn(host) {
  return host !== document.activeElement && host.contains(document.activeElement) ? document.activeElement : null;
}

// Who has nothing but keys goes on from what is in the place of what is gone, or else from the part of the page in which it was.
function returnFocus(host, act = "") {
  const [same] = [...host.querySelectorAll("[data-act]")].filter((each) => each.dataset.act === act && !each.disabled);
  const part = host.closest("[tabindex], section, form") ?? document.querySelector("main");
  if (!part.hasAttribute("tabindex")) part.tabIndex = -1;
  (same ?? part).focus();
}

// Takes away what somebody may be using (how: "hidden" or "disabled"), or gives it back.
export function withdraw(element, how, away) {
  const focused = away && !element[how] && element.contains(document.activeElement);
  element[how] = away;
  if (focused) returnFocus(element.parentElement);
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
    this.keep(new Set(all.map(this.key)));
    let at = this.host.firstElementChild;
    for (const each of all) {
      const key = this.key(each);
      if (!this.known.has(key)) this.known.set(key, this.create(each));
      const item = this.known.get(key);
      this.write(item, each);
      if (item === at) at = at.nextElementSibling;
      else this.host.insertBefore(item, at);
    }
  }

  // What is not wanted goes first: what is moved loses the keys.
  keep(wanted) {
    for (const [key, item] of this.known) {
      if (!wanted.has(key)) {
        const focused = focusIn(item);
        item.remove();
        this.known.delete(key);
        if (focused) returnFocus(this.host);
      }
    }
  }
}
