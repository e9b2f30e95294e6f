// Beside the list: the selected job with its calls, and the tags.
import { Items, make, put, set } from "./elements.js";
import { Jobs } from "./jobs.js";

const MOST_TAGS = 200;

export class Side {
  constructor(detail, tags, jobs, { steer, filter, mayChange }) {
    this.detail = detail;
    this.jobs = jobs;
    this.steer = steer;
    this.filter = filter;
    this.mayChange = mayChange;
    const newItem = ({ hint }) => make("li", "", { className: hint ? "hint" : "" });
    this.tagItems = new Items(tags, (tag) => tag.number, newItem, (item, tag) => this.fillTag(item, tag));
  }

  // The keys are at the same place still when what it does there is the opposite.
  button(text, action, kind, target, label, danger) {
    const made = make("button", text, { type: "button", disabled: !this.mayChange(), title: label });
    made.setAttribute("aria-label", label);
    made.dataset.act = `${kind} ${target} ${action.replace("un", "")}`;
    if (danger) made.className = "danger";
    made.addEventListener("click", () => this.steer(action, kind, target));
    return made;
  }

  showJob(number, detail) {
    const job = this.jobs.rows.get(number);
    if (!job || job.ended) {
      const text = number ? "This job has ended." : "Choose a job: by a click, or with the arrow keys.";
      put(this.detail, [text], () => [
        make("p", text, { className: "hint" }),
        make("p", "s or Delete stops it, f freezes it, ← and → close and open what it has started.", { className: "hint" }),
      ]);
      return;
    }
    const own = detail?.number === number ? detail : null;
    const kind = Jobs.kind(job);
    const left = own && own.left >= 0 ? ` (${own.left < 10 ? own.left.toFixed(1) : Math.round(own.left)} s more)` : "";
    const starter = this.jobs.rows.get(job.starter);
    const facts = [
      ["name", job.name],
      [kind === "running" || kind === "frozen" ? "is" : "waits for", kind + left],
      ["started by", starter ? Jobs.title(starter) : "code that has ended"],
      ["lobby", job.lobby],
      ["tags", this.jobs.tagNames(job).join(", ") || "none"],
    ];
    // Facts change all the time: the buttons stay for that, as they are for who has begun to press one.
    put(this.detail, [number, this.mayChange(), job.frozen], () => {
      const buttons = make("div", "", { className: "buttons" });
      buttons.append(
        this.button("Stop", "stop", "job", number, `Stop ${job.name}`, true),
        job.frozen
          ? this.button("Unfreeze", "unfreeze", "job", number, `Unfreeze ${job.name}`)
          : this.button("Freeze", "freeze", "job", number, `Freeze ${job.name}`),
      );
      return [buttons, make("dl", "", { className: "facts" }), make("ol", "", { className: "calls", ariaLabel: "Calls, innermost first" })];
    });
    const [, list, calls] = this.detail.children;
    put(list, facts, () => facts.flatMap(([name, value]) => [make("dt", name), make("dd", value)]));
    put(calls, own?.calls ?? [], () => (own?.calls ?? []).map((call) => this.call(call)));
  }

  call({ place, name, line }) {
    const item = make("li");
    const where = make("div", "", { className: "where" });
    where.append(make("span", place || "not in a file"), make("span", name));
    item.append(where, make("pre", line));
    return item;
  }

  // words: what the filter of the jobs wants. Of very many tags, those that it names come first.
  showTags(words) {
    // Who scrolls has everything drawn anew, and changes none of that.
    const state = [this.jobs.at, this.mayChange(), ...words].join(" ");
    if (state === this.tagState) return;
    this.tagState = state;
    const count = new Map();
    for (const job of this.jobs.rows.values()) {
      if (!job.ended) for (const tag of job.tags) count.set(tag, (count.get(tag) ?? 0) + 1);
    }
    let all = [...this.jobs.tags.values()].sort((a, b) => a.number - b.number);
    if (all.length > MOST_TAGS && words.length) {
      const named = ({ name }) => words.every((word) => name.toLowerCase().includes(word));
      all = [...all.filter(named), ...all.filter((tag) => !named(tag))];
    }
    const shown = all.slice(0, MOST_TAGS).map((tag) => ({ ...tag, jobs: count.get(tag.number) ?? 0 }));
    const left = all.length - shown.length;
    if (left) shown.push({ number: "more", hint: `and ${left.toLocaleString("en")} more: the filter brings up those that it names` });
    this.tagItems.show(shown.length ? shown : [{ number: "none", hint: "No code is under a tag." }]);
  }

  fillTag(item, tag) {
    if (tag.hint) {
      set(item, tag.hint);
      return;
    }
    item.dataset.tag = tag.name;
    put(item, [tag.name, tag.frozen, tag.blocked, this.mayChange()], () => this.tagParts(tag));
    set(item.querySelector(".of"), tag.jobs ? `${tag.jobs} ${tag.jobs === 1 ? "job" : "jobs"}` : "");
  }

  tagParts(tag) {
    const name = make("button", tag.name, { type: "button", className: "tagname", title: `Show the jobs under ${tag.name}` });
    name.dataset.act = `show ${tag.number}`;
    name.addEventListener("click", () => this.filter(tag.name));
    const states = ["frozen", "blocked"].filter((state) => tag[state]);
    return [
      name,
      ...states.map((state) => make("span", state, { className: "badge" })),
      make("span", "", { className: "of" }),
      this.button("Stop", "stop", "tag", tag.number, `Stop the tag ${tag.name}`, true),
      tag.frozen
        ? this.button("Unfreeze", "unfreeze", "tag", tag.number, `Unfreeze the tag ${tag.name}`)
        : this.button("Freeze", "freeze", "tag", tag.number, `Freeze the tag ${tag.name}`),
      tag.blocked
        ? this.button("Unblock", "unblock", "tag", tag.number, `Unblock the tag ${tag.name}`)
        : this.button("Block", "block", "tag", tag.number, `Block the tag ${tag.name}`, true),
    ];
  }
}
