// Momentum and kinetic energy as bars: what is conserved, and what is lost.

import { html, svg } from "../player/elements.js";
import { pieceAt } from "../player/motion.js";
import { dot, figures } from "../player/numbers.js";
import { COLOURS, CROWD } from "../player/picture.js";

const WIDTH = 400; // units of the picture; it is as wide as its place
const TALL = 26;
const LANE = 15; // of that: the shares of the spheres, above their total and what is missing to it

const sum = (list) => list.reduce((total, x) => total + x, 0);
const near = (x, most) => (Math.abs(x) < 1e-9 * most ? 0 : x);

export class Bars {
  constructor() {
    this.rows = ["x", "y", "energy"].map((kind) => this.row(kind));
    this.node = html(
      "section",
      { class: "bars" },
      html("h2", {}, "Momentum and kinetic energy"),
      ...this.rows.map(({ node }) => node),
      html("p", { class: "key" }, "Above a colour for each sphere, below ",
        "their total; hatched what the walls have taken, and the kinetic energy lost."),
    );
  }

  row(kind) {
    const title = html("h3", {});
    const said = html("p", { class: "said" });
    const picture = svg("svg", {
      role: "img", viewBox: `0 0 ${WIDTH} ${TALL}`, preserveAspectRatio: "none",
    });
    const node = html("div", { class: "bar-row" }, title, picture, said);
    return { kind, title, said, picture, node };
  }

  // For another motion: the scale is that of its largest values.
  lay(motion) {
    this.motion = motion;
    this.key = null;
    this.start = this.amounts(motion.start);
    let most = [0, 1].map((k) => this.reach(this.start[k], sum(this.start[k])));
    const starts = most.map((_, k) => sum(this.start[k]));
    const energy = sum(this.start[2]);
    const now = motion.spheres.map((s) => [s.mass, s.pieces[0][4], s.pieces[0][5]]);
    const index = new Map(motion.spheres.map(({ name }, i) => [name, i]));
    // From event to event only few velocities change.
    for (const event of motion.events) {
      for (const name of event.bodies) {
        const i = index.get(name);
        [now[i][1], now[i][2]] = event.after[name];
      }
      const shares = [0, 1].map((k) => now.map((s) => s[0] * s[k + 1]));
      most = most.map((m, k) => Math.max(m, this.reach(shares[k], starts[k])));
    }
    this.most = Math.max(...most) || 1;
    this.energy = energy || 1;
    for (const row of this.rows) {
      row.parts = motion.spheres.map((_, i) => svg("rect", {
        class: `share body${i % COLOURS}`, y: 1, height: LANE,
      }));
      row.sum = svg("rect", { class: "sum", y: LANE + 3, height: TALL - LANE - 4 });
      row.rest = svg("rect", { class: "rest", y: LANE + 3, height: TALL - LANE - 4 });
      const zero = row.kind === "energy" ? 0.5 : WIDTH / 2;
      row.zero = svg("path", { class: "zero", d: `M${zero} 0v${TALL}` });
      row.picture.replaceChildren(hatching(row.kind), ...row.parts, row.sum, row.rest, row.zero);
      row.rest.style.fill = `url(#hatch-${row.kind})`;
    }
  }

  // How far the bars reach: of shares of both signs, and of what the walls have taken.
  reach(shares, before) {
    const plus = sum(shares.filter((x) => x > 0));
    const minus = -sum(shares.filter((x) => x < 0));
    const walls = before - (plus - minus);
    return Math.max(plus, minus, Math.abs(walls), Math.abs(before));
  }

  // Momentum along x and y, and kinetic energy, of each sphere.
  amounts(t) {
    const now = this.motion.spheres.map((sphere) => {
      const piece = sphere.pieces[pieceAt(sphere, t)];
      return { mass: sphere.mass, v: [piece[4], piece[5]] };
    });
    return [
      now.map(({ mass, v }) => mass * v[0]),
      now.map(({ mass, v }) => mass * v[1]),
      now.map(({ mass, v }) => (mass * dot(v, v)) / 2),
    ];
  }

  show(t) {
    const key = this.motion.spheres.map((sphere) => pieceAt(sphere, t)).join();
    if (key === this.key) return;
    this.key = key;
    const shares = this.amounts(t);
    this.rows.forEach((row, k) => {
      if (row.kind === "energy") this.showEnergy(row, shares[k]);
      else this.showMomentum(row, shares[k], sum(this.start[k]));
    });
  }

  showMomentum(row, shares, before) {
    const scale = (WIDTH / 2 - 4) / this.most;
    const middle = WIDTH / 2;
    let right = 0;
    let left = 0;
    shares.forEach((share, i) => {
      const from = share > 0 ? right : left + share;
      if (share > 0) right += share;
      else left += share;
      place(row.parts[i], middle + scale * from, scale * Math.abs(share));
    });
    const total = near(sum(shares), this.most);
    const walls = near(before - total, this.most);
    const all = near(before, this.most);
    // Of one sign, what the walls have taken stands behind the total; of the other, opposite it.
    const from = total * walls > 0 ? total : 0;
    place(row.sum, middle + scale * Math.min(0, total), scale * Math.abs(total));
    place(row.rest, middle + scale * Math.min(from, from + walls), scale * Math.abs(walls));
    const axis = row.kind === "x" ? "i" : "j";
    row.title.replaceChildren("Momentum along ", html("b", {}, axis));
    const told = `${figures(total)} N s`;
    const rest = walls
      ? `${told} and ${figures(walls)} N s taken by the walls: together ${figures(all)} N s`
      : `${told}, conserved`;
    row.said.textContent = rest;
    const label = `Momentum along ${axis}: ${rest}.${this.each(shares, "N s")}`;
    row.picture.setAttribute("aria-label", label);
  }

  showEnergy(row, shares) {
    const scale = (WIDTH - 4) / this.energy;
    let from = 0;
    shares.forEach((share, i) => {
      place(row.parts[i], scale * from, scale * share);
      from += share;
    });
    const lost = near(sum(this.start[2]) - from, this.energy);
    place(row.rest, scale * from, Math.max(0, scale * lost));
    place(row.sum, 0, scale * from);
    const told = lost
      ? `${figures(from)} J; ${figures(lost)} J lost of ${figures(this.energy)} J ` +
        `(${figures((100 * lost) / this.energy)} %)`
      : `${figures(from)} J, conserved`;
    row.title.replaceChildren("Kinetic energy");
    row.said.textContent = told;
    row.picture.setAttribute("aria-label", `Kinetic energy: ${told}.${this.each(shares, "J")}`);
  }

  // In words: the share of each, where they are few.
  each(shares, unit) {
    const { spheres } = this.motion;
    if (spheres.length > CROWD) return "";
    const told = spheres.map(({ name }, i) => `${name} ${figures(shares[i])} ${unit}`);
    return ` ${told.join(", ")}.`;
  }
}

function place(rectangle, x, width) {
  rectangle.setAttribute("x", x);
  rectangle.setAttribute("width", width);
}

function hatching(kind) {
  return svg("defs", {}, svg(
    "pattern",
    { id: `hatch-${kind}`, width: 6, height: 6, patternUnits: "userSpaceOnUse",
      patternTransform: "rotate(45)" },
    svg("path", { class: "stroke", d: "M0 0V6" }),
  ));
}
