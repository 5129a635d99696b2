// The table seen from above: a picture at a fixed scale, and over it what can be taken hold of.

import { svg } from "../player/elements.js";
import { around, bounds } from "../player/motion.js";
import { figures, plus, size } from "../player/numbers.js";
import { Picture } from "../player/picture.js";
import { still, tidyStep } from "./scene.js";

const TARGET = 14; // px: nothing that can be dragged has a smaller radius
const GRIP = 6; // px: the radius of what is seen of a handle
const BEYOND = 13; // px from a sphere at which a short arrow is taken hold of
const FEW = 12; // spheres whose arrows can all be taken hold of

const said = ([x, y]) => `${figures(x)}, ${figures(y)}`;

export class Stage {
  constructor() {
    this.picture = new Picture();
    this.grid = svg("g", { class: "grid" });
    this.handles = svg("svg", {
      class: "handles", role: "group", "aria-label": "The table: spheres and walls",
    });
    this.view = null;
    this.selected = null;
    this.counts = "";
  }

  // --- what is seen of the table -----------------------------------------------------------------

  // A view of a whole scene, with room for its arrows.
  fit(scene, width, height) {
    const fastest = Math.max(...scene.spheres.map(({ velocity }) => size(velocity)), 0) || 1;
    const most = Math.min(0.16 * width, 0.28 * height, 150);
    const arrow = most / Math.sqrt(Math.max(1, scene.spheres.length / 6)) / fastest;
    // For the names of walls; those of upright ones stand beside them.
    const longest = Math.max(0, ...scene.walls.map(({ name }) => name.length));
    const [beside, above] = [Math.max(42, Math.min(20 + 9 * longest, 0.15 * width)), 42];
    const fitting = ([left, bottom, right, top]) => ({
      k: Math.min(
        (width - 2 * beside) / Math.max(right - left, 0.5),
        (height - 2 * above) / Math.max(top - bottom, 0.5),
      ),
      middle: [(left + right) / 2, (bottom + top) / 2],
      arrow,
    });
    const bare = bounds(still(scene));
    const metres = arrow / fitting(bare).k;
    const tips = scene.spheres.map(({ position, velocity }) => plus(position, velocity, metres));
    this.view = fitting(around(bare, tips));
  }

  zoom(factor) {
    const { k, middle, arrow } = this.view;
    this.view = { k: Math.max(4, Math.min(20000, k * factor)), middle, arrow };
  }

  pan([x, y]) {
    const { k, middle } = this.view;
    this.view = { ...this.view, middle: [middle[0] - x / k, middle[1] + y / k] };
  }

  // Makes the picture anew.
  lay(motion, width, height) {
    this.width = width;
    this.height = height;
    this.picture.lay(motion, width, height, this.view);
    this.picture.ground.append(this.grid);
    this.drawGrid();
    this.handles.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.handles.setAttribute("width", width);
    this.handles.setAttribute("height", height);
  }

  at(point) {
    return this.picture.at(point);
  }

  // Metres of a pixel of the picture.
  place([x, y]) {
    const { k, middle } = this.view;
    return [(x - this.width / 2) / k + middle[0], (this.height / 2 - y) / k + middle[1]];
  }

  pixel(event) {
    const box = this.handles.getBoundingClientRect();
    const share = this.width / (box.width || this.width);
    return [(event.clientX - box.left) * share, (event.clientY - box.top) * share];
  }

  // Steps in which places (m) and velocities (m/s) are dragged and nudged.
  get step() {
    return tidyStep(3 / this.view.k);
  }

  get speedStep() {
    return tidyStep(3 / this.view.arrow);
  }

  drawGrid() {
    const step = tidyStep(36 / this.view.k);
    const [left, top] = this.place([0, 0]);
    const [right, bottom] = this.place([this.width, this.height]);
    let path = "";
    for (let n = Math.ceil(left / step); n * step <= right; n += 1) {
      path += `M${this.at([n * step, 0])[0].toFixed(1)} 0V${this.height}`;
    }
    for (let n = Math.ceil(bottom / step); n * step <= top; n += 1) {
      path += `M0 ${this.at([0, n * step])[1].toFixed(1)}H${this.width}`;
    }
    const y = this.height - 10;
    const long = step * this.view.k;
    this.grid.replaceChildren(
      svg("path", { class: "lines", d: path }),
      svg("path", { class: "scale", d: `M10 ${y - 5}v5h${long}v-5` }),
      svg("text", { class: "number", x: 10 + long / 2, y: y - 10 }, `${step} m`),
    );
  }

  // --- what can be taken hold of -----------------------------------------------------------------

  // Puts the handles where things are in a scene.
  hold(scene) {
    const counts = [scene.spheres, scene.walls].map((list) => list.length).join();
    if (counts !== this.counts) this.make(scene, counts);
    scene.spheres.forEach((sphere, i) => this.holdSphere(sphere, this.balls[i], i, scene));
    scene.walls.forEach((wall, i) => this.holdWall(wall, this.bars[i], i));
  }

  make(scene, counts) {
    const had = this.focused();
    this.counts = counts;
    const handle = (kind, i, what, ...shapes) =>
      svg("g", {
        class: `handle ${kind}`, tabindex: 0, role: "button", "aria-roledescription": what,
        "data-kind": kind, "data-index": i,
      }, ...shapes);
    const shapes = (name, r, grip) => [
      svg(name, { class: "hit", r }), svg(name, { class: "grip", r: grip }),
    ];
    const point = (kind, i, what) => handle(kind, i, what, ...shapes("circle", TARGET, GRIP));
    this.bars = scene.walls.map((_, i) => ({
      bar: handle("wall", i, "wall", ...shapes("path")),
      start: point("start", i, "end of a wall"),
      end: point("end", i, "end of a wall"),
    }));
    this.balls = scene.spheres.map((_, i) => ({
      ball: handle("sphere", i, "sphere", ...shapes("circle")),
      tip: point("tip", i, "tip of a velocity"),
    }));
    this.draft = svg("path", { class: "draft", d: "M0 0" });
    this.handles.replaceChildren(
      svg("rect", { class: "nothing", width: "100%", height: "100%" }),
      ...this.bars.flatMap(({ bar, start, end }) => [bar, start, end]),
      ...this.balls.map(({ ball }) => ball),
      ...this.balls.map(({ tip }) => tip),
      this.draft,
    );
    // Where that was taken away, another is taken hold of.
    if (had && !this.focus(had.kind, had.index)) this.focus("sphere", scene.spheres.length - 1);
  }

  holdSphere({ name, mass, radius, position, velocity }, { ball, tip }, i, scene) {
    const place = this.at(position);
    const r = Math.max(radius * this.view.k, TARGET);
    const chosen = this.is("spheres", i);
    ball.setAttribute("transform", `translate(${place[0]} ${place[1]})`);
    for (const circle of ball.children) circle.setAttribute("r", r);
    ball.setAttribute("aria-label",
      `${name}: mass ${figures(mass)} kg, at ${said(position)} m, velocity ${said(velocity)} m/s`);
    ball.classList.toggle("selected", chosen);
    const end = this.tipOf(place, velocity, radius);
    const long = size(velocity) * this.view.arrow > radius * this.view.k;
    tip.setAttribute("transform", `translate(${end[0]} ${end[1]})`);
    tip.setAttribute("aria-label", `Velocity of ${name}: ${said(velocity)} m/s`);
    const seen = chosen || (long && scene.spheres.length <= FEW);
    tip.setAttribute("visibility", seen ? "visible" : "hidden");
    tip.setAttribute("tabindex", chosen ? 0 : -1);
  }

  // Where the tip of an arrow is taken hold of: never within its own sphere.
  tipOf(place, velocity, radius) {
    const { k, arrow } = this.view;
    const way = [arrow * velocity[0], -arrow * velocity[1]];
    const least = radius * k + BEYOND;
    if (size(way) >= least) return plus(place, way);
    const unit = size(way) > 1e-9 ? way : [0.8, -0.6];
    return plus(place, unit, least / size(unit));
  }

  holdWall({ name, start, end, e }, { bar, start: first, end: second }, i) {
    const [a, b] = [this.at(start), this.at(end)];
    const chosen = this.is("walls", i);
    for (const path of bar.children) path.setAttribute("d", `M${a.join(" ")}L${b.join(" ")}`);
    bar.setAttribute("aria-label",
      `Wall ${name}, from ${said(start)} to ${said(end)} m, e = ${figures(e)}`);
    bar.classList.toggle("selected", chosen);
    [[first, a, start, "start"], [second, b, end, "end"]].forEach(([node, place, point, what]) => {
      node.setAttribute("transform", `translate(${place[0]} ${place[1]})`);
      node.setAttribute("aria-label", `${name}: its ${what}, at ${said(point)} m`);
      node.setAttribute("tabindex", chosen ? 0 : -1);
      node.setAttribute("visibility", chosen ? "visible" : "hidden");
    });
  }

  is(kind, index) {
    return this.selected?.kind === kind && this.selected.index === index;
  }

  // A wall that is being drawn; null when it is done.
  drawDraft(from, to) {
    const d = from ? `M${this.at(from).join(" ")}L${this.at(to).join(" ")}` : "M0 0";
    this.draft?.setAttribute("d", d);
  }

  focused() {
    const node = document.activeElement?.closest?.(".handle");
    return node ? { kind: node.dataset.kind, index: Number(node.dataset.index) } : null;
  }

  focus(kind, index) {
    const node = this.handles.querySelector(`[data-kind="${kind}"][data-index="${index}"]`);
    node?.focus({ preventScroll: true });
    return Boolean(node);
  }
}
