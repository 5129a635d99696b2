// Plays motion in straight pieces: spheres seen from above, walls, impacts.
//
// Between impacts every sphere moves uniformly, so all there is to know are pieces
// [start, end, x, y, velocity x, velocity y] and the events between them (data.py describes the
// format). Nothing is simulated here; a time is looked up. Usage:
//
//     import { mount } from "./player.js";
//     const player = mount(element, data, { page: true });
//     player.play(); player.pause(); player.seek(1.5); player.next(); player.load(otherData);
//
// `page: true` listens to keys anywhere on the page, else only within the element. No markup is
// ever made of text: every text of the data becomes a text node.

import { Clock } from "./clock.js";
import { check } from "./controls.js";
import { button, html, mathematics, reachable } from "./elements.js";
import { listOfKeys, obey } from "./keys.js";
import { bounds, spoken, wordsOf } from "./motion.js";
import { Picture } from "./picture.js";
import { Card, Values } from "./tables.js";
import { Transport } from "./transport.js";

const MANY = 30; // events, beyond which not all are told in the description
const LEGEND =
  "Dashed: components along the line of centres, or perpendicular to the wall, and across it. " +
  "At an impact: faint as it was before, full as it is after.";
const KEYS = [
  ["Space", "play or pause"],
  ["→  ←", "next, previous impact"],
  [".  ,", "a little forward, back"],
  ["Home  End", "to the start, to the end"],
  ["S", "slow motion at impacts"],
  ["V  C  T", "velocities, components, trails"],
  ["+  −", "faster, slower"],
  ["?", "this list"],
];

class Player {
  constructor(root, data, { page = false, heading = "h1" } = {}) {
    this.root = root;
    this.clock = new Clock({
      moved: () => this.draw(),
      met: (event) => this.announce(event),
      turned: () => this.transport.turn(),
    });
    this.transport = new Transport(this.clock, {
      start: { label: "Back to the start", key: "Home", does: () => this.clock.rewind() },
      of: "the usual speed",
    });
    this.picture = new Picture();
    this.card = new Card();
    // The motion of a mistake, beside the true one and at the same time.
    this.shadow = new Clock({ moved() {}, met() {}, turned() {} });
    this.other = new Picture();
    this.otherCard = new Card();
    this.values = new Values();
    this.build(heading);
    this.load(data);
    this.listen(page ? document : root);
  }

  // --- its parts ---------------------------------------------------------------------------------

  build(heading) {
    this.title = html(heading, { class: "title" });
    this.drawn = html("p", { class: "drawn" });
    this.choice = html("select", { "aria-label": "Which motion" });
    this.slow = check("Slow motion at impacts", "S", true);
    this.velocities = check("Velocities", "V", true);
    this.components = check("Components", "C", true);
    this.trails = check("Trails", "T", true);
    this.help = listOfKeys(KEYS);
    const ask = button("Keys", () => this.help.showModal(), { title: "Keys (?)" });
    this.live = html("p", { class: "live", "aria-live": "polite" });
    this.notes = html("p", { class: "notes" });
    const options = [this.slow, this.velocities, this.components, this.trails];
    this.frame = html("div", { class: "frame" }, this.picture.node);
    this.trueLabel = html("p", { class: "label" }, "The true motion");
    const mistaken = html("p", { class: "label" }, "With the mistake:");
    this.mistaken = html("div", { class: "mistaken" }, mistaken, this.otherCard.node);
    this.otherLabel = html("p", { class: "label" });
    this.says = html("ul", { class: "says" });
    this.beside = html(
      "div",
      { class: "beside" },
      this.otherLabel,
      html("div", { class: "frame" }, this.other.node),
    );
    const first = html("div", { class: "first" }, this.trueLabel, this.frame);
    this.both = html("div", { class: "both" }, first);
    this.pictures = html("div", { class: "pictures" }, this.both);
    this.root.classList.add("restitution-player");
    this.root.replaceChildren(
      html("header", {}, this.title, this.drawn, this.choice),
      html(
        "div",
        { class: "floor" },
        html(
          "div",
          { class: "left" },
          this.pictures,
          this.transport.timeline,
          this.transport.node,
          html("div", { class: "options" }, ...options.map(({ node }) => node), ask),
          this.notes,
        ),
        html("div", { class: "right" }, this.card.node, this.values.node),
      ),
      this.live,
      this.help,
    );
  }

  listen(keys) {
    this.slow.box.addEventListener("change", () => {
      this.clock.slow = this.slow.box.checked;
    });
    for (const { box } of [this.velocities, this.components, this.trails]) {
      box.addEventListener("change", () => this.draw());
    }
    this.choice.addEventListener("change", () => this.choose(Number(this.choice.value)));
    this.onKey = (event) => this.key(event);
    this.keyTarget = keys;
    keys.addEventListener("keydown", this.onKey);
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(this.picture.node.parentNode);
  }

  // Takes the player away, with all that it listens to.
  destroy() {
    this.pause();
    this.observer.disconnect();
    this.keyTarget.removeEventListener("keydown", this.onKey);
    this.root.replaceChildren();
  }

  key(event) {
    if (this.help.open) return;
    const box = ({ box: each }) => () => each.click();
    const does = {
      ...this.transport.keys,
      s: box(this.slow),
      v: box(this.velocities),
      c: box(this.components),
      t: box(this.trails),
      "?": () => this.help.showModal(),
    };
    obey(event, does, this.transport.time);
  }

  // --- what it plays -----------------------------------------------------------------------------

  // Other data in the place of what was played.
  load(data) {
    this.data = data;
    this.title.textContent = data.title ?? "";
    this.title.hidden = !data.title;
    const labels = data.motions.map(({ label }, i) => label || `Motion ${i + 1}`);
    this.choice.replaceChildren(...labels.map((label, i) => html("option", { value: i }, label)));
    this.choice.hidden = data.motions.length < 2;
    const compared = data.motions.findLastIndex(({ beside }) => beside);
    this.choose(compared < 0 ? data.motions.length - 1 : compared);
  }

  // One of several motions.
  choose(index) {
    this.choice.value = String(index);
    const motion = this.data.motions[index];
    this.motion = motion;
    const { start, end } = motion;
    // Seconds that it takes to play at the usual speed, slow motion apart.
    const lasts = Math.min(16, 4 + 1.5 * motion.events.length);
    this.clock.load(motion, (end - start || 1) / lasts);
    this.drawn.replaceChildren(...mathematics(motion.drawn));
    this.drawn.hidden = !motion.drawn;
    this.notes.textContent = [LEGEND, ...motion.notes].join(" ");
    const moving = motion.spheres.map(({ name }) => name).join(", ");
    const told = motion.events.slice(0, MANY).map((event, i) => `${i + 1}: ${wordsOf(event)}`);
    const label = `Motion of ${moving} seen from above. ${told.join("; ")}.`;
    this.picture.node.setAttribute("aria-label", label);
    this.values.lay(motion);
    this.card.key = null;
    this.compare(motion.beside ?? null);
    this.live.textContent = "";
    this.width = 0;
    this.resize();
  }

  // Shows the motion of a mistake beside the true one, with what is wrong with it, or none.
  compare(beside) {
    this.trueLabel.hidden = beside === null;
    this.pictures.classList.toggle("two", beside !== null);
    if (beside === null) {
      for (const each of [this.beside, this.says, this.mistaken]) each.remove();
      return;
    }
    this.both.append(this.beside);
    this.pictures.append(this.says);
    this.card.node.after(this.mistaken);
    this.shadow.load(beside.motion, 1);
    this.otherCard.key = null;
    this.otherLabel.textContent = `With the mistake ${beside.label}`;
    this.says.replaceChildren(...beside.says.map((text) => html("li", {}, text)));
    const label = `The motion with the mistake. ${beside.says.join(" ")}`;
    this.other.node.setAttribute("aria-label", label);
  }

  // A view in which both motions are seen whole.
  wide(width, height) {
    const { motion } = this;
    const { motion: other } = motion.beside;
    const all = (part) => [...motion[part], ...other[part]];
    const [spheres, walls, events, points] = ["spheres", "walls", "events", "points"].map(all);
    return this.picture.whole({ ...motion, spheres, walls, events, points }, width, height);
  }

  resize() {
    const { frame } = this;
    const width = Math.floor(frame.clientWidth);
    if (!width || (width === this.width && innerHeight === this.seen)) return;
    this.width = width;
    this.seen = innerHeight;
    const [left, bottom, right, top] = bounds(this.motion);
    // Neither a strip nor a tower, and with its controls on one screen.
    const shape = Math.max(1.15, Math.min(2.1, (right - left) / (top - bottom || 1e-9)));
    const height = Math.max(190, Math.min(width / shape, 0.62 * innerHeight));
    const { beside = null } = this.motion;
    const view = beside && this.wide(width, Math.round(height));
    this.picture.lay(this.motion, width, Math.round(height), view);
    if (beside) this.other.lay(beside.motion, width, Math.round(height), view);
    this.transport.lay(width);
    this.draw();
    reachable(this.card.body);
    reachable(this.values.scroll);
  }

  // --- time --------------------------------------------------------------------------------------

  play() {
    this.clock.play();
  }

  pause() {
    this.clock.pause();
  }

  seek(t) {
    this.clock.seek(t);
  }

  next() {
    this.clock.next();
  }

  previous() {
    this.clock.previous();
  }

  announce(event) {
    this.live.textContent = spoken(event, this.motion.events.indexOf(event) + 1);
  }

  // --- what is seen ------------------------------------------------------------------------------

  draw() {
    if (!this.width) return;
    const { now, playing } = this.clock;
    const { focus, moment, shown, number } = this.clock.scene();
    const wanted = {
      velocities: this.velocities.box.checked,
      components: this.components.box.checked,
      trails: this.trails.box.checked,
    };
    this.picture.show(now, focus, moment, wanted);
    this.card.show(shown, number, moment ? shown.time : now);
    if (this.motion.beside) this.drawOther(now, wanted);
    this.values.show(now, playing);
    this.transport.show();
  }

  drawOther(now, wanted) {
    this.shadow.now = now;
    const { focus, moment, shown, number } = this.shadow.scene();
    this.other.show(now, focus, moment, wanted);
    this.otherCard.show(shown, number, moment ? shown.time : now);
  }
}

// A player in an element; `data` is described at the top of data.py.
export function mount(root, data, options) {
  return new Player(root, data, options);
}
