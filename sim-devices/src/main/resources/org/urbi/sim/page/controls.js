// What people may do to the world: halt and step time, reset, push a body, drive the robot by keys, buttons and gamepad.

const DRIVE_KEYS = { w: [1, 0], s: [-1, 0], a: [0, 1], d: [0, -1] };
const DEAD_ZONE = 0.15;
const STICK_STEPS = 10;

const typing = ({ target }) => target.closest?.("input, select, textarea");

export class Controls {
  #byId;
  #send;
  #space = null;
  #setting = null;
  #refusal = "";
  #moment = null;
  #picked = null;
  #held = new Map();
  #driven = "0 0";

  constructor(byId, send) {
    this.#byId = byId;
    this.#send = send;
    byId("pause").addEventListener("click", () => send(`pause ${this.#moment?.paused ? 0 : 1}`));
    byId("step").addEventListener("click", () => send("step 1"));
    byId("pace").addEventListener("change", ({ target }) => send(`speed ${target.value}`));
    byId("strength").addEventListener("input", () => this.#tellStrength());
    byId("reset").addEventListener("click", () => send("reset"));
    byId("push").addEventListener("click", () => this.#push());
    byId("space").addEventListener("dblclick", () => this.#push());
    byId("space").addEventListener("keydown", ({ key }) => key === "Enter" && this.#push());
    this.#addDriving();
  }

  // Whether anything may be changed: the text says why not.
  may(refusal) {
    this.#refusal = refusal;
    for (const control of this.#byId("controls").querySelectorAll("button, select, input")) control.disabled = Boolean(refusal);
    this.#byId("controls").title = refusal;
    this.#byId("may").hidden = !refusal;
    this.#byId("may").textContent = refusal;
    this.pick(this.#picked);
  }

  begin(setting) {
    this.#setting = setting;
    this.#moment = null;
    this.#held.clear();
    this.#driven = "0 0";
    this.#byId("driving").hidden = !setting.mobile;
    this.pick(null);
  }

  // What shows the third dimension, in which a body can be picked.
  use(space) {
    this.#space = space;
  }

  pick(index) {
    this.#picked = index;
    const body = this.#setting?.bodies[index];
    this.#byId("space").dataset.picked = body?.name ?? "";
    // Where it is changes all the time, and is not read aloud.
    this.#byId("picked-name").textContent = body ? `${body.name} is picked` : "";
    this.#byId("push").disabled = Boolean(this.#refusal) || !body || body.fixed;
    this.#sayPicked();
  }

  #sayPicked() {
    const body = this.#setting?.bodies[this.#picked];
    const pose = this.#moment?.bodies[this.#picked];
    const where = pose?.slice(0, 3).map((number) => number?.toFixed(2) ?? "?") ?? [];
    this.#byId("picked").textContent = body ? [body.name, ...where, body.fixed ? "(fixed)" : ""].join(" ").trim() : "nothing picked";
  }

  take(moment) {
    this.#moment = moment;
  }

  draw() {
    if (!this.#moment) return;
    const { paused, speed } = this.#moment;
    this.#byId("pause").setAttribute("aria-pressed", paused);
    this.#byId("pause").textContent = paused ? "Go on" : "Pause";
    if (document.activeElement !== this.#byId("pace")) this.#showPace(String(Number(speed.toPrecision(3))));
    this.#sayPicked();
  }

  // A program may give a world another speed than those that are offered.
  #showPace(speed) {
    const pace = this.#byId("pace");
    const other = this.#byId("pace-other");
    const offered = [...pace.options].some((option) => option !== other && option.value === speed);
    if (!offered) other.textContent = speed;
    other.hidden = offered;
    pace.value = speed;
  }

  #tellStrength() {
    this.#byId("strength-told").textContent = `${Number(this.#byId("strength").value).toFixed(1)} m/s`;
  }

  #push() {
    const aim = this.#space?.aim;
    const body = this.#setting?.bodies[this.#picked];
    if (!aim || !body || body.fixed) return;
    const strength = Number(this.#byId("strength").value);
    const faster = aim.direction.map((part) => part * strength);
    this.#send(["hit", ...aim.point, ...faster, body.name].join(" "));
  }

  #addDriving() {
    addEventListener("keydown", (event) => {
      const letter = event.key.toLowerCase();
      if (!DRIVE_KEYS[letter] || event.ctrlKey || event.metaKey || event.altKey || typing(event)) return;
      this.#hold(letter, DRIVE_KEYS[letter]);
    });
    // Who has pressed Shift or Caps Lock meanwhile lets a capital letter go.
    addEventListener("keyup", ({ key }) => this.#release(key.toLowerCase()));
    for (const button of this.#byId("driving").querySelectorAll("button")) {
      const way = button.dataset.drive.split(" ").map(Number);
      button.addEventListener("pointerdown", () => this.#hold(button, way));
      button.addEventListener("contextmenu", (event) => event.preventDefault());
      button.addEventListener("keydown", ({ key }) => (key === "Enter" || key === " ") && this.#hold(button, way));
      for (const end of ["pointerup", "pointerleave", "pointercancel", "keyup", "blur"])
        button.addEventListener(end, () => this.#release(button));
    }
    // Keys that are let go elsewhere are not told of here.
    addEventListener("blur", () => this.#halt());
    document.addEventListener("visibilitychange", () => document.hidden && this.#halt());
    addEventListener("gamepadconnected", () => requestAnimationFrame(() => this.#readPads()));
  }

  #hold(what, way) {
    this.#held.set(what, way);
    this.#drive();
  }

  #release(what) {
    if (this.#held.delete(what)) this.#drive();
  }

  #halt() {
    this.#held.clear();
    this.#drive();
  }

  // A browser tells nothing of a stick that moves: it is to be looked at, as long as there is one.
  #readPads() {
    const pads = navigator.getGamepads().filter(Boolean);
    const part = (axis) => {
      const most = pads.map((pad) => pad.axes[axis] ?? 0).reduce((a, b) => (Math.abs(b) > Math.abs(a) ? b : a), 0);
      return Math.abs(most) < DEAD_ZONE ? 0 : -Math.round(most * STICK_STEPS) / STICK_STEPS;
    };
    this.#held.set("pad", pads.length ? [part(1), part(0)] : [0, 0]);
    this.#drive();
    if (pads.length) requestAnimationFrame(() => this.#readPads());
  }

  #drive() {
    if (!this.#setting?.mobile) return;
    const sum = (n) => Math.max(-1, Math.min(1, [...this.#held.values()].reduce((all, way) => all + way[n], 0)));
    // Of −0 no word is to be made.
    const wanted = `${sum(0) || 0} ${sum(1) || 0}`;
    if (wanted === this.#driven) return;
    this.#driven = wanted;
    this.#send(`drive ${wanted}`);
  }
}
