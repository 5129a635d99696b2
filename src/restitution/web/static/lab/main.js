// The Lab: a scene on a table, edited at its start, played as the server has worked it out.

import { Clock } from "../player/clock.js";
import { check } from "../player/controls.js";
import { allow, button, html } from "../player/elements.js";
import { isTyping, listOfKeys, obey } from "../player/keys.js";
import { placeAt, spoken } from "../player/motion.js";
import { dot, figures, seconds } from "../player/numbers.js";
import { CROWD } from "../player/picture.js";
import { Card } from "../player/tables.js";
import { Transport } from "../player/transport.js";
import { ask, sentence } from "../api.js";
import { fragment, read } from "./address.js";
import { Bars } from "./bars.js";
import { History } from "./history.js";
import { Instruments } from "./instruments.js";
import { Measure } from "./measure.js";
import { at, fromRows, still, withWall } from "./scene.js";
import { SCENES } from "./scenes.js";
import { Simulation } from "./simulation.js";
import { Stage } from "./stage.js";
import { Tools } from "./tools.js";
import { ValuesTable } from "./values.js";

const SELDOM = 250; // ms between two looks at tables, while it plays
const ROWS = 3; // of the table of a crowd, that follow in one frame
const CALM = 1500; // ms between two impacts that are announced, where they follow fast
const SHOWS = [
  ["velocities", "Velocities", "V"],
  ["components", "Components", "C"],
  ["speeds", "Speeds", "N"],
  ["momenta", "Momenta", "M"],
  ["impulses", "Impulses", "I"],
  ["trails", "Trails", "T"],
];
const HINT =
  "Drag a sphere to move it, the tip of its arrow to throw it; one at rest shows its tip when it " +
  "is chosen. A double click adds a sphere.";
const KEYS = [
  ["Space", "play or pause"],
  ["→  ←", "next, previous impact"],
  [".  ,", "a little forward, back"],
  ["R", "restart: play again from the start"],
  ["Home  End", "to the start, to the end"],
  ["S", "slow motion at impacts"],
  ["+  −", "faster, slower"],
  ...SHOWS.map(([, label, key]) => [key, label.toLowerCase()]),
  ["Ctrl Z  Ctrl Y", "undo, redo"],
  ["On a sphere or a wall:", ""],
  ["↑ ↓ ← →", "move it, with Shift ten times as far"],
  ["Enter", "on to its arrow, or its ends, and back"],
  ["0", "on an arrow: to rest"],
  ["Delete", "take it away"],
];

const named = (name) => ({ "aria-label": name, title: name });

class Lab {
  constructor(root) {
    this.root = root;
    this.stage = new Stage();
    this.card = new Card({ angles: true });
    this.bars = new Bars();
    this.values = new ValuesTable(this);
    this.tools = new Tools(this.stage, this);
    this.instruments = new Instruments(this.stage);
    this.measure = new Measure(this);
    this.clock = new Clock({
      moved: () => this.draw(),
      met: (event) => this.announce(event),
      turned: () => this.turn(),
    });
    this.transport = new Transport(this.clock, {
      start: { label: "Restart: play again from the start", key: "R", does: () => this.restart() },
      slowest: -5,
      of: "true speed",
      play: () => this.toggle(),
      next: () => this.step(),
    });
    this.simulation = new Simulation({
      came: (told) => this.arrive(told),
      refused: (error) => this.blame(error),
      failed: (text) => this.say(text),
    });
    this.history = new History(null);
    this.looked = -Infinity;
    this.build();
    this.listen();
    this.open();
  }

  // --- its parts ---------------------------------------------------------------------------------

  build() {
    this.menu = html(
      "select", { id: "scenes" },
      ...SCENES.map(({ id, title }) => html("option", { value: id }, title)),
      html("option", { value: "", hidden: true }, "A scene of your own"),
    );
    this.watch = html("p", { class: "watch", id: "watch" });
    this.toolButtons = [["move", "Move and throw"], ["wall", "Draw walls"]].map(([tool, label]) =>
      button(label, () => this.take(tool), { "data-tool": tool, "aria-pressed": "false" }));
    this.measuring = button("Measure", () => this.toMeasure(!this.measure.shown),
      { "aria-pressed": "false" });
    this.edits = {
      add: button("Add a sphere", () => this.tools.addSphere()),
      wall: button("Add a wall", () => this.tools.addWall()),
      remove: button("Delete", () => this.tools.remove()),
      undo: button("Undo", () => this.undo()),
      redo: button("Redo", () => this.redo()),
    };
    this.frame = html("div", { class: "frame" }, this.stage.picture.node, this.stage.handles,
      this.instruments.node);
    this.views = html("div", { class: "views", role: "group", "aria-label": "View" },
      button("+", () => this.zoom(1.25), named("Nearer")),
      button("−", () => this.zoom(0.8), named("Further away")),
      button("Fit", () => this.fit(), named("Fit: see all of the table")));
    this.slow = check("Slow motion at impacts", "S", true);
    this.shows = SHOWS.map(([key, label, letter]) =>
      ({ key, letter, ...check(label, letter, false) }));
    this.note = html("p", { class: "note", role: "status" });
    this.live = html("p", { class: "live", "aria-live": "polite" });
    const asking = "Make a question of this impact";
    this.make = button(asking, () => this.question(), { class: "main" });
    this.help = listOfKeys(KEYS);
    this.root.classList.add("restitution-player", "lab");
    this.root.replaceChildren(
      html("div", { class: "choose" },
        html("label", { for: "scenes" }, "Scene"), this.menu,
        button("Reset", () => this.reset(), named("Reset: put the scene back as it was prepared")),
        button("Copy link", () => this.copy()),
        button("Keys", () => this.help.showModal())),
      this.watch,
      html("div", { class: "floor" },
        html("div", { class: "left" },
          html("div", { class: "tools", role: "group", "aria-label": "Tools" },
            ...this.toolButtons, html("span", { class: "gap" }), ...Object.values(this.edits),
            html("span", { class: "gap" }), this.measuring),
          html("div", { class: "ground" }, this.frame, this.views),
          this.transport.timeline,
          this.transport.node,
          html("div", { class: "options" }, this.slow.node, ...this.shows.map(({ node }) => node)),
          this.note),
        html("div", { class: "right" }, this.card.node, this.make, this.bars.node)),
      this.measure.node,
      this.values.node,
      this.live,
      this.help,
    );
  }

  listen() {
    this.slow.box.addEventListener("change", () => {
      this.clock.slow = this.slow.box.checked;
    });
    for (const { box } of this.shows) box.addEventListener("change", () => this.draw());
    this.menu.addEventListener("change", () => this.prepare(this.menu.value));
    this.stage.picture.node.addEventListener("pointerdown", () => this.pause());
    document.addEventListener("keydown", (event) => this.key(event));
    addEventListener("popstate", () => this.open());
    addEventListener("hashchange", () => this.open());
    new ResizeObserver(() => this.resize()).observe(this.frame);
  }

  key(event) {
    if (this.help.open) return;
    if ((event.ctrlKey || event.metaKey) && !event.altKey) {
      this.edit(event);
      return;
    }
    const does = {
      ...this.transport.keys,
      r: () => this.restart(),
      s: () => this.slow.box.click(),
      "?": () => this.help.showModal(),
    };
    for (const { letter, box } of this.shows) does[letter.toLowerCase()] = () => box.click();
    obey(event, does, this.transport.time);
  }

  edit(event) {
    const letter = event.key.toLowerCase();
    const back = letter === "z" && !event.shiftKey;
    if (isTyping(event.target) || !["y", "z"].includes(letter)) return;
    event.preventDefault();
    if (back) this.undo();
    else this.redo();
  }

  // --- scenes ------------------------------------------------------------------------------------

  // What the address says; a prepared scene where it says nothing.
  open() {
    const text = location.hash.slice(1);
    if (text === this.address) return;
    const { scene, base, prepared, readable } = read(text);
    this.prepared = prepared;
    this.base = base;
    this.address = text;
    this.begin(scene);
    if (!readable) this.say("The address holds no scene that can be read.");
  }

  // A prepared scene, as a page of its own in the history of the browser.
  prepare(id) {
    this.prepared = SCENES.find((scene) => scene.id === id);
    this.base = fromRows(this.prepared);
    this.address = fragment(this.base, this.base, this.prepared);
    history.pushState(null, "", `#${this.address}`);
    this.begin(this.base);
  }

  // The scene as it was prepared, or as it was when the page was opened.
  reset() {
    this.history.put(this.base);
    this.fitted = false;
    this.renew();
    this.say("The scene is as it was prepared. Undo takes this back.");
  }

  begin(scene) {
    const wanted = new Set((this.prepared?.show ?? "velocities components trails").split(" "));
    for (const { key, box } of this.shows) box.checked = wanted.has(key);
    this.slow.box.checked = this.prepared?.slow ?? scene.spheres.length <= CROWD;
    this.clock.slow = this.slow.box.checked;
    this.menu.value = this.prepared?.id ?? "";
    this.watch.textContent = this.prepared?.watch ?? "";
    this.history.begin(scene);
    this.stage.selected = null;
    this.fitted = false;
    this.take("move");
    this.say(HINT);
    this.renew(true);
  }

  write() {
    const scene = this.initial();
    const text = fragment(scene, this.base, this.prepared);
    if (text === this.address || (scene === this.base && !this.address)) return;
    this.address = text;
    history.replaceState(null, "", `#${text}`);
  }

  // --- what the tools ask for --------------------------------------------------------------------

  initial() {
    return this.history.value;
  }

  // The scene as it is now.
  current() {
    const { now, motion } = this.clock;
    return this.known && now > motion.start ? at(this.initial(), motion, now) : this.initial();
  }

  preview(scene) {
    const shown = scene ?? this.current();
    this.clock.pause();
    this.stage.lay(still(shown), this.width, this.height);
    this.stage.picture.show(0, null, false, this.options());
    this.stage.hold(shown);
    this.values.show(shown, "");
  }

  // Another scene: what is moved while the motion is under way begins where it is now.
  commit(scene, key = null) {
    this.pause();
    const later = this.known && this.clock.now > 0;
    const old = this.initial().spheres;
    const moved = later && scene.spheres.some(({ position }, i) => position !== old[i]?.position);
    const when = seconds(this.clock.now);
    this.history.put(scene, later ? null : key);
    this.renew();
    const begun = `The table as it was at ${when} is the new start. Undo brings the old one back.`;
    this.say(moved ? begun : "");
  }

  choose(item) {
    const { selected } = this.stage;
    if (item?.kind === selected?.kind && item?.index === selected?.index) return;
    this.stage.selected = item;
    allow(this.edits.remove, item);
    this.stage.hold(this.current());
  }

  refuse(text) {
    this.say(text);
  }

  remove(kind, index) {
    this.stage.selected = { kind, index };
    this.tools.remove();
    this.values.focusAway(kind, index);
  }

  take(tool) {
    this.tools.tool = tool;
    this.stage.handles.dataset.tool = tool;
    for (const node of this.toolButtons) {
      node.setAttribute("aria-pressed", String(node.dataset.tool === tool));
    }
  }

  undo() {
    if (this.history.undo()) this.renew();
    else this.say("There is nothing to undo.");
  }

  redo() {
    if (this.history.redo()) this.renew();
    else this.say("There is nothing to do again.");
  }

  say(text) {
    this.note.textContent = text;
  }

  // --- the motion --------------------------------------------------------------------------------

  // The scene as it is at its start, and its motion asked for.
  renew(atOnce = false) {
    const scene = this.initial();
    const { selected } = this.stage;
    if (selected && !scene[selected.kind][selected.index]) this.stage.selected = null;
    allow(this.edits.remove, this.stage.selected);
    allow(this.edits.undo, this.history.past.length);
    allow(this.edits.redo, this.history.future.length);
    this.eager = false;
    this.load(still(scene), false);
    this.write();
    this.simulation.request(scene, atOnce ? 0 : undefined);
  }

  // The motion of the scene; it is played if that was asked for before it was there.
  arrive({ motion, stopped }) {
    const eager = this.eager;
    this.load(motion, true);
    if (stopped) this.say(sentence(stopped));
    if (eager) this.clock.play();
    this.eager = false;
  }

  // Says why there is no motion, and shows with whom it is.
  blame({ message, bodies }) {
    this.eager = false;
    const index = this.initial().spheres.findIndex(({ name }) => bodies.includes(name));
    if (index >= 0) this.choose({ kind: "spheres", index });
    this.say(`This cannot be: ${message}.`);
  }

  load(motion, known) {
    this.known = known;
    this.clock.load(motion, 1);
    this.transport.time.disabled = !known;
    this.bars.lay(motion);
    this.values.lay(this.initial());
    this.card.key = null;
    clearTimeout(this.untold);
    this.live.textContent = "";
    const all = motion.spheres.map(({ name }) => name);
    const told = all.length > CROWD ? `${all.length} spheres` : all.join(", ");
    this.stage.picture.node.setAttribute("aria-label", `A table seen from above, with ${told}.`);
    this.lay();
  }

  resize() {
    const width = Math.floor(this.frame.clientWidth);
    if (!width || (width === this.width && innerHeight === this.seen)) return;
    this.seen = innerHeight;
    this.width = width;
    this.height = Math.round(Math.max(200, Math.min(0.62 * width, 0.54 * innerHeight)));
    this.fitted = false;
    this.lay();
  }

  lay() {
    if (!this.width) return;
    if (!this.fitted) {
      this.stage.fit(this.initial(), this.width, this.height);
      this.fitted = true;
    }
    this.stage.lay(this.clock.motion, this.width, this.height);
    this.instruments.draw();
    this.transport.lay(this.width);
    this.draw();
  }

  fit() {
    this.fitted = false;
    this.lay();
  }

  zoom(factor) {
    this.stage.zoom(factor);
    this.lay();
  }

  pan(way) {
    this.stage.pan(way);
    this.lay();
  }

  // --- time --------------------------------------------------------------------------------------

  toggle() {
    if (this.clock.playing) this.clock.pause();
    else if (this.known) this.clock.play();
    else this.eager = true;
  }

  pause() {
    this.clock.pause();
    this.eager = false;
  }

  step() {
    if (this.known) this.clock.next();
  }

  restart() {
    this.clock.pause();
    this.clock.seek(0);
    this.toggle();
  }

  // It begins or ceases to play.
  turn() {
    this.transport.turn();
    const { playing } = this.clock;
    const had = this.stage.focused();
    if (playing && had) this.had = had;
    this.frame.classList.toggle("playing", playing);
    if (playing) return;
    this.draw();
    const free = document.activeElement === document.body;
    if (this.had && free) this.stage.focus(this.had.kind, this.had.index);
    this.had = null;
  }

  announce(event) {
    const now = performance.now();
    clearTimeout(this.untold);
    const soon = this.announced + CALM - now;
    if (this.clock.playing && !this.clock.slow && soon > 0) {
      this.untold = setTimeout(() => this.announce(event), soon);
      return;
    }
    this.announced = now;
    this.live.textContent = spoken(event, this.clock.motion.events.indexOf(event) + 1);
  }

  // --- what is seen ------------------------------------------------------------------------------

  options() {
    const chosen = Object.fromEntries(this.shows.map(({ key, box }) => [key, box.checked]));
    return { ...chosen, angles: chosen.components };
  }

  draw() {
    if (!this.width) return;
    const began = performance.now();
    const { now, playing } = this.clock;
    const { focus, moment, shown, number } = this.clock.scene();
    // While a crowd moves fast nothing is looked at closely.
    const close = this.clock.slow || !playing ? focus : null;
    this.stage.picture.show(now, close, moment, this.options());
    // The tables are costly: while it plays they follow seldom, and those of a crowd row by row.
    const crowd = playing && this.initial().spheres.length > CROWD;
    if (crowd) this.values.follow(this.current(), ROWS, ` at ${seconds(now)}`);
    if (!playing || began - this.looked >= SELDOM || (close && !crowd)) {
      this.looked = began;
      this.shown = shown;
      allow(this.make, shown?.kind === "impact");
      this.card.show(shown, number, moment ? shown.time : now);
      this.bars.show(now);
      this.measure.look();
      if (!playing) this.look();
      else if (!crowd) this.values.show(this.current(), ` at ${seconds(now)}`);
    }
    this.transport.show();
  }

  // The tables and handles of what stands still.
  look() {
    const { now } = this.clock;
    const scene = this.current();
    this.values.showAll(scene, now > 0 ? ` at ${seconds(now)}` : " at the start");
    this.stage.hold(scene);
  }

  // --- measuring ---------------------------------------------------------------------------------

  // With instruments on the table, and without the true values beside it.
  toMeasure(on) {
    this.measuring.setAttribute("aria-pressed", String(on));
    this.card.node.hidden = on;
    this.measure.show(on);
    this.instruments.show(on);
    if (on && !this.spread) this.instruments.spread();
    this.spread ||= on;
    this.measure.look();
  }

  // The impact with a wall that is shown, or null.
  impact() {
    const event = this.shown;
    return event?.kind === "impact" && event.wall ? event : null;
  }

  impacts() {
    return this.clock.motion?.events.filter(({ kind, wall }) => kind === "impact" && wall) ?? [];
  }

  // Lays the protractor to an impact with a wall, where the ball is as they meet.
  align(event) {
    if (!event) return this.say("Nothing hits a wall now. Play until something does.");
    const [name] = event.bodies;
    const ball = this.clock.motion.spheres.find((sphere) => sphere.name === name);
    const sign = dot(event.before[name], event.line) > 0 ? -1 : 1;
    this.instruments.lay(placeAt(ball, event.time), event.line.map((x) => sign * x));
  }

  // Gives all walls one coefficient that is not shown. False where there is no wall.
  conceal() {
    const scene = this.initial();
    if (!scene.walls.length) {
      this.say("There is no wall on the table: draw one.");
      return false;
    }
    const e = Number((0.35 + 0.6 * Math.random()).toFixed(2));
    this.concealed = true;
    this.root.classList.add("secret");
    this.history.put(scene.walls.reduce((made, _, i) => withWall(made, i, { e }), scene));
    this.renew();
    this.say("The walls have another e now, which you do not see. Measure it.");
    return true;
  }

  reveal() {
    if (!this.concealed) return;
    this.concealed = false;
    this.root.classList.remove("secret");
    const [{ e } = {}] = this.initial().walls;
    if (e !== undefined) this.say(`The e of ${this.initial().walls[0].name} is ${figures(e)}.`);
  }

  // --- beyond the page ---------------------------------------------------------------------------

  async question() {
    const event = this.shown;
    if (event?.kind !== "impact") return;
    const scene = this.initial();
    const massOf = (name) => scene.spheres.find((sphere) => sphere.name === name).mass;
    const impact = {
      spheres: event.bodies.map((name) => ({
        name, mass: massOf(name), velocity: event.before[name],
      })),
      wall: event.wall,
      line: event.line,
      e: event.e,
    };
    try {
      const { statement } = await ask("statement", { impact });
      location.href = `./#${new URLSearchParams({ statement })}`;
    } catch (error) {
      this.say(sentence(error.message));
    }
  }

  async copy() {
    try {
      await navigator.clipboard.writeText(location.href);
      this.say("The link to this scene is copied.");
    } catch {
      this.say("The link is in the address bar: it could not be copied from here.");
    }
  }
}

const root = document.getElementById("lab");
root.lab = new Lab(root);
