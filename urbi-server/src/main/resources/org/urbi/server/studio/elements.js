// Makes elements, and renews what they contain.

export const make = (tag, text = "", properties = {}) => {
  const made = document.createElement(tag);
  made.textContent = text;
  return Object.assign(made, properties);
};

// Puts other content into an element, unless it is what is there: a click must not miss a button.
export function put(host, state, content) {
  const text = JSON.stringify(state);
  if (host.dataset.state === text) return;
  host.dataset.state = text;
  const focused = host.contains(document.activeElement) ? document.activeElement.dataset.act : null;
  host.replaceChildren(...content());
  if (focused) host.querySelector(`[data-act="${focused}"]`)?.focus();
}
