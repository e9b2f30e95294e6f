// The list of jobs. Of very many lines only those in sight are in the document.
import { rem } from "./elements.js";
import { Jobs } from "./jobs.js";

const BEYOND = 4;
const INDENT = 0.9;
// A click comes this many milliseconds after the end of the touch, at the latest.
const CLICK_AFTER = 300;

const element = (tag, name, text = "") => {
  const made = document.createElement(tag);
  if (name) made.className = name;
  made.textContent = text;
  return made;
};

export class JobList {
  constructor(list, rows, jobs, { onSelect, onStop, onFreeze }) {
    this.list = list;
    this.rows = rows;
    this.jobs = jobs;
    this.onSelect = onSelect;
    this.lines = [];
    this.closed = new Set();
    this.pool = new Map();
    this.selected = null;
    this.words = [];
    this.order = "tree";
    // Whether somebody is pressing something: then each line stays in its place.
    this.pressed = false;
    this.actions = { Delete: onStop, s: onStop, f: onFreeze };
    list.addEventListener("keydown", (event) => this.key(event));
    rows.addEventListener("click", (event) => this.click(event));
    list.addEventListener("pointerdown", (event) => event.button === 0 && this.press());
    for (const end of ["pointerup", "pointercancel"]) window.addEventListener(end, () => this.release());
    // What was let go elsewhere is not told of.
    list.addEventListener("pointermove", (event) => event.buttons || this.release());
  }

  press() {
    clearTimeout(this.releasing);
    this.releasing = 0;
    this.pressed = true;
  }

  release() {
    if (!this.pressed || this.releasing) return;
    this.releasing = setTimeout(() => {
      this.releasing = 0;
      this.pressed = false;
    }, CLICK_AFTER);
  }

  // The numbers mean nothing any more.
  forget() {
    this.selected = null;
    this.closed.clear();
    this.pressed = false;
    this.list.scrollTop = 0;
  }

  height() {
    return rem(Number.parseFloat(getComputedStyle(document.documentElement).getPropertyValue("--row")));
  }

  // Makes the lines anew, if something has changed that they depend on.
  arrange() {
    // What a job does, and what it costs, may be another with each view.
    const plain = this.order === "tree" && !this.words.length;
    const state = plain ? `tree ${this.jobs.version}` : `${this.jobs.views}`;
    if (this.state && (this.pressed || state === this.state)) return;
    this.state = state;
    this.lines = this.order === "tree" ? this.jobs.tree(this.words, this.closed) : this.jobs.busiest(this.words);
    this.rows.style.height = `${Math.max(1, this.lines.length) * this.row}px`;
  }

  // The lines in sight.
  visible() {
    const first = Math.max(0, Math.floor(this.list.scrollTop / this.row));
    const count = Math.ceil(this.list.clientHeight / this.row) + 1;
    return { first, last: Math.min(this.lines.length, first + count) };
  }

  draw() {
    this.row = this.height();
    this.arrange();
    const { first, last } = this.visible();
    const from = Math.max(0, first - BEYOND);
    const to = Math.min(this.lines.length, last + BEYOND);
    const wanted = new Set();
    for (let i = from; i < to; i++) {
      const line = this.lines[i];
      wanted.add(line.key);
      this.show(line, i);
    }
    for (const [key, row] of this.pool) {
      if (!wanted.has(key)) {
        row.remove();
        this.pool.delete(key);
      }
    }
    const active = this.pool.get(this.selected);
    if (active) this.list.setAttribute("aria-activedescendant", active.id);
    else this.list.removeAttribute("aria-activedescendant");
  }

  show(line, index) {
    let row = this.pool.get(line.key);
    if (!row) {
      row = this.create(line);
      this.pool.set(line.key, row);
      this.rows.append(row);
    }
    row.style.transform = `translateY(${index * this.row}px)`;
    row.setAttribute("aria-level", line.level);
    row.setAttribute("aria-selected", line.key === this.selected);
    row.setAttribute("aria-posinset", line.place);
    row.setAttribute("aria-setsize", line.of);
    const [what, state, share] = row.firstChild.children;
    what.style.paddingLeft = `${(line.level - 1) * INDENT}rem`;
    if (line.children) row.setAttribute("aria-expanded", line.open);
    else row.removeAttribute("aria-expanded");
    what.children[0].textContent = line.children ? (line.open ? "▾" : "▸") : "";
    if (!line.job) {
      what.children[2].textContent = `${line.alive} ${line.alive === 1 ? "job" : "jobs"}`;
      return;
    }
    // The row of a line may be that of an earlier look at the same job.
    const job = this.jobs.rows.get(line.key) ?? line.job;
    if (row.shown === job) return;
    row.shown = job;
    const kind = Jobs.kind(job);
    what.children[1].textContent = job.code || job.name;
    what.children[2].textContent = job.code ? job.name : "";
    row.title = `${job.name} ${job.place}`;
    row.classList.toggle("ended", Boolean(job.ended));
    for (const chip of [...what.querySelectorAll(".chip")]) chip.remove();
    for (const name of this.jobs.tagNames(job).filter((each) => each !== job.lobby)) {
      what.append(element("span", "chip", name));
    }
    state.dataset.kind = kind;
    state.textContent = kind;
    const percent = job.share / 10;
    share.firstChild.value = percent;
    share.lastChild.textContent = percent ? `${percent.toFixed(1)} %` : "";
    const waits = kind === "running" || kind === "frozen" ? kind : `waits for ${kind}`;
    row.setAttribute("aria-description", job.ended ? "has ended" : `${waits}, ${percent} percent`);
  }

  create(line) {
    const row = element("div", line.job ? "row" : "row lobby");
    row.role = "treeitem";
    row.id = `line-${line.key}`;
    row.dataset.key = line.key;
    const cells = element("div", "cells");
    const what = element("div", "what");
    const twisty = element("span", "twisty");
    twisty.ariaHidden = true;
    what.append(twisty, element("span", "code", line.lobby ?? ""), element("span", "name"));
    const share = element("div", "share");
    // The name of the item is what is written in it; its share is told behind that.
    share.ariaHidden = true;
    if (line.job) {
      const meter = element("meter");
      meter.max = 100;
      share.append(meter, element("span"));
    }
    cells.append(what, element("div", line.job ? "state" : ""), share, element("div"));
    row.append(cells);
    return row;
  }

  keyOf(row) {
    return this.lines.find((line) => String(line.key) === row.dataset.key)?.key ?? null;
  }

  click(event) {
    const row = event.target.closest(".row");
    if (!row) return;
    const key = this.keyOf(row);
    if (event.target.className === "twisty") this.toggle(key);
    else this.select(key);
  }

  // Goes to the line below which another one is.
  up(line) {
    const at = this.lines.indexOf(line);
    const above = this.lines.slice(0, at).findLastIndex((each) => each.level < line.level);
    if (above >= 0) this.move(above - at);
  }

  toggle(key) {
    if (!this.closed.delete(key)) this.closed.add(key);
    this.state = "";
    this.draw();
  }

  select(key) {
    this.selected = key;
    this.draw();
    this.onSelect(typeof key === "number" ? key : 0);
  }

  move(steps) {
    const at = this.lines.findIndex((line) => line.key === this.selected);
    const index = Math.min(this.lines.length - 1, Math.max(0, at + steps));
    const line = this.lines[index];
    if (!line) return;
    const top = index * this.row;
    if (top < this.list.scrollTop) this.list.scrollTop = top;
    const bottom = top + this.row - this.list.clientHeight;
    if (bottom > this.list.scrollTop) this.list.scrollTop = bottom;
    this.select(line.key);
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || event.shiftKey) return;
    const page = Math.max(1, Math.floor(this.list.clientHeight / this.row) - 1);
    const steps = { ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page, Home: -1e9, End: 1e9 }[event.key];
    const line = this.lines.find((each) => each.key === this.selected);
    if (steps) this.move(steps);
    else if (event.key === "ArrowLeft" && line?.children && line.open) this.toggle(line.key);
    else if (event.key === "ArrowLeft" && line) this.up(line);
    else if (event.key === "ArrowRight" && line?.children && !line.open) this.toggle(line.key);
    else if (event.key === "ArrowRight" && line?.children) this.move(1);
    else if (this.actions[event.key] && line?.job && !this.jobs.rows.get(line.key)?.ended) this.actions[event.key](line.key);
    else return;
    event.preventDefault();
  }
}
