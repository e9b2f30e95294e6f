import { forget, keep, kept } from "./storage.js";

// The colours of the page: those of the system, or those that somebody has chosen, which the browser keeps.
const CHOICES = [
  { name: "", sign: "◐", label: "Colours as the system has them" },
  { name: "light", sign: "○", label: "Light colours" },
  { name: "dark", sign: "●", label: "Dark colours" },
];
const KEY = "theme";

// What is drawn is drawn anew, in the colours that there are now.
const redraw = () => window.dispatchEvent(new Event("resize"));

// A button goes from each choice to the next one.
export function chooseTheme(button) {
  let chosen = 0;
  const show = (index) => {
    chosen = index;
    const { name, sign, label } = CHOICES[index];
    if (name) document.documentElement.dataset.theme = name;
    else delete document.documentElement.dataset.theme;
    button.textContent = sign;
    button.title = label;
    button.setAttribute("aria-label", label);
  };
  const before = kept("local", KEY) ?? "";
  show(Math.max(0, CHOICES.findIndex(({ name }) => name === before)));
  button.addEventListener("click", () => {
    show((chosen + 1) % CHOICES.length);
    const { name } = CHOICES[chosen];
    if (name) keep("local", KEY, name);
    else forget("local", KEY);
    redraw();
  });
  // The system may have other colours at night.
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
}
