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

const SVG = "http://www.w3.org/2000/svg";
const COLOURS = 6;
const HOLD = 900; // ms that slow motion rests at an impact
const SLOWEST = 0.1; // of the usual rate, at an impact
const TRAIL = 30; // pieces that are seen of where a sphere has been
const MANY = 30; // events, beyond which they are not counted one by one
const CROWD = 12; // spheres, beyond which those without room for their names have none
const SELDOM = 120; // ms between the tables of a crowd, while it moves
const DOT = 5; // px: the radius of a sphere of negligible size
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

// --- making elements -----------------------------------------------------------------------------

function put(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== null && value !== false) node.setAttribute(name, value === true ? "" : value);
  }
  node.append(...children.filter((child) => child !== null && child !== undefined));
  return node;
}

const html = (name, attributes = {}, ...children) =>
  put(document.createElement(name), attributes, children);
const svg = (name, attributes = {}, ...children) =>
  put(document.createElementNS(SVG, name), attributes, children);

const ICONS = {
  play: "M6 4l14 8-14 8z",
  pause: "M6 4h4v16H6zM14 4h4v16h-4z",
  rewind: "M4 4h3v16H4zM20 4v16L8 12z",
  previous: "M13 4v16L3 12zM16.5 9a3 3 0 1 1 0 6 3 3 0 0 1 0-6z",
  next: "M11 4v16l10-8zM7.500 9a3 3 0 1 1 0 6 3 3 0 0 1 0-6z",
};

function button(icon, label, shortcut) {
  const path = svg("path", { d: ICONS[icon] });
  const made = html(
    "button",
    { type: "button", "aria-label": label, title: `${label} (${shortcut})`, "data-do": icon },
    svg("svg", { viewBox: "0 0 24 24", "aria-hidden": "true", focusable: "false" }, path),
  );
  return { node: made, path };
}

function check(label, shortcut, on) {
  const box = html("input", { type: "checkbox", checked: on });
  const node = html("label", { title: `${label} (${shortcut})` }, box, label);
  return { node, box };
}

// Letters in italics, as mathematics is set; words such as sin stay upright.
function mathematics(text) {
  const pieces = text.split(/([A-Za-zα-ωΑ-Ω]+)/);
  return pieces.map((piece, index) =>
    index % 2 && piece.length < 3 ? html("var", {}, piece) : document.createTextNode(piece),
  );
}

// --- numbers -------------------------------------------------------------------------------------

function figures(x) {
  if (Math.abs(x) < 5e-10) return "0";
  const size = Math.abs(x);
  const near = Math.round(size);
  let text = size >= 999.5 ? String(near) : size.toPrecision(3);
  if (near && Math.abs(size - near) < 1e-9 * near) text = String(near);
  if (text.includes("e")) text = size.toFixed(6);
  return (x < 0 ? "−" : "") + text;
}

const seconds = (t) => `${(Math.abs(t) < 0.005 ? 0 : t).toFixed(2).replace("-", "−")} s`;

// The exact value where there is one, and its decimals where they say more.
function value(said, x) {
  const decimal = figures(x);
  if (!said || said === decimal) return [html("span", {}, decimal)];
  if (Number(said.replace("−", "-")) === x) return [html("span", {}, said)];
  return [
    html("span", { class: "exact" }, ...mathematics(said)),
    " ",
    html("span", { class: "decimal" }, decimal),
  ];
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1];
const cross = (a, b) => a[0] * b[1] - a[1] * b[0];
const plus = (a, b, k = 1) => [a[0] + k * b[0], a[1] + k * b[1]];
const size = (a) => Math.hypot(a[0], a[1]);
const smooth = (x) => x * x * (3 - 2 * x); // from 0 to 1 without a jerk at either end

// --- a motion, looked up -------------------------------------------------------------------------

function pieceAt(sphere, t, before = false) {
  const { pieces } = sphere;
  let low = 0;
  let high = pieces.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (before ? pieces[middle][0] < t : pieces[middle][0] <= t) low = middle;
    else high = middle - 1;
  }
  return low;
}

function placeAt(sphere, t) {
  const [start, , x, y, vx, vy] = sphere.pieces[pieceAt(sphere, t)];
  return [x + vx * (t - start), y + vy * (t - start)];
}

function bounds(motion) {
  const xs = [];
  const ys = [];
  const see = ([x, y], r = 0) => {
    xs.push(x - r, x + r);
    ys.push(y - r, y + r);
  };
  for (const { pieces, radius } of motion.spheres) {
    for (const [start, end, x, y, vx, vy] of pieces) {
      see([x, y], radius);
      see([x + vx * (end - start), y + vy * (end - start)], radius);
    }
  }
  for (const wall of motion.walls) {
    if (wall.points) wall.points.forEach((point) => see(point));
    else see(wall.centre, wall.radius);
  }
  motion.points.forEach(({ at }) => see(at));
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

// Bounds widened to hold some more points.
function around([left, bottom, right, top], points) {
  const xs = points.map(([x]) => x);
  const ys = points.map(([, y]) => y);
  return [
    Math.min(left, ...xs),
    Math.min(bottom, ...ys),
    Math.max(right, ...xs),
    Math.max(top, ...ys),
  ];
}

function fastest(motion) {
  let most = 0;
  for (const { pieces } of motion.spheres) {
    for (const piece of pieces) most = Math.max(most, Math.hypot(piece[4], piece[5]));
  }
  return most || 1;
}

// On which side of a straight wall nothing ever is: +1 left of it, −1 right of it, 0 neither.
function behind(a, b, motion) {
  const along = plus(b, a, -1);
  const unit = [along[0] / size(along), along[1] / size(along)];
  let left = 0;
  let right = 0;
  for (const sphere of motion.spheres) {
    for (const [start, end, x, y, vx, vy] of sphere.pieces) {
      for (const t of [0, end - start]) {
        const place = [x + vx * t, y + vy * t];
        const side = cross(unit, plus(place, a, -1));
        const beside = dot(unit, plus(place, a, -1));
        if (beside < 0 || beside > size(along)) continue;
        left = Math.max(left, side);
        right = Math.max(right, -side);
      }
    }
  }
  if (Math.min(left, right) > 0.1 * Math.max(left, right)) return 0;
  return left > right ? -1 : 1;
}

function names(event) {
  if (event.kind === "blow") return `${event.bodies[0]} receives an impulse`;
  if (event.kind === "arrival") return `${event.bodies[0]} reaches ${event.target ?? "the point"}`;
  return `${event.bodies[0]} hits ${event.wall ?? event.bodies[1]}`;
}

// Components of a velocity along the line of centres and across it.
const along = (event, v) => dot(v, event.line);
const across = (event, v) => cross(event.line, v);

// --- the picture ---------------------------------------------------------------------------------

export class Picture {
  constructor() {
    this.node = svg("svg", { class: "stage", role: "img" });
  }

  // Makes all shapes anew: for another motion, or another size of the picture.
  lay(motion, width, height) {
    this.motion = motion;
    const longest = Math.min(0.2 * width, 0.34 * height, 150);
    this.arrow = longest / Math.sqrt(Math.max(1, motion.spheres.length / 4)) / fastest(motion);
    this.blowLength = Math.min(0.16 * width, 0.25 * height, 110);
    const margin = Math.min(40, 0.08 * width + 6);
    const fit = ([left, bottom, right, top]) => {
      const k = Math.min(
        (width - 2 * margin) / (right - left || 1e-9),
        (height - 2 * margin) / (top - bottom || 1e-9),
      );
      return { k, middle: [(left + right) / 2, (bottom + top) / 2] };
    };
    const bare = bounds(motion);
    const rough = fit(bare).k;
    const { k, middle } = fit(around(bare, this.tips(motion, 1 / rough)));
    this.scale = k;
    this.at = ([x, y]) => [width / 2 + k * (x - middle[0]), height / 2 - k * (y - middle[1])];
    this.width = width;
    this.node.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.node.setAttribute("width", width);
    this.node.setAttribute("height", height);
    this.node.replaceChildren();
    this.node.append(svg("g", { class: "walls" }, ...motion.walls.flatMap((w) => this.wall(w))));
    this.node.append(...motion.points.flatMap((point) => this.point(point)));
    this.trails = motion.spheres.map((_, i) => this.add("path", `trail body${i % COLOURS}`));
    this.guide = this.add("path", "guide");
    this.ghosts = this.add("g", "ghosts");
    this.discs = motion.spheres.map((sphere, i) => this.disc(sphere, i));
    this.arrows = motion.spheres.map((_, i) => ({
      velocity: this.arrowhead(`velocity body${i % COLOURS}`),
      came: this.arrowhead(`velocity came body${i % COLOURS}`),
    }));
    this.parts = [0, 1].map(() => ({
      box: this.add("path", "box"),
      along: this.arrowhead("component"),
      across: this.arrowhead("component"),
      camealong: this.arrowhead("component came"),
      cameacross: this.arrowhead("component came"),
      texts: [0, 1, 2, 3].map(() => this.add("text", "number")),
    }));
    this.blow = this.arrowhead("blow");
    this.names = motion.spheres.map((sphere) => this.add("text", "name"));
    this.crowded = motion.spheres.length > CROWD;
    motion.spheres.forEach(({ name, radius }, i) => {
      const fits = radius * k > 4 * name.length + 4;
      if (fits || !this.crowded) this.names[i].append(name);
    });
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
    const by = plus(plus(a, way, 0.88), out, (side || 1) * 20);
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
  // circle if there is room, else beside it.
  nameAt(i, place, ways) {
    if (this.crowded) {
      this.names[i].setAttribute("x", place[0]);
      this.names[i].setAttribute("y", place[1]);
      return;
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
    const far = r >= 22 && room(best) > 0.6 ? 0.62 * r : r + 11;
    this.names[i].setAttribute("x", place[0] + far * Math.cos(best));
    this.names[i].setAttribute("y", place[1] - far * Math.sin(best));
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
  show(t, focus, moment, { velocities, components, trails }) {
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
      this.nameAt(i, place, this.ways(sphere, index, focus, moment, coming, components));
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
    });
    this.closely(places, components ? focus : null, moment, coming);
  }

  tip(place, v, k = 1) {
    return [place[0] + k * this.arrow * v[0], place[1] - k * this.arrow * v[1]];
  }

  trail(sphere, index, place) {
    let path = "";
    for (let i = Math.max(0, index - TRAIL); i <= index; i += 1) {
      const [x, y] = this.at([sphere.pieces[i][2], sphere.pieces[i][3]]);
      path += `${path ? "L" : "M"}${x} ${y}`;
    }
    return `${path}L${place[0]} ${place[1]}`;
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
      for (const arrow of [part.along, part.across, part.camealong, part.cameacross]) {
        this.hide(arrow);
        const kind = arrow.node.getAttribute("class").replace(/ body\d/, "");
        arrow.node.setAttribute("class", i < 0 ? kind : `${kind} body${i % COLOURS}`);
      }
      part.box.setAttribute("d", "M0 0");
      if (i < 0) return;
      if (moment || coming) this.resolve(part, "came", event, event.before[name], places[i], -1);
      if (!coming) this.resolve(part, "", event, event.after[name], places[i], 1);
    });
  }

  lineOfCentres(places, event) {
    const first = places[this.index(event.bodies[0])];
    const line = [event.line[0], -event.line[1]];
    const other = event.wall ? this.at(event.place) : places[this.index(event.bodies[1])];
    const near = size(plus(other, first, -1));
    const reach = Math.max(60, 0.1 * this.width) + this.discs[0].r;
    // From the first centre to the second as they are at the impact, and on to both sides.
    const a = plus(first, line, -reach);
    const b = plus(first, line, (event.wall ? 0 : near) + (event.wall ? near : reach));
    return `M${a[0]} ${a[1]}L${b[0]} ${b[1]}`;
  }

  // The two components of a velocity, leaving a centre (k = 1) or arriving there (k = −1).
  resolve(part, when, event, v, place, k) {
    const n = event.line;
    const across_ = [-n[1], n[0]];
    const [x, y] = [along(event, v), across(event, v)];
    const first = this.tip(place, [n[0] * x, n[1] * x], k);
    const second = this.tip(place, [across_[0] * y, across_[1] * y], k);
    const corner = this.tip(place, v, k);
    const pairs = [
      [part[`${when}along`], first],
      [part[`${when}across`], second],
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
    this.numbers(part, when ? 2 : 0, [
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

// --- the tables ----------------------------------------------------------------------------------

function row(label, cells, kind = {}) {
  return html("tr", kind, html("th", { scope: "row" }, ...label), ...cells);
}

// What has to be scrolled can be reached by the keyboard.
function reachable(scroll) {
  const over = scroll.scrollWidth > scroll.clientWidth || scroll.scrollHeight > scroll.clientHeight;
  if (over) scroll.setAttribute("tabindex", "0");
  else scroll.removeAttribute("tabindex");
}

const unitOf = (...text) => html("span", { class: "unit" }, " ", ...text);

// What an event does to the components of the velocities.
class Card {
  constructor() {
    this.heading = html("h2");
    this.body = html("div", { class: "scroll", role: "group", "aria-label": "The impact" });
    this.node = html("section", { class: "card" }, this.heading, this.body);
  }

  show(event, number, t) {
    const done = event !== null && t >= event.time;
    const key = event === null ? "" : `${number} ${done}`;
    if (this.key === key) return;
    this.key = key;
    this.body.replaceChildren();
    this.heading.replaceChildren();
    if (event === null) return;
    const e = event.kind === "impact" ? [", ", html("var", {}, "e"), " = "] : [];
    if (e.length) e.push(...mathematics(event.said?.e ?? String(Number(event.e.toPrecision(3)))));
    this.heading.append(`${number}: ${names(event)}`, ...e);
    if (event.kind === "impact") {
      this.body.append(this.table(this.components(event, done), "Components of velocity"));
      if (event.impulse !== null) this.body.append(this.effects(event, done));
    } else if (event.kind === "blow") {
      this.body.append(this.table(this.axes(event, done), "Velocity"));
      this.body.append(html("p", {}, `Impulse ${figures(size(event.impulse))}`, unitOf("N s")));
    }
    reachable(this.body);
  }

  // Rows of the components along the line of centres (or towards a wall) and across it.
  components(event, done) {
    const { wall, bodies } = event;
    const words = wall
      ? [` towards ${wall}`, ` parallel to ${wall}`]
      : [` along ${bodies[0]} → ${bodies[1]}`, " perpendicular"];
    return bodies.flatMap((name) =>
      [along, across].map((component, k) => {
        const key = k ? "across" : "along";
        const cell = (when) =>
          value(event.said?.[when]?.[name]?.[key], component(event, event[when][name]));
        return this.line(name, [words[k]], cell("before"), done ? cell("after") : null, !k);
      }),
    );
  }

  // Rows of the components along i and j, for an impulse from outside.
  axes(event, done) {
    const [name] = event.bodies;
    return [0, 1].map((k) =>
      this.line(
        name,
        [" along ", html("b", {}, "ij"[k])],
        value(null, event.before[name][k]),
        done ? value(null, event.after[name][k]) : null,
        !k,
      ),
    );
  }

  line(name, words, before, after, first) {
    const label = [html("span", { class: "who" }, name), ...words];
    const cells = [before, after ?? ["…"]].map((each) => html("td", {}, ...each));
    return row(label, cells, first ? { class: "first" } : {});
  }

  table(rows, caption) {
    const head = ["before", "after"].map((text) => html("th", { scope: "col" }, text));
    return html(
      "table",
      {},
      html("caption", {}, caption, unitOf("m s⁻¹")),
      html("thead", {}, html("tr", {}, html("td"), ...head)),
      html("tbody", {}, ...rows),
    );
  }

  effects(event, done) {
    const seen = (x) => (done ? figures(x) : "…");
    return html(
      "p",
      {},
      `Impulse ${seen(size(event.impulse))}`,
      unitOf("N s"),
      `; kinetic energy lost ${seen(event.lost)}`,
      unitOf("J"),
    );
  }
}

// All that is known of every sphere now.
class Values {
  constructor() {
    this.heading = html("h2");
    this.scroll = html("div", { class: "scroll", role: "group", "aria-label": "Values" });
    this.node = html("section", { class: "values" }, this.heading, this.scroll);
  }

  lay(motion) {
    this.motion = motion;
    this.key = null;
  }

  show(t, playing) {
    const { spheres } = this.motion;
    const since = performance.now() - (this.shown ?? -SELDOM);
    if (playing && spheres.length > CROWD && since < SELDOM) return;
    this.shown = performance.now();
    this.heading.textContent = `At ${seconds(t)}`;
    const indices = spheres.map((sphere) => pieceAt(sphere, t));
    const key = indices.join();
    if (key === this.key) return;
    this.key = key;
    const now = spheres.map((sphere, i) => {
      const piece = sphere.pieces[indices[i]];
      return { ...sphere, v: [piece[4], piece[5]], exact: sphere.said?.[indices[i]] };
    });
    this.scroll.replaceChildren(this.table(now));
    reachable(this.scroll);
  }

  table(now) {
    const weighed = now.every(({ mass }) => mass !== null);
    const sum = weighed && now.length > 1;
    const turn = ({ v }) => (size(v) < 1e-12 ? null : (Math.atan2(v[1], v[0]) * 180) / Math.PI);
    const momentum = (k) => ({ mass, v }) => (mass === null ? null : mass * v[k]);
    const energy = ({ mass, v }) => (mass === null ? null : (mass * dot(v, v)) / 2);
    const bold = (text) => html("b", {}, text);
    const lines = [
      [["velocity ", bold("i")], "m s⁻¹", ({ v }) => v[0], "x", false],
      [["velocity ", bold("j")], "m s⁻¹", ({ v }) => v[1], "y", false],
      [["speed"], "m s⁻¹", ({ v }) => size(v), "speed", false],
      [["direction from ", bold("i")], "°", turn, null, false],
    ];
    if (now.some(({ mass }) => mass !== null)) {
      lines.push([["momentum ", bold("i")], "N s", momentum(0), null, sum]);
      lines.push([["momentum ", bold("j")], "N s", momentum(1), null, sum]);
      lines.push([["kinetic energy"], "J", energy, null, sum]);
    }
    const cell = (x, said) => html("td", {}, ...(x === null ? ["–"] : value(said, x)));
    const cells = ([, , number, key, summed]) => [
      ...now.map((sphere) => cell(number(sphere), key && sphere.exact?.[key])),
      ...(sum ? [summed ? cell(now.reduce((s, each) => s + number(each), 0)) : html("td")] : []),
    ];
    const heads = now.map(({ name, mass }, i) =>
      html("th", { scope: "col", class: `who body${i % COLOURS}` }, name),
    );
    if (sum) heads.push(html("th", { scope: "col" }, "all"));
    if (now.length <= 5) {
      return html(
        "table",
        {},
        html("thead", {}, html("tr", {}, html("td"), ...heads)),
        html(
          "tbody",
          {},
          ...lines.map((line) => row([...line[0], unitOf(line[1])], cells(line))),
        ),
      );
    }
    const columns = lines.map((line) =>
      html("th", { scope: "col" }, ...line[0], unitOf(line[1])),
    );
    const table = lines.map(cells);
    return html(
      "table",
      {},
      html("thead", {}, html("tr", {}, html("td"), ...columns)),
      html(
        "tbody",
        {},
        ...[...now.map(({ name }) => name), ...(sum ? ["all"] : [])].map((name, i) =>
          row([name], table.map((line) => line[i])),
        ),
      ),
    );
  }
}

// --- the player ----------------------------------------------------------------------------------

export class Player {
  constructor(root, data, { page = false, heading = "h1" } = {}) {
    this.root = root;
    this.speed = 1;
    this.playing = false;
    this.calm = matchMedia("(prefers-reduced-motion: reduce)");
    this.picture = new Picture();
    this.card = new Card();
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
    this.time = html("input", { type: "range", step: "any", "aria-label": "Time" });
    this.marks = html("div", { class: "marks", "aria-hidden": "true" });
    this.clock = html("span", { class: "clock" });
    this.buttons = {
      rewind: button("rewind", "Back to the start", "Home"),
      previous: button("previous", "Previous impact", "←"),
      play: button("play", "Play", "Space"),
      next: button("next", "Next impact", "→"),
    };
    this.rate = html("input", { type: "range", min: -3, max: 2, step: 0.5, value: 0 });
    this.rateSaid = html("span", { class: "said" }, "1×");
    this.slow = check("Slow motion at impacts", "S", true);
    this.velocities = check("Velocities", "V", true);
    this.components = check("Components", "C", true);
    this.trails = check("Trails", "T", true);
    this.help = this.keys();
    const ask = html("button", { type: "button", class: "keys", title: "Keys (?)" }, "Keys");
    ask.addEventListener("click", () => this.help.showModal());
    this.live = html("p", { class: "live", "aria-live": "polite" });
    this.notes = html("p", { class: "notes" });
    const options = [this.slow, this.velocities, this.components, this.trails];
    this.root.classList.add("restitution-player");
    this.root.replaceChildren(
      html("header", {}, this.title, this.drawn, this.choice),
      html(
        "div",
        { class: "floor" },
        html(
          "div",
          { class: "left" },
          html("div", { class: "frame" }, this.picture.node),
          html("div", { class: "timeline" }, this.time, this.marks),
          html(
            "div",
            { class: "transport" },
            ...Object.values(this.buttons).map(({ node }) => node),
            this.clock,
            html("label", { class: "rate" }, "Speed", this.rate, this.rateSaid),
          ),
          html("div", { class: "options" }, ...options.map(({ node }) => node), ask),
          this.notes,
        ),
        html("div", { class: "right" }, this.card.node, this.values.node),
      ),
      this.live,
      this.help,
    );
  }

  keys() {
    const rows = KEYS.map(([key, does]) =>
      html("tr", {}, html("th", { scope: "row" }, html("kbd", {}, key)), html("td", {}, does)),
    );
    const close = html("button", { type: "button" }, "Close");
    const made = html(
      "dialog",
      { "aria-label": "Keys" },
      html("h2", {}, "Keys"),
      html("table", {}, html("tbody", {}, ...rows)),
      close,
    );
    close.addEventListener("click", () => made.close());
    return made;
  }

  listen(keys) {
    const { rewind, previous, play, next } = this.buttons;
    rewind.node.addEventListener("click", () => this.rewind());
    previous.node.addEventListener("click", () => this.previous());
    play.node.addEventListener("click", () => this.toggle());
    next.node.addEventListener("click", () => this.next());
    this.time.addEventListener("input", () => {
      this.pause();
      this.seek(Number(this.time.value));
    });
    this.rate.addEventListener("input", () => this.setSpeed(2 ** Number(this.rate.value)));
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
    if (event.ctrlKey || event.metaKey || event.altKey || this.help.open) return;
    const { target } = event;
    const typing = target.matches?.("textarea, select, input:not([type=range], [type=checkbox])");
    if (typing || target.isContentEditable) return;
    const box = ({ box: each }) => () => each.click();
    const does = {
      ArrowRight: () => this.next(),
      ArrowLeft: () => this.previous(),
      ".": () => this.nudge(1),
      ",": () => this.nudge(-1),
      Home: () => this.rewind(),
      End: () => this.leap(this.motion.end),
      s: box(this.slow),
      v: box(this.velocities),
      c: box(this.components),
      t: box(this.trails),
      "+": () => this.faster(1),
      "=": () => this.faster(1),
      "-": () => this.faster(-1),
      "−": () => this.faster(-1),
      "?": () => this.help.showModal(),
      " ": () => this.toggle(),
    };
    const name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const own = target === this.rate ? ["ArrowRight", "ArrowLeft", "Home", "End"] : [];
    if (target.matches?.("button, input[type=checkbox]")) own.push(" ");
    if (!(name in does) || own.includes(name)) return;
    event.preventDefault();
    does[name]();
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
    this.choose(data.motions.length - 1);
  }

  // One of several motions.
  choose(index) {
    this.pause();
    this.choice.value = String(index);
    const motion = this.data.motions[index];
    this.motion = motion;
    this.span = motion.end - motion.start || 1;
    this.now = motion.start;
    this.drawn.replaceChildren(...mathematics(motion.drawn));
    this.drawn.hidden = !motion.drawn;
    this.notes.textContent = [LEGEND, ...motion.notes].join(" ");
    this.time.min = motion.start;
    this.time.max = motion.end;
    this.marks.replaceChildren(
      ...motion.events.map((event, i) => {
        const said = motion.events.length > MANY ? "" : String(i + 1);
        const mark = html("span", { title: names(event) }, said);
        mark.style.setProperty("--share", (event.time - motion.start) / this.span);
        return mark;
      }),
    );
    const moving = motion.spheres.map(({ name }) => name).join(", ");
    const told = motion.events.slice(0, MANY).map((event, i) => `${i + 1}: ${names(event)}`);
    const label = `Motion of ${moving} seen from above. ${told.join("; ")}.`;
    this.picture.node.setAttribute("aria-label", label);
    this.reaches = motion.events.map((event) => this.reach(event));
    this.values.lay(motion);
    this.card.key = null;
    this.live.textContent = "";
    // Seconds that it takes to play at the usual speed, slow motion apart.
    const lasts = Math.min(16, 4 + 1.5 * motion.events.length);
    this.base = this.span / lasts;
    this.width = 0;
    this.resize();
  }

  resize() {
    const frame = this.picture.node.parentNode;
    const width = Math.floor(frame.clientWidth);
    if (!width || (width === this.width && innerHeight === this.seen)) return;
    this.width = width;
    this.seen = innerHeight;
    const [left, bottom, right, top] = bounds(this.motion);
    // Neither a strip nor a tower, and with its controls on one screen.
    const shape = Math.max(1.15, Math.min(2.1, (right - left) / (top - bottom || 1e-9)));
    const height = Math.max(190, Math.min(width / shape, 0.62 * innerHeight));
    this.picture.lay(this.motion, width, Math.round(height));
    this.draw();
    reachable(this.card.body);
    reachable(this.values.scroll);
  }

  // --- time --------------------------------------------------------------------------------------

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  play() {
    if (this.playing) return;
    if (this.now >= this.motion.end - 1e-9 * this.span) this.seek(this.motion.start);
    this.glide = null;
    this.playing = true;
    this.hold = 0;
    this.sayPlaying();
    this.last = performance.now();
    this.request = requestAnimationFrame((now) => this.frame(now));
  }

  pause() {
    this.glide = null;
    if (!this.playing) return;
    this.playing = false;
    cancelAnimationFrame(this.request);
    this.sayPlaying();
  }

  sayPlaying() {
    const { node, path } = this.buttons.play;
    const label = this.playing ? "Pause" : "Play";
    node.setAttribute("aria-label", label);
    node.setAttribute("title", `${label} (Space)`);
    path.setAttribute("d", this.playing ? ICONS.pause : ICONS.play);
  }

  frame(now) {
    if (!this.playing) return;
    const passed = Math.min(now - this.last, 100);
    this.last = now;
    if (this.hold > 0) this.hold -= passed;
    else this.advance(passed / 1000);
    if (this.playing) this.request = requestAnimationFrame((next) => this.frame(next));
  }

  // Goes on by some seconds of the viewer's time, and not past an impact without showing it.
  advance(passed) {
    const from = this.now;
    let to = from + this.base * this.speed * this.ease(from) * passed;
    const met = this.motion.events.find(({ time }) => time > from && time <= to);
    if (met) {
      this.announce(met);
      if (this.slow.box.checked) {
        to = met.time;
        this.hold = HOLD / Math.min(2, this.speed);
      }
    }
    if (to >= this.motion.end) {
      this.seek(this.motion.end);
      this.pause();
    } else this.seek(to);
  }

  // How much slower time goes near an impact.
  ease(t) {
    if (!this.slow.box.checked) return 1;
    const { events } = this.motion;
    const near = this.beside(t).map((i) => Math.abs(events[i].time - t) / this.reaches[i]);
    return SLOWEST + (1 - SLOWEST) * smooth(Math.min(1, ...near));
  }

  // The last event before a time and the first one after it, by their places in the list.
  beside(t) {
    const { events } = this.motion;
    let after = 0;
    let high = events.length;
    while (after < high) {
      const middle = (after + high) >> 1;
      if (events[middle].time <= t) after = middle + 1;
      else high = middle;
    }
    return [after - 1, after].filter((i) => i >= 0 && i < events.length);
  }

  // For how long before and after an event it is looked at closely.
  reach(event) {
    const { events } = this.motion;
    const others = [
      events.findLast(({ time }) => time < event.time),
      events.find(({ time }) => time > event.time),
    ].filter((other) => other !== undefined);
    const gaps = others.map((other) => Math.abs(other.time - event.time) / 2.2);
    return Math.min(0.12 * this.span, ...gaps);
  }

  seek(t) {
    this.now = Math.max(this.motion.start, Math.min(this.motion.end, t));
    this.draw();
  }

  rewind() {
    this.leap(this.motion.start);
  }

  nudge(sense) {
    this.pause();
    this.seek(this.now + (sense * this.base * this.speed) / 15);
  }

  next() {
    const from = this.glide?.to ?? this.now;
    const met = this.motion.events.find(({ time }) => time > from + 1e-9 * this.span);
    this.leap(met ? met.time : this.motion.end, met);
  }

  previous() {
    const from = this.glide?.to ?? this.now;
    const met = this.motion.events.findLast(({ time }) => time < from - 1e-9 * this.span);
    this.leap(met ? met.time : this.motion.start, met);
  }

  // To another time: swiftly, or at once for those who want little motion.
  leap(to, event) {
    this.pause();
    if (event) this.announce(event);
    if (this.calm.matches || document.hidden) {
      this.seek(to);
      return;
    }
    const glide = { from: this.now, to, since: performance.now(), lasts: 450 };
    this.glide = glide;
    const step = (now) => {
      if (this.glide !== glide) return;
      const share = Math.min(1, Math.max(0, (now - glide.since) / glide.lasts));
      if (share === 1) this.glide = null;
      this.seek(share === 1 ? to : glide.from + (to - glide.from) * smooth(share));
      if (share < 1) requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  setSpeed(speed) {
    this.speed = speed;
    this.rateSaid.textContent = `${Number(speed.toPrecision(2))}×`;
    this.rate.setAttribute("aria-valuetext", `${this.rateSaid.textContent} the usual speed`);
  }

  faster(sense) {
    this.rate.value = String(Number(this.rate.value) + 0.5 * sense);
    this.setSpeed(2 ** Number(this.rate.value));
  }

  announce(event) {
    const number = this.motion.events.indexOf(event) + 1;
    const speeds = event.bodies.map((name) => {
      const [before, after] = [size(event.before[name]), size(event.after[name])];
      return `speed of ${name} ${figures(before)}, then ${figures(after)}`;
    });
    const what = `${number}: ${names(event)} at ${seconds(event.time)}`;
    this.live.textContent = [what, ...speeds].join("; ");
  }

  // --- what is seen ------------------------------------------------------------------------------

  draw() {
    if (!this.width) return;
    const { motion, now } = this;
    const beside = this.beside(now).map((i) => [motion.events[i], this.reaches[i]]);
    const at = beside.find(([{ time }]) => Math.abs(time - now) < 1e-9 * this.span)?.[0];
    const near = beside.find(([{ time }, reach]) => Math.abs(time - now) <= reach)?.[0];
    const focus = at ?? near ?? null;
    const passed = beside.findLast(([{ time }]) => time <= now)?.[0];
    const shown = focus ?? passed ?? motion.events[0] ?? null;
    this.picture.show(now, focus, at !== undefined, {
      velocities: this.velocities.box.checked,
      components: this.components.box.checked,
      trails: this.trails.box.checked,
    });
    this.card.show(shown, motion.events.indexOf(shown) + 1, at ? shown.time : now);
    this.values.show(now, this.playing);
    this.time.value = String(now);
    this.time.setAttribute("aria-valuetext", seconds(now));
    this.clock.textContent = seconds(now);
  }
}

// A player in an element; `data` is described at the top of data.py.
export function mount(root, data, options) {
  return new Player(root, data, options);
}
