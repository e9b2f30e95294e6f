// The room of the robot: the page of a simulated world that runs in this server, in a frame while it is in sight.
import { make, put } from "./elements.js";

const PAGE = `
  <section class="card" id="robot" aria-labelledby="robot-title">
    <div class="bar">
      <h2 id="robot-title">Robot</h2>
      <label id="robot-choice"><span>world</span><select id="robot-world"></select></label>
      <a id="robot-alone" target="_blank" rel="opener">in a window of its own</a>
    </div>
    <div id="robot-frame"></div>
    <div id="robot-none">
      <p>There is no simulated world in this server that has a page. To get one, run this in the room <a href="#code">Code</a>:</p>
      <pre>requireFile("urbi/sim.u")|;
var Global.s = Simulation.new("examples/ball-tracking/table.world")|;
s.showPage(0, nil)|;</pre>
      <p>It is shown here as soon as it is there. A whole program is <code>./urbi examples/ball-tracking/demo.u</code>.</p>
    </div>
  </section>`;

export class Room {
  constructor(studio, host) {
    this.studio = studio;
    this.wanted = "";
    host.innerHTML = PAGE;
    this.find = (name) => host.querySelector(`#${name}`);
    this.find("robot-world").addEventListener("change", (event) => studio.go("robot", event.target.value));
    this.draw();
  }

  show(path) {
    this.shown = true;
    this.wanted = path;
    this.draw();
  }

  // A world of which nobody sees anything makes no pictures.
  hide() {
    this.shown = false;
    this.draw();
  }

  take(message) {
    if (message.type === "worlds") this.draw();
  }

  draw() {
    const { worlds } = this.studio;
    const world = worlds.find((each) => each.name === this.wanted) ?? worlds[0];
    this.find("robot-none").hidden = Boolean(world);
    this.find("robot-alone").hidden = !world;
    this.find("robot-choice").hidden = worlds.length < 2;
    const options = () => worlds.map(({ name, title }) => make("option", `${title} (${name})`, { value: name }));
    put(this.find("robot-world"), worlds, options);
    if (world) this.find("robot-world").value = world.name;
    const page = world ? `annex/${world.name}/` : "";
    this.find("robot-alone").href = page;
    const seen = this.shown ? page : "";
    put(this.find("robot-frame"), seen, () => (seen ? [this.frame(seen, `The world of ${world.title}`)] : []));
  }

  // It knows how high its page is, for screens on which the whole room scrolls.
  frame(src, title) {
    const frame = make("iframe", "", { src, title });
    frame.addEventListener("load", () => {
      const page = frame.contentDocument.body;
      const measure = () => frame.style.setProperty("--whole", `${page.offsetHeight + 2}px`);
      new ResizeObserver(measure).observe(page);
    });
    return frame;
  }
}
