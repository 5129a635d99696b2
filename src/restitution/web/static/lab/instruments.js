// A protractor and a ruler, which lie on the table, are moved by their bodies and turned by a knob.

import { svg } from "../player/elements.js";
import { figures, plus, size } from "../player/numbers.js";
import { tidyStep } from "./scene.js";

const DEGREE = Math.PI / 180;
const KNOB = 9; // px: its radius, within a target that is larger
const TARGET = 15;
const BAND = 40; // px: of the protractor, from the rim inwards, by which it is moved
const SMALL = 120; // px: a smaller protractor has fewer numbers
const BROAD = 30; // px: how broad the ruler is
const TURN = 1; // degrees of a key
const MOVE = 3; // px of a key, with Shift ten times as many

const unit = (angle) => [Math.cos(angle), -Math.sin(angle)]; // y of the picture points down
const spot = ([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`;
const d = (points) => `M${points.map(spot).join("L")}`;

// What both instruments share: a place in metres, an angle of the base line to i, and being moved.
class Instrument {
  constructor(name, stage) {
    this.stage = stage;
    this.name = name;
    this.place = [0, 0];
    this.angle = 0;
    this.marks = svg("g", { class: "marks" });
    this.body = svg("path", { class: "body" });
    this.knob = svg("g", { class: "knob" },
      svg("circle", { class: "target", r: TARGET }), svg("circle", { class: "seen", r: KNOB }));
    this.node = svg("g", {
      class: `instrument ${name}`, tabindex: 0, role: "button", "aria-roledescription": name,
    }, this.body, this.marks, this.knob);
    this.follow(this.body, (from, to) => this.shift(plus(to, from, -1)));
    this.follow(this.knob, (from, to) => this.turnTo(to));
    this.node.addEventListener("keydown", (event) => this.key(event));
  }

  // Pointer events on a part of it, as ways from pixel to pixel.
  follow(part, move) {
    let last = null;
    part.addEventListener("pointerdown", (event) => {
      if (event.button) return;
      last = this.stage.pixel(event);
      part.setPointerCapture(event.pointerId);
      event.preventDefault();
      event.stopPropagation();
      this.node.focus({ preventScroll: true });
    });
    part.addEventListener("pointermove", (event) => {
      if (!last) return;
      const now = this.stage.pixel(event);
      move(last, now);
      last = now;
    });
    for (const end of ["pointerup", "pointercancel"]) {
      part.addEventListener(end, () => {
        last = null;
      });
    }
    part.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
  }

  shift([x, y]) {
    const { k } = this.stage.view;
    const { width, height } = this.stage;
    const [px, py] = this.stage.at(plus(this.place, [x / k, -y / k]));
    // Its middle stays where it can be taken hold of.
    const inside = [Math.max(0, Math.min(width, px)), Math.max(0, Math.min(height, py))];
    this.place = this.stage.place(inside);
    this.draw();
  }

  turnTo(pixel) {
    const [x, y] = plus(pixel, this.stage.at(this.place), -1);
    if (size([x, y]) > TARGET) this.angle = Math.atan2(-y, x) + (this.turned ? Math.PI : 0);
    this.draw();
  }

  // Puts the knob at one end, or at the other where that one is not seen.
  hold(end, other) {
    const { width, height } = this.stage;
    const seen = ([x, y]) => x > 0 && x < width && y > 0 && y < height;
    this.turned = Boolean(other) && !seen(end) && seen(other);
    this.knob.setAttribute("transform", `translate(${(this.turned ? other : end).join(" ")})`);
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const far = event.shiftKey ? 10 * MOVE : MOVE;
    const ways = {
      ArrowLeft: [-far, 0], ArrowRight: [far, 0], ArrowUp: [0, -far], ArrowDown: [0, far],
    };
    const turns = { PageUp: TURN, PageDown: -TURN };
    if (ways[event.key]) this.shift(ways[event.key]);
    else if (turns[event.key]) {
      this.angle += turns[event.key] * DEGREE * (event.shiftKey ? 10 : 1);
      this.draw();
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }

  draw() {
    if (!this.stage.width) return;
    const degrees = ((this.angle / DEGREE) % 360 + 360) % 360;
    const [x, y] = this.place;
    this.node.setAttribute("aria-label",
      `The ${this.name}, at ${figures(x)}, ${figures(y)} m, its base line at ` +
      `${figures(degrees)}° to i. Arrow keys move it, Page Up and Page Down turn it.`);
    this.trace(this.stage.at(this.place));
  }

  // A number of its scale, upright.
  number(text, [x, y]) {
    return svg("text", { x: x.toFixed(1), y: y.toFixed(1) }, text);
  }
}

class Protractor extends Instrument {
  constructor(stage) {
    super("protractor", stage);
  }

  get radius() {
    const { width, height } = this.stage;
    return Math.max(90, Math.min(0.32 * width, 0.46 * height, 190));
  }

  trace(middle) {
    const r = this.radius;
    const at = (degrees, far) => plus(middle, unit(this.angle + degrees * DEGREE), far);
    const arc = (far, sweep, end) => `A${far} ${far} 0 0 ${sweep} ${spot(end)}`;
    const inner = r - BAND;
    this.body.setAttribute("d",
      d([at(0, r)]) + arc(r, 0, at(180, r)) + `L${spot(at(180, inner))}` +
      arc(inner, 1, at(0, inner)) + "Z");
    let ticks = d([at(0, r), at(180, r)]) + d([at(90, 7), at(-90, 7)]);
    const numbers = [];
    for (let n = 0; n <= 180; n += 1) {
      const long = n % 10 === 0 ? 12 : n % 5 === 0 ? 9 : 5;
      ticks += d([at(n, r), at(n, r - long)]);
      if (n % (r < SMALL ? 30 : 10)) continue;
      numbers.push(this.number(String(n), at(n, r - 20)));
      if (r < SMALL || n % 30 || n % 180 === 0) continue;
      const other = this.number(String(180 - n), at(n, r - 33)); // as on a scale from the left
      other.setAttribute("class", "other");
      numbers.push(other);
    }
    this.marks.replaceChildren(svg("path", { d: ticks }), ...numbers);
    this.hold(at(0, r + KNOB + 4), at(180, r + KNOB + 4));
  }
}

class Ruler extends Instrument {
  constructor(stage) {
    super("ruler", stage);
  }

  trace(start) {
    const { view, width } = this.stage;
    const step = tidyStep(6 / view.k); // m
    const count = 10 * Math.max(1, Math.floor((0.45 * width) / view.k / step / 10));
    const along = unit(this.angle);
    const across = [along[1], -along[0]]; // from the edge with the marks to the other, reversed
    const at = (n, down) => plus(plus(start, along, n * step * view.k), across, -down);
    const long = [at(-1.6, 0), at(count + 1.6, 0), at(count + 1.6, BROAD), at(-1.6, BROAD)];
    this.body.setAttribute("d", `${d(long)}Z`);
    let ticks = "";
    const numbers = [];
    for (let n = 0; n <= count; n += 1) {
      ticks += d([at(n, 0), at(n, n % 10 === 0 ? 13 : n % 5 === 0 ? 10 : 6)]);
      if (n % 10 === 0) numbers.push(this.number(String(Number((n * step).toPrecision(6))), at(n, 22)));
    }
    numbers[0].append(" m");
    this.marks.replaceChildren(svg("path", { d: ticks }), ...numbers);
    this.hold(plus(at(count + 1.6, BROAD / 2), along, KNOB + 4));
  }
}

// Both of them, over the table.
export class Instruments {
  constructor(stage) {
    this.stage = stage;
    this.protractor = new Protractor(stage);
    this.ruler = new Ruler(stage);
    this.all = [this.ruler, this.protractor];
    this.node = svg("svg", { class: "instruments", role: "group", "aria-label": "Instruments" },
      ...this.all.map(({ node }) => node));
    this.show(false);
  }

  show(on) {
    this.node.toggleAttribute("hidden", !on);
    this.shown = on;
    if (on) this.draw();
  }

  // Anew, where the picture is: its size or what is seen of the table may be another.
  draw() {
    if (!this.shown) return;
    const { width, height } = this.stage;
    this.node.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.node.setAttribute("width", width);
    this.node.setAttribute("height", height);
    for (const each of this.all) each.draw();
  }

  // Lays the protractor to a wall: its middle at a place, its half disc on the side of a direction.
  lay(place, [x, y]) {
    this.protractor.place = place;
    this.protractor.angle = Math.atan2(-x, y);
    this.protractor.draw();
  }

  // Puts both where they can be seen.
  spread() {
    const { width, height } = this.stage;
    this.protractor.place = this.stage.place([width / 2, 0.72 * height]);
    this.ruler.place = this.stage.place([0.08 * width, 0.12 * height]);
    this.protractor.angle = this.ruler.angle = 0;
    this.draw();
  }
}
