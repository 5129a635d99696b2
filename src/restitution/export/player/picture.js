// A motion at a time, seen from above: spheres, walls, arrows, what an impact does.

import { svg } from "./elements.js";
import {
  across, along, around, behind, bounds, fastest, pieceAt, placeAt,
} from "./motion.js";
import { cross, dot, figures, plus, size } from "./numbers.js";

export const COLOURS = 6;
export const CROWD = 12; // spheres, beyond which those without room for their names have none
const TRAIL = 30; // pieces that are seen of where a sphere has been
const ARC = 34; // px: the radius of an angle
const LETTER = 4.2; // px: half the width of one, about
const DOT = 5; // px: the radius of a sphere of negligible size

export class Picture {
  constructor() {
    this.node = svg("svg", { class: "stage", role: "img" });
  }

  // Makes all shapes anew: for another motion, or another size of the picture. A `view` says what
  // is seen: the point in the middle, `k` pixels to a metre, `arrow` pixels to 1 m/s; without one
  // the whole motion is.
  lay(motion, width, height, view = null) {
    this.motion = motion;
    this.blowLength = Math.min(0.16 * width, 0.25 * height, 110);
    const { k, middle, arrow } = view ?? this.whole(motion, width, height);
    this.arrow = arrow;
    const masses = motion.spheres.map(({ mass }) => mass ?? 1);
    this.usual = masses.reduce((sum, mass) => sum + mass, 0) / (masses.length || 1);
    this.scale = k;
    this.at = ([x, y]) => [width / 2 + k * (x - middle[0]), height / 2 - k * (y - middle[1])];
    this.width = width;
    this.node.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.node.setAttribute("width", width);
    this.node.setAttribute("height", height);
    this.node.replaceChildren();
    this.ground = this.add("g", "ground"); // for those who put something beneath
    this.node.append(svg("g", { class: "walls" }, ...motion.walls.flatMap((w) => this.wall(w))));
    this.node.append(...motion.points.flatMap((point) => this.point(point)));
    this.trailed = new Map();
    this.trails = motion.spheres.map((_, i) => this.add("path", `trail body${i % COLOURS}`));
    this.guide = this.add("path", "guide");
    this.ghosts = this.add("g", "ghosts");
    this.discs = motion.spheres.map((sphere, i) => this.disc(sphere, i));
    this.momenta = motion.spheres.map((_, i) => this.arrowhead(`momentum body${i % COLOURS}`));
    this.arrows = motion.spheres.map((_, i) => ({
      velocity: this.arrowhead(`velocity body${i % COLOURS}`),
      came: this.arrowhead(`velocity came body${i % COLOURS}`),
    }));
    this.parts = [0, 1].map(() => ({
      box: this.add("path", "box"),
      leaves: this.componentsOf("component"),
      came: this.componentsOf("component came"),
      texts: [0, 1, 2, 3].map(() => this.add("text", "number")),
    }));
    this.arcs = ["α", "β"].map((letter) => {
      const arc = { path: this.add("path", "arc"), text: this.add("text", "angle") };
      arc.text.append(letter);
      return arc;
    });
    this.blow = this.arrowhead("blow");
    this.blows = [0, 1].map(() => this.arrowhead("blow share"));
    this.speeds = motion.spheres.map((_, i) => this.add("text", `number body${i % COLOURS}`));
    this.told = motion.spheres.map(() => null); // of which piece the speed stands there
    this.names = motion.spheres.map((sphere) => this.add("text", "name"));
    this.crowded = motion.spheres.length > CROWD;
    motion.spheres.forEach(({ name, radius }, i) => {
      const fits = radius * k > 4 * name.length + 4;
      if (fits || !this.crowded) this.names[i].append(name);
    });
  }

  // A view of all that happens, arrows included.
  whole(motion, width, height) {
    const longest = Math.min(0.2 * width, 0.34 * height, 150);
    const arrow = longest / Math.sqrt(Math.max(1, motion.spheres.length / 4)) / fastest(motion);
    this.arrow = arrow;
    const margin = Math.min(40, 0.08 * width + 6);
    const fit = ([left, bottom, right, top]) => {
      const k = Math.min(
        (width - 2 * margin) / (right - left || 1e-9),
        (height - 2 * margin) / (top - bottom || 1e-9),
      );
      return { k, middle: [(left + right) / 2, (bottom + top) / 2] };
    };
    const bare = bounds(motion);
    return { ...fit(around(bare, this.tips(motion, 1 / fit(bare).k))), arrow };
  }

  // Where arrows begin and end, in m, with so many metres for a pixel.
  tips(motion, metre) {
    const found = [];
    const k = this.arrow * metre;
    for (const { pieces } of motion.spheres) {
      for (const [, , x, y, vx, vy] of pieces) found.push([x + vx * k, y + vy * k]);
      const [start, end, x, y, vx, vy] = pieces.at(-1);
      found.push([x + vx * (end - start + 0.6 * k), y + vy * (end - start + 0.6 * k)]);
    }
    for (const event of motion.events) {
      for (const name of event.bodies) {
        const sphere = motion.spheres.find((each) => each.name === name);
        const place = placeAt(sphere, event.time);
        found.push(plus(place, event.before[name], -k));
        if (event.kind === "blow") {
          const far = (this.blowLength * metre) / (size(event.impulse) || 1);
          found.push(plus(place, event.impulse, -far));
        }
      }
    }
    return found;
  }

  add(name, kind) {
    const made = svg(name, { class: kind });
    this.node.append(made);
    return made;
  }

  arrowhead(kind) {
    const shaft = svg("path", { class: "shaft" });
    const head = svg("path", { class: "head" });
    const node = svg("g", { class: `arrow ${kind}` }, shaft, head);
    this.node.append(node);
    return { node, shaft, head };
  }

  componentsOf(kind) {
    return { along: this.arrowhead(kind), across: this.arrowhead(kind) };
  }

  wall(wall) {
    if (!wall.points) return this.roundWall(wall);
    const points = wall.closed ? [...wall.points, wall.points[0]] : wall.points;
    const made = [];
    let hatching = "";
    for (let i = 0; i + 1 < points.length; i += 1) {
      const side = behind(points[i], points[i + 1], this.motion);
      hatching += this.hatches(this.at(points[i]), this.at(points[i + 1]), -side);
      if (i === 0 && wall.name) made.push(this.wallName(wall.name, points, side));
    }
    const line = points.map((point) => this.at(point).join(" ")).join("L");
    return [
      svg("path", { class: "hatch", d: hatching || "M0 0" }),
      svg("path", { class: "wall", d: `M${line}` }),
      ...made,
    ];
  }

  // Short strokes behind a wall; y points down here, so the sides are exchanged.
  hatches(a, b, side) {
    const way = plus(b, a, -1);
    const length = size(way);
    if (!side || !length) return "";
    const unit = [way[0] / length, way[1] / length];
    const out = [-unit[1] * side, unit[0] * side];
    let path = "";
    for (let s = 4; s < length; s += 8) {
      const foot = plus(a, unit, s);
      const tip = plus(plus(foot, out, 7), unit, -5);
      path += `M${foot[0]} ${foot[1]}L${tip[0]} ${tip[1]}`;
    }
    return path;
  }

  wallName(name, points, side) {
    const [a, b] = [this.at(points[0]), this.at(points[1])];
    const way = plus(b, a, -1);
    const length = size(way) || 1;
    const out = [way[1] / length, -way[0] / length];
    // Beside an upright wall a long name stands further off.
    const off = Math.max(20, 12 + LETTER * name.length * Math.abs(out[0]));
    const by = plus(plus(a, way, 0.88), out, (side || 1) * off);
    return svg("text", { class: "name", x: by[0], y: by[1] }, name);
  }

  roundWall(wall) {
    const [x, y] = this.at(wall.centre);
    const r = wall.radius * this.scale;
    const [first] = this.motion.spheres;
    const place = first ? placeAt(first, this.motion.start) : wall.centre;
    const inside = size(plus(place, wall.centre, -1)) <= wall.radius * (1 + 1e-9);
    let hatching = "";
    const count = Math.max(24, Math.round((2 * Math.PI * r) / 9));
    for (let i = 0; i < count; i += 1) {
      const turn = (2 * Math.PI * i) / count;
      const beyond = inside ? r + 7 : r - 7;
      const tip = turn + (inside ? 4 : -4) / r;
      hatching += `M${x + r * Math.cos(turn)} ${y + r * Math.sin(turn)}`;
      hatching += `L${x + beyond * Math.cos(tip)} ${y + beyond * Math.sin(tip)}`;
    }
    const label = [x + 0.7071 * (r + 22), y - 0.7071 * (r + 22)];
    return [
      svg("path", { class: "hatch", d: hatching }),
      svg("circle", { class: "wall", cx: x, cy: y, r }),
      svg("text", { class: "name", x: label[0], y: label[1] }, wall.name),
    ];
  }

  point({ name, at }) {
    const [x, y] = this.at(at);
    return [
      svg("path", { class: "cross", d: `M${x - 5} ${y}h10M${x} ${y - 5}v10` }),
      svg("text", { class: "name", x: x + 13, y: y - 11 }, name),
    ];
  }

  disc(sphere, i) {
    const r = Math.max(sphere.radius * this.scale, DOT);
    const kind = `sphere body${i % COLOURS}${sphere.radius ? "" : " dot"}`;
    const node = svg("circle", { class: kind, r });
    this.node.append(node);
    return { node, r };
  }

  // The name of a sphere stands where it is furthest from paths, arrows and neighbours: within the
  // circle if there is room, else beside it. Returns where something more can be said of it.
  nameAt(i, place, ways) {
    if (this.crowded) {
      this.names[i].setAttribute("x", place[0]);
      this.names[i].setAttribute("y", place[1]);
      return plus(place, [0, this.discs[i].r + 12]);
    }
    const used = ways.filter((way) => size(way) > 1e-9);
    const turns = [3, 1, 5, 7, 2, 6, 4, 0].map((eighth) => (eighth * Math.PI) / 4);
    const angle = (way, out) => Math.acos(Math.max(-1, Math.min(1, dot(way, out) / size(way))));
    const room = (turn) => {
      const out = [Math.cos(turn), Math.sin(turn)];
      return Math.min(2, ...used.map((way) => angle(way, out)));
    };
    const best = turns.reduce((a, b) => (room(b) > room(a) + 1e-9 ? b : a));
    const { r } = this.discs[i];
    const within = r >= 22 && room(best) > 0.6;
    const off = (far) => [place[0] + far * Math.cos(best), place[1] - far * Math.sin(best)];
    const [x, y] = off(within ? 0.62 * r : r + 11);
    this.names[i].setAttribute("x", x);
    this.names[i].setAttribute("y", y);
    if (within) return off(r + 12 + 8 * Math.abs(Math.cos(best)));
    return [x, y + (Math.sin(best) > 0.1 ? -15 : 15)];
  }

  // Directions in which something is drawn at a sphere, y up.
  ways(sphere, index, focus, moment, coming, components) {
    const piece = sphere.pieces[index];
    const past = index ? sphere.pieces[index - 1] : null;
    const v = [piece[4], piece[5]];
    const found = [v, [-v[0], -v[1]]];
    if (past) found.push([-past[4], -past[5]]);
    const k = focus?.bodies.indexOf(sphere.name) ?? -1;
    if (k < 0) return found;
    if (focus.kind === "blow") found.push([-focus.impulse[0], -focus.impulse[1]]);
    if (focus.kind !== "impact") return found;
    const n = focus.line;
    const t = [-n[1], n[0]];
    const towards = k ? [-n[0], -n[1]] : n; // where the other one is
    found.push(n, [-n[0], -n[1]], plus(towards, t, 1), plus(towards, t, -1));
    if (components) {
      const share = (w, sign) => [t[0] * sign * across(focus, w), t[1] * sign * across(focus, w)];
      if (!coming) found.push(share(focus.after[sphere.name], 1));
      if (moment || coming) found.push(share(focus.before[sphere.name], -1));
    }
    return found;
  }

  // Draws an arrow between two points of the picture; nothing if they are hardly apart.
  pointTo(arrow, from, to) {
    const way = plus(to, from, -1);
    const length = size(way);
    if (length < 2.5) {
      arrow.node.setAttribute("visibility", "hidden");
      return;
    }
    arrow.node.removeAttribute("visibility");
    const thin = arrow.node.classList.contains("component");
    const head = Math.min(thin ? 9 : 12, 0.7 * length);
    const half = head * 0.36;
    const unit = [way[0] / length, way[1] / length];
    // What arrives has its head on the way, so that it does not hide what leaves.
    const came = arrow.node.classList.contains("came");
    const tip = came ? plus(from, unit, Math.max(head, 0.55 * length)) : to;
    const base = plus(tip, unit, -head);
    const left = plus(base, [-unit[1], unit[0]], half);
    const right = plus(base, [-unit[1], unit[0]], -half);
    const end = came ? to : plus(to, unit, -0.8 * head);
    arrow.shaft.setAttribute("d", `M${from[0]} ${from[1]}L${end[0]} ${end[1]}`);
    arrow.head.setAttribute(
      "d",
      `M${tip[0]} ${tip[1]}L${left[0]} ${left[1]}L${right[0]} ${right[1]}z`,
    );
  }

  hide(arrow) {
    arrow.node.setAttribute("visibility", "hidden");
  }

  // The picture at a time. `focus` is the event that is looked at closely, or null. Before it the
  // velocities of its bodies are drawn as they arrive at the centres, out of the way of what is
  // struck; at its very moment both are seen, the earlier one faint.
  show(t, focus, moment, { velocities, components, trails, momenta, impulses, speeds, angles }) {
    const { spheres } = this.motion;
    const places = spheres.map((sphere) => this.at(placeAt(sphere, t)));
    if (focus?.kind === "impact" && !focus.wall) this.apart(places, focus, t);
    const coming = focus !== null && !moment && t < focus.time;
    this.node.classList.toggle("coming", coming);
    spheres.forEach((sphere, i) => {
      const index = pieceAt(sphere, t);
      const piece = sphere.pieces[index];
      const place = places[i];
      this.discs[i].node.setAttribute("cx", place[0]);
      this.discs[i].node.setAttribute("cy", place[1]);
      this.trails[i].setAttribute("d", trails ? this.trail(sphere, index, place) : "M0 0");
      const takesPart = focus?.kind !== "arrival" && focus?.bodies.includes(sphere.name);
      const ways = this.ways(sphere, index, focus, moment, coming, components);
      const spot = this.nameAt(i, place, ways);
      const { velocity, came } = this.arrows[i];
      const leaves = velocities && !(coming && takesPart);
      if (leaves) this.pointTo(velocity, place, this.tip(place, [piece[4], piece[5]]));
      else this.hide(velocity);
      if (velocities && takesPart && (moment || coming)) {
        const [u, v] = [focus.before[sphere.name], focus.after[sphere.name]];
        // Thrown back along its path: beside what leaves.
        const back = moment && Math.abs(cross(u, v)) < 0.02 * size(u) * size(v) && dot(u, v) < 0;
        const by = back ? [(-7 * u[1]) / size(u), (-7 * u[0]) / size(u)] : [0, 0];
        this.pointTo(came, plus(this.tip(place, u, -1), by), plus(place, by));
      } else this.hide(came);
      if (momenta) {
        const k = (sphere.mass ?? 0) / this.usual;
        this.pointTo(this.momenta[i], place, this.tip(place, [k * piece[4], k * piece[5]]));
      } else this.hide(this.momenta[i]);
      this.sayOf(i, speeds ? index : null, spot);
    });
    this.shares(impulses && !coming && focus?.impulse && focus.kind === "impact" ? focus : null);
    this.closely(places, components ? focus : null, moment, coming);
    this.angles(places, angles && focus?.wall ? focus : null, moment, coming);
  }

  // Its speed, next to its name.
  sayOf(i, index, spot) {
    const text = this.speeds[i];
    if (this.told[i] !== index) {
      this.told[i] = index;
      const piece = this.motion.spheres[i].pieces[index];
      text.textContent = piece ? figures(size([piece[4], piece[5]])) : "";
    }
    if (index === null) return;
    text.setAttribute("x", spot[0]);
    text.setAttribute("y", spot[1]);
  }

  // The impulses on both bodies, equal and opposite, as long as the velocities that they would
  // give to a sphere of the usual mass.
  shares(event) {
    this.blows.forEach((arrow, k) => {
      if (!event || k >= event.bodies.length) return this.hide(arrow);
      const from = this.at(event.place);
      const share = (k ? 1 : -1) / this.usual;
      this.pointTo(arrow, from, this.tip(from, event.impulse.map((x) => share * x)));
    });
  }

  // The angles that a path makes with the wall: α where it comes from, β where it goes to.
  angles(places, event, moment, coming) {
    const seen = [event && (coming || moment), event && !coming];
    this.arcs.forEach(({ path, text }, k) => {
      const v = seen[k] ? (k ? event.after : event.before)[event.bodies[0]] : [0, 0];
      const beside = seen[k] ? across(event, v) : 0;
      const shown = Math.abs(beside) > 0.02 * size(v);
      text.setAttribute("visibility", shown ? "visible" : "hidden");
      path.setAttribute("d", "M0 0");
      if (!shown) return;
      const sense = k ? 1 : -1; // what arrives is looked at from where it comes
      const wall = plus([0, 0], [-event.line[1], event.line[0]], sense * Math.sign(beside));
      const way = plus([0, 0], v, sense);
      const from = Math.atan2(wall[1], wall[0]);
      const turn = Math.atan2(cross(wall, way), dot(wall, way));
      const place = places[this.index(event.bodies[0])];
      const at = (angle, r) => plus(place, [Math.cos(angle), -Math.sin(angle)], r).join(" ");
      const sweep = turn > 0 ? 0 : 1;
      const end = at(from + turn, ARC);
      path.setAttribute("d", `M${at(from, ARC)}A${ARC} ${ARC} 0 0 ${sweep} ${end}`);
      const [x, y] = at(from + turn / 2, ARC + 11).split(" ");
      text.setAttribute("x", x);
      text.setAttribute("y", y);
    });
  }

  tip(place, v, k = 1) {
    return [place[0] + k * this.arrow * v[0], place[1] - k * this.arrow * v[1]];
  }

  trail(sphere, index, place) {
    return `${this.corners(sphere, index)}L${place[0]} ${place[1]}`;
  }

  // Where a trail begins and turns: another one only after another impact.
  corners(sphere, index) {
    const known = this.trailed.get(sphere);
    if (known?.index === index) return known.path;
    let path = "";
    for (let i = Math.max(0, index - TRAIL); i <= index; i += 1) {
      const [x, y] = this.at([sphere.pieces[i][2], sphere.pieces[i][3]]);
      path += `${path ? "L" : "M"}${x} ${y}`;
    }
    this.trailed.set(sphere, { index, path });
    return path;
  }

  // Spheres of negligible size are drawn with some: where they meet, side by side.
  apart(places, event, t) {
    const [i, j] = event.bodies.map((name) => this.index(name));
    if (this.motion.spheres[i].radius || this.motion.spheres[j].radius) return;
    const way = plus(places[j], places[i], -1);
    const lack = 2 * DOT - size(way);
    if (lack <= 0) return;
    const line = [event.line[0], -event.line[1]];
    const after = t > event.time && dot(way, line) < 0 ? -1 : 1;
    places[i] = plus(places[i], line, (-after * lack) / 2);
    places[j] = plus(places[j], line, (after * lack) / 2);
  }

  index(name) {
    return this.motion.spheres.findIndex((sphere) => sphere.name === name);
  }

  // Line of centres, components and their numbers, of the event that is looked at closely.
  closely(places, event, moment, coming) {
    const impact = event?.kind === "impact";
    this.guide.setAttribute("d", impact ? this.lineOfCentres(places, event) : "M0 0");
    if (event?.kind === "blow") {
      const place = places[this.index(event.bodies[0])];
      const way = [event.impulse[0], -event.impulse[1]];
      const one = 1 / (size(way) || 1);
      const from = plus(place, way, -this.blowLength * one);
      this.pointTo(this.blow, from, plus(place, way, -6 * one));
    } else this.hide(this.blow);
    this.parts.forEach((part, k) => {
      const name = impact ? event.bodies[k] : undefined;
      const i = name === undefined ? -1 : this.index(name);
      part.texts.forEach((text) => {
        text.replaceChildren();
        text.setAttribute("class", `number body${Math.max(i, 0) % COLOURS}`);
      });
      for (const arrow of [part.leaves, part.came].flatMap(Object.values)) {
        this.hide(arrow);
        const kind = arrow.node.getAttribute("class").replace(/ body\d/, "");
        arrow.node.setAttribute("class", i < 0 ? kind : `${kind} body${i % COLOURS}`);
      }
      part.box.setAttribute("d", "M0 0");
      if (i < 0) return;
      if (moment || coming) this.resolve(part, "came", event, event.before[name], places[i]);
      if (!coming) this.resolve(part, "leaves", event, event.after[name], places[i]);
    });
  }

  lineOfCentres(places, event) {
    const first = places[this.index(event.bodies[0])];
    const line = [event.line[0], -event.line[1]];
    const other = event.wall ? this.at(event.place) : places[this.index(event.bodies[1])];
    const near = size(plus(other, first, -1));
    const reach = Math.max(60, 0.1 * this.width) + this.discs[this.index(event.bodies[0])].r;
    // From the first centre to the second as they are at the impact, and on to both sides.
    const a = plus(first, line, -reach);
    const b = plus(first, line, (event.wall ? 0 : near) + (event.wall ? near : reach));
    return `M${a[0]} ${a[1]}L${b[0]} ${b[1]}`;
  }

  // The two components of a velocity that leaves a centre, or came there.
  resolve(part, when, event, v, place) {
    const k = when === "came" ? -1 : 1;
    const n = event.line;
    const t = [-n[1], n[0]];
    const [x, y] = [along(event, v), across(event, v)];
    const first = this.tip(place, [n[0] * x, n[1] * x], k);
    const second = this.tip(place, [t[0] * y, t[1] * y], k);
    const corner = this.tip(place, v, k);
    const pairs = [
      [part[when].along, first],
      [part[when].across, second],
    ];
    const side = plus(corner, first, -1);
    const aside = size(side) > 3 ? plus([0, 0], side, 5 / size(side)) : [0, 0];
    pairs.forEach(([arrow, tip], index) => {
      const by = index ? [0, 0] : aside; // what returns on the same line is drawn beside it
      if (k > 0) this.pointTo(arrow, place, tip);
      else this.pointTo(arrow, plus(tip, by), plus(place, by));
    });
    const both = size(plus(first, place, -1)) > 3 && size(plus(second, place, -1)) > 3;
    if (!both) pairs.forEach(([arrow]) => this.hide(arrow)); // it is the velocity itself
    else {
      const box = `M${first[0]} ${first[1]}L${corner[0]} ${corner[1]}L${second[0]} ${second[1]}`;
      part.box.setAttribute("d", `${part.box.getAttribute("d")}${box}`);
    }
    // Where there is no rectangle, what was is on one side of the line and what is on the other.
    const free = size(side) > 3 ? side : [k * n[1], k * n[0]];
    const beside = plus([0, 0], free, 12 / size(free));
    this.numbers(part, when === "came" ? 2 : 0, [
      [first, x, place, beside],
      [second, y, place, [0, 0]],
    ]);
  }

  numbers(part, offset, tips) {
    if (this.width < 440) return; // they stand in the table
    tips.forEach(([tip, x, place, beside], index) => {
      const way = plus(tip, place, -1);
      const text = part.texts[offset + index];
      if (size(way) < 16) return;
      const out = plus(plus(tip, way, 12 / size(way)), beside);
      text.setAttribute("x", out[0]);
      text.setAttribute("y", out[1]);
      text.append(figures(Math.abs(x)));
    });
  }
}
