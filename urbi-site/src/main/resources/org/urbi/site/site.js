"use strict";
// The search, and the choice between light and dark. All that is needed are files beside this one.

const HITS_SHOWN = 12;
const field = document.getElementById("search");
const list = document.getElementById("results");
let ready;

function script(name) {
  return new Promise((loaded, failed) => {
    const element = document.createElement("script");
    element.src = SITE_ROOT + name;
    element.onload = loaded;
    element.onerror = () => failed(new Error(`${name} is missing`));
    document.head.append(element);
  });
}

// Loaded when somebody wants to search: names are words, with and without their capitals.
function engine() {
  ready ??= Promise.all([script("libraries/minisearch.js"), script("search-data.js")]).then(() => {
    const search = new MiniSearch({
      fields: ["title", "page", "text"],
      searchOptions: { boost: { title: 6, page: 3 }, prefix: (word) => word.length > 1, fuzzy: (word) => (word.length > 4 ? 0.2 : 0), combineWith: "AND" },
    });
    search.addAll(SEARCH_DATA.map(([, page, title, text], id) => ({ id, page, title, text })));
    return search;
  });
  return ready;
}

// A piece of the text around the first of the words, with all of them marked.
function excerpt(text, words) {
  const pattern = new RegExp(`(${words.map((word) => word.replace(/[^\p{L}\p{N}_]/gu, "\\$&")).join("|")})`, "giu");
  const begin = Math.max(0, text.search(pattern) - 50);
  const shown = (begin > 0 ? "…" : "") + text.slice(begin, begin + 160);
  return shown.split(pattern).map((piece, index) => {
    if (index % 2 === 0) return piece;
    const mark = document.createElement("mark");
    mark.textContent = piece;
    return mark;
  });
}

function hit(result) {
  const [place, page, title, text] = SEARCH_DATA[result.id];
  const item = document.createElement("li");
  item.role = "option";
  const link = document.createElement("a");
  link.href = SITE_ROOT + place;
  link.append(title === page ? page : `${page} › ${title}`);
  const small = document.createElement("small");
  small.append(...excerpt(text, Object.keys(result.match)));
  link.append(small);
  item.append(link);
  return item;
}

function tell(text) {
  const line = document.createElement("p");
  line.textContent = text;
  list.replaceChildren(line);
}

function show(open) {
  list.hidden = !open;
  field.setAttribute("aria-expanded", open);
}

async function search() {
  const wanted = field.value.trim();
  show(wanted !== "");
  if (!wanted) return;
  try {
    const results = (await engine()).search(wanted);
    if (wanted !== field.value.trim()) return;
    if (results.length) list.replaceChildren(...results.slice(0, HITS_SHOWN).map(hit));
    else tell(`Nothing has all of “${wanted}”.`);
  } catch (error) {
    tell(`Search does not work: ${error.message}`);
  }
}

function move(step) {
  const items = [...list.querySelectorAll("li")];
  const at = items.findIndex((item) => item.ariaSelected === "true");
  const next = items[(at + step + items.length) % items.length] ?? items[0];
  items.forEach((item) => (item.ariaSelected = item === next));
  next?.scrollIntoView({ block: "nearest" });
}

field.addEventListener("focus", () => engine().catch(() => {}));
field.addEventListener("input", search);
field.addEventListener("keydown", (event) => {
  if (event.key === "ArrowDown" || event.key === "ArrowUp") {
    move(event.key === "ArrowDown" ? 1 : -1);
    event.preventDefault();
  } else if (event.key === "Enter") {
    (list.querySelector('[aria-selected="true"] a') ?? list.querySelector("a"))?.click();
  } else if (event.key === "Escape") {
    show(false);
  }
});
document.addEventListener("click", (event) => {
  if (!event.target.closest(".search") || event.target.closest("#results a")) show(false);
});
document.addEventListener("keydown", (event) => {
  if (event.key === "/" && !event.ctrlKey && !event.metaKey && document.activeElement !== field) {
    field.focus();
    event.preventDefault();
  }
});
document.querySelector(".search").hidden = false;

// The contents are beside the text, or above it: closed, since they would fill a telephone.
const contents = document.querySelector(".contents");
const narrow = matchMedia("(max-width: 50rem)");
const fold = () => (contents.open = !narrow.matches);
narrow.addEventListener("change", fold);
fold();

// Pages that are files may have no storage: then the choice is that of this page.
const button = document.getElementById("theme");
const root = document.documentElement;
const storage = (() => { try { return window.localStorage; } catch { return null; } })();
if (storage?.getItem("theme")) root.dataset.theme = storage.getItem("theme");
button.hidden = false;
button.addEventListener("click", () => {
  const dark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
  root.dataset.theme = dark ? "light" : "dark";
  storage?.setItem("theme", root.dataset.theme);
});

const asked = new URLSearchParams(location.search).get("q");
if (asked) {
  field.value = asked;
  search();
}
